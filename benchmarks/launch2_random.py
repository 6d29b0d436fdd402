"""Write random launch files of ROS 2, for comparisons with the real launch.

    benchmarks/launch2_random.py FOLDER [--files N] [--seed N] [--programs]

FOLDER gets a package with N launch files in turn in XML, YAML and Python, each with one that it includes: arguments,
configurations, groups, namespaces, remappings, parameters of all forms, environment, includes, nodes, containers, timers, conditions
and substitutions; in Python also event handlers, opaque functions, managed nodes, and scopes that are pushed and popped. Now and then
something is not declared, of another type, no Boolean or none of the choices, which launch rejects.
"""

from __future__ import annotations

import argparse
import random
from pathlib import Path
from typing import Any

from launch2_forms import PACKAGE, Action, Part, Text, written
from launch2_programs import DATA, HELPERS, Program

MANIFEST = (
    f"<package format='3'><name>{PACKAGE}</name><version>1.0.0</version><export><build_type>ament_cmake</build_type></export></package>\n"
)
PARAMETERS = """/**:
  ros__parameters: {shared: 1, rate: 2.5, flag: yes, text: 1e5}
""" + "".join(
    f"""namea{index}:
  ros__parameters: {{own: [1, 2], deep: {{er: x}}, p: {index}}}
/inner/namea{index}:
  ros__parameters: {{own: inner, rate: 1}}
/*/namei{index}:
  ros__parameters: {{star: 010, rate: 3}}
/**/namea{index + 20}:
  ros__parameters: {{stars: "on", shared: [x]}}
"""
    for index in range(0, 20, 2)
)
SUBSTITUTED = """/**:
  ros__parameters: {sub: $(var a0 fallback), deep: {er: "$(env ROS_DISTRO)"}, plain: [1, 2], sum: $(eval "'$(var i0 x)' + 'y'")}
"""
WORD = "word"
WORDS = ("x", "robot", "true", "false", "1", "0", "0.5", "y", "1e5", "007", "a.b", "-3", "True", "off")
VARIABLES = ("A", "B", "C")


