"""Temporal logic over composed systems: properties, the languages of model checkers, and what the checkers say."""
