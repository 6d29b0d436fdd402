"""What one asks of rules and their rows: proofs, queries, tests, coverage, profiles, conventions."""
