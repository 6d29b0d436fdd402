"""The composed system: the nodes that launch files start, their ports with the names they have at run time, and what connects them."""
