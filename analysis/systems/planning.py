"""Which models the launches of a workspace need, found while components are analysed: what a node needs depends on models of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from rosarch.analysis.systems.instances import ModelIndex, Wants, configure
from rosarch.analysis.systems.processes import with_nodes
from rosarch.analysis.systems.settings import NodeSettings
from rosarch.analysis.systems.trees import Trees
from rosarch.models.component import ComponentModel
from rosarch.models.node_configuration import NodeConfiguration

if TYPE_CHECKING:
    from rosarch.extractor.launch.model import Composition, NodeStart


def configuring(composition: Composition) -> str:
    """All of a composition that configures components."""
    nodes = [(n.package, n.type, n.full_name, n.called, n.container, n.args, _renaming(n)) for n in composition.nodes]
    process = [(one.nodes, one.setting.name, one.setting.value) for node in composition.nodes for one in node.process]
    params = [(setting.name, setting.value, bool(setting.conditions)) for setting in composition.params]
    return repr((nodes, process, params, [unread.name for unread in composition.unread]))


def _renaming(node: NodeStart) -> list[tuple[str | None, str, str]]:
    return [(remap.node, remap.source, remap.target) for remap in node.remaps if remap.source.startswith("__")]


def made_by(models: Iterable[ComponentModel]) -> dict[tuple[str, str], list[ComponentModel]]:
    """The models of the nodes of each program or class, by package and by the name that launch files know it by."""
    made: dict[tuple[str, str], list[ComponentModel]] = {}
    for model in models:
        if model.configuration:
            continue
        if model.executable:
            made.setdefault((model.package, model.executable), []).append(model)
        else:
            made.update({(model.package, type_): [model] for type_ in model.types})
    return made


class Planner:
    """Which configurations the components need that launches start, as far as models are known."""

    def __init__(self, compositions: Sequence[Composition], trees: Trees) -> None:
        self.compositions = compositions
        self.index = ModelIndex(trees)
        self.generic: dict[str, ComponentModel] = {}
        self._started: dict[tuple[str, ...], tuple[Sequence[ComponentModel], list[NodeSettings]]] = {}
        self._programs = [{(node.package, node.type) for node in composition.nodes} for composition in compositions]

    def after(self, models: Sequence[ComponentModel]) -> list[NodeConfiguration]:
        """With which configurations the component is needed that `models` are of, as far as these say: whether there are models or not."""
        self.index.add(models)
        self.generic |= {model.title: model for model in models if not model.configuration}
        components = {(model.package, model.component) for model in models}
        own = [model for model in self.generic.values() if (model.package, model.component) in components]
        types = {(model.package, type_) for model in own for type_ in ((model.component,) if model.executable else model.types)}
        index, wants = ModelIndex.of(self.index.trees, [*own, *models]), Wants()
        for settings in self._starting(own, types):
            configure(settings, index, wants, types)
        return [each for one in components for each in sorted(wants.components.get(one, ()), key=lambda found: found.key)]

    def _starting(self, own: Sequence[ComponentModel], types: set[tuple[str, str]]) -> list[NodeSettings]:
        """The launches that start one of these, with the nodes that it makes: the same for all configurations of a component."""
        titles = tuple(model.title for model in own)
        known, started = self._started.get(titles, ([], []))
        if len(known) != len(own) or any(model is not other for model, other in zip(own, known, strict=True)):
            made = made_by(own)
            programs_of = zip(self.compositions, self._programs, strict=True)
            there = [composition for composition, programs in programs_of if not programs.isdisjoint(made.keys() | types)]
            started = [NodeSettings(with_nodes(composition, made)) for composition in there]
            self._started[titles] = (own, started)
        return started

    def wants(self, made: Mapping[tuple[str, str], list[ComponentModel]]) -> Wants:
        """What the launches want beside the models in the index."""
        wants = Wants()
        for composition in self.compositions:
            configure(NodeSettings(with_nodes(composition, made)), self.index, wants)
        return wants
