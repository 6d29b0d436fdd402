"""The behavior of composed systems: state machines put together, verified and simulated."""
