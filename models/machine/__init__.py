"""State machines, made from the document of a component."""
