"""The finite part of a node's state: which variables, or fields of them, have distinguishable values, and which those are."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from rosarch.base.logic import atoms
from rosarch.models.machine.conditions import (
    NULL,
    Comparison,
    Condition,
    Operand,
    boolean_sides,
    choice,
    chosen_sides,
    compact,
    constant,
    is_name,
    number,
    parse_condition,
    strip,
)
from rosarch.models.machine.counting import (
    WIDE,
    Arithmetic,
    Counting,
    arithmetic,
    calculated,
    counting,
    is_integer,
    step,
    stepped,
    stored,
    whole,
    width,
)
from rosarch.models.machine.limits import MOST_LIMITS, NO_NUMBER, are_ranges, is_path, range_of, ranges
from rosarch.models.machine.logic import BOOLEAN, OTHER, Subject
from rosarch.models.machine.pointers import asked_object, begins_null, is_nothing, may_be_null

Document = Mapping[str, Any]
EMPTY = ".empty()"
_PATH = re.compile(r"((?:::)?[A-Za-z_][\w:]*(?:\.\w+)*)((?:\.(?:empty|size|length)\(\))?)")
_QUALIFIERS = re.compile(r"\b(const|volatile|static|mutable|std::)\s*|std::atomic<(.*)>|\batomic<(.*)>|\batomic_(?=bool)")
_INTEGER = re.compile(r"(unsigned|signed|short|long|int|char|u?int\d+_t|size_t|std::size_t|float|double)( (int|char|long|double|short))*")
_SIZES = (".size()", ".length()")
_LENGTH = re.compile(r"^len\((.*)\)$")
_TRUE_WHEN_FILLED = ("list", "dict", "set", "collections::deque")
_LISTS = r"^$|\b(vector|deque|list|queue|stack)\b"  # Python sources give no types
EMPTIES = re.compile(r"(?:\.|->)clear\(\)|^(?:list|dict|set|deque|str|string)\((?:maxlen=[\w.]+)?\)$|^\{\}$|^\[\]$|^\"\"$")


@dataclass(frozen=True)
class Cell:
    """A state variable, or a field of one, with its finitely many values; `subject` stands for it in conditions.

    `initial` are the values it may begin with, several when the source does not say. `at` is the line of its first value. `counting` is
    how it is counted, if it is.
    """

    subject: Subject
    variable: str
    suffix: str
    type: str
    initial: tuple[str, ...]
    at: str
    counting: Counting | None = None

    def value_of(self, text: str) -> str | None:
        """The value that a constant in the source is here, `None` when the text is no constant."""
        if self.counting:
            number = whole(text)
            return None if number is None else self.counting.name(number)
        if NULL in self.subject.values and is_nothing(self.type, text):
            return NULL
        return value_in(text, self.subject.values)

    def nearest(self, value: str) -> str | None:
        """A value as one of this cell's: itself, or `OTHER`, or `None` when this cell has nothing like it."""
        return _nearest(value, self.subject.values)


def value_in(text: object, values: Sequence[str]) -> str | None:
    """A constant as one of `values`; None when it is none, or not distinguished."""
    found = None if text is None else constant(str(text))
    if found is None:
        return None
    size = number(found)
    if size is not None and are_ranges(values):
        return range_of(size, values)
    if size is not None and tuple(values) == BOOLEAN:
        found = "false" if size == 0 else "true"
    return _nearest(found, values)


def _nearest(value: str, values: Sequence[str]) -> str | None:
    if value in values:
        return value
    return OTHER if OTHER in values else None


def nonzero(values: Iterable[str]) -> frozenset[str] | None:
    """The values that count as true; None where no value counts as false, or one is a name of which that is not known."""
    known = frozenset(values)
    zeros = known & {NULL, "0", "false", "''", '""'}
    return known - zeros if zeros and not any(map(is_name, known - zeros - {OTHER})) else None


