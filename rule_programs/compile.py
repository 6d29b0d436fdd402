"""`python -m rosarch.rule_programs.compile`: compile the shipped rules where they are installed, so that no run has to."""

from __future__ import annotations

from rosarch.datalog import ship_program
from rosarch.rule_programs.sets import compiled_file, roots

PROGRAMS = (("component", True), ("component", False), ("system", False))


def compile_rules() -> None:
    """Compile what is not compiled, or was from other texts or for another engine."""
    for program, on_demand in PROGRAMS:
        ship_program(compiled_file(program, on_demand=on_demand), roots(program), on_demand=on_demand)


if __name__ == "__main__":
    compile_rules()
