"""State machines, made from the document of a component."""

from rosarch.models.machine.build import MAX_STATES, Region, StateMachine, Transition, Trigger, build_machine

__all__ = ["MAX_STATES", "Region", "StateMachine", "Transition", "Trigger", "build_machine"]
