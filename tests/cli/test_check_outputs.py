"""The options on findings and where the reports go, without the analysis that makes them."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import typer
from handmade_findings import CHECKS, FULL, NEAR_MISS, SOURCES, STYLE, finding

from rosarch.base.files import folder_reader
from rosarch.cli import check_options as options
from rosarch.cli import check_outputs as outputs
from rosarch.cli.check_options import FailOn, load_configuration, make_policy
from rosarch.cli.check_outputs import Destinations, judge, parse_destinations, write_reports
from rosarch.cli.errors import InputError
from rosarch.findings.configuration import Configuration
from rosarch.findings.policy import THRESHOLDS, Policy, Reported, apply_policy


@pytest.fixture
def ws(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A workspace below the current folder, with the sources of the findings."""
    monkeypatch.chdir(tmp_path)
    for path, text in SOURCES.items():
        file = tmp_path / "ws" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return Path("ws")


def refused(call: Callable[..., Any], *arguments: Any, **named: Any) -> str:
    with pytest.raises(InputError) as caught:
        call(*arguments, **named)
    return str(caught.value)


def reported() -> Reported:
    return apply_policy([FULL], Policy(), checks=CHECKS)


def test_no_configuration(ws: Path) -> None:
    assert load_configuration(ws, None, CHECKS) == Configuration()


def test_configuration_of_the_workspace(ws: Path) -> None:
    (ws / ".rosarch.yml").write_text(
        "checks: {style: error}\nfail_on: error\nbaseline: b.json\nlaunch: [base/launch/base.launch]\npackage_path: [src, /opt/ros]\n"
    )
    found = load_configuration(ws, None, CHECKS)
    assert (found.checks, found.fail_on, found.baseline) == ((("style", "error"),), "error", "ws/b.json")
    assert [entry.files for entry in found.launch] == [("ws/base/launch/base.launch",)]
    assert found.package_path == ("ws/src", "/opt/ros")


def test_configuration_elsewhere(ws: Path) -> None:
    (ws / ".rosarch.yml").write_text("nonsense")
    Path("other.yml").write_text("checks: {unused-suppression: ignore}\nbaseline: b.json")
    found = load_configuration(ws, Path("other.yml"), CHECKS)
    assert (found.checks, found.baseline) == ((("unused-suppression", "ignore"),), "b.json")


def test_wrong_configurations(ws: Path) -> None:
    (ws / ".rosarch.yml").write_text("checks: {stile: error}\nfailon: note\n")
    assert refused(load_configuration, ws, None, CHECKS) == (
        "ws/.rosarch.yml:1:10: unknown check `stile`, did you mean `style`?\n"
        "ws/.rosarch.yml:2:1: unknown setting `failon`, did you mean `fail_on`?"
    )
    (ws / ".rosarch.yml").write_bytes(b"checks:\n  \xff: error\n")
    assert refused(load_configuration, ws, None, CHECKS) == "ws/.rosarch.yml:2:3: not UTF-8 text: byte 0xff"
    assert refused(load_configuration, ws, Path("none.yml"), CHECKS) == "none.yml: cannot be read (no such file or directory)"
    assert refused(load_configuration, ws, Path("ws"), CHECKS) == "ws: cannot be read (not a regular file)"
    os.mkfifo("fifo.yml")
    assert refused(load_configuration, ws, Path("fifo.yml"), CHECKS) == "fifo.yml: cannot be read (not a regular file)"


