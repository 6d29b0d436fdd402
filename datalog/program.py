"""Programs and results: the public face of the package."""

from __future__ import annotations

import hashlib
import marshal
import sys
import weakref
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.datalog import cache
from rosarch.datalog.engine import engine
from rosarch.datalog.engine.plan import Code
from rosarch.datalog.engine.runtime import names, ordered
from rosarch.datalog.engine.shipped import is_shipped, read_shipped, write_program
from rosarch.datalog.engine.user_functors import Functors, FunctorUse, bind, functor_uses
from rosarch.datalog.files.inputs import InputReader
from rosarch.datalog.files.row_text import Show, line_chunks
from rosarch.datalog.language.errors import DatalogError, Diagnostic, Location, Report, did_you_mean, with_lines
from rosarch.datalog.language.preprocess import Loading
from rosarch.datalog.language.types import Types, build_types

if TYPE_CHECKING:
    from rosarch.datalog.engine.again import Reading, Series
    from rosarch.datalog.language.overrides import Overridden
    from rosarch.datalog.language.sources import Sources
    from rosarch.datalog.language.syntax import Directive, Unit

Row = tuple[Any, ...]
_BASES = {"i": "number", "u": "unsigned", "f": "float", "s": "symbol", "r": "record", "+": "adt"}


@dataclass(frozen=True, slots=True)
class Attribute:
    """A column: `type` as declared, `base` one of number, unsigned, float, symbol, record, adt."""

    name: str
    type: str
    base: str


@dataclass(frozen=True, slots=True)
class RelationDecl:
    """A declared relation; `doc` is the `///` comment above its `.decl`."""

    name: str
    attributes: tuple[Attribute, ...]
    doc: str
    location: Location
    is_input: bool = False
    is_output: bool = False
    qualifiers: frozenset[str] = frozenset()


@dataclass(slots=True)
class Result:
    """The rows of an evaluation, by relation."""

    _rows: Mapping[str, Collection[Any]]
    _arity: Mapping[str, int]
    _sorted: dict[str, list[Row]] = field(default_factory=dict)

    @classmethod
    def of(cls, rows: Mapping[str, Collection[Row]], program: Program) -> Result:
        """The result of a program that has these rows, by relation, in the form that `rows` gives them."""
        arity = {name: len(relation.attributes) for name, relation in program.relations.items()}
        return cls({name: [row[0] for row in found] if arity[name] == 1 else found for name, found in rows.items()}, arity)

    def names(self) -> list[str]:
        """The relations whose rows were kept."""
        return sorted(self._rows)

    def rows(self, name: str) -> list[Row]:
        """The rows of a relation, sorted.

        Values are str, int and float; tuples for records, None for nil, `("Branch", args...)` for algebraic data types.
        """
        if name not in self._sorted:
            if name not in self._rows:
                raise DatalogError([Diagnostic(f"no rows of `{name}` were kept", hint=did_you_mean(name, self._rows))])
            rows = ordered(self._rows[name])
            self._sorted[name] = [(v,) for v in rows] if self._arity[name] == 1 else rows
        return self._sorted[name]

    def all_rows(self) -> dict[str, list[Row]]:
        """The rows of all relations that were kept."""
        return {name: self.rows(name) for name in self.names()}

    def by_relation(self) -> Mapping[str, list[Row]]:
        """The same, each when it is asked for."""
        return _ByRelation(self)

    def lines(self, name: str, writers: Sequence[Show], delimiter: str = "\t") -> Iterator[str]:
        """The rows of a relation, sorted, as text in pieces of many lines; `writers` are those of its columns."""
        return line_chunks(self._rows[name], writers, delimiter)

    def count(self, name: str) -> int:
        """The number of rows of a relation."""
        return len(self._rows[name])


@dataclass(frozen=True, slots=True, eq=False)
class _ByRelation(Mapping[str, list[Row]]):
    """The rows of a result by relation."""

    result: Result

    def __getitem__(self, name: str) -> list[Row]:
        if name not in self.result._rows:
            raise KeyError(name)
        return self.result.rows(name)

    def __iter__(self) -> Iterator[str]:
        return iter(self.result.names())

    def __len__(self) -> int:
        return len(self.result._rows)


class _Derived(Mapping[str, Collection[Any]]):
    """The rows of some relations, derived when they are asked for; the evaluation lasts as long as this."""

    def __init__(self, evaluation: engine.Evaluation, names: Collection[str], sources: dict[str, str]) -> None:
        self._evaluation = evaluation
        self._names = names
        self._sources = sources
        weakref.finalize(self, evaluation.close)

    def __getitem__(self, name: str) -> Collection[Any]:
        if name not in self._names:
            raise KeyError(name)
        try:
            with engine.collector_paused():
                return self._evaluation.rows([name])[name]
        except DatalogError as error:
            raise with_lines(error, self._sources) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


