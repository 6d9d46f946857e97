"""What runs inside a student's process: these files stand alone and import nothing of the course."""
