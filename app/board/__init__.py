"""The board: any reflectance model, of the course or of the user, as an object to examine."""
