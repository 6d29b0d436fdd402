"""The behaviour of composed systems: state machines of nodes that meet at their messages."""
