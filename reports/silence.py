"""Why nothing arrives on a topic, as text and as JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from rosarch.base.places import Place
from rosarch.findings.model import Finding
from rosarch.findings.silence import Sender, Silence, Unseen
from rosarch.reports.printable import json_text


def silence_text(system: str, found: Silence) -> str:
    """The chain back to the first broken link; what it rests on is indented below."""
    return "\n".join([f"{found.topic} in {system}: {_summary(found)}", *_lines(found, 1)]) + "\n"


def _summary(found: Silence) -> str:
    if not found.senders:
        return "no node that is started sends on it" + (", as far as was seen" if found.unseen else "")
    if found.broken:
        return "nothing arrives"
    if found.stuck:
        return "nothing arrives, as far as was seen"
    stuck = sum(sender.stuck for sender in found.senders)
    if stuck:
        return f"of {len(found.senders)} senders, {stuck} send{'s' if stuck == 1 else ''} nothing that arrives"
    return "nothing was found that keeps messages from arriving"


def _lines(found: Silence, depth: int) -> Iterator[str]:
    pad = "  " * depth
    if found.readers and depth == 1:
        yield f"{pad}read by {', '.join(found.readers)}"
    for sender in found.senders:
        yield f"{pad}{sender.node} sends on it{_at(sender.place)}"
        yield from _sender_lines(sender, depth + 1)
    for other, reason in found.near:
        yield f"{pad}{other} is sent and read by nobody ({reason})"
    yield from (f"{pad}{_finding(each)}" for each in found.findings)
    yield from (f"{pad}perhaps: {_finding(each)}" for each in found.perhaps)
    if found.stuck:
        yield from (f"{pad}{each.node} may send on it: {each.reason}{_at(each.place)}" for each in found.unseen)


def _sender_lines(sender: Sender, depth: int) -> Iterator[str]:
    pad = "  " * depth
    yield from (f"{pad}{_finding(each)}" for each in sender.findings)
    yield from (f"{pad}perhaps: {_finding(each)}" for each in sender.perhaps)
    if sender.never and not sender.findings and not sender.inputs:
        yield f"{pad}it is never sent: its rate is zero"
    for source in sender.inputs:
        if source.stuck:
            yield f"{pad}it is made from {source.topic}: {_summary(source)}"
            yield from _lines(source, depth + 1)
    if not sender.stuck and not sender.perhaps:
        made = ", ".join(source.topic for source in sender.inputs)
        yield f"{pad}nothing was found that keeps it from sending{f' what it makes from {made}' if made else ''}"


def _finding(finding: Finding) -> str:
    return f"{finding.message} [{finding.check.id}]{_at(finding.place)}"


def _at(place: Place | None) -> str:
    return f"  {place.path}:{place.line}" if place else ""


def silence_json(answers: Sequence[tuple[str, Silence]]) -> str:
    """The answers for all systems."""
    return json_text([{"system": system, **_silence(found)} for system, found in answers])


def _silence(found: Silence) -> dict[str, Any]:
    return {
        "topic": found.topic,
        "broken": found.broken,
        **({"seen_above": True} if found.seen else {}),
        "readers": list(found.readers),
        "senders": [_sender(each) for each in found.senders],
        "similar": [{"topic": other, "reason": reason} for other, reason in found.near],
        "findings": [_finding_json(each) for each in found.findings],
        "perhaps": [_finding_json(each) for each in found.perhaps],
        "unseen": [_unseen(each) for each in found.unseen],
    }


def _sender(sender: Sender) -> dict[str, Any]:
    return {
        "node": sender.node,
        **_place(sender.place),
        "broken": sender.broken,
        "never_sent": sender.never,
        "findings": [_finding_json(each) for each in sender.findings],
        "perhaps": [_finding_json(each) for each in sender.perhaps],
        "inputs": [_silence(each) for each in sender.inputs],
    }


def _finding_json(finding: Finding) -> dict[str, Any]:
    return {"check": finding.check.id, "severity": finding.severity, "message": finding.message, **_place(finding.place)}


def _unseen(unseen: Unseen) -> dict[str, Any]:
    return {"node": unseen.node, "reason": unseen.reason, **_place(unseen.place)}


def _place(place: Place | None) -> dict[str, Any]:
    return {"file": place.path, "line": place.line} if place else {}