class Writer:
    """Makes the actions of one launch file, whose arguments begin with `prefix`. `declared` are those that are there by then."""

    def __init__(self, rng: random.Random, prefix: str, included: str | None, *, python: bool) -> None:
        self.rng, self.prefix, self.included, self.python = rng, prefix, included, python
        self.declared: list[str] = []
        self.nodes = 0
        self.names = [f"name{prefix}{index}" for index in range(40)]
        rng.shuffle(self.names)

    def file(self) -> list[Action]:
        """All actions of a file."""
        found = [self.argument(f"{self.prefix}{index}") for index in range(self.rng.randint(1, 3))]
        return [*found, *self.actions(self.rng.randint(2, 5), 0)]

    def often(self, percent: float) -> bool:
        return self.rng.random() * 100 < percent

    # -- texts

    def word(self) -> Text:
        return [Part("text", text=self.rng.choice(WORDS))]

    def text(self, depth: int = 0) -> Text:
        """Any text."""
        found = self.word() if self.often(45) else [self.part(depth)]
        between = "/" if found[0].kind in ("find", "dirname", "filename") else self.rng.choice(("_", "/", "s"))  # a path ends there
        return [*found, Part("text", text=between), self.part(2)] if self.often(15) else found

    def part(self, depth: int) -> Part:
        kinds = ["var"] * 6 + ["env", "env_default", "find", "dirname", "eval", "command"] + (["if", "all", "any"] if depth < 2 else [])
        kinds += ["var_default", "math", "param", "filename", "file-content"]
        kind = self.rng.choice(kinds)
        if kind == "var" and self.declared:
            return self.variable()
        if kind == "env":
            return Part("env", [[Part("text", text="ROS_DISTRO")]])
        if kind == "env_default":
            return Part("env", [[Part("text", text=self.rng.choice(VARIABLES))], self.word()])
        if kind == "eval":
            return self.expression()
        if kind == "command":
            program = Part("find-exec", [[Part("text", text="echo")]]) if self.often(30) else Part("text", text="echo")
            return Part("command", [[program, Part("text", text=f" {self.rng.choice(WORDS)}")]])
        if kind == "if":
            return Part("if", [self.truth(depth + 1), self.word(), self.word()])
        if kind in ("all", "any"):
            return Part(kind, [self.truth(depth + 1) for _ in range(self.rng.randint(1, 3))])
        if kind == "var_default":
            return Part("var", [[Part("text", text=self.rng.choice([*self.declared, "undeclared"]))], self.word()])
        if kind == "math":
            return Part(
                "eval", [[Part("text", text=self.rng.choice(("math.floor(2.5)", "math.pi > 3", "max(1, 2)")))], [Part("text", text="math")]]
            )
        if kind == "param":
            default = [] if self.often(5) else [self.word()]
            return Part("param", [[Part("text", text=self.rng.choice(("p", "q", "deep.p")))], *default])
        if kind == "file-content":
            return Part(kind, [self.in_package("word.txt")])
        return Part(kind if kind in ("find", "dirname", "filename") else "text", text="word")

    def variable(self) -> Part:
        name = "undeclared" if self.often(1) else self.rng.choice(self.declared)
        return Part("var", [[Part("text", text=name)]])

    def expression(self) -> Part:
        left = [self.variable()] if self.declared and self.often(70) else self.word()
        operation = self.rng.choice((" == ", " != ", " + ", " in "))
        right = self.word()
        quote = Part("text", text="'")
        return Part("eval", [[quote, *left, quote, Part("text", text=operation), quote, *right, quote]])

    def truth(self, depth: int = 0) -> Text:
        """A text that is a Boolean, nearly always."""
        kind = self.rng.choice(("plain", "plain", "not", "and", "or", "equals", "not-equals", "eval"))
        if kind == "not" and depth < 2:
            return [Part("not", [self.truth(depth + 1)])]
        if kind in ("and", "or") and depth < 2:
            return [Part(kind, [self.truth(depth + 1), self.truth(depth + 1)])]
        if kind in ("equals", "not-equals"):
            return [Part(kind, [[self.variable()] if self.declared else self.word(), self.word()])]
        if kind == "eval" and self.declared:
            quote, name = Part("text", text="'"), self.variable()
            return [Part("eval", [[quote, name, quote, Part("text", text=self.rng.choice((" == ", " != "))), quote, *self.word(), quote]])]
        return [Part("text", text="maybe" if self.often(1) else self.rng.choice(("true", "false", "1", "0", "True", "FALSE")))]

    def condition(self) -> tuple[str, Text] | None:
        if self.python and self.declared and self.often(4):
            return self.rng.choice(("equals", "not-equals")), [self.variable(), *self.word()]
        return (self.rng.choice(("if", "unless")), self.truth()) if self.often(25) else None

    # -- actions

    def actions(self, count: int, depth: int) -> list[Action]:
        return [self.action(depth) for _ in range(count)]

    def action(self, depth: int) -> Action:
        kinds = (
            ["node"] * 5 + ["let"] * 2 + ["namespace", "remap", "parameter", "sim_time", "from_file", "set_env", "append_env", "unset_env"]
        )
        kinds += ["container", "load", "executable", "log", "reset_env", "log_dir", "shutdown", *(["reset"] if self.often(30) else [])]
        kinds += ["lifecycle", "unset", "environments"] if self.python else []
        if depth < 2:
            kinds += ["group"] * 4 + ["timer", "include"] + (["event", "opaque", "configurations"] if self.python else [])
        made: Action = getattr(self, self.rng.choice(kinds))(depth)
        made.condition = self.condition()
        return made

    def argument(self, name: str) -> Action:
        default = self.text() if self.often(30) else self.word()
        choices = ["x", "robot", *(part.text for part in default if part.text and self.often(90))] if self.often(5) else None
        self.declared.append(name)
        needed = self.often(4)
        return Action("arg", {"name": name, "default": None if needed else default, "choices": choices})

    def let(self, _depth: int) -> Action:
        name = self.rng.choice([*self.declared, "fresh"])
        made = Action("let", {"name": name, "value": self.text()})
        if name not in self.declared and self.often(30):
            self.declared.append(name)  # though what sets it may be conditional
        return made

    def group(self, depth: int) -> Action:
        keep = [(name, self.word()) for name in self.rng.sample(self.declared, min(len(self.declared), self.rng.randint(0, 2)))]
        attributes = {
            "scoped": self.rng.choice((True, True, True, False, None)),
            "forwarding": self.rng.choice((True, True, True, None, None, False)),
            "keep": [(name, value) for name, value in keep if self.often(40)],
        }
        known = list(self.declared)
        if attributes["scoped"] is not False and attributes["forwarding"] is False:
            self.declared = [name for name, _ in attributes["keep"]]
        inner = self.actions(self.rng.randint(1, 4), depth + 1)
        self.declared = known
        return Action("group", attributes, inner)

    def reset(self, _depth: int) -> Action:
        keep = [(name, self.word()) for name in self.rng.sample(self.declared, self.rng.randint(0, len(self.declared)))]
        self.declared = [name for name, _ in keep]
        return Action("reset", {"keep": keep})

    def reset_env(self, _depth: int) -> Action:
        return Action("reset_env")

    def log(self, _depth: int) -> Action:
        return Action("log", {"message": self.text()})

    def log_dir(self, _depth: int) -> Action:
        return Action("set_ros_log_dir", {"new_log_dir": [Part("text", text="/tmp/logs")]})

    def shutdown(self, _depth: int) -> Action:
        return Action("shutdown", {"reason": self.word()})

    def unset(self, _depth: int) -> Action:
        return Action("unset", {"name": self.rng.choice([*self.declared, "undeclared"])})

    def configurations(self, depth: int) -> Action:
        """What is set between `PushLaunchConfigurations` and `PopLaunchConfigurations` is gone afterwards."""
        known = list(self.declared)
        inner = self.actions(self.rng.randint(1, 3), depth + 1)
        self.declared = known
        return Action("configurations", {}, inner)

    def environments(self, _depth: int) -> Action:
        return Action("environments", {}, [self.set_env(0), *self.actions(1, 2)])

    def namespace(self, _depth: int) -> Action:
        pushed = (
            [self.variable()] if self.declared and self.often(10) else [Part("text", text=self.rng.choice(("inner", "/outer", "a/b", "")))]
        )
        return Action("push_ros_namespace", {"namespace": pushed})

    def remap(self, _depth: int) -> Action:
        return Action("set_remap", dict(zip(("from", "to"), self.renaming(), strict=True)))

    def renaming(self) -> tuple[Text, Text]:
        source = self.rng.choice(("in", "/in", "~/in", "out", "ns/out"))
        target = self.rng.choice(("here", "/there", "~/own"))
        return [Part("text", text=source)], [Part("text", text=target)]

    def parameter(self, _depth: int) -> Action:
        name = self.rng.choice(("p", "q", "deep.p"))
        if self.often(25):
            return Action("set_parameter", {"name": name, "plain": self.rng.choice((1, 2.5, True, [1, 2], ["x", "y"]))})
        return Action("set_parameter", {"name": name, "value": self.text()})

    def sim_time(self, _depth: int) -> Action:
        return Action("set_use_sim_time", {"value": self.rng.choice(("true", "false"))})

    def from_file(self, _depth: int) -> Action:
        return Action("set_parameters_from_file", {"filename": self.in_package(self.rng.choice(("parameters.yaml", "substituted.yaml")))})

    def in_package(self, name: str) -> Text:
        return [Part(self.rng.choice(("find", "dirname"))), Part("text", text="/" + name)]

    def set_env(self, _depth: int) -> Action:
        return Action("set_env", {"name": self.rng.choice(VARIABLES), "value": self.text()})

    def append_env(self, _depth: int) -> Action:
        return Action(
            "append_env", {"name": self.rng.choice(VARIABLES), "value": self.word(), "prepend": self.rng.choice((True, False, None))}
        )

    def unset_env(self, _depth: int) -> Action:
        return Action("unset_env", {"name": self.rng.choice(VARIABLES)})

    def include(self, depth: int) -> Action:
        if self.included is None:
            return self.node(depth)
        passed = [(f"i{index}", self.text()) for index in range(3) if self.often(50)]
        return Action("include", {"file": self.in_package(self.included), "arguments": passed})

    def timer(self, depth: int) -> Action:
        kind = self.rng.choice(("timer", "ros_timer"))
        periods = (0.5, 1.0, 2.0) if kind == "timer" else (0.001,)  # before any other, also where other timers are played faster
        return Action(kind, {"period": self.rng.choice(periods)}, self.actions(self.rng.randint(1, 2), depth + 1))

    def executable(self, _depth: int) -> Action:
        return Action("executable", {"cmd": [Part("text", text="run "), *self.text(2)]})

    def event(self, depth: int) -> Action:
        target = f"node{self.rng.randrange(self.nodes)}" if self.nodes else None
        kind = self.rng.choice(("OnProcessStart", "OnProcessExit", "OnExecutionComplete"))
        return Action("event", {"kind": kind, "target": target}, self.actions(self.rng.randint(1, 2), depth + 2))

    def opaque(self, depth: int) -> Action:
        return Action(
            "opaque", {"asked": self.rng.choice(self.declared) if self.declared else None}, self.actions(self.rng.randint(1, 2), depth + 1)
        )

    # -- nodes

    def node(self, _depth: int) -> Action:
        name = f"node{self.nodes}"
        self.nodes += 1
        words = self.rng.choice((["--flag"], ["-x", "1"], ["--ros-args", "-p", "arg:=2", "--"], ["--ros-args", "-r", "a:=b"]))
        arguments: list[Text] = [[Part("text", text=word)] for word in words]
        if self.declared and self.often(30):
            arguments.insert(0, [Part("text", text="name:="), self.variable()])
        program = f"program_{self.prefix}{self.nodes}"
        attributes = {**self.of_node(75), "exec": program, "key": name, "args": arguments if self.often(20) else None}
        return Action("node", attributes)

    def lifecycle(self, depth: int) -> Action:
        made = self.node(depth)
        made.attributes["name"] = made.attributes["name"] or [Part("text", text=self.names.pop())]
        made.attributes["namespace"] = made.attributes["namespace"] or [Part("text", text="")]
        return Action("lifecycle_node", {**made.attributes, "autostart": self.rng.choice((True, False, None))})

    def of_node(self, named: float) -> dict[str, Any]:
        return {
            "name": [Part("text", text=self.names.pop())] if self.often(named) else None,
            "namespace": [Part("text", text=self.rng.choice(("inner", "/outer", "deep/er", "", "/")))] if self.often(30) else None,
            "params": [self.given() for _ in range(self.rng.choice((0, 0, 1, 2, 3)))],
            "remaps": [self.renaming() for _ in range(self.rng.choice((0, 0, 1, 2)))],
        }

    def given(self) -> Action:
        """A parameter of a node."""
        kind = self.rng.choice(("value", "value", "value", "number", "list", "file", "group", "typed"))
        name = self.rng.choice(("p", "rate", "shared", "list", "deep.er"))
        if kind == "file":
            file = self.rng.choice(("parameters.yaml", "parameters.yaml", "substituted.yaml"))
            return Action("file", {"path": self.in_package(file), "substitutions": self.rng.choice((True, False, None))})
        if kind == "group":
            return Action("param", {"name": name}, [self.given_value("a"), self.given_value("b")])
        if kind == "number":
            return Action("param", {"name": name, "plain": self.rng.choice((1, 2.5, True, -4, 1e10))})
        if kind == "list":
            return Action("param", {"name": name, "plain": self.rng.choice(([1, 2], ["x", "y z"], [True, False], [0.5, 1.0]))})
        if kind == "typed":
            kind, words = self.rng.choice(
                (("str", WORDS), ("int", ("1", "007", "-3", "2.5")), ("float", ("1", "0.5", "x")), ("bool", ("true", "0", "no")))
            )
            return Action("param", {"name": name, "value": [Part("text", text=self.rng.choice(words))], "type": kind})
        return self.given_value(name)

    def given_value(self, name: str) -> Action:
        return Action("param", {"name": name, "value": self.text()})

    def components(self) -> list[Action]:
        found = []
        for _ in range(self.rng.randint(1, 3)):
            found.append(
                Action("composable_node", {**self.of_node(97), "plugin": f"random_launch::Class{len(found)}"}, condition=self.condition())
            )
        return found

    def container(self, _depth: int) -> Action:
        attributes = {**self.of_node(100), "exec": "component_container", "key": f"node{self.nodes}"}
        self.nodes += 1
        return Action("node_container", {**attributes, "namespace": attributes["namespace"] or [Part("text", text="")]}, self.components())

    def load(self, _depth: int) -> Action:
        return Action("load_composable_node", {"target": [Part("text", text=self.rng.choice(("/first", "second")))]}, self.components())


