"""What an element of a launch file sees: namespace, arguments, remappings and private parameters so far (roslaunch's loader context)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from rosarch.extractor.launch.model import Condition, LaunchError, ParamSetting, Place, Remap
from rosarch.extractor.launch.names import canonical, global_namespace, is_legal, ns_join
from rosarch.extractor.launch.unknowns import with_unknowns_as


@dataclass
class Scope:
    """The state within one `<launch>`, `<group>` or `<node>`. A child starts with copies and hands nothing back.

    `private` may be shared with the scope of the including file, as roslaunch shares it: a private parameter set in an included file
    reaches later nodes of the including one, but only when that had set one before.
    """

    namespace: str
    filename: str
    parent: Scope | None = None
    remaps: list[Remap] = field(default_factory=list)
    private: list[ParamSetting] = field(default_factory=list)
    environment: list[tuple[str, str]] = field(default_factory=list)
    args: dict[str, str] = field(default_factory=dict)
    declared: set[str] = field(default_factory=set)
    maybe_declared: dict[str, tuple[Condition, ...]] = field(default_factory=dict)
    anonymous: dict[str, str] = field(default_factory=dict)
    passes_all: bool = False
    conditions: tuple[Condition, ...] = ()
    held: tuple[Condition, ...] = ()
    lines: tuple[Place, ...] = ()

    def child(self, namespace: str | None, conditions: tuple[Condition, ...] = ()) -> Scope:
        """The scope of an element within this one.

        Raises:
            LaunchError: the namespace is a private name.
        """
        inner = ns_join(self.namespace, namespace) if namespace else self.namespace
        try:
            inner = global_namespace(inner or "/")
        except ValueError as error:
            raise LaunchError("namespace", namespace or "", str(error)) from None
        return Scope(
            namespace=inner,
            filename=self.filename,
            parent=self,
            private=self.private or [],
            environment=self.environment[:],
            args=dict(self.args),
            declared=set(self.declared),
            maybe_declared=dict(self.maybe_declared),
            anonymous=dict(self.anonymous),
            conditions=self.conditions + conditions,
            held=self.held,
            lines=self.lines,
        )

    def declare(self, name: str, value: str | None, default: str | None, into: dict[str, str]) -> None:
        """Process an `<arg>`: a value is set in `into`, a default only when there is none.

        Raises:
            LaunchError: the argument is declared twice, or its value would override one that was passed.
        """
        if name in self.declared and not self.passes_all:
            raise LaunchError("arg-declared-twice", name, f"argument `{name}` has already been declared")
        self.declared.add(name)
        if value is not None:
            if name in into and not self.passes_all:
                raise LaunchError("arg-override", name, f"argument `{name}` has a fixed value and cannot be passed")
            into[name] = value
        elif default is not None:
            into.setdefault(name, default)

    def add_remap(self, remap: Remap) -> None:
        """Add a remapping; it replaces one of the same name.

        Raises:
            LaunchError: a name is empty or illegal.
        """
        source, target = canonical(remap.source), canonical(remap.target)
        if not source or not target:
            raise LaunchError("remap", f"{remap.source}:={remap.target}", "from and to of a remapping must not be empty")
        for name, role in ((source, "from"), (target, "to")):
            if not is_legal(with_unknowns_as("x", name)):
                raise LaunchError("remap", name, f"`{name}` is no legal name to remap {role}")
        if not remap.conditions:
            self.remaps[:] = [other for other in self.remaps if other.source != source]
        self.remaps.append(replace(remap, source=source, target=target))

    def all_remaps(self) -> list[Remap]:
        """The remappings that a node here gets, outer ones first."""
        if self.parent is None:
            return self.remaps[:]
        own = {remap.source for remap in self.remaps if not remap.conditions}
        return [remap for remap in self.parent.all_remaps() if remap.source not in own] + self.remaps

    def add_private(self, setting: ParamSetting) -> None:
        """Set a private parameter for the nodes that follow."""
        if not setting.conditions:
            self.private[:] = [other for other in self.private if other.name != setting.name]
        self.private.append(setting)


def settle(settings: dict[str, list[ParamSetting]], new: ParamSetting) -> None:
    """Add a setting of a parameter: it replaces those before, unless it is only one of two alternatives."""
    before = settings.get(new.name, []) if new.conditions else []
    settings[new.name] = [*(old for old in before if old.conditions != new.conditions), new]
