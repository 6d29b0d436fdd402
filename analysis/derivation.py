"""What the rules derive of one component: by itself, and with configurations of its nodes; the models that are made of it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

from rosarch.analysis.method import Method
from rosarch.base.places import Place
from rosarch.extractor.stored_facts import Facts
from rosarch.models.component import UNUSED, ComponentModel, Relations, build_models
from rosarch.models.node_configuration import NodeConfiguration
from rosarch.models.openness import Unseen
from rosarch.rule_programs.sets import component_program, model_program

if TYPE_CHECKING:
    from rosarch.datalog import Result
    from rosarch.extractor.pipeline import ComponentFacts
    from rosarch.extractor.unit_store import Makers, UnitRows
    from rosarch.rule_programs.choice import RuleSet

Following = Callable[[Sequence[ComponentModel]], Iterable[NodeConfiguration]]
"""With which configurations a component is analysed, too, because of models of it."""
Configuration = NodeConfiguration | None
"""None stands for the component by itself."""
Made = tuple[Configuration, tuple[ComponentModel, ...]]
Derive = Callable[[Mapping[str, Any]], Relations]
Evaluate = Callable[[Mapping[str, Any]], "Result"]
Extracted: TypeAlias = "ComponentFacts | Facts"
Job = tuple[Extracted, Configuration]
Rows = Mapping[str, Any]

_LEFT_OUT = "left_out"
MORE_DECISIONS = 2
"""Decisions that others make possible are followed so far."""
MAX_ROUNDS = 12
"""With more elements in the loops of a component, their rounds are not derived one by one: each costs what the component costs, twice."""


@dataclass(frozen=True)
class Task:
    """Components that are made from the same sources, each with the configurations that models of it are wanted with.

    Those that follow from these models are wanted, too, if it `follows`.
    """

    parts: tuple[tuple[Extracted, tuple[Configuration, ...]], ...]
    follows: bool

    @property
    def size(self) -> int:
        """How much it is about."""
        return max(component.size for component, _ in self.parts)

    @property
    def jobs(self) -> list[Job]:
        """Each component with each of its configurations."""
        return [(component, configuration) for component, configurations in self.parts for configuration in configurations]

    @property
    def is_one(self) -> bool:
        """Whether it cannot be divided."""
        return len(self.jobs) == 1 and not self.follows

    def divided(self) -> Iterator[Task]:
        """The same, in tasks of one configuration each."""
        return (Task(((component, (configuration,)),), follows=False) for component, configuration in self.jobs)


def tasks_of(jobs: Iterable[Job], *, follows: bool) -> list[Task]:
    """Jobs as tasks."""
    parts: dict[int, tuple[Extracted, list[Configuration]]] = {}
    for component, configuration in jobs:
        parts.setdefault(id(component), (component, []))[1].append(configuration)
    together: dict[object, list[tuple[Extracted, tuple[Configuration, ...]]]] = {}
    for number, (component, configurations) in parts.items():
        together.setdefault(component.units or number, []).append((component, tuple(configurations)))
    return [Task(tuple(each), follows) for each in together.values()]


class Deriving:
    """Makes models of components by a method; `after` are the configurations that follow from models, if any."""

    def __init__(self, system: str, method: Method, after: Following | None) -> None:
        self.system = system
        self.engine = method.engine
        self.after = after
        self.program = model_program(method.rules)
        self.makers = _makers(method.rules) if method.sources.whole else None

    def models(self, task: Task) -> list[list[Made]]:
        """The models of each component of a task, with its configurations. What they have in common is derived once."""
        found: list[list[Made]] = []
        rows: Rows = {}
        files = self._files(task)
        with self._evaluations(task) as evaluate:
            for component, configurations in task.parts:
                # nothing of an unused source runs: there is nothing to derive
                rows = _sharing(_read(component, files), rows) if component.kind != UNUSED else {}
                found.append(list(self._of_component(component, configurations, rows, evaluate, files, follows=task.follows)))
        return found

    def _files(self, task: Task) -> UnitRows | None:
        """The files that the components of a task all consist of, where they are asked for more than once."""
        from rosarch.extractor.unit_store import UnitRows

        return UnitRows(task.parts[0][0].units) if len(task.parts) > 1 or self.makers else None

    def _evaluations(self, task: Task) -> AbstractContextManager[Evaluate]:
        """What evaluates the rules: it keeps rows where there is more to come than one component by itself."""
        if task.is_one and task.jobs[0][1] is None:
            return nullcontext(partial(self.program.evaluate, engine=self.engine))
        return self.program.series(engine=self.engine)

    def _of_component(
        self,
        component: Extracted,
        configurations: Iterable[Configuration],
        rows: Rows,
        evaluate: Evaluate,
        files: UnitRows | None,
        *,
        follows: bool,
    ) -> Iterator[Made]:
        def derive(facts: Mapping[str, Any]) -> Relations:
            return evaluate({**rows, **facts}).by_relation()

        waiting, done = list(configurations), set[Configuration]()
        while waiting:
            configuration = waiting.pop(0)
            if configuration in done:
                continue
            done.add(configuration)
            if configuration is None:
                models = self._alone(component, derive({}), files)
            else:
                models = self._configured(component, configuration, configured_rows(derive, rows["component"], configuration))
            for model in models:
                _ = model.rhythms  # found here, where other components are worked on at the same time
            yield configuration, models
            if follows and self.after:
                waiting += self.after(models)

    def _alone(self, component: Extracted, relations: Relations, files: UnitRows | None) -> tuple[ComponentModel, ...]:
        found = self._built(component, component.kind, relations)
        reason = UNUSED if component.kind == UNUSED else "uncalled"
        more = (Unseen("ports", reason, function, Place(*at)) for function, *at in _left_out(component, self.makers, files))
        return (replace(found[0], left_out=tuple(sorted({*found[0].left_out, *more}))), *found[1:])

    def _configured(self, component: Extracted, configuration: NodeConfiguration, relations: Relations) -> tuple[ComponentModel, ...]:
        found = self._built(component, "node" if configuration.entry else component.kind, relations)
        # of a program that makes several nodes, the one of this name
        own = next((model for model in found if model.executable and model.node_name == configuration.name), found[0])
        return (replace(own, configuration=configuration.key),)

    def _built(self, component: Extracted, kind: str, relations: Relations) -> tuple[ComponentModel, ...]:
        return build_models(self.system, component.name, component.package, kind, component.sources, relations)


def _read(component: Extracted, files: UnitRows | None) -> Rows:
    """The facts of a component; `files` are what its units hold, if that was read before."""
    from rosarch.extractor.pipeline import ComponentFacts

    return component.rows(files) if isinstance(component, ComponentFacts) else component.rows()


def _sharing(rows: Rows, before: Rows) -> Rows:
    """The rows of a component; those of relations that one before has, too, as the same object."""
    return {name: before[name] if name in before and before[name] == found else found for name, found in rows.items()}


def _left_out(component: Extracted, makers: Makers | None, files: UnitRows | None) -> Iterable[tuple[Any, ...]]:
    """Where code makes ports that no facts are kept of; of stored facts that is not known."""
    from rosarch.extractor.pipeline import ComponentFacts

    return component.left_out(makers, files) if makers and isinstance(component, ComponentFacts) else ()


def _makers(rules: RuleSet) -> Makers:
    """What makes ports, as the rules know it."""
    from rosarch.extractor.unit_store import Makers

    found = component_program(rules).evaluate({}, keep=["api_port", "makes_port_called"])
    return Makers(
        frozenset(str(row[0]) for row in found.rows("api_port")), frozenset(str(row[0]) for row in found.rows("makes_port_called"))
    )


def configured_rows(derive_of: Derive, component: Iterable[tuple[Any, ...]], configuration: NodeConfiguration) -> Relations:
    """What `derive_of` the facts of a configuration comes to; `component` has the row of the component.

    More than once: the conditions that the configuration decides rule out code, what is left may decide others, and nodes that the
    component makes inside of its own are analysed apart, which is only known when values are.
    """
    given: dict[str, Any] = configuration.rows()
    if configuration.entry:
        given["component"] = {(name, package, "plugin") for name, package, _ in component}

    def derive(facts: Mapping[str, Any]) -> Relations:
        return derive_of({**given, **facts})

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


def _by_rounds(found: Relations, derive: Derive) -> Relations:
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
