"""Real nodes have the ports that models say they have."""

from __future__ import annotations

import pytest
from recovered import OF_THE_LIBRARY, Node, compared, fetched

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("node", [node for node in OF_THE_LIBRARY if node.type in ("mux", "throttle")], ids=lambda node: node.type)
def test_ports_of_topic_tools(node: Node, tmp_path_factory: pytest.TempPathFactory) -> None:
    if node.program is None:
        pytest.skip("topic_tools is not installed")
    folder = tmp_path_factory.mktemp("recovered")
    elements = compared(node, fetched(node.source, folder), folder)
    assert len(elements) >= 2
    assert [(element["outcome"], element["name"]) for element in elements if element["outcome"] != "confirmed"] == []
