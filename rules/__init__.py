"""The Datalog rules, as package data."""
