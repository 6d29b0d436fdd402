"""What drives an analysis: from a workspace to the models of its components and systems, and to findings."""
