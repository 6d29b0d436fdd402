"""Component models as JSON documents, in the fields and the order of the component model format."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

from rosarch.base.files import path_below
from rosarch.base.whole import write_whole
from rosarch.models.component import ComponentModel, to_json
from rosarch.reports.printable import json_text

_IDENTITY = ("system", "component", "package", "kind", "node_name", "executable", "ports")


def models_text(models: Iterable[ComponentModel]) -> str:
    """All documents in one array."""
    return json_text([to_json(model) for model in models])


def ports_text(models: Iterable[ComponentModel]) -> str:
    """An array of the components with nothing but their identity and ports."""
    return json_text([{key: value for key, value in to_json(model).items() if key in _IDENTITY} for model in models])


def behaviors_text(models: Iterable[ComponentModel]) -> str:
    """An array of the components with nothing but their identity, ports and behaviour."""
    return json_text([{key: value for key, value in to_json(model).items() if key not in ("sources", "params")} for model in models])


def component_schema() -> Any:
    """The JSON Schema of one component's document."""
    return json.loads(files("rosarch.reports").joinpath("schema/component.schema.json").read_text(encoding="utf-8"))


def write_models(models: Iterable[ComponentModel], out: Path) -> None:
    """Write one document per component to `out`/<package>/<component>.json."""
    for model in models:
        write_document(to_json(model), out)


def write_document(model: Mapping[str, Any], out: Path) -> None:
    """Write the document of a component, as above."""
    path = path_below(out, model["package"], f"{model['component']}.json")
    write_whole(path, json_text(model).encode("utf-8", "backslashreplace"))
