"""Check that every call site a reader finds with a regular expression is a port, or has a reason not to be one.

    benchmarks/coverage.py SYSTEMS_DIR SYSTEM...

A site is a line with `.advertise(`, `->subscribe<` and the like in a source or header that is compiled into a node or nodelet, comments,
strings and `#if 0` left out. It is a port (with a known or, with a reason, an unknown name); or unreached (in a function that no component
with this file runs); or none of the API's (a function of the system that is called so, lines that conditional compilation leaves out); or
missed. Missed sites are listed, with `--list` unreached ones too.

Beside the sites, all API calls are counted that the rules know of (ports of every library and accesses to parameters), and those whose name
is not known, *unnamed*; all reached calls that send a message, a request or a goal, and those of which no port is known that it goes
through, *portless*; all ports that something can be sent through, and those that nothing is known to go through, *silent*. `--list` shows
these, so that a reader can judge which ones the source names.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosarch.base.limits import LIMITS
from rosarch.base.pool import Failure, default_jobs, run_tasks
from rosarch.extractor.pipeline import ComponentFacts, extract
from rosarch.extractor.settings import Settings
from rosarch.rule_programs.sets import component_program

SITE = re.compile(r"(?:\.|->)\s*(?:template\s+)?(advertise|subscribe|advertiseService|serviceClient)\s*[<(](?!\s*\))")
TOKENS = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
CONDITIONAL = re.compile(r"\s*#\s*(if|ifdef|ifndef|elif|else|endif)\b\s*(.*)")
SENDING = frozenset({"publisher", "service_client", "action_client", "tf_broadcaster"})
NEAR = 2  # lines between the regular expression's match and the place of the call that the tool reports

Site = tuple[str, int]


@dataclass
class Judged:
    """Nodes of the syntax tree that should be understood, and those that are not in any component, with what is known about them."""

    nodes: set[str] = field(default_factory=set)
    missing: dict[str, str] = field(default_factory=dict)

    def include(self, other: Judged) -> None:
        """What is known from one component is known."""
        known = (self.nodes - self.missing.keys()) | (other.nodes - other.missing.keys())
        self.nodes |= other.nodes
        self.missing = {node: text for node, text in (self.missing | other.missing).items() if node not in known}


@dataclass
class Seen:
    """What the analysis of a system says, by file and line."""

    files: set[str] = field(default_factory=set)
    ports: set[Site] = field(default_factory=set)
    unknown: set[Site] = field(default_factory=set)
    calls: dict[Site, set[bool]] = field(default_factory=lambda: defaultdict(set))
    others: set[Site] = field(default_factory=set)
    unnamed: Judged = field(default_factory=Judged)
    portless: Judged = field(default_factory=Judged)
    silent: Judged = field(default_factory=Judged)
    components: int = 0
    failed: list[str] = field(default_factory=list)


def stripped(text: str) -> str:
    """The text without comments, strings and `#if 0` parts; lines keep their numbers."""
    text = TOKENS.sub(lambda match: ("" if match[0].startswith("/") else '""') + "\n" * match[0].count("\n"), text)
    lines, hidden = [], []
    for line in text.split("\n"):
        directive = CONDITIONAL.match(line)
        if directive and directive[1] in ("if", "ifdef", "ifndef"):
            hidden.append(directive[1] == "if" and directive[2].strip() == "0")
        elif directive and hidden and directive[1] in ("elif", "else"):
            hidden[-1] = False
        elif directive and hidden and directive[1] == "endif":
            hidden.pop()
        lines.append("" if any(hidden) else line)
    return "\n".join(lines)


def sites(root: Path, files: Iterable[str]) -> list[Site]:
    """The places in `files` that the regular expression finds."""
    found = []
    for name in sorted(files):
        text = stripped((root / name).read_text(encoding="utf-8", errors="replace"))
        found += [(name, text.count("\n", 0, match.start(1)) + 1) for match in SITE.finditer(text)]
    return sorted(set(found))


def read_system(root: Path, jobs: int) -> Seen:
    """Extract and evaluate every component of a system."""
    program, seen = component_program(), Seen()
    keep = ("port", "port_site", "port_unknown", "parameter_site", "parameter_access", "node_location", "reachable")
    keep += ("sends", "api_call", "api_sends", "api_sends_at_once", "expr_runs")

    def work(component: ComponentFacts) -> Seen:
        rows = component.rows()
        result = program.evaluate(rows, keep=keep)
        return component_seen(rows, {name: result.rows(name) for name in keep})

    with extract(root, settings=Settings(jobs)) as extraction:
        for index, outcome in run_tasks(work, extraction.components, jobs=jobs, timeout=LIMITS.evaluation):
            component = extraction.components[index]
            if isinstance(outcome, Failure):
                seen.failed.append(f"{component.package}/{component.name}: {outcome.reason}")
                continue
            seen.files |= outcome.files
            seen.ports |= outcome.ports
            seen.unknown |= outcome.unknown
            seen.others |= outcome.others
            seen.components += 1
            seen.unnamed.include(outcome.unnamed)
            seen.portless.include(outcome.portless)
            seen.silent.include(outcome.silent)
            for site, runs in outcome.calls.items():
                seen.calls[site] |= runs
        nothing = [d for d in extraction.diagnostics if d.kind == "source" and os.path.relpath(d.path, root) not in seen.files]
        seen.failed += [str(d).partition("\n")[0] for d in nothing]
    return seen


def component_seen(rows: Mapping[str, Iterable[Any]], derived: Mapping[str, Iterable[Any]]) -> Seen:
    """Files, ports and calls of one component."""
    paths = dict(rows["source_file"])
    places = {node: (path, line) for node, path, line, _column in derived["node_location"]}
    unknown = {port for port, _reason in derived["port_unknown"]}
    seen = Seen(files=set(paths.values()))
    for (port,) in derived["port"]:
        if port[0] in places:
            (seen.unknown if port in unknown else seen.ports).add(places[port[0]])
    reachable = {function for (function,) in derived["reachable"]}
    functions = dict(rows["expr_function"])
    locations = {node: (paths[file], line) for node, file, line, _column in rows["location"] if file in paths}
    own = {call for call, function in rows["call_function"] if "@" in function}  # the system's functions have a place
    for call, name in rows["call"]:
        if call in locations and call in own and SITE.search(f".{name}("):
            seen.others.add(locations[call])
        elif call in locations:
            seen.calls[locations[call]].add(functions.get(call) in reachable)
    seen.unnamed = _unnamed(derived, places)
    seen.portless, seen.silent = _sends(derived, places)
    for file, first, last in rows.get("lines_skipped", ()):
        seen.others |= {(paths[file], line) for line in range(first, last + 1)}
    return seen


def _unnamed(derived: Mapping[str, Iterable[Any]], places: Mapping[str, Site]) -> Judged:
    """The calls that make ports or access parameters, and those without any known name."""
    ports = {site for site, *_rest in derived["port_site"] if site in places}
    parameters = {call for call, _op in derived["parameter_site"] if call in places}
    named = {site for ((site, _kind, name),) in derived["port"] if name[:1] != "?"}
    named |= {call for call, _op, name in derived["parameter_access"] if name[:1] != "?"}
    made = {site for ((site, _kind, _name),) in derived["port"]}
    calls = (ports & made) | parameters
    reasons = {site: f"{kind} {name} ({reason})" for (site, kind, name), reason in derived["port_unknown"]}
    return Judged(calls, {call: "{}:{}: {}".format(*places[call], reasons.get(call, "parameter")) for call in calls - named})


def _sends(derived: Mapping[str, Iterable[Any]], places: Mapping[str, Site]) -> tuple[Judged, Judged]:
    """The calls that send, and those without a port; the ports that something can be sent through, and those through which nothing is."""
    functions = {name for relation in ("api_sends", "api_sends_at_once") for (name,) in derived[relation]}
    run = {expr for (expr,) in derived["expr_runs"]}
    calls = {call: name for call, name in derived["api_call"] if name in functions and call in run and call in places}
    sent = {call for call, _port in derived["sends"]}
    lost = {call: "{}:{}: {}".format(*places[call], name) for call, name in calls.items() if call not in sent}
    ports = {site: f"{kind} {name}" for ((site, kind, name),) in derived["port"] if kind in SENDING and site in places}
    used = {site for _call, (site, _kind, _name) in derived["sends"]}
    silent = {site: "{}:{}: {}".format(*places[site], text) for site, text in ports.items() if site not in used}
    return Judged(set(calls), lost), Judged(set(ports), silent)


def classify(site: Site, seen: Seen) -> str:
    """Port, unknown, unreached, other or missed."""
    near = [(site[0], site[1] + distance) for distance in sorted(range(-NEAR, NEAR + 1), key=abs)]
    for label, found in (("ports", seen.ports), ("unknown", seen.unknown)):
        if any(place in found for place in near):
            return label
    if site in seen.others or any(place in seen.others and place not in seen.calls for place in near):
        return "others"
    runs = next((seen.calls[place] for place in near if place in seen.calls), {True})
    return "missed" if True in runs else "unreached"


def main() -> int:
    """Print a row per system; the exit code is 1 when a site is missed or a component failed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("systems", type=Path)
    parser.add_argument("names", nargs="+", metavar="SYSTEM")
    parser.add_argument("--jobs", type=int, default=default_jobs())
    parser.add_argument("--list", action="store_true", help="list unreached sites too")
    options = parser.parse_args()
    for name in options.names:
        if not (options.systems / name).is_dir():
            parser.error(f"{options.systems / name}: no such folder")
    columns = ["system", "components", "sites", "ports", "unknown", "unreached", "not API", "missed", "API calls", "unnamed"]
    columns += ["sends", "portless", "senders", "silent", "failed"]
    print(f"| {' | '.join(columns)} |\n|{'---|' * len(columns)}")
    trouble: list[str] = []
    failed = False
    for name in options.names:
        root = options.systems / name
        seen = read_system(root, options.jobs)
        classes: dict[str, list[Site]] = defaultdict(list)
        for site in sites(root, seen.files):
            classes[classify(site, seen)].append(site)
        counts = [seen.components, sum(map(len, classes.values()))]
        counts += [len(classes[label]) for label in ("ports", "unknown", "unreached", "others", "missed")]
        judged = {"unnamed": seen.unnamed, "portless": seen.portless, "silent": seen.silent}
        counts += [count for found in judged.values() for count in (len(found.nodes), len(found.missing))]
        print(f"| {name} | {' | '.join(map(str, [*counts, len(seen.failed)]))} |", flush=True)
        failed |= bool(classes["missed"] or seen.failed)
        trouble += [f"{name}: missed {path}:{line}" for path, line in classes["missed"]]
        trouble += [f"{name}: unreached {path}:{line}" for path, line in classes["unreached"] if options.list]
        for label, found in judged.items():
            trouble += [f"{name}: {label} {text}" for text in sorted(found.missing.values()) if options.list]
        trouble += [f"{name}: failed {text}" for text in seen.failed]
    print("\n".join(["", *trouble]))
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
