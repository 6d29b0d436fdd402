"""What sub-commands are asked about, and how that is read: the arguments and options that several of them have, defined once."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import MISSING, dataclass, fields, replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, get_type_hints

from rosarch.base.limits import SOURCE_SECONDS
from rosarch.cli.check_options import load_configuration
from rosarch.cli.derivations import Component, datalog_errors, load_rules, selected
from rosarch.cli.errors import InputError
from rosarch.cli.inputs import check_engine, check_folder, extraction_cache, load_analysis
from rosarch.cli.options import (
    Cached,
    Defines,
    Engine,
    EngineChoice,
    Folder,
    Input,
    Jobs,
    Libraries,
    NoUnderlay,
    Packages,
    Timeout,
    Underlays,
    Verbose,
    installed,
    parse_defines,
)
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.systems import Environment, Launches, PackagePath, SystemInputs, Systems, load_shared_facts
from rosarch.cli.terminal import show_diagnostics

if TYPE_CHECKING:
    from rosarch.analysis.components import Analysis
    from rosarch.analysis.method import Method
    from rosarch.analysis.systems.shared import Launch, SharedFacts
    from rosarch.datalog import Program
    from rosarch.extractor.selection import SelectedComponent
    from rosarch.extractor.settings import Settings as SourceSettings
    from rosarch.extractor.underlay import Underlay
    from rosarch.rule_programs.choice import RuleSet
    from rosarch.rule_programs.sets import SystemRules


@dataclass(frozen=True, kw_only=True)
class ReadingOptions:
    """The options on rules, and on how sources are read."""

    own: Rules = None
    variants: Variants = None
    settings: Settings = None
    engine: EngineChoice = Engine.embedded
    jobs: Jobs = None
    defines: Defines = None
    timeout: Timeout = SOURCE_SECONDS
    underlays: Underlays = None
    no_underlay: NoUnderlay = False
    cached: Cached = True
    verbose: Verbose = False

    @cached_property
    def underlay(self) -> Underlay:
        """What is installed."""
        return installed(self.underlays, none=self.no_underlay)

    def rules(self, *files: Path) -> RuleSet:
        """The rules, with files of the user's own."""
        return parse_rules([*files, *(self.own or ())], self.variants, self.settings)

    def sources(self) -> SourceSettings:
        """How sources are read."""
        from rosarch.extractor.settings import Settings as SourceSettings

        return SourceSettings(self.jobs, self.timeout, parse_defines(self.defines), extraction_cache(self.cached), underlay=self.underlay)

    def method(self, rules: RuleSet, library: Sequence[Path] = ()) -> Method:
        """By what components and systems are analysed; some commands have `rules` that differ from those of the options."""
        from rosarch.analysis.method import Method
        from rosarch.library import prefixes

        sources = replace(self.sources(), underlay=replace(self.underlay, libraries=prefixes(library)))
        return Method(rules, self.engine.value, sources, library)

    def analysis(
        self, rules: RuleSet, folder: Path, packages: Sequence[str] | None, component: str | None = None, *, whole: bool = False
    ) -> Analysis:
        """The models of the components in a folder, by these rules; see `load_analysis`, and `Settings` for `whole`."""
        method = self.method(rules)
        return load_analysis(folder, packages, replace(method, sources=replace(method.sources, whole=whole)), component)

    def systems_in(self, folder: Path, launches: Sequence[str] | None, rules: RuleSet) -> SystemInputs:
        """Systems of a folder of sources."""
        return SystemInputs(folder, self.method(rules), launches)


@dataclass(frozen=True, kw_only=True)
class SystemQuestion(ReadingOptions):
    """Systems that launch files start."""

    folder: Folder
    launches: Launches = None
    package_path: PackagePath = None
    environment: Environment = None
    libraries: Libraries = None

    def inputs(self, rules: RuleSet) -> SystemInputs:
        """What is to be composed, by these rules."""
        return SystemInputs(self.folder, self.method(rules, self.libraries or ()), self.launches, self.package_path, self.environment)

    def program_and_facts(
        self, rules: RuleSet, config: Path | None = None, *, required: bool = False
    ) -> tuple[SystemRules, SharedFacts, list[Launch]]:
        """The program of these rules, what is known around the launches, and these; where `required`, none is an error."""
        from rosarch.rule_programs.checks import shipped_checks
        from rosarch.rule_programs.sets import system_rules

        folder = check_folder(self.folder)
        shared, launches = load_shared_facts(self.inputs(rules), load_configuration(folder, config, shipped_checks()))
        show_diagnostics(shared.diagnostics, self.verbose)
        if required and not launches:
            raise InputError(f"{folder}: no launch file below this folder")
        with datalog_errors():
            return system_rules(rules), shared, launches


