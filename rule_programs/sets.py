"""The rules of an analysis: those that ship, with variants of contested decisions, options, and rules of the user's own."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rosarch.base.hints import hint
from rosarch.datalog import Overridden, Program, is_compiled, load_program
from rosarch.extractor.manifest import content_hash, rules_folder
from rosarch.rule_programs.checks import Check, check_files, is_check, read_checks, require_places, require_unique
from rosarch.rule_programs.choice import SHIPPED as SHIPPED
from rosarch.rule_programs.choice import RuleSet as RuleSet
from rosarch.rule_programs.own_files import own_files, own_programs
from rosarch.rule_programs.variants import PROGRAMS, Decision, RuleSetError, decisions

if TYPE_CHECKING:
    from rosarch.datalog.engine.rederive import RuleHistory


@dataclass(frozen=True)
class Option:
    """A number or choice that the rules leave open."""

    name: str
    meaning: str
    default: str
    allowed: tuple[str, ...]

    def problem(self, value: str) -> str:
        """Why the option cannot be `value`; empty when it can."""
        return "" if value in self.allowed else f"the option `{self.name}` is one of {', '.join(self.allowed)}, not `{value}`"


@dataclass(frozen=True)
class SystemRules:
    """The rules of systems and the checks among them."""

    program: Program
    checks: tuple[Check, ...]


def rule_set(own: Sequence[Path] = (), variants: Mapping[str, str] | None = None, options: Mapping[str, str] | None = None) -> RuleSet:
    """Rules with these files and folders, variants by decision, and options; what is the default anyway is left out.

    Raises:
        RuleSetError: a file, decision, variant, option or value that does not exist.
    """
    own_files(own)
    own = tuple(own)
    known = {decision.name: decision for decision in decisions(own)}
    chosen = []
    for name, variant in sorted((variants or {}).items()):
        if name not in known:
            raise RuleSetError(f"there is no decision `{name}`{_nearest(name, known)}")
        names = [each.name for each in known[name].variants]
        if variant not in names:
            raise RuleSetError(f"{name} has no variant `{variant}`{_nearest(variant, names)}")
        if variant != known[name].default.stem:
            chosen.append((name, variant))
    return RuleSet(own, tuple(chosen), _checked_options(RuleSet(own, tuple(chosen)), options or {}))


def _nearest(name: str, known: Collection[str]) -> str:
    return hint(name, known) or f", there are {', '.join(sorted(known))}"


def _checked_options(rules: RuleSet, given: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    if not given:
        return ()
    known = {option.name: option for option in find_options(rules)}
    for name, value in given.items():
        if name not in known:
            raise RuleSetError(f"there is no option `{name}`{_nearest(name, known)}")
        if problem := known[name].problem(value):
            raise RuleSetError(problem)
    return tuple(sorted((name, value) for name, value in given.items() if value != known[name].default))


def other_variants() -> Iterator[RuleSet]:
    """Rules with the variants that ship and are no default: as few as have each of them, with one of every decision at a time."""
    others = [[(decision.name, each.name) for each in decision.variants if each.path != decision.default] for decision in decisions()]
    for chosen in zip_longest(*others):
        yield rule_set(variants=dict(each for each in chosen if each))


def component_program(rules: RuleSet = SHIPPED) -> Program:
    """The rules that derive a component's model."""
    return _program("component", rules)


def model_program(rules: RuleSet = SHIPPED) -> Program:
    """The rules of a component for what its model is made of, and no other rows."""
    return _program("component", rules, on_demand=True)


def system_rules(rules: RuleSet = SHIPPED) -> SystemRules:
    """The rules of systems with all checks that ship, and those of the user's own.

    Raises:
        CheckError: a check is not as it should be.
    """
    return _system_rules(rules, _stamp(rules))


@lru_cache(maxsize=4)
def _system_rules(rules: RuleSet, _stamp: tuple[int, ...]) -> SystemRules:
    files = _files(rules)["system"]
    shipped = check_files()
    own = [file for file in files if is_check(file)]
    require_unique([*shipped, *own])
    program = _program("system", rules)
    checks = read_checks([*shipped, *own])
    require_places(checks, program.relations)
    return SystemRules(program, checks)


def roots(program: str, rules: RuleSet = SHIPPED) -> list[Path]:
    """The root files of the rules of components or of systems; what else there is they include."""
    optional = check_files() if program == "system" else [rules_folder() / "flows.dl"] if rules.flows else []
    return [rules_folder() / f"{program}.dl", *optional, *_files(rules)[program]]


def _files(rules: RuleSet) -> Mapping[str, tuple[Path, ...]]:
    return own_programs(own_files(rules.own)) if rules.own else dict.fromkeys(PROGRAMS, ())


