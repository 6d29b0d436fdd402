"""Compare what rosarch and the real roslaunch make of launch files.

    benchmarks/launch.py ORACLE.jsonl ROOT [--oracle-root DIR] [--package-path DIR] [--env NAME=VALUE]

ORACLE.jsonl has one JSON object per launch file below ROOT: `file`, the `arguments` it was loaded with, if any (a list of
`name:=value`), and either what roslaunch then had in its memory (`nodes`, `params`, `tests`) or the `exception` it stopped with. Every
difference is listed; the exit code is 1 if there is one. A file that roslaunch rejects must be rejected by rosarch, with the same cause.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from rosarch.extractor.launch import Composition, Files, PackagePath, Problem, compose, record
from rosarch.extractor.launch.names import mapping

Record = dict[str, Any]
CUT = 300  # characters of an exception's text that the records have
_ANONYMOUS = re.compile(r"\$\(anon ([^)\s]+)[^)]*\)")
_NOT_INSTALLED = re.compile(r"no such command \[\[?'[^'/]+'")  # a program by its name

# What an exception of roslaunch says, the kind of problem that this is for rosarch, and the group that holds its subject.
CAUSES: tuple[tuple[str, str], ...] = (
    (r"environment variable '(.*?)' is not set", "env"),
    (r"requires the '(.*?)' arg to be set", "arg"),
    (r"arg '(.*?)' is not defined", "arg"),
    (r"\bname '(.*?)' is not defined", "arg"),
    (r"()\bname '.*?' is not defined", "eval"),
    (r"file does not exist \[(.*?)\]\n", "file"),
    (r"(?:No such file or|Is a|Not a) directory: '(.*?)'", "file"),
    (r"no such command \[\[?'(.*?)'", "command"),
    (r"()command \[.*returned with code", "command"),
    (r"unused args \[(.*?)\] for include", "unused-args"),
    (r"multiple nodes named \[(.*?)\]", "duplicate-node"),
    (r"arg '(.*?)' has already been declared", "arg-declared-twice"),
    (r"cannot override arg '(.*?)'", "arg-override"),
    (r"()include args must have declared values", "arg-without-value"),
    (r"()RecursionError", "cycle"),
    (r"()Invalid roslaunch XML syntax", "xml"),
    (r"()[Ii]nvalid YAML|Error within YAML|in \"<unicode string>\", line", "yaml"),
    (r"()No closing quotation|IndexError: list index", "command"),
    (r"()'utf-8' codec can't decode", "encoding"),
    (r"()'ROSLaunchConfig' object has no attribute", "condition"),
    (r"()cannot set both 'if' and 'unless'", "condition"),
    (r"()is not a '(?:bool|boolean)' type", "condition param-type"),
    (r"()Unknown type|invalid literal for int|could not convert string to float", "param-type machine number"),
    (r"()invalid bool value|bool value for .* must be non-empty", "bool number"),
    (r"()invalid float value|'timeout' cannot be empty|must be a (?:positive )?number|be a (?:positive )?number", "number"),
    (r"()one and only one of value/textfile", "param"),
    (r"()one and only one of value/default", "arg-value"),
    (r"XmlParseException: (\w+)\. \n\nMachine xml", "arg"),
    (r"()missing required|KeyError: |Invalid <arg> tag: '|'name' attribute must be non-empty|tags cannot have", "attribute"),
    (r"()remap (?:from|to)", "remap"),
    (r"()has an empty 'ns' attribute|into a global name", "namespace"),
    (r"()in order to use 'clear_params'|to use 'clear_params'", "clear-params"),
    (r"()(?i:machine)", "machine"),
    (r"()command must be 'load', 'dump', or 'delete'", "rosparam-command"),
    (r"()invalid with 'delete' command", "rosparam-delete"),
    (r"()'param' attribute must be set|Cannot load non-dictionary", "rosparam-name"),
    (r"()TypeError: .*(?:concatenate|subscriptable|must be str)", "yaml-key"),
    (r"()double underscore|SyntaxError|AttributeError|TypeError|ArithmeticError|ZeroDivisionError|OverflowError", "eval"),
    (r"()ValueError|IndexError|KeyError|Invalid <\w+> tag: .*\$\(eval ", "eval"),
    (r"()[Ss]ubstitution (?:args|command)|command only accepts|must specify|may only specify", "substitution"),
    (r"()respawn and required|node name cannot|must be non-empty|must be one of", "node"),
    (r"ResourceNotFound: The following package was not found in .*?>: (\S+)", "package"),
    (r"()ResourceNotFound: The following package was not found in", "package"),
    (r"ResourceNotFound: (\S+)", "package"),
)


def causes_of(exception: str) -> list[tuple[str, str]]:
    """The kinds of problem, and the subject if the text gives it, that an exception of roslaunch can stand for."""
    matches = [(re.search(pattern, exception, re.DOTALL), kinds) for pattern, kinds in CAUSES]
    return [(kind, match[1] or "") for match, kinds in matches if match for kind in kinds.split()]


def refusal_difference(exception: str, composition: Composition, cut: bool = False) -> str | None:
    """How the refusal of rosarch differs from that of roslaunch.

    A command that rosarch does not run counts as one that fails, and so does one that it answers although the program was not installed
    where roslaunch ran: that is no property of the files. With `cut`, the text of the exception may end before the cause; then
    rosarch must reject something after entering the files whose names are left.
    """
    causes = causes_of(exception)
    through = re.findall(r"while processing (\S+):\n", exception)
    hidden = cut and bool(through) and set(through) <= {*composition.files, *(problem.subject for problem in composition.problems)}
    if not causes and not hidden:
        return f"roslaunch's reason is not known to this program: {exception!r}"
    for problem in composition.problems:
        fatal = problem.fatal and not problem.conditions
        if (fatal or problem.kind == "command") and (hidden or is_cause(problem, causes)):
            return None
        if fatal:
            return f"roslaunch: {exception!r}, rosarch: {problem}"
    return None if _NOT_INSTALLED.search(exception) else f"roslaunch: {exception!r}, rosarch: no refusal"


def is_cause(problem: Problem, causes: list[tuple[str, str]]) -> bool:
    """Whether `problem` is one of `causes`."""
    about = _ANONYMOUS.sub(r"$(anon \1)", problem.subject)
    return any(problem.kind == kind and subject in ("", about) for kind, subject in causes)


def differences(oracle: Record, mine: Record) -> Iterator[str]:
    """All differences between two records of a file that roslaunch loads."""
    for index, (theirs, own) in enumerate(zip(oracle["nodes"], mine["nodes"])):  # noqa: B905 (lengths are compared below)
        for key in theirs:
            if theirs[key] != own.get(key):
                yield f"node {index} {theirs['namespace']}{theirs['name']}: {key} is {theirs[key]!r}, rosarch has {own.get(key)!r}"
    if len(oracle["nodes"]) != len(mine["nodes"]):
        yield f"{len(oracle['nodes'])} nodes, rosarch has {len(mine['nodes'])}"
    if oracle.get("tests", mine["tests"]) != mine["tests"]:
        yield f"{oracle['tests']} tests, rosarch has {mine['tests']}"
    theirs, own = (Counter((key, _text(value)) for key, value in params.items()) for params in (oracle["params"], mine["params"]))
    for key, value in sorted((theirs - own).keys()):
        others = [text for name, text in own if name == key]
        yield f"parameter {key} is {value}, rosarch has {others[0] if others else 'none'}"
    for key, value in sorted((own - theirs).keys()):
        if key not in oracle["params"]:
            yield f"parameter {key} is not there, rosarch has {value}"


def _text(value: Any) -> str:
    return json.dumps(value, sort_keys=True)


def without_anonymous(text: str, names: Iterable[str]) -> str:
    """`text` of roslaunch with its random names (`talker_host_123_456789`) as rosarch writes them."""
    for name in names:
        legal = re.sub(r"[-.:]", "_", name)
        text = re.sub(rf"{re.escape(legal)}_\w+?_\d+_\d{{10,}}", f"$(anon {name})", text)
    return text


def compare_file(oracle: Record, root: Path, files: Files, options: argparse.Namespace) -> list[str]:
    """The differences for one launch file, texts made equal in what differs between machines: the root folder and anonymous names."""
    arguments = dict(pair for word in oracle.get("arguments", ()) if (pair := mapping(word)))
    namespace = arguments.pop("__ns", None)
    composition = compose([root / oracle["file"]], arguments, files=files, environment=options.environment, namespace=namespace)
    mine = json.dumps(record(composition))
    names = sorted(set(_ANONYMOUS.findall(mine)))
    theirs = json.loads(without_anonymous(json.dumps(oracle), names).replace(str(options.oracle_root), str(root)))
    if "exception" in oracle:
        cut = len(oracle["exception"].partition(": ")[2]) >= CUT
        found = refusal_difference(theirs["exception"], composition, cut)
        return [found] if found else []
    if composition.refusal:
        return [f"roslaunch loads it, rosarch refuses: {composition.refusal}"]
    return list(differences(theirs, json.loads(_ANONYMOUS.sub(r"$(anon \1)", mine))))


def parse_arguments() -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(description="Compare what rosarch and the real roslaunch make of launch files.")
    parser.add_argument("oracle", type=Path, metavar="ORACLE.jsonl", help="what roslaunch made of them")
    parser.add_argument("root", type=Path, metavar="ROOT", help="the folder they lie in")
    parser.add_argument("--oracle-root", type=Path, metavar="DIR", help="where ROOT was when ORACLE.jsonl was written")
    parser.add_argument("--package-path", type=Path, action="append", metavar="DIR", help="more packages; default EXTRA_PKG, /usr/share")
    parser.add_argument("--env", action="append", default=[], metavar="NAME=VALUE", help="an environment variable that roslaunch had")
    options = parser.parse_args()
    options.root = options.root.resolve()
    options.oracle_root = options.oracle_root or options.root
    options.package_path = options.package_path or [*filter(None, os.environ.get("EXTRA_PKG", "").split(":")), "/usr/share"]
    options.environment = {
        "ROS_MASTER_URI": "http://localhost:11311",
        **os.environ,
        "ROS_PACKAGE_PATH": ":".join(map(str, (options.root, *options.package_path))),
        **dict(text.split("=", 1) for text in options.env),
    }
    return options


def main() -> int:
    """Compare all records; 1 when something differs."""
    options = parse_arguments()
    files = Files(PackagePath([options.root, *options.package_path]))
    counts: Counter[str] = Counter()
    start = time.perf_counter()
    for line in options.oracle.read_text(encoding="utf-8").splitlines():
        oracle = json.loads(line)
        found = compare_file(oracle, options.root, files, options)
        kind = "refused" if "exception" in oracle else "loaded"
        counts[kind] += 1
        counts[f"{kind} equal"] += not found
        for difference in found:
            print(f"{oracle['file']}: {difference}")
    print(
        f"{options.root.name}: {counts['loaded equal']} of {counts['loaded']} files that roslaunch loads are equal,"
        f" {counts['refused equal']} of {counts['refused']} that it refuses are refused for the same cause,"
        f" {time.perf_counter() - start:.1f} s"
    )
    return int(counts["loaded equal"] != counts["loaded"] or counts["refused equal"] != counts["refused"])


if __name__ == "__main__":
    sys.exit(main())