def test_options_overrule_the_configuration() -> None:
    configuration = Configuration(checks=(("style", "error"), ("near-miss", "ignore")), fail_on="error", ignore_paths=("x",))
    policy = make_policy(configuration, CHECKS)
    assert (policy.severity(finding(STYLE)), policy.severity(finding(NEAR_MISS)), policy.fail_on) == ("error", "ignore", "error")
    assert policy.ignored_paths == ("x",)
    policy = make_policy(configuration, CHECKS, notes=["*"], warnings=["near-*, style"], fail_on=FailOn.never, exit_zero=True)
    assert (policy.severity(finding(STYLE)), policy.severity(finding(NEAR_MISS)), policy.fail_on) == ("warning", "warning", "never")
    assert policy.severity(finding()) == "note"
    assert policy.exit_zero
    policy = make_policy(Configuration(), CHECKS, errors=["unused-suppression"], ignored=["type-mismatch"])
    assert (policy.severity(finding()), policy.fail_on) == ("ignore", "warning")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"errors": ["stile"]}, "--error stile: no such check, did you mean `style`?"),
        ({"ignored": ["style", "zz-*"]}, "--ignore zz-*: no such check"),
        ({"warnings": ["style,"]}, "--warning : no such check"),
    ],
)
def test_unknown_checks_are_refused(options: dict[str, Any], message: str) -> None:
    assert refused(make_policy, Configuration(), CHECKS, **options) == message


@pytest.mark.parametrize(
    ("formats", "outputs", "expected"),
    [
        ("text", None, Destinations()),
        ("json", [], Destinations(("json",))),
        ("text,github", None, Destinations(("text", "github"))),
        ("text, text", None, Destinations(("text",))),
        (
            "github",
            ["sarif=out/a.sarif", "junit=j=1.xml", "json=a.json", "json=b.json"],
            Destinations(
                ("github",),
                (("sarif", Path("out/a.sarif")), ("junit", Path("j=1.xml")), ("json", Path("a.json")), ("json", Path("b.json"))),
            ),
        ),
    ],
)
def test_destinations(formats: str, outputs: list[str] | None, expected: Destinations) -> None:
    assert parse_destinations(formats, outputs) == expected


@pytest.mark.parametrize(
    ("formats", "outputs", "message"),
    [
        ("jsn", None, "--format jsn: no format `jsn`, did you mean `json`?"),
        ("", None, "--format : no format ``, there are text, json, sarif, junit, github, markdown"),
        ("text,json", None, "--format text,json: json must be alone on stdout; write it to a file with --output json=FILE"),
        ("text", ["sarif"], "--output sarif: not of the form FORMAT=FILE"),
        ("text", ["sarif="], "--output sarif=: not of the form FORMAT=FILE"),
        ("text", ["serif=a"], "--output serif=a: no format `serif`, did you mean `sarif`?"),
        ("text", ["sarif=/"], "--output sarif=/: / is a folder"),
    ],
)
def test_wrong_destinations(formats: str, outputs: list[str] | None, message: str) -> None:
    assert refused(parse_destinations, formats, outputs) == message


