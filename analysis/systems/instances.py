"""Nodes as their components with their configurations: which models a launch needs, and which node has which.

A node's host is the component that is started. What it makes inside of its own, nodes and plug-ins, depends on the model of the host with
the node's configuration; of a plug-in again on the model of the plug-in.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TypeVar

from rosarch.analysis.systems.processes import process_settings
from rosarch.analysis.systems.settings import NodeSettings, configuration_of
from rosarch.analysis.systems.trees import Trees
from rosarch.extractor.launch.arguments import node_arguments
from rosarch.extractor.launch.model import Composition, NodeStart, ParamSetting
from rosarch.extractor.launch.names import canonical, global_namespace
from rosarch.extractor.workspace.plugins import TREE_NODE
from rosarch.models.component import ComponentModel
from rosarch.models.node_configuration import InnerNode, NodeConfiguration, arguments_of_plugin

Component = tuple[str, str]
"""Package and name."""
_Key = TypeVar("_Key", str, Component)
"""What a model is known by: the name of a plug-in, or a component."""

_DEPTH = 6
"""Plug-ins that load plug-ins are followed so far."""


@dataclass
class ModelIndex:
    """The available models: of components by themselves, by package and by the names that they are started by, and with configurations.

    `trees` reads the behavior trees of the workspace.
    """

    trees: Trees
    hosts: dict[tuple[str, str], dict[str, ComponentModel]] = field(default_factory=lambda: defaultdict(dict))
    configured: dict[tuple[Component, str], ComponentModel] = field(default_factory=dict)
    plugins: dict[tuple[str, str], ComponentModel] = field(default_factory=dict)

    @classmethod
    def of(cls, trees: Trees, models: Iterable[ComponentModel]) -> ModelIndex:
        """The index of these models."""
        index = cls(trees)
        index.add(models)
        return index

    def add(self, models: Iterable[ComponentModel]) -> None:
        """More models."""
        for model in models:
            if model.configuration:
                self.configured[(model.package, model.component), model.configuration] = model
                if model.plugin:
                    self.plugins[model.plugin.name, model.configuration] = model
            else:
                for type_ in (model.component,) if model.executable else model.types:
                    self.hosts[model.package, type_][model.title] = model


@dataclass
class Wants:
    """Models that nodes need: of components, of plug-ins by the names that they are loaded by, and those that are needed by themselves.

    `in_namespaces` are the configurations that are needed where code asks for the namespace, by the key of that without one.
    """

    components: dict[Component, set[NodeConfiguration]] = field(default_factory=lambda: defaultdict(set))
    plugins: dict[str, set[NodeConfiguration]] = field(default_factory=lambda: defaultdict(set))
    alone: set[str] = field(default_factory=set)
    in_namespaces: dict[str, set[NodeConfiguration]] = field(default_factory=lambda: defaultdict(set))


@dataclass(frozen=True)
class Parts:
    """What a node consists of: the titles of its models, and what belongs to it and has none.

    `tree_nodes` are the names of nodes of behavior trees without models, `trees` the files that could not all be read.
    """

    titles: tuple[str, ...] = ()
    tree_nodes: frozenset[str] = frozenset()
    trees: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Configured:
    """A composition with the nodes that others make inside of their own, and what its nodes consist of, by their index.

    A node that is not among these has the model of its component by itself.
    """

    composition: Composition
    parts: Mapping[int, Parts]


def configure(
    settings: NodeSettings, index: ModelIndex, wants: Wants | None = None, only: set[tuple[str, str]] | None = None
) -> Configured:
    """Find the models of each node; what is not there is added to what is wanted. With `only`, other programs are left out."""
    composition, finder = settings.composition, _Finder(settings, index, wants or Wants())
    nodes: list[NodeStart] = []
    made: _Made = []
    parts: dict[int, Parts] = {}
    params: list[ParamSetting] = []
    for node in composition.nodes:
        if only is not None and (node.package, node.type) not in only:
            continue
        found = finder.parts(node, made, params)
        if found.titles:
            parts[len(nodes)] = found
        nodes.append(node)
    for node, found in made:
        parts[len(nodes)] = found
        nodes.append(node)
    return Configured(replace(composition, nodes=tuple(nodes), params=(*composition.params, *params)), parts)


_Made = list[tuple[NodeStart, Parts]]
"""Nodes that others make."""


class _Finder:
    """Finds the models of the nodes of one composition."""

    def __init__(self, settings: NodeSettings, index: ModelIndex, wants: Wants) -> None:
        self.settings, self.index, self.wants = settings, index, wants

    def parts(self, node: NodeStart, made: _Made, params: list[ParamSetting]) -> Parts:
        """What a node consists of; the nodes that it makes are added to `made`, what is set for these to `params`."""
        hosts = list(self.index.hosts.get((node.package, node.type), {}).values())
        if len(hosts) != 1:
            return Parts()
        host = hosts[0]
        configuration = self.settings.configuration(node)
        configuration = replace(configuration, namespace=canonical(node.namespace) or "/")
        if host.asks_command_line:
            configuration = replace(configuration, words=_words(node))
        if not _matters(host, configuration):
            self.wants.alone.add(host.title)
            return Parts()
        component = (host.package, host.component)
        model = self._model(component, configuration, asks=host.asks_namespace)
        told = self._told(model, configuration) if model and model.asks_plugins else ()
        if told:
            model = self._model(component, replace(configuration, results=told), asks=host.asks_namespace)
        if model is None:
            return Parts()
        self._inner(node, model, component, made, params)
        return self._consisting(node, model, configuration, made)

    def _model(self, component: Component, configuration: NodeConfiguration, *, asks: bool = False) -> ComponentModel | None:
        """The model of a component with a configuration; it is wanted when it is not there."""
        return self._sought(component, configuration, self.index.configured, self.wants.components, asks=asks)

    def _sought(
        self,
        key: _Key,
        configuration: NodeConfiguration,
        models: Mapping[tuple[_Key, str], ComponentModel],
        wanted: dict[_Key, set[NodeConfiguration]],
        *,
        asks: bool = False,
    ) -> ComponentModel | None:
        """The model with a configuration, which has a namespace only where the code asks for it: nodes in others share their models.

        It `asks` where that is known before there is such a model.
        """
        plain = replace(configuration, namespace=None)
        found = None
        for each in (configuration,) if asks else (plain, configuration):
            found = models.get((key, each.key))
            if found is None:
                wanted[key].add(each)
                self.wants.in_namespaces[plain.key].add(configuration)
            if found is None or not found.asks_namespace:
                break
        return found

    def _told(self, model: ComponentModel, configuration: NodeConfiguration) -> tuple[tuple[str, str], ...]:
        """What functions return that a host asks its plug-ins for, where all of one base always return something known."""
        if model.loads_any:
            return ()
        plugins = [self._plugin(name, own) for name, own in self._plugin_configurations(model, configuration)]
        found: set[tuple[str, str]] = set()
        for base, function in model.asks_plugins:
            texts = [dict(plugin.results).get(function) if plugin else None for plugin in plugins if not plugin or _is_of(plugin, base)]
            if all(texts):
                found.update((function, text) for text in texts if text)
        return tuple(sorted(found))

    def _consisting(self, node: NodeStart, model: ComponentModel, configuration: NodeConfiguration, made: _Made) -> Parts:
        """What a node with this model consists of: with its plug-ins, and with the behavior trees that all of these carry out."""
        models = [model, *self._plugins(model, configuration)]
        found = Parts(tuple(each.title for each in models))
        for each in models:
            for name in each.tree_hosts or [None] if each.tree_files else []:
                own = configuration if name is None else replace(configuration, name=name)
                trees = self._trees(each, own)
                if name is None:
                    found = Parts((*found.titles, *trees.titles), found.tree_nodes | trees.tree_nodes, found.trees | trees.trees)
                else:
                    made.append((_renamed(node, name, node.namespace), trees))
        return found

    def _trees(self, model: ComponentModel, configuration: NodeConfiguration) -> Parts:
        """What the behavior trees consist of that a component carries out, where their nodes use a node with this configuration."""
        nodes, unread = self.index.trees.nodes(model.tree_files)
        titles: list[str] = []
        absent: set[str] = set()
        for each in nodes:
            own = replace(configuration, arguments=(), entry=None, inputs=each.inputs)
            found = self._plugin(each.id, own)
            if found is None:
                absent.add(each.id)
            elif found.plugin and found.plugin.base == TREE_NODE:
                titles.append(found.title)
        return Parts(tuple(titles), frozenset(absent), unread)

    def _plugins(self, model: ComponentModel, configuration: NodeConfiguration, depth: int = 0) -> Iterator[ComponentModel]:
        """The models of the plug-ins that a component loads, and of those that they load."""
        for name, own in self._plugin_configurations(model, configuration) if depth < _DEPTH else ():
            plugin = self._plugin(name, own)
            if plugin is not None:
                yield plugin
                yield from self._plugins(plugin, own, depth + 1)

    def _plugin_configurations(self, model: ComponentModel, configuration: NodeConfiguration) -> Iterator[tuple[str, NodeConfiguration]]:
        """The plug-ins that a component loads, by name, each with its configuration."""
        for name in model.loads:
            for arguments in arguments_of_plugin(name, model.plugin_arguments):
                yield name, replace(configuration, arguments=arguments, entry=None)

    def _plugin(self, name: str, configuration: NodeConfiguration) -> ComponentModel | None:
        """The model of a plug-in with a configuration; it is wanted when it is not there."""
        return self._sought(name, configuration, self.index.plugins, self.wants.plugins)

    def _inner(
        self,
        node: NodeStart,
        model: ComponentModel,
        component: Component,
        made: _Made,
        params: list[ParamSetting],
    ) -> None:
        for inner in model.inner:
            started = self._inner_start(node, inner)
            if started is None:
                continue
            settings = {name: [one] for name, one in process_settings(self.settings.composition, node, started.full_name).items()}
            values = configuration_of(started, settings, self.settings.is_open(node))
            space = canonical(started.namespace) or "/"
            configuration = replace(values, arguments=inner.arguments, entry=inner.class_, namespace=space)
            found = self._model(component, configuration)
            if found is None:
                continue
            made.append((started, self._consisting(started, found, configuration, made)))
            params += [replace(one, name=f"{started.full_name}/{name}") for name, own in settings.items() for one in own]

    def _inner_start(self, node: NodeStart, inner: InnerNode) -> NodeStart | None:
        """The start of a node that another one makes; None when it is not known in which namespace."""
        namespaces = {
            canonical(global_namespace(node.namespace + text if relative else text)) or "/" for text, relative in inner.namespaces
        }
        if len(namespaces) != 1:
            return None
        return _renamed(node, inner.name, global_namespace(namespaces.pop()))


def _is_of(plugin: ComponentModel, base: str) -> bool:
    """Whether a plug-in derives from the class `base`, as far as its description says."""
    return plugin.plugin is None or plugin.plugin.base in (base, None)


def _renamed(node: NodeStart, name: str, namespace: str) -> NodeStart:
    """The start of a node that another one makes."""
    return replace(node, name=name, called=name, namespace=namespace, container=None, first=(), inside=node.namespace)


def _words(node: NodeStart) -> tuple[str, ...] | None:
    """The words of its command line, without what is for ROS; None when they are not known, as for what is loaded somewhere."""
    return None if node.container is not None else tuple("?" if "$(" in word else word for word in node_arguments(node).plain)


def _matters(model: ComponentModel, configuration: NodeConfiguration) -> bool:
    """Whether the configuration may say anything about the component that its model by itself does not have."""
    if model.loads or model.loads_any or model.inner or model.tree_files:
        return True
    if model.asks_name and configuration.name and configuration.name != model.node_name:
        return True
    return model.asks_namespace or configuration.words is not None or bool(model.params)