@dataclass
class _Draft:
    """What is found about a cell, or an input, before its values are settled."""

    constants: dict[str, None] = field(default_factory=dict)  # compared with, or assigned, in the order of the document
    tested: bool = False
    assigned: bool = False
    open: bool = False  # may take values that no constant names
    copies: set[tuple[str, str]] = field(default_factory=set)
    inputs: set[str] = field(default_factory=set)  # that it takes values from or is compared with
    asked: list[tuple[Arithmetic, int]] = field(default_factory=list)  # comparisons with whole numbers
    given: list[str | None] = field(default_factory=list)  # the texts that are assigned
    truth_compared: bool = False  # with True or False, which are one and zero among numbers
    compared: bool = False  # with something that is no number
    limits: set[float] = field(default_factory=set)  # that it is compared with by size


Place = tuple[str, str]  # the name of a variable, and `""`, `.field` or `.empty()`


class Locator:
    """Finds the variable that an operand in a condition names."""

    def __init__(self, names: Iterable[str]) -> None:
        self._by_last: dict[str, list[str]] = {}
        for name in names:
            self._by_last.setdefault(name.rsplit("::", 1)[-1], []).append(name)

    def is_unique(self, name: str) -> bool:
        """Whether no other variable has the same last name."""
        return len(self._by_last[name.rsplit("::", 1)[-1]]) == 1

    def locate(self, text: str, owner: str) -> Place | None:
        """The variable and the field of it, seen from a member of the class `owner`; nothing for what is no state variable."""
        match = _PATH.fullmatch(_LENGTH.sub(r"\1.size()", asked_object(compact(text)).replace("->", ".")))
        if not match:
            return None
        parts = match.group(1).split(".")
        call = match.group(2)
        for index, part in enumerate(parts):
            known = self._by_last.get(part.rsplit("::", 1)[-1], [])
            found = [name for name in known if self._fits(name, part, parts[:index])]
            if len(found) > 1:
                found = [name for name in found if _owner(name) == owner]
            if len(found) == 1:
                suffix = "".join(f".{part}" for part in parts[index + 1 :])
                return found[0], suffix + (EMPTY if call in (EMPTY, *_SIZES) else "")
        return None

    @staticmethod
    def _fits(name: str, part: str, before: list[str]) -> bool:
        """Whether an access could be to this variable: by its bare or qualified name, or in an object named after its class."""
        if "::" in part and not f"::{name.lstrip(':')}".endswith(f"::{part.lstrip(':')}"):
            return False
        if not before:
            return True
        class_, holder = _letters(_owner(name)), _letters(before[-1])
        return bool(class_ and holder) and (class_ in holder or holder in class_)


def _owner(name: str) -> str:
    return name.rpartition("::")[0].rsplit("::", 1)[-1]


def _letters(text: str) -> str:
    return re.sub(r"[^a-z]|^[mg]_", "", text.lower())


