"""From sources to component models: extraction, then the rules, one component at a time, in worker processes."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.analysis.cache import ModelCache
from rosarch.analysis.method import PLAIN, Method
from rosarch.base.limits import LIMITS
from rosarch.base.places import Place
from rosarch.base.pool import Failure, default_jobs, meanwhile, run_tasks
from rosarch.extractor.stored_facts import Facts, read_stored
from rosarch.models.component import UNUSED, ComponentModel, Relations, build_models, distinct
from rosarch.models.node_configuration import NodeConfiguration
from rosarch.models.openness import Unseen
from rosarch.rule_programs.sets import component_program, is_loaded_soon, model_program, rules_digest

if TYPE_CHECKING:
    from rosarch.datalog import Program
    from rosarch.extractor.pipeline import ComponentFacts
    from rosarch.extractor.unit_store import Makers
    from rosarch.extractor.workspace import Component, Diagnostic
    from rosarch.extractor.workspace.built import Built
    from rosarch.rule_programs.choice import RuleSet


Configurations = Callable[["ComponentFacts | Facts"], Iterable[NodeConfiguration | None]]
"""With which configurations a component is analysed; None stands for the component by itself."""
Following = Callable[[Sequence[ComponentModel]], Iterable[NodeConfiguration]]
"""With which configurations a component is analysed, too, because of models of it."""


@dataclass(frozen=True)
class Wanted:
    """Which models of components there shall be: those that are wanted `first`, and what comes `after` models of the component."""

    first: Configurations = lambda _: (None,)
    after: Following = lambda _: ()


ALONE = Wanted()
_LEFT_OUT = "left_out"
MORE_DECISIONS = 2
"""Decisions that others make possible are followed so far."""
MAX_ROUNDS = 12
"""With more elements in the loops of a component, their rounds are not derived one by one: each costs what the component costs, twice."""


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
) -> Analysis:
    """Analyse the components of `packages` (all by default) below `root`. See `extract` for `only`."""
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

        with extract(root, packages, method.sources, only=only, is_cached=is_cached) as extraction:
            models, failures = _evaluate(system, extraction.components, root, method, kept(), wanted)
            return Analysis(models, (*extraction.diagnostics, *failures), extraction.programs, extraction.builds)


def analyze_facts(path: Path, method: Method = PLAIN) -> Analysis:
    """Analyse stored facts.

    Raises `ManifestError` when they are stale or damaged.
    """
    stored = read_stored(path)
    models, failures = _evaluate(stored.root.name, stored.components, path, method)
    return Analysis(models, (*stored.diagnostics, *failures))


_Job = tuple["ComponentFacts | Facts", NodeConfiguration | None]


def _all_cached(kept: ModelCache, component: ComponentFacts, wanted: Wanted) -> bool:
    """Whether all models that are wanted of a component were made before."""
    waiting, seen = list(wanted.first(component)), set()
    while waiting:
        configuration = waiting.pop()
        models = kept.load(_title(component), _key(component, configuration))
        if models is None:
            return False
        seen.add(configuration)
        waiting += [each for each in wanted.after(models) if each not in seen]
    return True


def _evaluate(
    system: str,
    components: Sequence[ComponentFacts | Facts],
    where: Path,
    method: Method,
    kept: ModelCache | None = None,
    wanted: Wanted = ALONE,
) -> tuple[tuple[ComponentModel, ...], list[Diagnostic]]:
    """The models of components, and what comes after these, in rounds."""
    from rosarch.base.diagnostics import Diagnostic

    models: list[ComponentModel] = []
    failures: list[Diagnostic] = []
    seen: set[tuple[int, NodeConfiguration | None]] = set()
    open_: list[_Job] = []

    def add(component: ComponentFacts | Facts, configurations: Iterable[NodeConfiguration | None]) -> None:
        for configuration in configurations:
            if (id(component), configuration) in seen:
                continue
            seen.add((id(component), configuration))
            known = kept.load(_title(component), _key(component, configuration)) if kept else None
            if known is None:
                open_.append((component, configuration))
            else:
                made(component, known)

    def made(component: ComponentFacts | Facts, found: Sequence[ComponentModel]) -> None:
        models.extend(found)
        add(component, wanted.after(found))

    for component in components:
        add(component, wanted.first(component))
    changed = bool(open_)
    while open_:
        waiting, open_ = open_, []
        for (component, configuration), outcome in _derived(waiting, method):
            if isinstance(outcome, Failure):
                detail = f"{_title(component)} not analysed: {outcome.reason} ({outcome.detail})"
                failures.append(Diagnostic("component", where, 1, 1, detail))
            else:
                found = _models(system, component, configuration, outcome)
                if kept:
                    kept.store(_title(component), _key(component, configuration), found)
                made(component, found)
            if method.sources.progress:
                method.sources.progress("components", len(seen) - len(open_), len(seen))
    if kept and changed:
        kept.cache.trim()
    return _told_once(distinct(models)), sorted(failures, key=str)


def _told_once(models: Iterable[ComponentModel]) -> tuple[ComponentModel, ...]:
    """The models, each with what is left out of all of them, once."""
    models = tuple(models)
    seen = {(port.at.path, port.at.line) for model in models for port in model.ports}
    told: list[ComponentModel] = []
    for model in models:
        own = [each for each in model.left_out if (each.at.path, each.at.line) not in seen]
        seen.update((each.at.path, each.at.line) for each in own)
        told.append(replace(model, left_out=tuple(own)))
    return tuple(told)


def _models(
    system: str, component: ComponentFacts | Facts, configuration: NodeConfiguration | None, relations: Relations
) -> tuple[ComponentModel, ...]:
    kind = "node" if configuration and configuration.entry else component.kind
    found = build_models(system, component.name, component.package, kind, component.sources, relations)
    if configuration is None:
        reason = UNUSED if kind == UNUSED else "uncalled"
        more = (Unseen("ports", reason, function, Place(*at)) for function, *at in relations.get(_LEFT_OUT, ()))
        return (replace(found[0], left_out=tuple(sorted({*found[0].left_out, *more}))), *found[1:])
    # of a program that makes several nodes, the one of this name
    own = next((model for model in found if model.executable and model.node_name == configuration.name), found[0])
    return (replace(own, configuration=configuration.key),)


def _derived(jobs_open: Sequence[_Job], method: Method) -> Iterator[tuple[_Job, Relations | Failure]]:
    """What the rules derive of each component, in worker processes."""
    program, engine = model_program(method.rules), method.engine
    makers = _makers(method.rules) if method.sources.whole else None
    largest_first = sorted(jobs_open, key=lambda job: -job[0].size)  # so that many processes end evenly

    def work(job: _Job) -> Relations:
        component, configuration = job
        if configuration is None:
            # nothing of an unused source runs: there is nothing to derive
            rows = component.rows() if component.kind != UNUSED else {}
            return {**program.evaluate(rows, engine=engine).all_rows(), _LEFT_OUT: _left_out(component, makers)}
        return configured_rows(program, component.rows(), configuration, engine)

    for index, outcome in run_tasks(work, largest_first, jobs=method.sources.jobs or default_jobs(), timeout=LIMITS.evaluation):
        yield largest_first[index], outcome


def _left_out(component: ComponentFacts | Facts, makers: Makers | None) -> Iterable[tuple[Any, ...]]:
    """Where code makes ports that no facts are kept of; of stored facts that is not known."""
    from rosarch.extractor.pipeline import ComponentFacts

    return component.left_out(makers) if makers and isinstance(component, ComponentFacts) else ()


def _makers(rules: RuleSet) -> Makers:
    """What makes ports, as the rules know it."""
    from rosarch.extractor.unit_store import Makers

    found = component_program(rules).evaluate({}, keep=["api_port", "makes_port_called"])
    return Makers(
        frozenset(str(row[0]) for row in found.rows("api_port")), frozenset(str(row[0]) for row in found.rows("makes_port_called"))
    )


def configured_rows(
    program: Program, rows: Mapping[str, Iterable[tuple[Any, ...]]], configuration: NodeConfiguration, engine: str
) -> Relations:
    """What the rules derive of a component with a configuration.

    More than once: the conditions that the configuration decides rule out code, what is left may decide others, and nodes that the
    component makes inside of its own are analysed apart, which is only known when values are.
    """
    given: dict[str, Any] = {**rows, **configuration.rows()}
    if configuration.entry:
        given["component"] = {(name, package, "plugin") for name, package, _ in rows["component"]}

    def derive(facts: Mapping[str, Any]) -> Relations:
        return program.evaluate({**given, **facts}, engine=engine).all_rows()

    found = first = derive({})
    decided = _decided(first)
    given["configured_apart"] = apart = {(class_,) for _, class_, _ in first["inner_node"]}
    if apart and decided["configured_condition_in"]:
        first = derive({**decided, "configured_apart": ()})
    if apart or any(decided.values()):
        found = derive(decided)
        for _ in range(MORE_DECISIONS):
            further = {name: decided[name] | rows for name, rows in _decided(found).items()}
            if further == decided:
                break
            decided = further
            found = derive(decided)
        found = {**found, **{name: first[name] for name in ("inner_node", "inner_namespace", "inner_given")}}
    return _by_rounds(found, derive)


def _decided(found: Relations) -> dict[str, set[tuple[Any, ...]]]:
    return {"configured_condition": set(found["decided"]), "configured_condition_in": set(found["decided_in"])}


def _by_rounds(found: Relations, derive: Callable[[Mapping[str, Any]], Relations]) -> Relations:
    """What was found, without the ports, and types of ports, that no round of a loop over known elements makes: its texts were mixed.

    A round is derived alone where conditions come to both values for texts that are known.
    """
    elements: dict[str, set[str]] = {}
    for variable, text in found["round_of_loop"]:
        elements.setdefault(variable, set()).add(text)
    loops = {variable: texts for variable, texts in elements.items() if len(texts) > 1 and "?" not in texts}
    if not found["undecided_by_texts"] or sum(map(len, loops.values())) > MAX_ROUNDS:
        return found
    for variable, texts in sorted(loops.items()):
        ports: set[tuple[Any, ...]] = set()
        types: set[tuple[Any, ...]] = set()
        for text in sorted(texts):
            round_ = {"configured_round": {(variable, text)}}
            own = derive({**round_, **_decided(derive(round_))})
            ports |= set(own["port"])
            types |= set(own["port_type"])
        found = _without(found, ports, types)
    return found


def _without(found: Relations, ports: Set[tuple[Any, ...]], types: Set[tuple[Any, ...]]) -> Relations:
    """The rows without those of other ports than `ports`, and of other types than `types`."""
    gone = {port for (port,) in set(found["port"]) - ports}
    kept = {name: {row for row in rows if gone.isdisjoint(row)} for name, rows in found.items()} if gone else dict(found)
    return {**kept, "port_type": set(kept["port_type"]) & types}


def _key(component: ComponentFacts | Facts, configuration: NodeConfiguration | None) -> str | None:
    """The facts of a component, and its configuration."""
    if configuration is None or component.key is None:
        return component.key
    return f"{component.key} {configuration.key}"


def _title(component: ComponentFacts | Facts) -> str:
    return f"{component.package}/{component.name}"
