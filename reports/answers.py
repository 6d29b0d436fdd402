"""Answers to questions about systems, as text and as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rosarch.models.system.chains import ChainAnswer, PortShown, Step
from rosarch.models.system.rates import TopicRate
from rosarch.reports.printable import json_text

_SIDES = {
    "publisher": "publishes", "subscriber": "reads", "tf_broadcaster": "sends transforms on", "tf_listener": "looks transforms up on",
    "service_client": "calls", "service_server": "serves", "action_client": "sends goals to", "action_server": "serves",
}  # fmt: skip
_KINDS = {"reactive": "reacts", "deferred": "sends it in a loop or timer", "kept": "keeps it until something else makes it send"}
_WAITS = {"callbacks": "callbacks run once a round", "sending": "sent in the next round"}
_MOST = 4
"""How many variables are named; JSON has them all."""


def chain_text(answer: ChainAnswer) -> str:
    """An answer with its chain, or with what is in its way."""
    lines = [f"{answer.answer}: {_summary(answer)}"]
    if answer.chain and (answer.answer == "yes" or answer.asked.always):
        lines += _chain_lines(answer.chain)
        known = answer.waits is not None
        lines.append(f"  waits {_seconds(answer.waits)} at most, besides execution" if known else "  how long it waits is not known")
    if answer.uncertain:
        lines.append("not certain:")
        lines += [f"  {_inside(step)}" for step in answer.uncertain]
    if answer.missing:
        lines.append("missing:")
        lines += [f"  {node}: {reason}" for node, reason in answer.missing]
    if answer.ends:
        lines.append("the influence ends at:")
        lines += [f"  {_port(port)}{_place(port)}: {reason}" for port, reason in answer.ends]
    return "\n".join(lines) + "\n"


def _summary(answer: ChainAnswer) -> str:
    verb = {"yes": "always causes" if answer.asked.always else "can cause", "no": "need not cause" if answer.chain else "cannot cause"}
    return f"{answer.asked.source} {verb.get(answer.answer, 'might cause')} {answer.asked.target} in {answer.system}"


def _chain_lines(chain: Sequence[Step]) -> list[str]:
    lines = [f"  {_port(chain[0].source)}{_place(chain[0].source)}"]
    for step in chain:
        if step.kind in ("connection", "answer"):
            lines.append(f"    {'is answered by' if step.kind == 'answer' else 'arrives at'} {_port(step.sink)}{_place(step.sink)}")
        else:
            lines.append(f"    {_inside(step)}")
    return lines


def _inside(step: Step) -> str:
    """What a node does between two of its ports, in one line; a connection as one that need not be there."""
    if step.kind in ("connection", "answer"):
        return f"{_port(step.source)} -> {_port(step.sink)}: whether it is there, and loses no message, is not certain"
    told = [f"{step.source.node} {_KINDS[step.kind]}, {step.how}: {step.source.name} -> {step.sink.name}"]
    if step.variables:
        told.append(f"through {_few(step.variables)}")
    if step.condition:
        told.append(f"if {step.condition}")
    if step.filters:
        told.append(f"decided by {_few(step.filters)}")
    told += [f"{_WAITS[reason]}: {_seconds(seconds)}" for seconds, reason in step.waits]
    return "; ".join(told) + (f"  {' '.join(map(str, step.at))}" if step.at else "")


def _few(names: Sequence[str]) -> str:
    return ", ".join(names[:_MOST]) + (f" and {len(names) - _MOST} more" if len(names) > _MOST else "")


def _port(port: PortShown) -> str:
    return f"{port.node} {_SIDES.get(port.kind, port.kind)} {port.name}"


def _place(port: PortShown) -> str:
    return f"  {port.at}" if port.at else ""


def _seconds(value: float | None) -> str:
    return "?" if value is None else f"{value:.3g} s"


def chain_json(answers: Sequence[ChainAnswer]) -> str:
    """Answers as JSON."""
    return json_text([_document(answer) for answer in answers])


def _document(answer: ChainAnswer) -> dict[str, Any]:
    return {
        "system": answer.system,
        "question": f"{'must' if answer.asked.always else 'can'} {answer.asked.source} cause {answer.asked.target}",
        "answer": answer.answer,
        "chain": [_step_document(step) for step in answer.chain],
        "waits": answer.waits,
        "uncertain": [_step_document(step) for step in answer.uncertain],
        "missing": [{"node": node, "reason": reason} for node, reason in answer.missing],
        "ends": [{**_port_document(port), "reason": reason} for port, reason in answer.ends],
    }


def _step_document(step: Step) -> dict[str, Any]:
    return {
        "from": _port_document(step.source), "to": _port_document(step.sink), "kind": step.kind, "how": step.how, "certain": step.certain,
        "at": list(map(str, step.at)), "condition": step.condition, "variables": list(step.variables), "filters": list(step.filters),
        "waits": [{"seconds": seconds, "reason": reason} for seconds, reason in step.waits],
    }  # fmt: skip


def _port_document(port: PortShown) -> dict[str, Any]:
    return {"node": port.node, "name": port.name, "kind": port.kind, "at": str(port.at) if port.at else None}


def rates_text(system: str, rates: Sequence[TopicRate]) -> str:
    """Rates of topics, one a line."""
    width = max((len(rate.topic) for rate in rates), default=0)
    lines = [f"rates in {system}"]
    for rate in rates:
        why = f" ({'; '.join(rate.reasons)})" if rate.reasons else ""
        lines.append(f"  {rate.topic:{width}}  {_interval(rate)}  {', '.join(rate.senders)}{why}".rstrip())
    return "\n".join(lines) + "\n"


def _interval(rate: TopicRate) -> str:
    if rate.high is None:
        return f"{rate.low:.4g} Hz or more" if rate.low else "not known"
    return f"{rate.low:.4g} Hz" if rate.low == rate.high else f"{rate.low:.4g} to {rate.high:.4g} Hz"


def rates_json(found: Sequence[tuple[str, Sequence[TopicRate]]]) -> str:
    """Rates of topics as JSON."""
    documents = [
        {"system": system, "rates": [{**vars(rate), "senders": list(rate.senders), "reasons": list(rate.reasons)} for rate in rates]}
        for system, rates in found
    ]
    return json_text(documents)
