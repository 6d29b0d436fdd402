"""What rules keep to in addition to being legal: comments that say when a row holds and how certainly, names, and no dead weight.

The certainty of a relation is the last statement of its `///` comment:

- `Must.`: each row certainly holds; `Must, given `port`.`: it does if `port` is what it is said to be;
- `May.`: a row may hold;
- `Demand.`: rows say what is asked for, and restrict others to it; they claim nothing.

The comment of a relation that does not depend on facts from outside need not say it.

What certainly holds cannot rest on what may: a clause of a `Must` relation has no `May` atom in its body, except one about what is given.
A negated atom is left alone: that nothing of the kind is possible is certain enough.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass

from rosarch.datalog.inspection.clauses import Rule, Rules, rules_of
from rosarch.datalog.language.errors import Diagnostic
from rosarch.datalog.language.strata import atoms_of
from rosarch.datalog.language.syntax import Argument, Constraint, Literal, Variable, walk
from rosarch.datalog.program import Program, RelationDecl

MOST_ATTRIBUTES = 6
NAME = re.compile(r"(_?[a-z][a-z0-9]*(_[a-z0-9]+)*\.)?_?[a-z][a-z0-9]*(_[a-z0-9]+)*")
_CERTAINTY = re.compile(r"(?:^|(?<=[.]) )(Must|May|Demand)\b(?:, given ((?:`\w+`(?:, | and )?)+))?(?=[.,])")


@dataclass(frozen=True, slots=True)
class Certainty:
    """What a comment says: `word` is Must, May, Demand, or empty; `given` are attributes that are taken for granted."""

    word: str
    given: frozenset[str] = frozenset()


def certainty(declaration: RelationDecl) -> Certainty:
    """The certainty of the rows of a relation, as its comment says."""
    found = _CERTAINTY.search(" ".join(declaration.doc.split()))
    return Certainty(found[1], frozenset(re.findall(r"`(\w+)`", found[2] or ""))) if found else Certainty("")


def unconventional(program: Program, about: Callable[[str], bool], shown: Collection[str] = ()) -> list[Diagnostic]:
    """What the declarations and clauses of the files that `about` chooses do not keep to, by place.

    `shown` are relations that somebody is shown although no directive puts them out, as checks are.
    """
    rules = rules_of(program)
    constant = _constant(rules, {r.name for r in program.relations.values() if r.is_input})
    chosen = [r for r in program.relations.values() if about(r.location.path)]
    found = [
        *_undocumented(chosen, constant),
        *_misnamed(chosen),
        *_dead(rules, [r for r in chosen if r.name not in shown]),
        *_uncertain(program, rules, about),
    ]
    return sorted(found, key=lambda d: d.location or ("", 0, 0))


def is_private(name: str) -> bool:
    """Whether a relation is private to its file."""
    return _own_name(name).startswith("_")


def _own_name(name: str) -> str:
    """The name without that of the instance of a component that it is in."""
    return name.rpartition(".")[2]


def _constant(rules: Rules, inputs: Collection[str]) -> set[str]:
    """The relations whose rows are those of the program alone, whatever the facts are: they hold."""
    found: set[str] = set()
    for names in rules.strata:
        if not any(name in inputs or rules.reads[name] - found - set(names) for name in names):
            found.update(names)
    return found


def _undocumented(relations: Iterable[RelationDecl], constant: Collection[str]) -> Iterator[Diagnostic]:
    for relation in relations:
        if is_private(relation.name):
            continue
        if not relation.doc:
            yield _warning(relation, f"`{relation.name}` has no `///` comment that says when a row holds")
            continue
        missing = [a.name for a in relation.attributes if f"`{a.name}`" not in relation.doc]
        if missing:
            yield _warning(relation, f"the comment of `{relation.name}` does not say what {', '.join(f'`{n}`' for n in missing)} is")
        if not certainty(relation).word and relation.name not in constant:
            yield _warning(relation, f"the comment of `{relation.name}` does not end in `Must.`, `May.` or `Demand.`")
        for name in sorted(certainty(relation).given - {a.name for a in relation.attributes}):
            yield _warning(relation, f"`{relation.name}` has no attribute `{name}`, which its comment takes as given")


def _misnamed(relations: Iterable[RelationDecl]) -> Iterator[Diagnostic]:
    for relation in relations:
        for name in (relation.name, *(a.name for a in relation.attributes)):
            if not NAME.fullmatch(name):
                yield _warning(relation, f"`{name}` is not written in snake_case")
        if len(relation.attributes) > MOST_ATTRIBUTES:
            yield _warning(relation, f"`{relation.name}` has {len(relation.attributes)} attributes, more than {MOST_ATTRIBUTES}")


def _dead(rules: Rules, relations: Iterable[RelationDecl]) -> Iterator[Diagnostic]:
    """Relations that nothing reads and nobody is shown."""
    read = {_own_name(name) for reader, names in rules.reads.items() for name in names if name != reader}
    for relation in relations:
        exempt = relation.is_output or relation.is_input or relation.name.startswith("assert_")
        if not exempt and _own_name(relation.name) not in read:
            yield _warning(relation, f"`{relation.name}` is read by no other relation and put out by none")


def _uncertain(program: Program, rules: Rules, about: Callable[[str], bool]) -> Iterator[Diagnostic]:
    known = {name: certainty(declaration) for name, declaration in program.relations.items()}
    for rule in rules.all:
        head = known[rule.clause.head.name]
        if head.word == "Must" and about(rule.location.path) and not rule.generated:
            for name in _possible(rule, program, known):
                message = f"`{rule.clause.head.name}` is a Must, and rests on `{name}`, which is a May"
                yield Diagnostic(message, rule.location, severity="warning")


def _possible(rule: Rule, program: Program, known: dict[str, Certainty]) -> list[str]:
    """The May relations that a clause rests on, except for what its head takes as given."""
    declaration = program.relations[rule.clause.head.name]
    given = known[declaration.name].given
    granted = {
        node.name
        for attribute, argument in zip(declaration.attributes, rule.clause.head.args, strict=True)
        if attribute.name in given
        for node in walk(argument)
        if isinstance(node, Variable)
    }
    for literal in rule.clause.body:  # the parts of a record are given with it
        if isinstance(literal, Constraint) and literal.op == "=":
            for one, other in ((literal.left, literal.right), (literal.right, literal.left)):
                if isinstance(one, Variable) and one.name in granted:
                    granted |= _names(other)
    found: dict[str, None] = {}
    for literal in rule.clause.body:
        for atom, strict in atoms_of(literal):
            if not strict and known[atom.name].word == "May" and not _names(atom) & granted:
                found[atom.name] = None
    return list(found)


def _names(term: Argument | Literal) -> set[str]:
    return {node.name for node in walk(term) if isinstance(node, Variable)}


def _warning(relation: RelationDecl, message: str) -> Diagnostic:
    return Diagnostic(message, relation.location, severity="warning")