def _settings(program: str, rules: RuleSet) -> dict[str, Any]:
    """What is to be loaded otherwise than the shipped rules have it."""
    given = "\n".join(f'option_given("{name}", "{value}").' for name, value in rules.options)
    chosen = {d.default: path for d, path in chosen_variants(rules) if d.program == program and path != d.default}
    return {"extra_source": given, "instead": chosen}


def chosen_variants(rules: RuleSet) -> list[tuple[Decision, Path]]:
    """Every decision with the file that answers it."""
    chosen = dict(rules.variants)
    found = []
    for decision in decisions(rules.own):
        variant = decision.find(chosen.get(decision.name, decision.default.stem))
        found.append((decision, variant.path if variant else decision.default))
    return found


def _program(program: str, rules: RuleSet, *, on_demand: bool = False) -> Program:
    return _loaded(program, rules, _stamp(rules), on_demand)


@lru_cache(maxsize=8)
def _loaded(program: str, rules: RuleSet, _stamp: tuple[int, ...], on_demand: bool) -> Program:
    return load_program(
        roots(program, rules), on_demand=on_demand, **_settings(program, rules), shipped=compiled_file(program, on_demand=on_demand)
    )


def rule_history(program: str, rules: RuleSet) -> RuleHistory:
    """The rules of components or of systems while they are edited."""
    from rosarch.datalog.engine.rederive import RuleHistory

    return RuleHistory(roots(program, rules), **_settings(program, rules))


def _stamp(rules: RuleSet) -> tuple[int, ...]:
    """What changes with the user's own files."""
    if not rules.own:
        return ()
    files = [*own_files(rules.own), *(variant.path for decision in decisions(rules.own) for variant in decision.variants)]
    return tuple(number for stat in map(Path.stat, files) for number in (stat.st_mtime_ns, stat.st_size))


def is_loaded_soon(rules: RuleSet) -> bool:
    """Whether the rules of components were compiled before, so that they need not be while sources are read."""
    shipped = compiled_file("component", on_demand=True)
    return is_compiled(roots("component", rules), on_demand=True, **_settings("component", rules), shipped=shipped)


def compiled_file(program: str, *, on_demand: bool) -> Path:
    """Where the shipped rules of components or of systems are compiled to when rosarch is installed.

    Rules that differ in those of systems alone have the same rules of components, and the other way round.
    """
    return rules_folder() / "compiled" / f"{program}{'_on_demand' * on_demand}.pickle"


def check_own(rules: RuleSet) -> None:
    """Load what files of the user's own are part of, so that what is wrong with them is said before anything is done.

    Raises:
        DatalogError, CheckError, RuleSetError: something is.
    """
    files = _files(rules)
    if files["component"]:
        component_program(rules)
    if files["system"]:
        system_rules(rules)


def find_options(rules: RuleSet = SHIPPED) -> tuple[Option, ...]:
    """The options, by name; those of the user's own rules as well."""
    programs = [_program(program, rules) for program in PROGRAMS] if rules.own else [load_program(rules_folder() / "options.dl")]
    rows: dict[str, set[tuple[str, str]]] = {"option_default": set(), "option_allowed": set(), "option_meaning": set()}
    for program in programs:
        result = program.evaluate({}, keep=list(rows))
        for name, found in rows.items():
            found.update((option, text) for option, text in result.rows(name))
    meanings = dict(sorted(rows["option_meaning"]))
    return tuple(
        Option(name, meanings.get(name, ""), default, tuple(sorted(value for option, value in rows["option_allowed"] if option == name)))
        for name, default in sorted(rows["option_default"])
    )


def overridden(rules: RuleSet) -> tuple[Overridden, ...]:
    """The relations of the shipped rules that files of the user's own override."""
    if not any(b'"override"' in file.read_bytes() for file in own_files(rules.own)):
        return ()
    return tuple(each for program in PROGRAMS for each in _program(program, rules).overridden)


def rules_digest(rules: RuleSet) -> str:
    """A hash of the rules of components, contents of files included; empty for those that ship."""
    return "" if rules == SHIPPED else model_program(rules).hash


def described(rules: RuleSet) -> dict[str, Any]:
    """What results say about rules other than those that ship: variants, options, own files with hashes, what they override."""
    if rules == SHIPPED:
        return {}
    values = {option.name: option.default for option in find_options(rules)} | dict(rules.options)
    return {
        "variants": {decision.name: path.stem for decision, path in chosen_variants(rules)},
        "options": dict(sorted(values.items())),
        "own": [{"file": str(path), "hash": content_hash(path)} for path in own_files(rules.own)],
        "overridden": sorted({each.relation for each in overridden(rules)}),
    }