def write(folder: Path, files: int, seed: int, *, programs: bool = False) -> None:
    """Write the package."""
    folder = folder / PACKAGE
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(MANIFEST)
    texts = {"parameters.yaml": PARAMETERS, "substituted.yaml": SUBSTITUTED, "word.txt": WORD, "helpers.py": HELPERS, "data.yaml": DATA}
    for name, text in texts.items():
        (folder / name).write_text(text)
    for index in range(files):
        for name, prefix, included in ((f"part{index}", "i", None), (f"random{index}", "a", f"part{index}")):
            rng = random.Random(f"{seed}/{name}")
            if included is not None and programs:
                found = next(path.name for path in folder.glob(f"{included}.*"))
                (folder / f"{name}.launch.py").write_text(Program(rng, found).text_of())
                continue
            kinds = {"xml": ".launch.xml", "yaml": ".launch.yaml", "py": ".launch.py"}
            kind = rng.choice(tuple(kinds)) if included is None else tuple(kinds)[index % 3]
            if included is not None:
                found = next(path.name for path in folder.glob(f"{included}.*"))
                included = found
            actions = Writer(rng, prefix, included, python=kind == "py").file()
            (folder / f"{name}{kinds[kind] if included else kinds[kind].replace('.launch', '.part')}").write_text(written(kind, actions))


def main() -> None:
    """Write launch files."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--files", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--programs", action="store_true", help="programs of Python: helpers, loops, classes, handlers of events")
    options = parser.parse_args()
    write(options.folder, options.files, options.seed, programs=options.programs)


if __name__ == "__main__":
    main()