class Domains:
    """The cells of a component, and the values of its inputs that conditions distinguish.

    Variables that count have each number as a value, as far as conditions distinguish them and these are no more than `counts`. Where there
    are `limits`, other numbers lie in ranges between those that conditions compare them with.
    """

    def __init__(self, document: Document, *, counts: int = 0, limits: bool = False) -> None:
        self._counts, self._limited = counts, limits
        begins = (document.get("traits") or {}).get("field_begins", ())
        self._fields = {(str(name), str(path)): str(value) for name, path, value in begins}
        repeated = (document.get("traits") or {}).get("repeated", ()) if counts else ()
        self._unknown = {str(place) for (place,) in (*repeated, *(document.get("traits") or {}).get("converted", ()))}
        self._variables = {v["name"]: v for v in reversed(document.get("state_variables") or ())}
        self._order = list(dict.fromkeys(v["name"] for v in document.get("state_variables") or ()))
        self.locator = Locator(self._order)
        self._drafts: dict[Place, _Draft] = {}
        self._inputs: dict[str, _Draft] = {}
        rows = [row for row in document.get("transitions") or () if row.get("variable")]
        self._assignments = [(*variable_and_field(row, self._variables), self.assigned(row)) for row in rows]
        for owner, text in _conditions(document):
            self._read_condition(parse_condition(text), owner)
        self._read_assignments()
        self.cells = {cell.subject.key: cell for cell in self._settle()}
        self._by_place = {(cell.variable, cell.suffix): cell for cell in self.cells.values()}

    def cell(self, place: Place | None) -> Cell | None:
        """The cell at a place, if its values are finitely many."""
        return self._by_place.get(place) if place else None

    def cells_of(self, variable: str) -> list[Cell]:
        """The cells of a variable: itself or fields of it."""
        return [cell for cell in self.cells.values() if cell.variable == variable]

    def left_out(self) -> list[str]:
        """The state variables without a cell."""
        return [name for name in self._order if not self.cells_of(name)]

    def input(self, text: str) -> Subject:
        """An input as a subject."""
        draft = self._inputs.get(compact(text), _Draft())
        if (limits := self._limits(draft)) and is_path(compact(text)):
            return Subject(compact(text), strip(text), ranges(limits))
        return Subject(compact(text), strip(text), _values(draft.constants, True) if draft.constants.keys() - set(BOOLEAN) else BOOLEAN)

    def tested(self, text: str, owner: str) -> str:
        """What is not zero where an operand is true: of a container of Python, its size."""
        place = self.locator.locate(text, owner)
        filled = place and not place[1] and _plain_type(self._variables[place[0]]) in _TRUE_WHEN_FILLED
        return f"{text}.size()" if filled else text

    def constant(self, text: str, owner: str) -> str | None:
        """The constant that a text denotes: none where a state variable is called as constants are."""
        known = constant(text)
        return None if known is None or (is_name(known) and self.locator.locate(text, owner)) else known

    def assigned(self, row: Mapping[str, Any]) -> str | None:
        """What a row gives its variable, as a number of its type.

        Of what may be done several times in a row, or is a number of another type, that is known for constants only.
        """
        text: str | None = row.get("value_normal") or row.get("value")
        if text is not None and constant(text) is None and not self._unknown.isdisjoint(str(row.get("at")).split()):
            return None
        variable, suffix = variable_and_field(row, self._variables)
        return stored(_plain_type(self._variables[variable]), text) if text and not suffix and variable in self._variables else text

    def _read_condition(self, condition: Condition, owner: str) -> None:
        for leaf in atoms(condition):
            if isinstance(leaf, Operand):
                asked = self.tested(leaf.text, owner)
                self._read_numbers((asked, "0"), owner)
                self._draft(asked, owner).tested = True
            elif isinstance(leaf, Comparison):
                self._read_numbers((leaf.left, leaf.right), owner)
                self._read_comparison(leaf, owner)

    def _read_comparison(self, asked: Comparison, owner: str) -> None:
        if sides := chosen_sides(asked) or boolean_sides(asked):
            for part in sides:
                self._read_condition(part, owner)
        elif asked.op == "==" and asked.right in ("True", "False"):
            draft = self._draft(asked.left, owner)
            draft.tested = draft.truth_compared = True
        elif asked.op in ("==", "is"):
            self._read_equality(asked.left, asked.right, owner)
        else:
            if self._limited and (limit := number(asked.right)) is not None and is_path(compact(asked.left)):
                self._draft(asked.left, owner).limits.add(limit)
            for side in (asked.left, asked.right):
                place = self.locator.locate(side, owner)
                if place and place[1].endswith(EMPTY):
                    self._drafts.setdefault(place, _Draft()).tested = True

    def _read_numbers(self, sides: tuple[str, str], owner: str) -> None:
        asked = calculated(*sides)
        place = self.locator.locate(asked[0].name, owner) if asked else None
        if asked and place:
            self._drafts.setdefault(place, _Draft()).asked.append(asked)
        for side in () if place else sides:
            if (part := arithmetic(side)) and (other := self.locator.locate(part.name, owner)):
                self._drafts.setdefault(other, _Draft()).compared = True

    def _read_equality(self, left: str, right: str, owner: str) -> None:
        draft, value = self._draft(left, owner), self.constant(right, owner)
        if value is not None:
            draft.constants[value] = None
            return
        here, there = self.locator.locate(left, owner), self.locator.locate(right, owner)
        if here and there:  # the values of one are worth distinguishing in the other
            self._drafts.setdefault(here, _Draft()).copies.add(there)
            self._drafts.setdefault(there, _Draft()).copies.add(here)
        elif here or there:
            self._draft(left if here else right, owner).inputs.add(compact(right if here else left))

    def _draft(self, text: str, owner: str) -> _Draft:
        place = self.locator.locate(text, owner)
        return self._drafts.setdefault(place, _Draft()) if place else self._inputs.setdefault(compact(text), _Draft())

    def _read_assignments(self) -> None:
        for variable, suffix, _value in self._assignments:
            if variable in self._variables:
                self._drafts.setdefault((variable, suffix), _Draft())
        for variable, suffix, value in self._assignments:
            for place in [place for place in self._drafts if place[0] == variable]:
                if place[1] == suffix:
                    self._read_value(self._drafts[place], value, _owner(variable))
                elif place[1].startswith(suffix) or suffix.startswith(place[1]):
                    self._drafts[place].open = self._drafts[place].assigned = True
                    self._drafts[place].given.append(value if place[1] == suffix + EMPTY else None)
                    if value and (part := part_text(value, place[1][len(suffix) :])):
                        self._drafts[place].inputs.add(compact(part))

    def _read_value(self, draft: _Draft, value: str | None, owner: str) -> None:
        draft.assigned = True
        draft.given.append(value)
        if value is None:
            draft.open = True
        elif (known := self.constant(value, owner)) is not None:
            draft.constants[known] = None
        elif place := self.locator.locate(value, owner):
            draft.copies.add(place)
        elif chosen := choice(value):
            self._read_condition(parse_condition(chosen[0]), owner)
            for text in chosen[1:]:
                self._read_value(draft, text, owner)
            draft.given.append(None)
        else:
            draft.open = True
            draft.inputs.add(compact(value))
            if not (self._counts and step(value)):
                self._read_condition(parse_condition(value), owner)

    def _share_limits(self) -> None:
        """What is copied is distinguished as finely where it comes from as where it goes to."""
        changed = True
        while changed:
            changed = False
            for draft in self._drafts.values():
                others = [self._drafts[place] for place in draft.copies if place in self._drafts]
                others += [self._inputs.setdefault(key, _Draft()) for key in draft.inputs if draft.limits and is_path(key)]
                for other in others:
                    if other.limits != draft.limits:
                        other.limits |= draft.limits
                        draft.limits |= other.limits
                        changed = True

    @staticmethod
    def _limits(draft: _Draft) -> set[float]:
        """The limits between which the values of a number are distinguished; none for too many, or where it is compared with no number."""
        sizes = [number(constant) for constant in (*draft.constants, *(("0",) if draft.tested else ()))]
        found = {size for size in sizes if size is not None} | draft.limits
        return found if draft.limits and None not in sizes and len(found) <= MOST_LIMITS else set()

    def _ranges(self, place: Place, limits: Iterable[float]) -> tuple[str, ...]:
        """The ranges that a variable may be in: a whole number is always in one."""
        is_whole = place[1] == "" and is_integer(_plain_type(self._variables[place[0]]))
        return tuple(value for value in ranges(limits) if not (is_whole and value == NO_NUMBER))

    def _settle(self) -> Iterator[Cell]:
        self._share_limits()
        distinct = {place for place, draft in self._drafts.items() if draft.constants or draft.tested}
        for place, draft in self._drafts.items():
            first = self._initial(place)
            draft.constants = dict.fromkeys([*([first] if first is not None else ()), *draft.constants])
            draft.open |= first is None
            if draft.truth_compared and draft.constants.keys() - {*BOOLEAN, NULL}:
                draft.constants |= dict.fromkeys(("0", "1"))
        changed = True
        while changed:
            changed = False
            for here, draft in self._drafts.items():
                for source in (self._drafts.get(place, _Draft(open=True)) for place in sorted(draft.copies)):
                    before = len(draft.constants), draft.open
                    draft.constants.update(source.constants)
                    draft.open |= source.open
                    distinct |= {place for place in [here] if distinct & draft.copies}
                    changed |= before != (len(draft.constants), draft.open)
        rank = {name: number for number, name in enumerate(self._order)}
        for place in sorted(self._drafts, key=lambda place: (rank[place[0]], place[1])):
            draft = self._drafts[place]
            if (found := self._counting(place, draft)) and len(found.names) <= self._counts:
                yield self._counted(place, found)
                continue
            limits = self._limits(draft) if draft.open else set()
            values = self._ranges(place, limits) if limits and not place[1].endswith(EMPTY) else self._cell_values(place, draft)
            if draft.assigned and len(values) > 1 and (values == BOOLEAN or limits or place in distinct):
                yield self._cell(place, values)
                if values != BOOLEAN and not limits:
                    for key in draft.inputs:  # an input is distinguished as finely as the variable that takes its value
                        self._inputs.setdefault(key, _Draft()).constants.update(dict.fromkeys(v for v in values if v != OTHER))

    def _cell(self, place: Place, values: tuple[str, ...]) -> Cell:
        name, suffix = place
        row = self._variables[name]
        last = name.rsplit("::", 1)[-1]
        text = (last if self.locator.is_unique(name) else name.lstrip(":")) + suffix
        cell = Cell(Subject(name + suffix, text, values, True), name, suffix, _plain_type(row), (), str(row.get("at") or ""))
        first = self._initial(place)
        value = cell.value_of(first) if first is not None else None
        return Cell(cell.subject, name, suffix, cell.type, (value,) if value else values, cell.at)

    def _counting(self, place: Place, draft: _Draft) -> Counting | None:
        """How the variable at a place is counted, if it is: it begins with a number, and gets numbers and what these come to."""
        first = self._first_number(place)
        sized = place[1] == EMPTY
        if first is None or not draft.asked or (sized and all(limit < 2 for _, limit in draft.asked)):
            return None
        given, steps = [], []
        for text in draft.given:
            known = None if text is None else 0 if sized and EMPTIES.search(text) else whole(text)
            taken = stepped(text, sized) if known is None and text is not None else None
            if known is not None:
                given.append(known)
            elif taken is not None and self.locator.locate(taken.name, _owner(place[0])) == place:
                steps.append(taken)
            else:
                return None
        size = WIDE if sized else width(_plain_type(self._variables[place[0]]))
        return counting(first, given, steps, draft.asked, rests=not draft.compared, width=size, sized=sized) if steps else None

    def _first_number(self, place: Place) -> int | None:
        name, suffix = place
        text, type_ = self._variables[name].get("initial"), _plain_type(self._variables[name])
        if suffix == EMPTY:
            return 0 if text in (None, "", '""', "[]", "list()", "deque()") and re.search(_LISTS, type_) else None
        if suffix:
            return None
        if text is None and name.startswith("::") and _INTEGER.fullmatch(type_):
            return 0
        if type_ and not (_INTEGER.fullmatch(type_) and type_ not in ("float", "double")):
            return None
        return whole(text) if re.fullmatch(r"\s*-?\d+[uUlL]*\s*", str(text)) else None

    def _counted(self, place: Place, found: Counting) -> Cell:
        name, suffix = place
        row = self._variables[name]
        last = name.rsplit("::", 1)[-1]
        shown = ".size()" if suffix.endswith(EMPTY) else suffix
        text = (last if self.locator.is_unique(name) else name.lstrip(":")) + shown
        subject = Subject(name + shown, text, (*found.names, *found.beyond), True)
        first = self._first_number(place) or 0
        return Cell(subject, name, suffix, _plain_type(row), (found.name(first),), str(row.get("at") or ""), found)

    def _initial(self, place: Place) -> str | None:
        """The constant that a variable begins with; C++ fixes some that are not written."""
        name, suffix = place
        row = self._variables[name]
        text, type_ = row.get("initial"), _plain_type(row)
        if suffix.endswith(EMPTY):
            return "true" if text in (None, "") or EMPTIES.search(text) else None
        if place in self._fields:
            return constant(self._fields[place])
        if text is not None and constant(str(text)) is not None:
            alone = suffix == "" or sum(place[0] == name for place in self._drafts) == 1
            return constant(stored(type_, str(text))) if alone else None
        if text is None and suffix == "":
            if begins_null(type_):
                return NULL
            if name.startswith("::"):  # storage that is zero before the program starts
                return "false" if type_ == "bool" else "0" if _INTEGER.fullmatch(type_) else NULL if type_.endswith("*") else None
        return None

    def _cell_values(self, place: Place, draft: _Draft) -> tuple[str, ...]:
        type_ = _plain_type(self._variables[place[0]]) if place[1] == "" else ""
        plain = set(draft.constants) <= set(BOOLEAN)
        if type_ == "bool" or place[1].endswith(EMPTY) or (type_ == "" and plain and (draft.constants or draft.tested)):
            return BOOLEAN
        constants = dict(draft.constants)
        if may_be_null(type_):
            return (NULL, OTHER) if constants or draft.tested else ()
        if draft.tested and (_INTEGER.fullmatch(type_) or constants):
            constants["0"] = None
        return _values(constants, draft.open) if constants else ()