@dataclass(frozen=True, kw_only=True)
class Question(ReadingOptions):
    """Components, or with `launches` the systems that these compose."""

    folder: Input
    packages: Packages = None
    component: Component = None
    launches: Systems = None

    @property
    def systems(self) -> bool:
        """Whether it is about systems."""
        return bool(self.launches)

    def asked_by(self, text: str) -> tuple[RuleSet, Program]:
        """The rules that a query or row is about, and the program of them."""
        from rosarch.models.traits import FLOW_TRAITS
        from rosarch.rule_programs.flows import rules_for

        rules = rules_for(self.rules(), text, FLOW_TRAITS, systems=self.systems)
        return rules, load_rules(rules, systems=self.systems)

    @contextmanager
    def asked(self, rules: RuleSet) -> Iterator[Sequence[SelectedComponent]]:
        """What it is about; none is an error."""
        if not self.launches:
            check_engine(self.engine.value)
            with selected(self.folder, self.packages, self.component, self.sources(), verbose=self.verbose) as components:
                yield components
            return
        if self.packages or self.component:
            raise InputError("--launch asks about whole systems; --package and --component are about components")
        from rosarch.extractor.selection import SelectedComponent

        shared, found = load_shared_facts(self.systems_in(self.folder, self.launches, rules))
        show_diagnostics(shared.diagnostics, self.verbose)
        yield [SelectedComponent(launch.name, "", self.folder, partial(shared.rows, launch)) for launch in found]


def asks(*without: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a sub-command the arguments and options of its first parameter, a Question or other ReadingOptions, but for those named here."""

    def decorate(command: Callable[..., None]) -> Callable[..., None]:
        first, *others = inspect.signature(command, eval_str=True).parameters.values()
        shared = [p for p in _parameters(first.annotation) if p.name not in without]
        own = [p.replace(kind=p.KEYWORD_ONLY) for p in others]
        how = [p for p in shared if p.name in _HOW]
        about = [p for p in shared if p.name not in _HOW]  # with the rules; then options of its own, and last how sources are read
        parameters = sorted([*about, *own], key=lambda p: (p.default is not p.empty, p not in about)) + how

        def ask(**given: Any) -> None:
            command(first.annotation(**{p.name: given.pop(p.name) for p in shared}), **given)

        ask.__name__, ask.__doc__ = command.__name__, command.__doc__
        ask.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        ask.__annotations__ = {p.name: p.annotation for p in parameters}
        return ask

    return decorate


_RULES = ("own", "variants", "settings")
_HOW = {field.name for field in fields(ReadingOptions)} - set(_RULES)


def _parameters(shape: type[ReadingOptions]) -> Iterator[inspect.Parameter]:
    """A parameter for each field, what is asked about first."""
    hints = get_type_hints(shape, include_extras=True)
    common = {field.name for field in fields(ReadingOptions)}
    for field in sorted(fields(shape), key=lambda field: field.name in common):
        default = inspect.Parameter.empty if field.default is MISSING else field.default
        yield inspect.Parameter(field.name, inspect.Parameter.KEYWORD_ONLY, annotation=hints[field.name], default=default)


Answer = TypeVar("Answer")


def answered(launches: Sequence[Launch], answer: Callable[[Launch], Answer]) -> list[tuple[str, Answer]]:
    """The answer for each system that has what is asked about, with the name of the system.

    Raises:
        InputError: none has it.
    """
    from rosarch.models.system.asking import QuestionError

    found: list[tuple[str, Answer]] = []
    problems: list[QuestionError] = []
    for launch in launches:
        try:
            found.append((launch.name, answer(launch)))
        except QuestionError as error:
            problems.append(error)
    if problems and not found:
        raise InputError(str(problems[0])) from None
    return found
