"""Clauses to Python functions: nested loops over relations and hash indexes.

Rows are tuples, except that the rows of a unary relation are the bare values. A function gets the relation it adds
to, the delta it starts from, where new rows go, and then the relations and indexes it reads. An index maps a key (the
value of its column, a tuple for several) to the rows with that key, reduced to the value of the one column that is
left where there is only one; where the clause has constants beside variables, to those of the rows with the constants.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from rosarch.datalog.engine.expressions import Expressions
from rosarch.datalog.engine.nested_code import NestedCode
from rosarch.datalog.engine.plan import Origin
from rosarch.datalog.engine.storage import IndexKey, RowsNeeded, Storage, TableKey, local, row_of
from rosarch.datalog.language.errors import DatalogError, Diagnostic
from rosarch.datalog.language.ground import is_bound
from rosarch.datalog.language.normalise import Absent, Fold, Generate, Scan, Step, step_variables
from rosarch.datalog.language.syntax import Argument, Atom, Branch, Constraint, Number, Record, String, Truth, Unnamed, Variable, variables

MAX_LOOPS = 16


class Emitter(NestedCode):
    """Writes the function of one clause, or of one delta version of it."""

    def __init__(
        self, storage: Storage, expressions: Expressions, *, ordered: bool, delta: int | None, growing: Collection[str],
        own: TableKey | None = None,
    ) -> None:  # fmt: skip
        super().__init__()
        self.storage = storage
        self.expressions = expressions
        self.ordered = ordered  # loop in sorted order: something in the clause depends on the order
        self.delta = delta
        self.growing = growing  # relations to which the function may add while it loops over them
        self.own = own  # the table that the function is for, which it knows as `own`
        self.relations: set[str] = set()
        self.indexes: dict[int, tuple[Origin, ...]] = {}
        self.tables: set[int] = set()
        self.origins: dict[str, tuple[str, int]] = {}  # of a Python name: the relation and column whose values it takes
        self.constant: set[str] = set()  # variables that are equal to a constant

    def arguments(self) -> list[str]:
        """The names of the relations, indexes and tables that the function is given."""
        numbers = (*(f"i{n}" for n in sorted(self.indexes)), *(f"k{n}" for n in sorted(self.tables)))
        return [*map(local, sorted(self.relations)), *numbers]

    # -- bodies -------------------------------------------------------------------------------------

    def body(
        self, steps: Sequence[Step], bound: dict[str, str], wanted: set[str], finish: Callable[[dict[str, str]], None],
        *, bag: bool, checkpoint: Callable[[dict[str, str]], bool] | None = None,
    ) -> None:  # fmt: skip
        """Emit the steps in a good order, then `finish`. `bag`: every combination of rows counts, not just one."""
        pending = list(steps)
        checked = False
        depth = self.depth
        while True:
            self._settle(pending, bound, wanted, bag)
            if not pending:
                break
            if checkpoint is not None and not checked and self.loops:
                checked = checkpoint(bound)
            step = self._choose(pending, bound)
            pending.remove(step)
            if self.loops >= MAX_LOOPS and checkpoint is not None:
                self.open_function()
            if isinstance(step, Generate):
                self._generate(step, bound)
            else:
                self._scan(step, pending, bound, wanted)
        finish(bound)
        while checkpoint is not None and self.functions and self.functions[-1] >= depth:
            self.depth = self.functions.pop()
            self.line("inner()")

    def _needed(self, pending: Sequence[Step], wanted: set[str]) -> set[str]:
        """The variables that something after this point uses."""
        needed = set(wanted)
        for step in pending:
            needed |= step_variables(step)
        return needed

    def _settle(self, pending: list[Step], bound: dict[str, str], wanted: set[str], bag: bool) -> None:
        """Emit all tests, then assignments, that the bound variables allow, until none is left."""
        while True:
            if not any(self._test(s, pending, bound, wanted, bag) for s in list(pending)) and not any(
                self._assign(s, pending, bound) for s in list(pending)
            ):
                return

    def _test(self, step: Step, pending: list[Step], bound: dict[str, str], wanted: set[str], bag: bool) -> bool:
        names = set(bound)
        match step:
            case Truth():
                if not step.value:
                    self.fail_if("True")
            case Constraint() if is_bound(step.left, names) and is_bound(step.right, names):
                self.fail_unless(self.expressions.condition(step, bound))
            case Absent() if all(isinstance(a, Unnamed) or is_bound(a, names) for a in step.atom.args):
                self.fail_if(self._exists(step.atom, bound))
            case Scan() if step.index != self.delta or step.index < 0:
                others = self._needed([s for s in pending if s is not step], wanted)
                if not self._is_test(step.atom, names, others, bag):
                    return False
                condition = self._exists(step.atom, bound)
                if condition != local(step.atom.name) or step.index < 0:  # else tested before any loop
                    self.fail_unless(condition)
            case _:
                return False
        pending.remove(step)
        return True

    @staticmethod
    def _is_test(atom: Atom, names: set[str], others: set[str], bag: bool) -> bool:
        """Whether a positive atom only asks if some row exists."""
        free = []
        for arg in atom.args:
            if isinstance(arg, Unnamed) or (isinstance(arg, Variable) and arg.name not in names):
                free.append(arg)
        if not free:
            return True
        named = [a.name for a in free if isinstance(a, Variable)]
        return not bag and not others & set(named) and len(named) == len(set(named))

    def _exists(self, atom: Atom, bound: dict[str, str]) -> str:
        """The condition that some row matches the bound arguments."""
        columns = tuple(
            i for i, a in enumerate(atom.args) if not (isinstance(a, Unnamed) or (isinstance(a, Variable) and a.name not in bound))
        )
        if atom.name in self.storage.demanded:
            return self._exists_in_table(atom, columns, bound)
        if not columns or len(columns) == len(atom.args):
            self.relations.add(atom.name)
            self.storage.probed.update([atom.name] if columns else [])
            key = row_of([self.expressions.write(a, bound) for a in atom.args]) if columns else ""
            return f"{key} in {local(atom.name)}" if columns else local(atom.name)
        index, key = self._index(atom, columns, bound)
        return f"{key} in {self._index_name(index, atom, bound)}"

    def _exists_in_table(self, atom: Atom, columns: tuple[int, ...], bound: dict[str, str]) -> str:
        """The condition that some row of a relation that is derived on demand matches."""
        keys = self._table_keys(atom, columns)
        if keys == columns:
            return self._table(atom, columns, bound)
        rest = [i for i in columns if i not in keys]
        if len(keys) + 1 != len(atom.args):
            raise RowsNeeded(atom.name)
        return f"{self.expressions.write(atom.args[rest[0]], bound)} in {self._table(atom, keys, bound)}"

    def _table_keys(self, atom: Atom, columns: tuple[int, ...]) -> tuple[int, ...]:
        """The columns to ask a table by; those of the own table are given, and of pairs the first is taken when both are known."""
        keys = columns
        if self.own is not None and self._is_own(atom):
            keys = self.own[1]
        elif columns == (0, 1) and len(atom.args) == 2 and isinstance(atom.args[0], Variable):
            keys = (0,)
        if not keys or not set(keys) <= set(columns):
            raise RowsNeeded(atom.name)
        return keys

    def _table(self, atom: Atom, keys: Sequence[int], bound: dict[str, str]) -> str:
        """The expression for what a table has for these bound columns of an atom."""
        key = row_of([self.expressions.write(atom.args[i], bound) for i in keys])
        if self.own == (atom.name, tuple(keys)):
            return f"own[{key}]"
        number = self.storage.table((atom.name, tuple(keys)))
        self.tables.add(number)
        return f"k{number}[{key}]"

    def _index(self, atom: Atom, columns: Sequence[int], bound: dict[str, str]) -> tuple[IndexKey, str]:
        """The index for these bound columns of an atom, and the expression of the key to ask it for."""
        constants = tuple((i, self.expressions.constant(a)) for i in columns if isinstance(a := atom.args[i], (Number, String)))
        if len(constants) == len(columns):
            constants = ()  # one index serves all constants
        fixed = {i for i, _ in constants}
        keyed = tuple(i for i in columns if i not in fixed)
        return (atom.name, keyed, constants), row_of([self.expressions.write(atom.args[i], bound) for i in keyed])

    def _index_name(self, key: IndexKey, atom: Atom, bound: dict[str, str]) -> str:
        """The Python name of an index, which the function takes as an argument."""
        number = self.storage.index(key)
        keyed = ((i, bound[a.name]) for i in key[1] if isinstance(a := atom.args[i], Variable))
        origins = tuple(Origin(i, *self.origins[name]) for i, name in keyed if name in self.origins)
        self.indexes[number] = origins if self.indexes.get(number, origins) == origins else ()
        return f"i{number}"

    def _assign(self, step: Step, pending: list[Step], bound: dict[str, str]) -> bool:
        names = set(bound)
        if isinstance(step, Fold):
            if not step.inputs <= names:
                return False
            pending.remove(step)
            self._fold(step, bound)
            return True
        if not isinstance(step, Constraint) or step.op != "=":
            return False
        for source, target in ((step.left, step.right), (step.right, step.left)):
            if isinstance(target, (Variable, Unnamed, Record, Branch)) and is_bound(source, names):
                if isinstance(target, Variable) and isinstance(source, (Number, String)):
                    self.constant.add(target.name)
                pending.remove(step)
                self._match(target, self.expressions.write(source, bound), bound)
                return True
        return False

    # -- patterns -----------------------------------------------------------------------------------

    def _match(self, pattern: Argument, value: str, bound: dict[str, str]) -> None:
        """Bind or test the parts of a pattern against a value."""
        match pattern:
            case Unnamed():
                return
            case Variable() if pattern.name not in bound:
                name = self.python_name(pattern.name, bound)
                self.line(f"{name} = {value}")
                bound[pattern.name] = name
            case Record() | Branch() if not is_bound(pattern, set(bound)):
                self._unpack(pattern, value, bound)
            case _ if is_bound(pattern, set(bound)):
                self.fail_if(f"{value} != {self.expressions.write(pattern, bound)}")
            case _:
                raise DatalogError([Diagnostic("cannot solve this equation for its variables", pattern.location)])

    def _unpack(self, pattern: Record | Branch, value: str, bound: dict[str, str]) -> None:
        if not value.isidentifier():
            name = self.temporary()
            self.line(f"{name} = {value}")
            value = name
        if isinstance(pattern, Branch):
            self.fail_if(f"{value}[0] != {pattern.name!r}")
        else:
            self.fail_if(f"{value} is None")
        later: list[tuple[Argument, str]] = []
        for index, arg in enumerate(pattern.args):
            part = f"{value}[{index + isinstance(pattern, Branch)}]"
            if isinstance(arg, (Variable, Unnamed)):
                self._match(arg, part, bound)
            else:
                later.append((arg, part))
        for arg, part in later:
            self._match(arg, part, bound)

    # -- loops --------------------------------------------------------------------------------------

    def _choose(self, pending: Sequence[Step], bound: dict[str, str]) -> Scan | Generate:
        """The next step to loop over: the delta, then the atom with most of its columns bound."""
        names = set(bound)
        best: tuple[float, int] | None = None
        chosen: Scan | Generate | None = None
        for position, step in enumerate(pending):
            if isinstance(step, Scan):
                if step.index == self.delta and step.index >= 0:
                    return step
                keyed = [a for a in step.atom.args if is_bound(a, names)]
                joined = self._joined(keyed)  # else its rows multiply with all so far
                if self.own is not None and self._is_own(step.atom) and not all(is_bound(step.atom.args[i], names) for i in self.own[1]):
                    continue
                score = 3.0 * len(keyed) / max(len(step.atom.args), 1) + bool(keyed)
                if joined:
                    score += 10.0
                elif step.atom.name in self.storage.demanded:
                    score = self.storage.ranks.get(step.atom.name, 0.0)  # it would have to be whole, whatever is known
                else:
                    score += self.storage.ranks.get(step.atom.name, 0.0)
            elif isinstance(step, Generate) and all(is_bound(a, names) for a in step.functor.args):
                score = 0.5
            else:
                continue
            if best is None or (-score, position) < best:
                best, chosen = (-score, position), step
        if isinstance(chosen, Scan) and chosen.atom.name in self.storage.demanded and not self._is_own(chosen.atom):
            keyed = [a for a in chosen.atom.args if is_bound(a, names)]
            if not self._joined(keyed):  # by constants alone a table is not asked: many rows would have them
                raise RowsNeeded(chosen.atom.name)
        if chosen is None and self.own is not None and any(isinstance(s, Scan) and self._is_own(s.atom) for s in pending):
            raise RowsNeeded(self.own[0])
        if chosen is None:
            at = next((s.location for s in pending if isinstance(s, Constraint)), None)
            raise DatalogError([Diagnostic("no order of evaluation binds every variable of this rule", at)])
        return chosen

    def _joined(self, keyed: Sequence[Argument]) -> bool:
        """Whether known arguments of an atom tie it to what has been looped over."""
        return any(isinstance(a, Variable) and a.name not in self.constant for a in keyed)

    def _is_own(self, atom: Atom) -> bool:
        return self.own is not None and atom.name == self.own[0]

    def _generate(self, step: Generate, bound: dict[str, str]) -> None:
        values = self.expressions.write(step.functor, bound)
        if step.variable in bound:
            self.fail_unless(f"{bound[step.variable]} in {values}")
            return
        name = self.python_name(step.variable, bound)
        self.open_loop(f"for {name} in {values}:")
        bound[step.variable] = name

    def _scan(self, step: Scan, pending: list[Step], bound: dict[str, str], wanted: set[str]) -> None:
        atom, names = step.atom, set(bound)
        needed = self._needed(pending, wanted)
        is_delta = step.index == self.delta and step.index >= 0
        columns = () if is_delta else tuple(i for i, a in enumerate(atom.args) if is_bound(a, names))
        if atom.name in self.storage.demanded and not is_delta:
            columns = self._table_keys(atom, columns)
        targets: list[str] = []
        tests: list[str] = []
        fresh: dict[str, str] = {}
        for i, arg in enumerate(atom.args):
            if i in columns or isinstance(arg, Unnamed):
                targets.append("_")
            elif isinstance(arg, Variable) and arg.name not in bound and arg.name not in fresh:
                again = sum(isinstance(a, Variable) and a.name == arg.name for a in atom.args) > 1
                if arg.name in needed or again:
                    fresh[arg.name] = self.python_name(arg.name, bound | fresh)
                targets.append(fresh.get(arg.name, "_"))
            else:
                targets.append(self.temporary())
                tests.append(f"{targets[-1]} != {self.expressions.write(arg, bound | fresh)}")
        self.open_loop(f"for {self._loop_target(targets, columns)} in {self._source(atom, columns, bound, is_delta)}:")
        bound.update(fresh)
        if not is_delta and atom.name not in self.storage.demanded:
            named = ((i, a.name) for i, a in enumerate(atom.args) if isinstance(a, Variable))
            self.origins.update((fresh[name], (atom.name, i)) for i, name in named if name in fresh)
        for test in tests:
            self.fail_if(test)

    @staticmethod
    def _loop_target(targets: list[str], columns: tuple[int, ...]) -> str:
        free = [t for i, t in enumerate(targets) if i not in columns]
        if columns and len(free) == 1:
            return free[0]
        if len(targets) == 1:
            return targets[0]
        return ", ".join(targets) if any(t != "_" for t in targets) else "_"

    def _source(self, atom: Atom, columns: tuple[int, ...], bound: dict[str, str], is_delta: bool) -> str:
        if is_delta:
            source = "delta"
        elif atom.name in self.storage.demanded:
            source = self._table(atom, columns, bound)
        elif not columns:
            self.relations.add(atom.name)
            source = f"tuple({local(atom.name)})" if atom.name in self.growing else local(atom.name)
        else:
            key, value = self._index(atom, columns, bound)
            self.storage.listed.add(key)
            source = f"{self._index_name(key, atom, bound)}.get({value}, EMPTY)"
        return f"ordered({source})" if self.ordered else source

    # -- aggregates ---------------------------------------------------------------------------------

    def _fold(self, step: Fold, bound: dict[str, str]) -> None:
        op = step.aggregate.op
        result = self.python_name(step.variable, bound)
        kind = self.expressions.kind(step.aggregate) if op != "count" else "i"
        collects = op == "mean" or (op == "sum" and kind == "f")
        self.line(f"{result} = {'[]' if collects else 'None' if op in ('min', 'max') else '0'}")
        outer_depth, outer_loops = self.depth, self.loops
        self.open_loop("for _ in ONCE:")
        inner = {k: v for k, v in bound.items() if k in step.inputs}
        wanted = set(step.distinct)
        if step.target is not None:
            wanted |= variables(step.target)

        if step.distinct:
            self.line(f"{result}_seen = set()")

        def finish(now: dict[str, str]) -> None:
            if step.distinct:
                self.line(f"key = ({''.join(now[v] + ', ' for v in step.distinct if v)})")
                self.line(f"if key in {result}_seen: continue")
                self.line(f"{result}_seen.add(key)")
            if op == "count":
                self.line(f"{result} += 1")
                return
            assert step.target is not None
            value = self.expressions.write(step.target, now)
            if collects:
                self.line(f"{result}.append({value})")
            elif op == "sum":
                self.line(f"{result} += {value}")
            else:
                name = self.temporary()
                self.line(f"{name} = {value}")
                self.line(f"if {result} is None or {name} {'<' if op == 'min' else '>'} {result}: {result} = {name}")

        self.body(step.steps, inner, wanted, finish, bag=op not in ("min", "max"))
        self.depth, self.loops = outer_depth, outer_loops
        if op in ("min", "max"):
            self.fail_if(f"{result} is None")
        elif op == "mean":
            self.fail_if(f"not {result}")
            self.line(f"{result} = single(fsum({result}) / len({result}))")
        elif op == "sum":
            self.line(f"{result} = {'single(fsum(' + result + '))' if collects else self._wrapped(result, kind)}")
        bound_name = bound.get(step.variable)
        if bound_name is not None:
            self.fail_unless(f"{bound_name} == {result}")
        bound[step.variable] = result

    @staticmethod
    def _wrapped(value: str, kind: str) -> str:
        return f"wrap({value})" if kind == "i" else f"wrap_unsigned({value})"