def _values(constants: Iterable[str], is_open: bool) -> tuple[str, ...]:
    named = tuple(constants)
    return named if not is_open or set(named) == set(BOOLEAN) else (*named, OTHER)


def _plain_type(row: Mapping[str, Any]) -> str:
    text = str(row.get("type") or "")
    if text == "object":  # of Python, which says nothing
        return ""
    atomic = re.fullmatch(r".*\batomic<\s*(.*?)\s*>\s*", text)
    return _QUALIFIERS.sub("", atomic.group(1) if atomic else text).strip()


def variable_and_field(row: Mapping[str, Any], variables: Iterable[str]) -> Place:
    """The variable that a transition assigns and the field of it: given apart, or after the variable's name."""
    name, field_ = str(row["variable"]), row.get("field")
    if name not in variables:
        for cut in (match.start() for match in re.finditer(r"\.|->|\[", name)):
            if name[:cut] in variables:
                return name[:cut], "." + name[cut:].replace("->", ".").lstrip(".")
    return name, f".{field_}" if field_ else ""


def part_text(value: str, rest: str) -> str | None:
    """The spelling of the field `rest` of an assigned value, where it has one."""
    text = f"{value[1:].strip()}->{rest[1:]}" if value.startswith("*") else f"{strip(value)}{rest}"
    return text if rest and re.fullmatch(r"[\w:.>\-]+(\(\))?", text) else None


def condition_of(row: Mapping[str, Any], key: str) -> str | None:
    """A row's condition: with local variables replaced by what they stand for, where the model has it so."""
    text: str | None = row.get(f"{key}_normal") or row.get(key)
    return text


def _conditions(document: Document) -> Iterator[tuple[str, str]]:
    """All conditions, each with the class in whose member it stands, where that is known."""
    for row in document.get("transitions") or ():
        if guard := condition_of(row, "guard"):
            yield _owner(str(row.get("variable") or "")), guard
    for kind, key in (("reactive", "when"), ("one_shot", "when"), ("periodic", "conditional")):
        for row in document.get(kind) or ():
            yield from (("", text) for way in (row, *row.get("ways", ())) if (text := condition_of(way, key)))