@dataclass(slots=True)
class Program:
    """A checked and compiled program; evaluate it as often as you like."""

    relations: dict[str, RelationDecl]
    warnings: list[Diagnostic]
    hash: str
    code: Code
    types: Types
    directives: list[Directive]
    sources: dict[str, str]  # the texts of all files as written
    parsed: dict[str, str]  # those of rule files after the preprocessor
    pragmas: dict[str, str]
    functor_uses: dict[str, FunctorUse]
    bytecode: bytes
    overridden: tuple[Overridden, ...] = ()
    on_demand: bool = False  # only the rows of outputs are there
    functors: Functors = field(default_factory=dict)  # user-defined ones, as Python functions
    _functions: dict[str, Any] | None = None
    _reading: Reading | None = None

    def __getstate__(self) -> dict[str, Any]:
        state = {name: getattr(self, name) for name in self.__dataclass_fields__}
        return {**state, "functors": {}, "_functions": None, "_reading": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        for name, value in state.items():
            setattr(self, name, value)

    @property
    def inputs(self) -> list[str]:
        """The names of the `.input` relations."""
        return [r.name for r in self.relations.values() if r.is_input]

    @property
    def outputs(self) -> list[str]:
        """The names of the `.output` relations."""
        return [r.name for r in self.relations.values() if r.is_output]

    def evaluate(
        self, facts: Mapping[str, Iterable[Row]] | Path, *, engine: str = "embedded",
        keep: Collection[str] | str | None = None, limit_rows: int | None = None, time_limit: float | None = None,
    ) -> Result:  # fmt: skip
        """Derive everything from the facts.

        `facts`: rows of `.input` relations (missing ones are empty), or a folder of `.facts` files.
        `keep`: the relations whose rows are wanted; the `.output` ones by default, every one with "all".
        `engine`: `embedded`, or `souffle` to run the souffle binary.
        `limit_rows`, `time_limit`: raise DatalogError once a relation has more rows, or after so many seconds.
        """
        kept = self._kept(keep)
        if engine == "souffle":
            from rosarch.datalog.engine.souffle import evaluate_with_souffle

            rows: Mapping[str, Collection[Any]] = evaluate_with_souffle(self, self._given(facts), kept, time_limit)
        elif engine == "embedded":
            rows = self._evaluate_embedded(facts, kept, limit_rows=limit_rows, time_limit=time_limit)
        else:
            raise DatalogError(f"unknown engine `{engine}`, expected `embedded` or `souffle`")
        return Result(rows, self.code.arity)

    def evaluate_as(
        self, kind: Callable[..., engine.Evaluation], facts: Mapping[str, Iterable[Row]] | Path, keep: Collection[str] | str | None
    ) -> Result:  # fmt: skip
        """Derive everything from the facts by an evaluation that does more than derive."""
        return Result(self._evaluate_embedded(facts, self._kept(keep), kind=kind), self.code.arity)

    @contextmanager
    def series(self, *, engine: str = "embedded") -> Iterator[Callable[[Mapping[str, Iterable[Row]]], Result]]:
        """What evaluates the program again and again: what facts that differ from earlier ones do not reach is derived once.

        The rows of a result are derived when they are asked for, which they can be until the series ends.
        Rows of facts that are the same objects each time need not be compared.
        """
        if engine != "embedded" or self.code.counts or self.code.uses_ordinals:
            yield partial(self.evaluate, engine=engine)
            return
        from rosarch.datalog.engine.again import Reading, Series

        if self._reading is None:
            self._reading = Reading(self.code)
        with closing(Series(self._reading)) as series:
            yield partial(self._begun, series)

    def _begun(self, series: Series, facts: Mapping[str, Iterable[Row]]) -> Result:
        """The result of the next evaluation of a series."""
        with engine.collector_paused():
            evaluation = series.evaluation(self.code, self._loaded_functions(), self._given(facts), engine.Control(None, None))
        return Result(_Derived(evaluation, dict.fromkeys(self.outputs), self.sources), self.code.arity)

    def _evaluate_embedded(
        self, facts: Mapping[str, Iterable[Row]] | Path, kept: Collection[str], *,
        limit_rows: int | None = None, time_limit: float | None = None, kind: Callable[..., engine.Evaluation] = engine.Evaluation,
    ) -> Mapping[str, Collection[Any]]:  # fmt: skip
        functions, control = self._loaded_functions(), engine.Control(limit_rows, time_limit)
        try:
            # nothing else holds the rows of a folder, so that relations are freed when no rule reads them any more
            with engine.collector_paused(), closing(kind(self.code, functions, self._given(facts), control)) as evaluation:
                if not control.active:
                    return evaluation.run(kept)
                from rosarch.datalog.engine.watch import watching

                with watching(evaluation):
                    return evaluation.run(kept)
        except DatalogError as error:
            raise with_lines(error, self.sources) from None

    def _given(self, facts: Mapping[str, Iterable[Row]] | Path) -> Mapping[str, Iterable[Row]]:
        """Facts by relation, those of a folder read, after a check that they are facts of input relations."""
        found = self.read_facts(Path(facts)) if isinstance(facts, (str, Path)) else facts
        self._check_facts(found)
        return found

    def _loaded_functions(self) -> dict[str, Any]:
        if self._functions is None:
            self._functions = self.load_functions()
        return self._functions

    def load_functions(self) -> dict[str, Any]:
        """The functions of the generated module, with what they call."""
        return engine.load_functions(marshal.loads(self.bytecode), {**names(self.types.bits), **bind(self)})

    def _kept(self, keep: Collection[str] | str | None) -> list[str]:
        if keep is None:
            return self.outputs
        if isinstance(keep, str):
            return self._kept(list(self.relations) if keep == "all" else [keep])
        for name in keep:
            if name not in self.relations:
                raise DatalogError([Diagnostic(f"unknown relation `{name}`", hint=did_you_mean(name, self.relations))])
            if self.on_demand and not self.relations[name].is_output:
                raise DatalogError(f"no rows of `{name}`: the program derives those of its outputs only")
        return list(dict.fromkeys(keep))

    def _check_facts(self, facts: Mapping[str, Iterable[Row]]) -> None:
        for name in facts:
            relation = self.relations.get(name)
            if relation is None:
                hint = did_you_mean(name, self.inputs)
                raise DatalogError([Diagnostic(f"facts given for the unknown relation `{name}`", hint=hint)])
            if not relation.is_input:
                raise DatalogError(f"facts given for `{name}`, which is not an `.input` relation")

    def read_facts(self, folder: Path, *, strict: bool = False) -> dict[str, list[Row]]:
        """The rows of every `.input` relation, read as its directives say, from files in the folder.

        A relation whose file is missing has no rows; with `strict`, that is an error.
        """
        if not folder.is_dir():
            raise DatalogError(f"no such folder of facts: `{folder}`")
        return InputReader(self, folder, strict=strict).read()


def load_program(
    path: Path | str | Sequence[Path | str], *, extra_source: str = "", preprocess: bool = False, macros: Sequence[str] = (),
    include: Sequence[Path | str] = (), instead: Mapping[Path, Path] | None = None, bits: int = 32, functors: Functors | None = None,
    on_demand: bool = False, shipped: Path | None = None,
) -> Program:  # fmt: skip
    """Parse, check and compile a program: one or more root files and what they include.

    `extra_source` is appended as if it were a last file. `preprocess` runs the C preprocessor over texts with its directives, with
    `macros` (`NAME` or `NAME=VALUE`) defined; `include` are folders for `.include` and `#include`, and an `.include` of a file of `instead`
    takes the file it is mapped to. `bits` is the width of numbers, 32 or 64. `functors` are the functions behind `.functor` declarations.
    A program `on_demand` derives what its outputs need, and has the rows of no other relation. Compiled programs are cached by the content
    of all files; `shipped` may have the program from when the files were installed. Raises DatalogError with every diagnostic.
    """
    if bits not in (32, 64):
        raise DatalogError(f"numbers have 32 or 64 bits, not {bits}")
    paths = [Path(path)] if isinstance(path, (str, Path)) else [Path(p) for p in path]
    reading = _reading(preprocess, macros, tuple(Path(p) for p in include), instead, bits)
    key = _cache_key(extra_source, reading, bits, on_demand)
    program = cache.load(paths, key)
    if program is None and shipped is not None:
        program = _shipped(shipped, paths, key)
    if not isinstance(program, Program):
        program, digests = _compiled(paths, extra_source, reading, bits, on_demand)
        cache.store(paths, key, digests, program)
    program.functors = dict(functors or {})
    return program


def _compiled(paths: Sequence[Path], extra_source: str, reading: Loading, bits: int, on_demand: bool) -> tuple[Program, dict[str, str]]:
    """The program, and the hashes of its files."""
    from rosarch.datalog.language.sources import EXTRA_SOURCE, TOO_DEEP, deepest, read_program  # a cached program does without

    with engine.collector_paused():
        unit, sources, report = read_program(paths, extra_source, reading)
        try:
            program = compile_unit(unit, sources, report, bits, on_demand=on_demand)
        except RecursionError:
            report.error(TOO_DEEP, deepest(sources.parsed))
            raise DatalogError(report.errors[-1:]) from None
    return program, {path: cache.digest(path) for path in sources.texts if path != EXTRA_SOURCE}


def _shipped(file: Path, paths: Sequence[Path], key: str) -> Program | None:
    found = read_shipped(file, paths, key)
    if found is None:
        return None
    program, python, digests = found
    if python != sys.version:
        program.bytecode = bytecode_of(program.code)
        cache.store(paths, key, digests, program)
    return program


def is_compiled(
    paths: Sequence[Path], *, extra_source: str = "", instead: Mapping[Path, Path] | None = None, on_demand: bool = False,
    shipped: Path | None = None,
) -> bool:  # fmt: skip
    """Whether there is a compiled program of these files, which `load_program` takes unless a file has changed since."""
    key = _cache_key(extra_source, _reading(False, (), (), instead, 32), 32, on_demand)
    return cache.is_stored(paths, key) or (shipped is not None and is_shipped(shipped, paths, key))


def ship_program(file: Path, paths: Sequence[Path], *, on_demand: bool = False) -> None:
    """Compile a program into a file, unless it is there, for `load_program` to find it wherever its rules are installed."""
    reading = _reading(False, (), (), None, 32)
    key = _cache_key("", reading, 32, on_demand)
    if not is_shipped(file, paths, key):
        program, digests = _compiled(paths, "", reading, 32, on_demand)
        write_program(file, paths, key, digests, program)


def _reading(preprocess: bool, macros: Sequence[str], folders: tuple[Path, ...], instead: Mapping[Path, Path] | None, bits: int) -> Loading:
    return Loading(preprocess or bool(macros), (f"RAM_DOMAIN_SIZE={bits}", *macros), folders, tuple(sorted((instead or {}).items())))


def _cache_key(extra_source: str, reading: Loading, bits: int, on_demand: bool) -> str:
    return f"{extra_source}\0{reading!r}\0{bits}\0{on_demand}"


def compile_unit(unit: Unit, sources: Sources, report: Report, bits: int = 32, *, on_demand: bool = False) -> Program:
    """Check and compile a syntax tree."""
    from rosarch.datalog.engine.compile import compile_program
    from rosarch.datalog.engine.demand import compile_on_demand
    from rosarch.datalog.engine.preparation import prepare

    checked, _ = prepare(unit, report, bits)
    unit = checked.unit
    try:
        if on_demand:
            goals = sorted({d.relation for d in unit.directives if d.kind in ("output", "printsize")})
            inputs = {d.relation for d in unit.directives if d.kind == "input"}
            code = compile_on_demand(checked.relations, checked.strata, checked.clauses, checked.types, goals, inputs)
        else:
            code = compile_program(checked.relations, checked.strata, checked.clauses, checked.types)
    except DatalogError as error:
        raise with_lines(error, sources.texts) from None
    content = hashlib.sha256(f"{cache.engine_version()} {bits}".encode())
    for text in sources.parsed.values():
        content.update(text.encode("utf-8", "surrogateescape") + b"\0")
    return Program(
        declarations(unit, checked.types),
        report.warnings,
        content.hexdigest()[:32],
        code,
        checked.types,
        unit.directives,
        dict(sources.texts),
        dict(sources.parsed),
        {pragma.key: pragma.value for pragma in unit.pragmas},
        functor_uses(unit, checked.types),
        bytecode_of(code),
        sources.overridden,
        on_demand,
    )


def bytecode_of(code: Code) -> bytes:
    """The generated module as this Python has it."""
    return marshal.dumps(compile(code.source, "<datalog>", "exec"))


def declarations(unit: Unit, types: Types) -> dict[str, RelationDecl]:
    """The relations of a syntax tree, in its order."""
    inputs = {d.relation for d in unit.directives if d.kind == "input"}
    outputs = {d.relation for d in unit.directives if d.kind in ("output", "printsize")}
    result: dict[str, RelationDecl] = {}
    for r in unit.relations:
        attributes = tuple(Attribute(a.name, a.type, _BASES[types.kind(a.type)] if types.exists(a.type) else "") for a in r.attributes)
        result[r.name] = RelationDecl(r.name, attributes, r.doc, r.location, r.name in inputs, r.name in outputs, r.qualifiers)
    return result


def load_declarations(path: Path | str | Sequence[Path | str]) -> Mapping[str, RelationDecl]:
    """The relations declared in files and what they include, without checking or compiling their rules."""
    paths = [Path(path)] if isinstance(path, (str, Path)) else [Path(p) for p in path]
    from rosarch.datalog.language.components import instantiate
    from rosarch.datalog.language.sources import read_program

    unit, _, report = read_program(paths)
    unit = instantiate(unit, report)
    types = build_types(unit.types, report)
    report.raise_errors()
    return declarations(unit, types)
