"""From sources to component models: extraction, then the rules, one component at a time, in worker processes."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.extractor.cache import Cache
from rosarch.extractor.limits import LIMITS, SOURCE_SECONDS
from rosarch.extractor.pool import Failure, default_jobs, meanwhile, run_tasks
from rosarch.extractor.stored import Facts, read_stored
from rosarch.models.cache import ModelCache
from rosarch.models.component import ComponentModel, Relations, build_models, distinct
from rosarch.models.rule_sets import SHIPPED, RuleSet, is_loaded_soon, model_program, rules_digest

if TYPE_CHECKING:
    from rosarch.extractor.pipeline import ComponentFacts
    from rosarch.extractor.units import Progress
    from rosarch.extractor.workspace import Component, Diagnostic
    from rosarch.extractor.workspace.built import Built


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
    *,
    rules: RuleSet = SHIPPED,
    engine: str = "embedded",
    jobs: int | None = None,
    timeout: float = SOURCE_SECONDS,
    defines: Mapping[str, str] | None = None,
    cache: Cache | None = None,
    progress: Progress | None = None,
    only: Callable[[Component], bool] | None = None,
) -> Analysis:
    """Analyse the components of `packages` (all by default) below `root` by `rules`. See `extract` for the other options."""
    with meanwhile(partial(model_program, rules)) if not is_loaded_soon(rules) else nullcontext(lambda: None) as rules_compiled:
        from rosarch.extractor.pipeline import extract  # takes a while itself, in which the rules are compiled

        system = root.resolve().name

        @lru_cache(maxsize=1)
        def kept() -> ModelCache | None:
            rules_compiled()
            return ModelCache(cache, system, engine, rules_digest(rules)) if cache else None

        def known(component: ComponentFacts) -> bool:
            models = kept()
            return models is not None and models.load(_title(component), component.key) is not None

        options: dict[str, Any] = {"jobs": jobs, "timeout": timeout, "defines": defines, "cache": cache, "progress": progress, "only": only}
        with extract(root, packages, known=known, **options) as extraction:
            models, failures = _evaluate(system, extraction.components, root, rules, engine, jobs, progress, kept())
            return Analysis(models, (*extraction.diagnostics, *failures), extraction.programs, extraction.builds)


def analyze_facts(
    path: Path, *, rules: RuleSet = SHIPPED, engine: str = "embedded", jobs: int | None = None, progress: Progress | None = None
) -> Analysis:
    """Analyse stored facts.

    Raises `ManifestError` when they are stale or damaged.
    """
    stored = read_stored(path)
    models, failures = _evaluate(stored.root.name, stored.components, path, rules, engine, jobs, progress)
    return Analysis(models, (*stored.diagnostics, *failures))


def _evaluate(
    system: str,
    components: Sequence[ComponentFacts | Facts],
    where: Path,
    rules: RuleSet,
    engine: str,
    jobs: int | None,
    progress: Progress | None,
    kept: ModelCache | None = None,
) -> tuple[tuple[ComponentModel, ...], list[Diagnostic]]:
    from rosarch.extractor.diagnostics import Diagnostic

    models: list[ComponentModel] = []
    failures: list[Diagnostic] = []
    waiting = []
    for component in components:
        known = kept.load(_title(component), component.key) if kept else None
        if known is None:
            waiting.append(component)
        else:
            models.extend(known)
    waiting_for = len(waiting)
    for component, outcome in _derived(waiting, rules, engine, jobs) if waiting else ():
        if isinstance(outcome, Failure):
            detail = f"{_title(component)} not analysed: {outcome.reason} ({outcome.detail})"
            failures.append(Diagnostic("component", where, 1, 1, detail))
        else:
            made = build_models(system, component.name, component.package, component.kind, component.sources, outcome)
            models.extend(made)
            if kept:
                kept.store(_title(component), component.key, made)
        if progress:
            waiting_for -= 1
            progress("components", len(components) - waiting_for, len(components))
    if kept and waiting:
        kept.cache.trim()
    return distinct(models), sorted(failures, key=str)


def _derived(
    components: Sequence[ComponentFacts | Facts], rules: RuleSet, engine: str, jobs: int | None
) -> Iterator[tuple[ComponentFacts | Facts, Relations | Failure]]:
    """What the rules derive of each component, in worker processes."""
    program = model_program(rules)
    largest_first = sorted(components, key=lambda each: -each.size)  # so that many processes end evenly

    def work(component: ComponentFacts | Facts) -> Relations:
        return program.evaluate(component.rows(), engine=engine).all_rows()

    for index, outcome in run_tasks(work, largest_first, jobs=jobs or default_jobs(), timeout=LIMITS.evaluation):
        yield largest_first[index], outcome


def _title(component: ComponentFacts | Facts) -> str:
    return f"{component.package}/{component.name}"
