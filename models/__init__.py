"""Component models, assembled from the relations that the rules derive."""