def test_reports_go_where_they_are_sent(ws: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = ("text", "json", "sarif", "junit", "github", "markdown")
    files = tuple((name, Path(f"out/report.{name}")) for name in names)
    write_reports(reported(), Destinations(("text", "github"), files), ws, folder_reader(ws))
    shown = capsys.readouterr().out
    texts = {name: Path(f"out/report.{name}").read_text() for name in names}
    assert shown == texts["text"] + texts["github"]
    assert shown.startswith("ws/odom/src/odom.cpp:3:13: error: ")
    assert json.loads(texts["json"])["folder"] == "ws"
    uri = json.loads(texts["sarif"])["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
    assert uri == "ws/odom/src/odom.cpp"


def test_paths_are_those_seen_from_the_current_folder(
    ws: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    base = ws.absolute()
    starts = []
    for here, folder in ((base, Path(".")), (base.parent, base), (base / "odom", base), (base / "odom", Path(".."))):
        monkeypatch.chdir(here)
        write_reports(reported(), Destinations(("github",)), folder, folder_reader(folder))
        starts.append(capsys.readouterr().out.partition(",")[0].partition("file=")[2])
    absolute = f"{base}/odom/src/odom.cpp"
    assert starts == ["odom/src/odom.cpp", "ws/odom/src/odom.cpp", absolute, absolute]


def test_a_file_that_cannot_be_written(ws: Path) -> None:
    Path("file").write_text("x")
    assert (
        refused(write_reports, reported(), Destinations((), (("json", Path("file/a.json")),)), ws, folder_reader(ws))
        == "file: cannot write (file exists)"
    )


def test_a_text_that_is_not_utf_8_is_written_all_the_same(ws: Path) -> None:
    found = apply_policy([finding(message="\udcff")], Policy(), checks=CHECKS)
    write_reports(found, Destinations((), (("json", Path("a.json")), ("sarif", Path("a.sarif")))), ws, folder_reader(ws))
    assert json.loads(Path("a.json").read_text())["findings"][0]["message"] == "\udcff"


def test_baselines(ws: Path) -> None:
    old, new = finding(), finding(message="new")
    first = judge([old], Policy(), [], checks=CHECKS, baseline=None, new_baseline=Path("b.json"))
    assert (first.shown, first.in_baseline, first.exit_code) == ((), (old,), 0)
    second = judge([old, new], Policy(), [], checks=CHECKS, baseline=Path("b.json"), new_baseline=None)
    assert (second.shown, second.in_baseline, second.exit_code) == ((new,), (old,), 1)
    third = judge([new], Policy(), [], checks=CHECKS, baseline=Path("b.json"), new_baseline=Path("b.json"))
    assert (third.shown, third.in_baseline, third.gone) == ((), (new,), ())
    assert [entry["message"] for entry in json.loads(Path("b.json").read_text())["findings"]] == ["new"]


def test_wrong_baselines(ws: Path) -> None:
    Path("b.json").write_text("{")
    named = {"checks": CHECKS, "new_baseline": None}
    assert refused(judge, [], Policy(), [], baseline=Path("b.json"), **named) == (
        "b.json:1:2: not a baseline: expecting property name enclosed in double quotes"
    )
    assert refused(judge, [], Policy(), [], baseline=Path("c.json"), **named) == "c.json: cannot be read (no such file or directory)"


def test_findings_of_any_iterable(ws: Path) -> None:
    found = judge(iter([finding()]), Policy(), iter([]), checks=iter(CHECKS), baseline=None, new_baseline=Path("b.json"))
    assert len(found.in_baseline) == 1
    assert replace(found, in_baseline=()).exit_code == 0


def test_options_of_a_command() -> None:
    got: dict[str, Any] = {}
    app = typer.Typer()

    @app.command()
    def command(
        errors: options.Errors = None,
        warnings: options.Warnings = None,
        notes: options.Notes = None,
        ignored: options.Ignored = None,
        fail_on: options.Failing = None,
        exit_zero: options.ExitZero = False,
        config: options.ConfigFile = None,
        baseline: options.BaselineFile = None,
        new_baseline: options.NewBaseline = None,
        formats: outputs.Formats = "text",
        written: outputs.Outputs = None,
    ) -> None:
        got.update((name, value) for name, value in locals().items() if name != "got")

    words = "--error a --error b --warning c --note d --ignore * --fail-on never --exit-zero --config c.yml --baseline b --write-baseline n"
    typer.main.get_command(app).main([*words.split(), "--format", "github", "-o", "sarif=s"], standalone_mode=False)
    assert got == {
        "errors": ["a", "b"], "warnings": ["c"], "notes": ["d"], "ignored": ["*"], "fail_on": FailOn.never, "exit_zero": True,
        "config": Path("c.yml"), "baseline": Path("b"), "new_baseline": Path("n"), "formats": "github", "written": ["sarif=s"],
    }  # fmt: skip
    typer.main.get_command(app).main([], standalone_mode=False)
    assert not any(value for name, value in got.items() if name != "formats")
    assert tuple(each.value for each in FailOn) == THRESHOLDS
