"""Library files from component models: what a composed system needs of them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from rosarch.base.files import path_below
from rosarch.base.logic import alternatives
from rosarch.base.whole import write_whole
from rosarch.extractor.workspace.model import PYTHON_NODE
from rosarch.library.model import GENERATED, Source
from rosarch.library.reading import COMPONENT_KINDS
from rosarch.models import formula
from rosarch.models.component import MANAGED, ComponentModel, Parameter, Port, default_value
from rosarch.models.rhythm import needs_of

UNKNOWN = "?"
_OF_ROS_1 = frozenset({"hydro", "indigo", "jade", "kinetic", "lunar", "melodic", "noetic"})
_PARAMETER = re.compile(r"~[\w./]+")


def library_documents(models: Iterable[ComponentModel], source: Source) -> dict[str, dict[str, Any]]:
    """A document per package that has components."""
    packages: dict[str, list[dict[str, Any]]] = {}
    versions: dict[str, set[int]] = {}
    for model in sorted((one for one in models if not one.executable), key=lambda model: (model.package, _name(model))):
        document = component_document(model)
        says_something = model.kind != "plugin" or "ports" in document or "params" in document
        if _kind(model) in COMPONENT_KINDS and says_something:
            found = packages.setdefault(model.package, [])
            # with the other names of a program; of a class that is loaded into containers, with the programs that run it alone
            others = [{**document, "component": name, "kind": "node"} for name in model.executables if name != _name(model)]
            known_names = {one["component"] for one in found}
            found += [one for one in (document, *others) if one["component"] not in known_names]
            known = versions.setdefault(model.package, set())
            if model.middleware:
                known.add(2 if "ROS 2" in model.middleware else 1)
    head = {"origin": source.origin, "revision": source.revision}
    more = {"distributions": list(source.distributions)} if source.distributions else {}
    # packages without nodes of their own are for the ROS of the others
    together = sorted(set().union(*versions.values())) or [1 if _OF_ROS_1.issuperset(source.distributions) else 2]
    return {
        package: {
            **{"package": package, **head, "ros": sorted(versions[package]) or together, **more},
            **{"made": GENERATED, "components": found},
        }
        for package, found in packages.items()
    }


def component_document(model: ComponentModel) -> dict[str, Any]:
    """One component: without source lines and callbacks, and without what is not known, which `open` lists."""
    ports = [port for port in model.ports if UNKNOWN not in port.name or _parameter(port)]
    accesses = [*model.params, *model.reconfigurable]
    params = [parameter for parameter in accesses if parameter.name and UNKNOWN not in parameter.name]
    silent = not model.loads and all(port.implicit for port in ports)
    lost_ports = len(ports) < len(model.ports) or UNKNOWN in model.loads or silent
    lost_params = len(params) < len(accesses)
    kept = _kept(model)
    return _present_fields(
        component=_name(model),
        kind=_kind(model),
        base=model.plugin.base if model.plugin else None,
        node_name=model.node_name,
        open=(lost_params or "ports") if lost_ports else ("params" if lost_params else None),
        loads=[name for name in model.loads if UNKNOWN not in name] or None,
        ports=_distinct(_port(port, kept) for port in ports) or None,
        params=_parameters(params) or None,
    )


def _kind(model: ComponentModel) -> str:
    """What kind of component it is; whether others manage its life, and which language it is in, is not said."""
    if model.kind == PYTHON_NODE:
        return "node"
    if model.kind != MANAGED:
        return model.kind
    return "component" if model.plugin else "node"


def _name(model: ComponentModel) -> str:
    """The name that launch files know a component by."""
    return model.types[0]


def _present_fields(**fields: Any) -> dict[str, Any]:
    return {key: value for key, value in fields.items() if value is not None and value is not False}


def _distinct(documents: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = []
    for document in documents:
        if document not in found:
            found.append(document)
    return found


def _port(port: Port, kept: Mapping[str, str]) -> dict[str, Any]:
    return _present_fields(
        kind=port.kind,
        name=None if UNKNOWN in port.name else port.name,
        type=None if port.type in (UNKNOWN, "*") else port.type,
        from_param=_parameter(port),
        queue=port.queue,
        latched=port.latched,
        via=None if port.via in ("plain", "bind", "lambda", "options") else port.via,
        implicit=port.implicit,
        conditional=_condition(port, kept),
    )


def _kept(model: ComponentModel) -> dict[str, str]:
    """The private parameters whose values variables keep, by the names of these."""
    kept = {str(trait.values[0]): str(trait.values[1]) for trait in model.traits if trait.name == "keeps_value_of"}
    if model.middleware and "ROS 2" in model.middleware:
        kept = {name: f"~{parameter}" for name, parameter in kept.items()}
    return {name: parameter for name, parameter in kept.items() if _PARAMETER.fullmatch(parameter)}


def _condition(port: Port, kept: Mapping[str, str]) -> str | None:
    """When the port is there: by the parameters that each of its ways needs, and by the text of the rest."""
    text = formula.text(port.guard)
    ways = [[(item, [_needed(need) for need in needs_of(item, kept)]) for item in way] for way in alternatives(port.guard)] if kept else []
    needed = [dict.fromkeys(need for _, needs in way for need in needs if need) for way in ways]
    common = [need for need in needed[0] if all(need in others for others in needed)] if needed else []
    if text is None or not common:
        return text
    rest = [formula.text(item) for item, needs in ways[0] if None in needs] if len(ways) == 1 else [text]
    return " and ".join([*common, *filter(None, rest)])


def _needed(need: tuple[str, str, bool] | None) -> str | None:
    """What a parameter has to be."""
    parameter, value, holds = need or ("", "", False)
    if not parameter or (value != "true" and (not holds or " and " in value)):
        return None
    return f"{'' if holds else 'not '}{parameter}" if value == "true" else f"{parameter} is {value}"


def _parameter(port: Port) -> str | None:
    """The parameter that holds the port's whole name."""
    whole = port.name == UNKNOWN or UNKNOWN not in port.name
    return port.from_param if whole and port.from_param and UNKNOWN not in port.from_param else None


