"""What a source says, in comments, that rosarch should find in it."""
