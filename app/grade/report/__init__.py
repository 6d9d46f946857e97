"""What a class's results look like: for students, the course team and other programs; one file a format."""
