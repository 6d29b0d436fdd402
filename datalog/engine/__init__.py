"""The engines: clauses compiled to Python and evaluated, and the souffle binary behind the same interface."""
