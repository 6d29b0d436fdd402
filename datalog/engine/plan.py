"""A compiled program: what is cached and evaluated, independent of the syntax tree."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from rosarch.datalog.engine.indexes import Index


@dataclass(frozen=True, slots=True)
class Origin:
    """All keys that a rule asks an index for have in `column` a value of another column, which may be few."""

    column: int
    relation: str
    values: int  # the other column


@dataclass(frozen=True, slots=True)
class Rule:
    """A generated function, the slots it works on, and where it comes from."""

    function: str
    target: str
    location: str  # path:line:col of the clause
    delta: str  # the relation whose delta it scans, if any
    required: tuple[int, ...]  # relations without which it derives nothing
    relations: tuple[int, ...]  # arguments of the function, followed by the indexes
    indexes: tuple[tuple[int, tuple[Origin, ...]], ...]
    tables: tuple[int, ...] = ()  # arguments that follow the indexes


@dataclass(frozen=True, slots=True)
class Grouping:
    """The pairs of a relation by their first column, or by their second when it is `reversed`."""

    relation: int  # slot
    reversed: bool


@dataclass(frozen=True, slots=True)
class BulkRule:
    """A generated function for one version of a clause; it gets the delta and what it looks up grouped as the plan says."""

    function: str
    target: str
    location: str
    delta: str
    delta_reversed: bool
    groupings: tuple[Grouping, ...]


@dataclass(frozen=True, slots=True)
class Member:
    """A relation of a stratum: its slots, and the indexes to maintain while the stratum grows."""

    name: str
    full: int
    indexes: tuple[int, ...]
    counts: bool = False  # of one column of numbers
    choices: tuple[tuple[int, ...], ...] = ()
    subsumption: tuple[Rule, ...] = ()
    limit: int = 0  # rows after which its stratum is left, if any


@dataclass(frozen=True, slots=True)
class Stratum:
    """Relations that depend on each other: rules to run once, and rules to run until nothing is new.

    `staged`: the rows of a round become visible only at its end, all together.
    """

    members: tuple[Member, ...]
    base: tuple[Rule, ...]
    loop: tuple[Rule, ...]
    staged: bool = False
    bulk: tuple[BulkRule, ...] = ()  # the loop once more, over bitmaps, where all rules are over pairs
    drops: tuple[int, ...] = ()  # slots of relations and indexes that no later stratum reads

    def rules(self) -> tuple[Rule, ...]:
        """All rules of the stratum."""
        return (*self.base, *self.loop, *(rule for member in self.members for rule in member.subsumption))

    @property
    def chooses(self) -> bool:
        """Whether base rules write to the new rows instead of the relation."""
        return any(m.choices for m in self.members)


@dataclass(frozen=True, slots=True)
class TablePlan:
    """How the rows of a relation that have a key are found when they are asked for.

    A table has what `keys` leave of its rows: the value of the only other column, or the whole row, or nothing but that there is one.
    `recursive`: rules ask the table itself. `loop`: rules that find further rows of a key from those that are new. `whole`: the rules that
    derive all rows of the relation, for when many keys are asked for; None when there are none.
    """

    relation: str
    arity: int
    keys: tuple[int, ...]
    rules: tuple[Rule, ...]
    recursive: bool = False
    loop: tuple[Rule, ...] = ()
    whole: Stratum | None = None

    def keyed_rules(self) -> tuple[Rule, ...]:
        """The rules that find the rows of a key."""
        return (*self.rules, *self.loop)

    def all_rules(self) -> tuple[Rule, ...]:
        """These, and the rules that find all rows."""
        return (*self.keyed_rules(), *(self.whole.rules() if self.whole else ()))


@dataclass(slots=True)
class Code:
    """What is cached: everything needed to evaluate, independent of the syntax tree."""

    source: str = ""
    bulk_source: str = ""  # the functions of bulk rules, compiled when they are needed
    strata: list[Stratum] = field(default_factory=list)
    facts: dict[str, list[Any]] = field(default_factory=dict)
    relation_slot: dict[str, int] = field(default_factory=dict)
    arity: dict[str, int] = field(default_factory=dict)
    nested: dict[str, tuple[int, ...]] = field(default_factory=dict)  # columns of records, of relations that have some
    indexes: tuple[Index, ...] = ()  # their slots follow those of the relations
    tables: tuple[TablePlan, ...] = ()  # their slots follow those of the indexes
    derived: frozenset[str] = frozenset()  # relations to which rules and facts of the program add rows
    probed: frozenset[str] = frozenset()  # relations that are asked whether they have a row
    uses_ordinals: bool = False
    counts: bool = False  # rows depend on how often rules have been evaluated

    def relations_of(self, rule: Rule) -> set[int]:
        """The slots of the relations that a rule reads, but for those that it asks tables for."""
        indexes = (self.indexes[slot - len(self.relation_slot)].relation for slot, _ in rule.indexes)
        return {*rule.required, *rule.relations, *indexes}
