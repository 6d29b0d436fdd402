"""Discrete-event simulation of composed systems."""
