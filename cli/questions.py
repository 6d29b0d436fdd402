"""What `query`, `explain`, `why-not`, `rules run`, `watch` and `browse` are asked about, and how that is read: their common options."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import MISSING, dataclass, fields
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_type_hints

from rosarch.cli.derivations import Component, selected
from rosarch.cli.errors import InputError
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Input, Jobs, Packages, Timeout, Verbose, parse_defines
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.systems import SystemInputs, Systems, load_surrounding
from rosarch.cli.terminal import show_diagnostics

if TYPE_CHECKING:
    from rosarch.models.rule_choice import RuleSet
    from rosarch.models.selection import SelectedComponent


@dataclass(frozen=True)
class Question:
    """Components, or with `launches` the systems that these compose, and the rules that tell of them."""

    folder: Input
    packages: Packages = None
    component: Component = None
    launches: Systems = None
    own: Rules = None
    variants: Variants = None
    settings: Settings = None
    engine: EngineChoice = Engine.embedded
    jobs: Jobs = None
    defines: Defines = None
    timeout: Timeout = 60.0
    cached: Cached = True
    verbose: Verbose = False

    @property
    def systems(self) -> bool:
        """Whether it is about systems."""
        return bool(self.launches)

    def rules(self, *files: Path) -> RuleSet:
        """The rules, with files of the user's own."""
        return parse_rules([*files, *(self.own or ())], self.variants, self.settings)

    @contextmanager
    def asked(self, rules: RuleSet) -> Iterator[Sequence[SelectedComponent]]:
        """What it is about; none is an error."""
        if not self.launches:
            with selected(
                self.folder, self.packages, self.component, jobs=self.jobs, timeout=self.timeout, defines=self.defines,
                cached=self.cached, verbose=self.verbose, engine=self.engine,
            ) as components:  # fmt: skip
                yield components
            return
        if self.packages or self.component:
            raise InputError("--launch asks about whole systems; --package and --component are about components")
        from rosarch.models.selection import SelectedComponent

        inputs = SystemInputs(
            self.folder, self.launches, engine=self.engine, jobs=self.jobs, timeout=self.timeout, defines=parse_defines(self.defines),
            cached=self.cached, rules=rules,
        )  # fmt: skip
        shared, found = load_surrounding(inputs)
        show_diagnostics(shared.diagnostics, self.verbose)
        yield [SelectedComponent(launch.name, "", self.folder, partial(shared.rows, launch)) for launch in found]


def asks(*without: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a sub-command, whose first parameter is a Question, the arguments and options of one, but for those named here."""
    hints = get_type_hints(Question, include_extras=True)
    shared = [
        inspect.Parameter(
            field.name, inspect.Parameter.KEYWORD_ONLY, annotation=hints[field.name],
            default=inspect.Parameter.empty if field.default is MISSING else field.default,
        )
        for field in fields(Question)
        if field.name not in without
    ]  # fmt: skip

    def decorate(command: Callable[..., None]) -> Callable[..., None]:
        own = [p.replace(kind=p.KEYWORD_ONLY) for p in list(inspect.signature(command, eval_str=True).parameters.values())[1:]]
        names = [p.name for p in shared]
        at = 1 + names.index("settings")  # the folder, arguments of its own, what is asked about; options of its own, how that is read
        parameters = [shared[0], *(p for p in own if p.default is p.empty), *shared[1:at], *(p for p in own if p.default is not p.empty)]

        def ask(**given: Any) -> None:
            command(Question(**{name: given.pop(name) for name in names}), **given)

        ask.__name__, ask.__doc__ = command.__name__, command.__doc__
        ask.__signature__ = inspect.Signature([*parameters, *shared[at:]])  # type: ignore[attr-defined]
        ask.__annotations__ = {p.name: p.annotation for p in (*parameters, *shared[at:])}
        return ask

    return decorate
