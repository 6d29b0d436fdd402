"""What all YAML is read with: a loader that makes no objects, and whose time grows with the text."""

from __future__ import annotations

from typing import Any

import yaml

MAX_NESTING = 200  # lists and maps in brackets within each other: the scanner looks at all that are open for every token


class BoundedLoader(yaml.SafeLoader):
    """PyYAML's safe loader, with a bound on nesting."""

    def fetch_flow_collection_start(self, TokenClass: Any) -> None:
        """A bracket opens."""
        if self.flow_level >= MAX_NESTING:
            raise yaml.scanner.ScannerError(None, None, f"brackets nested more than {MAX_NESTING} deep", self.get_mark())
        super().fetch_flow_collection_start(TokenClass)
