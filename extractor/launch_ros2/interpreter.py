"""Python launch files, interpreted over their syntax trees: statements, modules, and branches that cannot be decided.

Of an undecided `if`, both branches are interpreted, one after the other from the same names; what differs afterwards is an `Either`. What
one of them adds to a list or launch description is an `Either` there. A branch that raises is taken for one that does not happen.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from typing import Any

from rosarch.extractor.launch.model import Condition
from rosarch.extractor.launch_ros2.calls import GENERAL, Attempt, Calls
from rosarch.extractor.launch_ros2.expressions import Raised, Stopped, Undecided, either
from rosarch.extractor.launch_ros2.natives_objects import enumerate_members, is_enumeration
from rosarch.extractor.launch_ros2.registry import CONSTANTS, NATIVES
from rosarch.extractor.launch_ros2.values import (
    MODULES,
    NOTHING,
    Class,
    Constructor,
    Either,
    Frame,
    Instance,
    Made,
    Module,
    ModuleFrame,
    TextFile,
    Unknown,
)
from rosarch.extractor.python_syntax import bound_names, parse_python

MAX_ROUNDS = 10_000
MAX_FORKS = 16
SUBJECT = "the subject"
"""What a `match` is about, under a name that Python has not."""


class _Return(Exception):
    def __init__(self, value: Any) -> None:
        self.value = value


class _Leave(Exception):
    """`break`."""


class _Next(Exception):
    """`continue`."""


class Interpreter(Calls):
    """Interprets the modules that launch files are."""

    def run_module(self, name: str, file: str, text: str, *, is_launch_file: bool = False) -> ModuleFrame:
        """The names of a module after it has run.

        Raises:
            SyntaxError: it is not Python 3.
            Raised: it raises an exception; `frame.variables` of the module are as they were by then.
        """
        tree = parse_python(text)
        module = ModuleFrame(name, file, is_launch_file, {"__name__": name, "__file__": file}, bound=bound_names(tree))
        self.modules[name] = module
        self._top(tree.body, Frame(module.variables, module))
        return module

    def _top(self, body: Sequence[ast.stmt], frame: Frame) -> None:
        """Run statements of which none may leave a function or loop."""
        try:
            self.block(body, frame)
        except (_Return, _Leave, _Next):
            raise Raised("SyntaxError", "`return`, `break` or `continue` at a wrong place", self.place(body[0], frame)) from None

    def block(self, body: Sequence[ast.stmt], frame: Frame) -> None:
        """Run statements."""
        for statement in body:
            self.step()
            method = self.method_for(statement)
            if method is None:
                self.misunderstood(self.place(statement, frame), f"{type(statement).__name__} is not interpreted")
            else:
                method(statement, frame)

    def body_of(self, body: Sequence[ast.stmt], frame: Frame) -> Any:
        """What a function with this body returns."""
        depth = len(self.path)
        try:
            self.block(body, frame)
            found: Any = None
        except _Return as returned:
            found = returned.value
        except (_Leave, _Next):
            raise Raised("SyntaxError", "`break` or `continue` outside of a loop", self.place(body[0], frame)) from None
        finally:
            del self.path[depth:]
        for condition, value in reversed(frame.returns):
            found = either(condition, value, found)
        return found if frame.yielded is None else frame.yielded

    # -- simple statements ----------------------------------------------------------------------------------------------------

    def _do_expr(self, node: ast.Expr, frame: Frame) -> None:
        if isinstance(node.value, (ast.Yield, ast.YieldFrom)):
            self._yielded(node.value, frame)
        else:
            self.value(node.value, frame)

    def _yielded(self, node: ast.Yield | ast.YieldFrom, frame: Frame) -> None:
        if node.value is not None and frame.yielded is not None:
            found = self.value(node.value, frame)
            frame.yielded.extend([found] if isinstance(node, ast.Yield) else self.iterated(found, node.value, frame))

    def _do_assign(self, node: ast.Assign, frame: Frame) -> None:
        value = self.value(node.value, frame)
        for target in node.targets:
            self.assign(target, value, frame)

    def _do_annassign(self, node: ast.AnnAssign, frame: Frame) -> None:
        if node.value is not None:
            self.assign(node.target, self.value(node.value, frame), frame)

    def _do_augassign(self, node: ast.AugAssign, frame: Frame) -> None:
        before = self.value(node.target, frame)
        added = self.value(node.value, frame)
        if isinstance(before, list) and isinstance(node.op, ast.Add):
            before.extend(map(self.guarded, self.added(added, node.value, frame)))
        else:
            self.assign(node.target, self.operation(node.op, before, added, node.value, frame), frame)

    def assign(self, target: ast.expr, value: Any, frame: Frame) -> None:
        if isinstance(target, ast.Name):
            self._variables_of(target.id, frame)[target.id] = value
        elif isinstance(target, (ast.Tuple, ast.List)):
            self._unpack(target.elts, value, frame)
        elif isinstance(target, ast.Attribute):
            owner = self.value(target.value, frame)
            if isinstance(owner, Instance):
                owner.attributes[target.attr] = value
                if owner.made is not None and target.attr.startswith(f"_{owner.made.kind}__"):  # a private attribute of the base class
                    owner.made.arguments[target.attr.partition("__")[2]] = value
            elif isinstance(owner, Made):
                owner.arguments[target.attr.strip("_")] = value
        elif isinstance(target, ast.Subscript):
            owner, key = self.value(target.value, frame), self.value(target.slice, frame)
            try:
                self.set_item(owner, key, value)
            except TypeError as error:  # a key that cannot be one
                raise Raised("TypeError", str(error), self.place(target, frame)) from None

    def _variables_of(self, name: str, frame: Frame) -> dict[str, Any]:
        here: Frame | None = frame
        while here is not None and name in here.shared:
            here = here.above
        if here is None or (here is not frame and name not in here.variables):
            return frame.module.variables
        return here.variables

    def _unpack(self, targets: Sequence[ast.expr], value: Any, frame: Frame) -> None:
        star = next((index for index, one in enumerate(targets) if isinstance(one, ast.Starred)), None)
        if not isinstance(value, (list, tuple)) or (star is None and len(value) != len(targets)):
            # an item that is not known may stand for each of many
            if isinstance(value, (list, tuple)) and not any(isinstance(item, Unknown) for item in value):
                raise Raised("ValueError", "wrong number of values to unpack", self.place(targets[0], frame))
            value = [Unknown(ast.unparse(target), self.place(target, frame)) for target in targets]
            star = None
        if star is None:
            for target, item in zip(targets, value, strict=False):
                self.assign(target, item, frame)
            return
        after = len(targets) - star - 1
        middle = list(value[star : len(value) - after])
        items = [*value[:star], middle, *value[len(value) - after :]]
        for target, item in zip(targets, items, strict=False):
            self.assign(target.value if isinstance(target, ast.Starred) else target, item, frame)

    def _do_delete(self, node: ast.Delete, frame: Frame) -> None:
        for target in node.targets:
            if isinstance(target, ast.Name):
                frame.variables.pop(target.id, None)
            elif isinstance(target, ast.Subscript):
                owner, key = self.value(target.value, frame), self.value(target.slice, frame)
                if isinstance(owner, (dict, list)) and not isinstance(key, Unknown) and not self.path:
                    del owner[key]

    def _do_return(self, node: ast.Return, frame: Frame) -> None:
        raise _Return(None if node.value is None else self.value(node.value, frame))

    def _do_raise(self, node: ast.Raise, frame: Frame) -> None:
        error = node.exc.func if isinstance(node.exc, ast.Call) else node.exc
        text = ast.unparse(node.exc) if node.exc is not None else "an exception again"
        kind = ast.unparse(error).rpartition(".")[2] if error is not None else "Exception"
        raise Raised(kind, text, self.place(node, frame), certain=not self.unset)

    def _do_pass(self, _node: ast.Pass, _frame: Frame) -> None:
        """Nothing."""

    _do_assert = _do_pass

    def _do_break(self, _node: ast.Break, _frame: Frame) -> None:
        raise _Leave

    def _do_continue(self, _node: ast.Continue, _frame: Frame) -> None:
        raise _Next

    def _do_global(self, node: ast.Global | ast.Nonlocal, frame: Frame) -> None:
        frame.shared.update(node.names)

    _do_nonlocal = _do_global

    # -- definitions ----------------------------------------------------------------------------------------------------------

    def _do_functiondef(self, node: ast.FunctionDef | ast.AsyncFunctionDef, frame: Frame) -> None:
        frame.variables[node.name] = self.decorated(self.function(node, frame), node.decorator_list, frame)

    _do_asyncfunctiondef = _do_functiondef

    def _do_classdef(self, node: ast.ClassDef, frame: Frame) -> None:
        bases = tuple(self.value(base, frame) for base in node.bases)
        inner = Frame({}, frame.module, frame)
        self._top(node.body, inner)
        names = tuple(one.target.id for one in node.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name))
        made = Class(node.name, bases, inner.variables, names)
        self.own(made)
        if is_enumeration(bases):
            enumerate_members(made)
        frame.variables[node.name] = made

    def _do_import(self, node: ast.Import, frame: Frame) -> None:
        for alias in node.names:
            found = self.module(alias.name, frame, self.place(node, frame))
            if alias.asname:
                frame.variables[alias.asname] = found
            else:
                first = alias.name.partition(".")[0]
                frame.variables[first] = found if first == alias.name else Module(first)

    def _do_importfrom(self, node: ast.ImportFrom, frame: Frame) -> None:
        package = frame.module.name if node.level else ""
        for _ in range(node.level - frame.module.file.endswith("__init__.py")):
            package = package.rpartition(".")[0]
        name = ".".join(part for part in (package, node.module) if part)
        for alias in node.names:
            module = self.module(name, frame, self.place(node, frame))
            if alias.name == "*":
                frame.variables.update(_all_of(module))
                continue
            frame.variables[alias.asname or alias.name] = self.member(module, alias.name, node, frame)

    # -- blocks ---------------------------------------------------------------------------------------------------------------

    def _do_if(self, node: ast.If, frame: Frame) -> None:
        test = self.value(node.test, frame)
        truth = self.truth(test)
        if truth is not None:
            self.block(node.body if truth else node.orelse, frame)
            return
        if len(self.path) >= MAX_FORKS:
            raise Undecided
        self._both(self.condition(node.test, test, frame), node, frame)

    def _do_match(self, node: ast.Match, frame: Frame) -> None:
        """`match`, as the chain of `if` that says the same."""
        subject = node.subject
        if not isinstance(subject, ast.Name):  # what is calculated is so once
            frame.variables[SUBJECT] = self.value(subject, frame)
            subject = ast.copy_location(ast.Name(SUBJECT, ast.Load()), subject)
        chain: list[ast.stmt] = []
        for case in reversed(node.cases):
            test = _tested(case.pattern, subject)
            if test is None:
                self.misunderstood(self.place(case.pattern, frame), f"a pattern of `match` is not interpreted: {ast.unparse(case.pattern)}")
                return
            test = test if case.guard is None else ast.BoolOp(ast.And(), [test, case.guard])
            chain = [ast.fix_missing_locations(ast.copy_location(ast.If(test, case.body, chain), case.pattern))]
        self.block(chain, frame)

    def _both(self, holds: Condition, node: ast.If, frame: Frame) -> None:
        """Both branches of an undecided `if`, and what they come to."""
        fails = holds.contrary()
        before = dict(frame.variables)
        first, first_return, first_dead = self._branch(node.body, holds, frame)
        frame.variables.clear()
        frame.variables.update(before)
        second, second_return, second_dead = self._branch(node.orelse, fails, frame)
        if first_dead != second_dead:
            self._take(*((second, second_return) if first_dead else (first, first_return)), frame)
            return
        if first_return is not None and second_return is not None:
            raise _Return(either(holds, first_return[0], second_return[0]))
        if first_return is not None or second_return is not None:
            returned, condition, other = (first_return, holds, second) if first_return is not None else (second_return, fails, first)
            frame.returns.append((condition, returned[0] if returned else None))
            self.path.append(fails if first_return is not None else holds)
            self._take(other, None, frame)
            return
        names = {**first, **second}
        self._take({name: either(holds, first.get(name, NOTHING), second.get(name, NOTHING)) for name in names}, None, frame)

    @staticmethod
    def _take(variables: dict[str, Any], returned: tuple[Any] | None, frame: Frame) -> None:
        frame.variables.clear()
        frame.variables.update(variables)
        if returned is not None:
            raise _Return(returned[0])

    def _branch(self, body: Sequence[ast.stmt], condition: Condition, frame: Frame) -> tuple[dict[str, Any], tuple[Any] | None, bool]:
        """The names after a branch, what it returns, and whether it raises."""
        depth = len(self.path)
        self.path.append(condition)
        returned: tuple[Any] | None = None
        dead = False
        try:
            self.block(body, frame)
        except _Return as found:
            returned = (found.value,)
        except (_Leave, _Next):
            pass
        except Raised:
            dead = True
        finally:
            del self.path[depth:]
        return dict(frame.variables), returned, dead

    def _do_for(self, node: ast.For | ast.AsyncFor, frame: Frame) -> None:
        items = self.value(node.iter, frame)
        items = items if isinstance(items, list) else self.iterated(items, node.iter, frame)
        for count, item in enumerate(items):  # a list may change meanwhile
            if count > MAX_ROUNDS:
                raise Stopped("a loop with too many rounds")
            conditions = [item.condition] if isinstance(item, Either) and item.second is NOTHING else []
            self.path.extend(conditions)
            try:
                self.assign(node.target, item.first if conditions else item, frame)
                self.block(node.body, frame)
            except _Leave:
                return
            except _Next:
                continue
            finally:
                del self.path[len(self.path) - len(conditions) :]
        self.block(node.orelse, frame)

    _do_asyncfor = _do_for

    def _do_while(self, node: ast.While, frame: Frame) -> None:
        for _ in range(MAX_ROUNDS):
            if not self.truth(self.value(node.test, frame)):
                return
            try:
                self.block(node.body, frame)
            except _Leave:
                return
            except _Next:
                continue
        raise Stopped("a loop with too many rounds")

    def _do_try(self, node: ast.Try, frame: Frame) -> None:
        attempt = Attempt(frozenset(name for handler in node.handlers for name in _names_of(handler)))
        before, depth = dict(frame.variables), len(self.path)
        self.attempts.append(attempt)
        returned: _Return | None = None
        try:
            self._attempt(node, frame)
        except _Return as found:
            returned = found
        finally:
            self.attempts.pop()
            del self.path[depth:]
        if attempt.missed:
            self._instead(attempt, node, before, returned, frame)
        elif returned is not None:
            raise returned

    def _instead(self, attempt: Attempt, node: ast.Try, before: dict[str, Any], returned: _Return | None, frame: Frame) -> None:
        """The handler of what may have been raised, in addition to what comes without."""
        holds = attempt.missed[0]
        handler = next(one for one in node.handlers if _names_of(one) & attempt.kinds)
        after = dict(frame.variables)
        frame.variables.clear()
        frame.variables.update(before)
        if returned is not None:  # what follows comes after the handler only
            frame.returns.append((holds, returned.value))
            self.path.append(holds.contrary())
            self.block(handler.body, frame)
            return
        handled, left, dead = self._branch(handler.body, holds.contrary(), frame)
        if left is not None:
            frame.returns.append((holds.contrary(), left[0]))
        if dead or left is not None:
            self.path.append(holds)
            self._take(after, None, frame)
            return
        self._take(
            {name: either(holds, after.get(name, NOTHING), handled.get(name, NOTHING)) for name in {**after, **handled}}, None, frame
        )

    def _attempt(self, node: ast.Try, frame: Frame) -> None:
        try:
            try:
                self.block(node.body, frame)
            except Raised as error:
                handler = next((one for one in node.handlers if _handles(one, error)), None)
                if handler is None:
                    raise
                if handler.name:
                    frame.variables[handler.name] = error.message
                self.block(handler.body, frame)
            else:
                self.block(node.orelse, frame)
        finally:
            self.block(node.finalbody, frame)

    def _do_with(self, node: ast.With | ast.AsyncWith, frame: Frame) -> None:
        for item in node.items:
            value = self.value(item.context_expr, frame)
            if item.optional_vars is not None:
                self.assign(item.optional_vars, value, frame)
        self.block(node.body, frame)
        for item in node.items:
            if isinstance(item.optional_vars, ast.Name) and isinstance(found := frame.variables.get(item.optional_vars.id), TextFile):
                self.close(found)

    _do_asyncwith = _do_with


def _tested(pattern: ast.pattern, subject: ast.expr) -> ast.expr | None:
    """Whether a subject is as a pattern of `match` wants it, which may bind a name; None for patterns of parts and classes."""
    if isinstance(pattern, ast.MatchValue):
        return ast.Compare(subject, [ast.Eq()], [pattern.value])
    if isinstance(pattern, ast.MatchSingleton):
        return ast.Compare(subject, [ast.Is()], [ast.Constant(pattern.value)])
    if isinstance(pattern, ast.MatchOr):
        found = [_tested(one, subject) for one in pattern.patterns]
        return None if None in found else ast.BoolOp(ast.Or(), [one for one in found if one is not None])
    if not isinstance(pattern, ast.MatchAs):
        return None
    inner = ast.Constant(True) if pattern.pattern is None else _tested(pattern.pattern, subject)
    if pattern.name is None or inner is None:
        return inner
    bound: ast.expr = ast.NamedExpr(ast.Name(pattern.name, ast.Store()), subject)
    return ast.BoolOp(ast.And(), [inner, ast.BoolOp(ast.Or(), [ast.Compare(bound, [ast.Is()], [subject]), ast.Constant(True)])])


def _all_of(module: Any) -> dict[str, Any]:
    """What `import *` brings."""
    if not isinstance(module, Module):
        return {}
    if module.frame is None:
        known = {**CONSTANTS, **NATIVES}
        parts = {full[len(module.name) + 1 :]: value for full, value in known.items() if full.startswith(f"{module.name}.")}
        return {**parts, **{name: Constructor(name) for name in MODULES.get(module.name, ())}}
    return {name: value for name, value in module.frame.variables.items() if not name.startswith("_")}


_RELATED = {
    "OSError": {"FileNotFoundError", "EnvironmentError", "IOError"},
    "IndexError": {"LookupError"},
    "KeyError": {"LookupError"},
    "FileNotFoundError": {"OSError", "EnvironmentError", "IOError"},
}


def _handles(handler: ast.ExceptHandler, error: Raised) -> bool:
    """Whether a handler is for an exception of this kind, by the names of both."""
    return bool(_names_of(handler) & (GENERAL | {error.kind} | _RELATED.get(error.kind, set())))


def _names_of(handler: ast.ExceptHandler) -> set[str]:
    """The exceptions that a handler is for; one without a name is for all."""
    if handler.type is None:
        return set(GENERAL)
    kinds = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]
    return {ast.unparse(kind).rpartition(".")[2] for kind in kinds}
