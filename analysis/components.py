"""From sources to component models: extraction, then the rules, one component at a time, in worker processes."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

from rosarch.analysis.cache import ModelCache
from rosarch.analysis.derivation import Configuration, Deriving, Extracted, Following, Job, Made, Task, tasks_of
from rosarch.analysis.method import PLAIN, Method
from rosarch.base.limits import LIMITS
from rosarch.base.pool import Failure, default_jobs, meanwhile, run_tasks
from rosarch.extractor.stored_facts import read_stored
from rosarch.models.component import ComponentModel, distinct
from rosarch.rule_programs.sets import is_loaded_soon, model_program, rules_digest

if TYPE_CHECKING:
    from rosarch.extractor.pipeline import ComponentFacts
    from rosarch.extractor.survey import Survey
    from rosarch.extractor.workspace import Component, Diagnostic
    from rosarch.extractor.workspace.built import Built


Configurations = Callable[[Extracted], Iterable[Configuration]]
"""With which configurations a component is analysed."""


@dataclass(frozen=True)
class Wanted:
    """Which models of components there shall be: those that are wanted `first`, and what comes `after` models of the component, if any."""

    first: Configurations = lambda _: (None,)
    after: Following | None = None


ALONE = Wanted()


@dataclass(frozen=True)
class Analysis:
    """The models of all components, sorted by package and name, and what was not understood on the way."""

    models: tuple[ComponentModel, ...]
    diagnostics: tuple[Diagnostic, ...]
    programs: frozenset[tuple[str, str]] = frozenset()
    builds: tuple[Built, ...] = ()


def analyze(
    root: Path,
    packages: Collection[str] | None = None,
    method: Method = PLAIN,
    *,
    only: Callable[[Component], bool] | None = None,
    wanted: Wanted = ALONE,
    surveyed: Survey | None = None,
) -> Analysis:
    """Analyse the components of `packages` (all by default) below `root`. See `extract` for `only` and `surveyed`."""
    rules, cache = method.rules, method.sources.cache
    with meanwhile(partial(model_program, rules)) if not is_loaded_soon(rules) else nullcontext(lambda: None) as rules_compiled:
        from rosarch.extractor.pipeline import extract  # takes a while itself, in which the rules are compiled

        system = root.resolve().name

        @lru_cache(maxsize=1)
        def kept() -> ModelCache | None:
            rules_compiled()
            told = rules_digest(rules) + " whole" * method.sources.whole
            return ModelCache(cache, system, method.engine, told) if cache else None

        def is_cached(component: ComponentFacts) -> bool:
            models = kept()
            return models is not None and _all_cached(models, component, wanted)

        with extract(root, packages, method.sources, only=only, is_cached=is_cached, surveyed=surveyed) as extraction:
            models, failures = _evaluate(system, extraction.components, root, method, kept(), wanted)
            return Analysis(models, (*extraction.diagnostics, *failures), extraction.programs, extraction.builds)


def analyze_facts(path: Path, method: Method = PLAIN) -> Analysis:
    """Analyse stored facts.

    Raises `ManifestError` when they are stale or damaged.
    """
    stored = read_stored(path)
    models, failures = _evaluate(stored.root.name, stored.components, path, method)
    return Analysis(models, (*stored.diagnostics, *failures))


def _all_cached(kept: ModelCache, component: ComponentFacts, wanted: Wanted) -> bool:
    """Whether all models that are wanted of a component were made before."""
    waiting, seen = list(wanted.first(component)), set()
    while waiting:
        configuration = waiting.pop()
        models = kept.load(_title(component), _key(component, configuration))
        if models is None:
            return False
        seen.add(configuration)
        waiting += [each for each in wanted.after(models) if each not in seen] if wanted.after else []
    return True


class _Found:
    """The models of components found so far, and what is still to be derived."""

    def __init__(self, wanted: Wanted, kept: ModelCache | None) -> None:
        self.wanted = wanted
        self.kept = kept
        self.models: dict[tuple[int, Configuration], tuple[ComponentModel, ...]] = {}
        self.asked: set[tuple[int, Configuration]] = set()
        self._open: list[Job] = []
        self._divided: list[Task] = []

    def want(self, component: Extracted, configurations: Iterable[Configuration]) -> None:
        """There shall be models of a component with these configurations: of earlier runs, or derived."""
        for configuration in configurations:
            if (id(component), configuration) not in self.asked:
                self.asked.add((id(component), configuration))
                known = self.kept.load(_title(component), _key(component, configuration)) if self.kept else None
                if known is None:
                    self._open.append((component, configuration))
                else:
                    self._take(component, configuration, known)

    def derived(self, component: Extracted, made: Sequence[Made]) -> None:
        """Models of a component have been derived."""
        self.asked.update((id(component), configuration) for configuration, _ in made)
        for configuration, models in made:
            if self.kept:
                self.kept.store(_title(component), _key(component, configuration), models)
            self._take(component, configuration, models)

    def divide(self, task: Task) -> None:
        """A task has failed: what it is about is derived one by one."""
        self._divided += task.divided()

    def tasks(self) -> list[Task]:
        """What is to be derived, since this was asked last."""
        tasks = [*self._divided, *tasks_of(self._open, follows=self.wanted.after is not None)]
        self._open, self._divided = [], []
        return tasks

    def _take(self, component: Extracted, configuration: Configuration, models: tuple[ComponentModel, ...]) -> None:
        if (id(component), configuration) not in self.models:
            self.models[id(component), configuration] = models
            if self.wanted.after:
                self.want(component, self.wanted.after(models))


def _evaluate(
    system: str,
    components: Sequence[Extracted],
    where: Path,
    method: Method,
    kept: ModelCache | None = None,
    wanted: Wanted = ALONE,
) -> tuple[tuple[ComponentModel, ...], list[Diagnostic]]:
    """The models of components, and what comes after these, in rounds."""
    from rosarch.base.diagnostics import Diagnostic

    found, failures = _Found(wanted, kept), list[Diagnostic]()
    for component in components:
        found.want(component, wanted.first(component))
    known = len(found.models)
    while tasks := found.tasks():
        for task, outcome in _derived(tasks, Deriving(system, method, wanted.after), method):
            if not isinstance(outcome, Failure):
                for (component, _), made in zip(task.parts, outcome, strict=True):
                    found.derived(component, made)
            elif task.is_one:
                detail = f"{_title(task.parts[0][0])} not analysed: {outcome.reason} ({outcome.detail})"
                failures.append(Diagnostic("component", where, 1, 1, detail))
            else:
                found.divide(task)
            if method.sources.progress:
                method.sources.progress("components", len(found.models) + len(failures), len(found.asked))
    if kept and len(found.models) > known:
        kept.cache.trim()
    models = [model for each in found.models.values() for model in each]
    return _told_once(distinct(models)), sorted(failures, key=str)


def _told_once(models: Iterable[ComponentModel]) -> tuple[ComponentModel, ...]:
    """The models, each with what is left out of all of them, once."""
    models = tuple(models)
    seen = {(port.at.path, port.at.line) for model in models for port in model.ports}
    told: list[ComponentModel] = []
    for model in models:
        own = [each for each in model.left_out if (each.at.path, each.at.line) not in seen]
        seen.update((each.at.path, each.at.line) for each in own)
        # the same object where nothing goes, so that it keeps the rhythms that were found for it
        told.append(replace(model, left_out=tuple(own)) if len(own) < len(model.left_out) else model)
    return tuple(told)


def _derived(tasks: Sequence[Task], deriving: Deriving, method: Method) -> Iterator[tuple[Task, list[list[Made]] | Failure]]:
    """What tasks come to, in worker processes."""
    largest_first = sorted(tasks, key=lambda task: -task.size)  # so that many processes end evenly

    def work(index: int) -> list[list[Made]]:
        return deriving.models(largest_first[index])

    numbers = range(len(tasks))
    for index, outcome in run_tasks(work, numbers, jobs=method.sources.jobs or default_jobs(), timeout=LIMITS.evaluation):
        yield largest_first[index], outcome


def _key(component: Extracted, configuration: Configuration) -> str | None:
    """The facts of a component, and its configuration."""
    if configuration is None or component.key is None:
        return component.key
    return f"{component.key} {configuration.key}"


def _title(component: Extracted) -> str:
    return f"{component.package}/{component.name}"
