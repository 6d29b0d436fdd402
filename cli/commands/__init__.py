"""The sub-commands of `rosarch`, a module each."""
