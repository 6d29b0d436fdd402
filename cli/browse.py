"""`rosarch browse`: the relations of a robot, to look through at the terminal."""

from __future__ import annotations

from functools import partial

from rosarch.cli.derivations import Component, asked, datalog_errors, evaluate, load_rules
from rosarch.cli.errors import InputError
from rosarch.cli.options import Cached, Defines, Engine, EngineChoice, Input, Jobs, Packages, Timeout, Verbose
from rosarch.cli.rule_options import Rules, Settings, Variants, parse_rules
from rosarch.cli.systems import Systems
from rosarch.cli.terminal import is_terminal


def browse(
    folder: Input,
    packages: Packages = None,
    component: Component = None,
    launches: Systems = None,
    own: Rules = None,
    variants: Variants = None,
    settings: Settings = None,
    engine: EngineChoice = Engine.embedded,
    jobs: Jobs = None,
    defines: Defines = None,
    timeout: Timeout = 60.0,
    cached: Cached = True,
    verbose: Verbose = False,
) -> None:
    """Look through relations: what each holds, its rows, the proof of a row and the source it is about."""
    from rosarch.datalog import RowStore

    try:
        from rosarch.cli.browser import Browser, Robot
    except ImportError as error:
        raise InputError(f"browse needs {error.name}: pip install 'rosarch[interactive]'") from None
    if not is_terminal():
        raise InputError("browse is for a terminal; rosarch query prints rows")
    with datalog_errors():
        rules = parse_rules(own, variants, settings)
        program = load_rules(rules, systems=bool(launches))
        with asked(
            folder,
            packages,
            component,
            launches,
            rules=rules,
            jobs=jobs,
            timeout=timeout,
            defines=defines,
            cached=cached,
            verbose=verbose,
            engine=engine,
        ) as components:

            def rows(number: int) -> RowStore:
                return RowStore(*evaluate(program, components[number], engine))

            Browser([Robot(c.title, c.root, program, partial(rows, i)) for i, c in enumerate(components)]).run()
