"""The `rosarch` command: one module per sub-command, and what they share."""
