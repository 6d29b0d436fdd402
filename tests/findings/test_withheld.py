"""Claims that are withheld: those of a closed world, with what was not seen of the nodes that they name."""

from __future__ import annotations

from dataclasses import replace

from handmade_findings import STYLE, finding

from rosarch.base.places import Place
from rosarch.findings.withheld import withheld
from rosarch.models.openness import OpenPart

DRIVER = OpenPart("/driver", "demo/driver has no model", Place("a.launch", 1, 1))
INCLUDE = OpenPart("", "the included file b.launch was not read", Place("a.launch", 2, 1))


def test_what_is_claimed_anyway_is_not_withheld() -> None:
    claimed = finding(STYLE, "/driver does not read x")
    assert withheld([claimed], [replace(claimed, systems=("other",))], [DRIVER]) == ()


def test_a_claim_is_withheld_for_what_was_not_seen_of_its_nodes() -> None:
    (of_driver,) = withheld([], [finding(STYLE, "/driver does not read x")], [DRIVER, INCLUDE])
    (of_filter,) = withheld([], [finding(STYLE, "/filter reads /scan, which no node publishes")], [DRIVER, INCLUDE])
    assert (of_driver.because, of_filter.because) == ((DRIVER,), (DRIVER, INCLUDE))