def _parameters(accesses: Iterable[Parameter]) -> list[dict[str, Any]]:
    """Each parameter and operation once, with the first type and default that is known."""
    found: dict[tuple[str, str], dict[str, Any]] = {}
    for access in accesses:
        known = found.setdefault((access.name, access.op), {"name": access.name, "op": access.op})
        for key, value in _present_fields(type=access.type).items():
            known.setdefault(key, value)
        if access.default not in (None, UNKNOWN):
            value = default_value(access)
            known.setdefault("default", access.default if isinstance(value, list) else value)
    return [found[key] for key in sorted(found)]


def document_text(document: dict[str, Any]) -> str:
    """A file's text: a line for each port and parameter."""
    components = ",\n".join(_component_text(component) for component in document["components"])
    head = ",\n".join(f" {json.dumps(key)}: {_line(value)}" for key, value in document.items() if key != "components")
    return f'{{\n{head},\n "components": [\n{components}\n ]\n}}\n'


def _component_text(component: dict[str, Any]) -> str:
    parts = []
    for key, value in component.items():
        if key in ("ports", "params"):
            rows = ",\n".join(f"    {_line(row)}" for row in value)
            parts.append(f"   {json.dumps(key)}: [\n{rows}]")
        else:
            parts.append(f"   {json.dumps(key)}: {_line(value)}")
    return "  {\n" + ",\n".join(parts) + "\n  }"


def _line(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False)


def write_library(documents: dict[str, dict[str, Any]], out: Path) -> tuple[Path, ...]:
    """Write each package's document to `out`/<package>.json; the files written."""
    paths = []
    for package, document in documents.items():
        path = path_below(out, f"{package}.json")
        write_whole(path, document_text(document).encode("utf-8", "backslashreplace"))
        paths.append(path)
    return tuple(paths)
