"""What is started together: requests with arguments, and files that no other includes."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosarch.analysis.systems.launches import given, unincluded
from rosarch.analysis.systems.requests import LaunchEnvironment, LaunchWordError, Request, parse_request


@pytest.fixture
def where(tmp_path: Path) -> LaunchEnvironment:
    """A workspace with a package and three launch files, one of which another includes."""
    package = tmp_path / "robot"
    package.mkdir()
    (package / "package.xml").write_text("<package><name>robot</name></package>")
    (package / "main.launch").write_text(
        '<launch><arg name="x" default="1"/><arg name="y" default="2"/>'
        '<node pkg="p" type="t" name="n_$(arg x)_$(arg y)_$(optenv ROBOT none)"/><include file="$(find robot)/part.launch"/></launch>'
    )
    (package / "part.launch").write_text('<launch><node pkg="p" type="t" name="part"/></launch>')
    (package / "tools.launch").write_text('<launch><node pkg="p" type="t" name="tools"/></launch>')
    return LaunchEnvironment(tmp_path, (tmp_path,), {"ROBOT": "r2"})


def test_requests() -> None:
    assert parse_request("a.launch") == Request(("a.launch",))
    assert parse_request("a.launch 'b c.launch' x:=1,2 y:=a\\\\,b") == Request(
        ("a.launch", "b c.launch"), (("x", ("1", "2")), ("y", ("a,b",)))
    )


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "`` names no launch file"),
        ("x:=1", "`x:=1` names no launch file"),
        ("a.launch 1x:=2", "1x:=2: not of the form NAME:=VALUE"),
        ("a.launch :=2", ":=2: not of the form NAME:=VALUE"),
        ("a.launch 'b", "`a.launch 'b`: no closing quotation"),
    ],
)
def test_bad_requests(text: str, message: str) -> None:
    with pytest.raises(LaunchWordError) as caught:
        parse_request(text)
    assert str(caught.value) == message


def nodes(where: LaunchEnvironment, *texts: str) -> dict[str, list[str]]:
    return {launch.name: [node.full_name for node in launch.composition.nodes] for launch in given(map(parse_request, texts), where)}


def test_each_combination_of_values_is_a_launch(where: LaunchEnvironment) -> None:
    assert nodes(where, "robot/main.launch x:=3,4 y:=5") == {
        "robot/main.launch x:=3 y:=5": ["/n_3_5_r2", "/part"],
        "robot/main.launch x:=4 y:=5": ["/n_4_5_r2", "/part"],
    }
    assert given([parse_request("robot/main.launch x:=3")], where)[0].words == ("robot/main.launch", "x:=3")


def test_files_are_started_together_or_one_by_one(where: LaunchEnvironment) -> None:
    assert nodes(where, "robot/part.launch robot/tools.launch") == {"robot/part.launch robot/tools.launch": ["/part", "/tools"]}
    assert nodes(where, "robot/part.launch", "robot/tools.launch") == {"robot/part.launch": ["/part"], "robot/tools.launch": ["/tools"]}


def test_files_are_absolute_or_below_the_current_folder_or_the_workspace(
    where: LaunchEnvironment, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path / "robot")
    assert list(nodes(where, "part.launch", "robot/part.launch", f"{tmp_path}/robot/part.launch")) == ["robot/part.launch"]


def test_a_file_that_is_not_there(where: LaunchEnvironment) -> None:
    with pytest.raises(LaunchWordError) as caught:
        nodes(where, "robot/gone.launch")
    assert str(caught.value) == f"robot/gone.launch: no such launch file, neither here nor below {where.root}"


def test_too_many_combinations(where: LaunchEnvironment) -> None:
    values = ",".join(map(str, range(17)))
    with pytest.raises(LaunchWordError) as caught:
        nodes(where, f"robot/main.launch x:={values} y:={values}")
    assert str(caught.value) == "more than 256 combinations of arguments"


def test_files_that_no_other_includes(where: LaunchEnvironment) -> None:
    assert [launch.name for launch in unincluded(where)] == ["robot/main.launch", "robot/tools.launch"]
