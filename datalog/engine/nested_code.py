"""Writing Python code line by line, in loops within loops."""

from __future__ import annotations

import re


class NestedCode:
    """The body of a function while it is written."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.depth = 1
        self.loops = 0
        self.temporaries = 0
        self.names: dict[str, str] = {}
        self.functions: list[int] = []  # depths of open nested functions

    def line(self, text: str) -> None:
        """Write one line at the current depth."""
        self.lines.append("    " * self.depth + text)

    def fail_unless(self, condition: str) -> None:
        """Continue with the next combination unless the condition holds."""
        self.line(f"if not ({condition}): {'continue' if self.loops else 'return'}")

    def fail_if(self, condition: str) -> None:
        """Continue with the next combination if the condition holds."""
        self.line(f"if {condition}: {'continue' if self.loops else 'return'}")

    def open_loop(self, text: str) -> None:
        """Write a loop header; what follows is inside."""
        self.line(text)
        self.depth += 1
        self.loops += 1

    def temporary(self) -> str:
        """A fresh Python name."""
        self.temporaries += 1
        return f"t{self.temporaries}"

    def python_name(self, variable: str, bound: dict[str, str]) -> str:
        """A Python name for a variable, not used by any other variable in scope."""
        base = "v_" + re.sub("[^A-Za-z0-9_]", "_", variable)
        name, taken = base, set(self.names.values())
        while name in taken or name in bound.values():
            self.temporaries += 1
            name = f"{base}_{self.temporaries}"
        self.names[f"{variable}@{name}"] = name
        return name

    def open_function(self) -> None:
        """Continue in a nested function: Python allows no more than twenty nested blocks in one."""
        self.line("def inner():")
        self.functions.append(self.depth)
        self.depth += 1
        self.loops = 0
