"""Paths and commands of Python launch files that are put together wrongly."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from rosarch.extractor.launch_ros2.misjoined import misjoined

FILE = "share = get_package_share_directory('robot')\nmodel = os.path.join(share, 'a.xacro')\nspaced = ' a.xacro'\n{}\n"


@pytest.mark.parametrize(
    ("code", "what"),
    [
        ("os.path.join(share, '/config', 'a.yaml')", "os.path.join drops what is before the absolute path `/config/a.yaml`"),
        ("os.path.join(share, '/config', name)", "os.path.join drops what is before the absolute path `/config/...`"),
        ("os.path.join(share, 'config/', 'a.yaml')", None),
        ("os.path.join('/opt', '/config')", None),
        ("share.join('/config')", None),
        ("Command(['xacro', model])", "no space separates `xacro` from what follows in the command"),
        ("launch.substitutions.Command(['ros2 run xacro xacro', PathJoinSubstitution([share, 'a'])])",
         "no space separates `ros2 run xacro xacro` from what follows in the command"),
        ("Command([PathJoinSubstitution([FindExecutable(name='xacro')]), LaunchConfiguration('model')])",
         "no space separates `xacro` from what follows in the command"),
        ("Command([FindExecutable(name='xacro'), ' ', LaunchConfiguration('model')])", None),
        ("Command(['xacro ', model])", None),
        ("Command(['xacro', ' ', model])", None),
        ("Command(['xacro', spaced])", None),
        ("Command(['xacro', unknown])", None),
        ("Command(['xacro', str(model)])", None),
        ("Command(['/opt/', LaunchConfiguration('program')])", None),
        ("Command(['cat a prefix:=', LaunchConfiguration('prefix')])", None),
        ("Command(['cat part', LaunchConfiguration('number')])", None),
        ("Command(['xacro'])", None),
        ("Command(['xacro ', model, 'prefix:=a'])", "no space separates `prefix:=` from what is before it in the command"),
        ("Command(['xacro ', os.path.join(share, 'a.xacro'), 'prefix:=', prefix])",
         "no space separates `prefix:=` from what is before it in the command"),
        ("Command(['xacro ', model, ' prefix:=', LaunchConfiguration('prefix'), 'sim:=true'])",
         "no space separates `sim:=` from what is before it in the command"),
        ("Command(['xacro ', model, ' prefix:=', prefix, ' sim:=', sim])", None),
        ("Command(['xacro ', model, ' ', 'prefix:=a'])", None),
        ("Command(['xacro ', model, ' ', side, '_prefix:=a'])", None),
        ("Command(['xacro ', model, ' prefix:=', prefix, '_link'])", None),
        ("Command('xacro a.xacro')", None),
        ("ExecuteProcess(cmd=['ros2 bag play run'])",
         "`ros2 bag play run` is taken for the name of one program: the words of a command are items of its list"),
        ("ExecuteProcess(cmd=[['ros2 run x ', package]], output='screen')",
         "`ros2 run x` is taken for the name of one program: the words of a command are items of its list"),
        ("ExecuteProcess(cmd=['ros2 bag play run'], shell=True)", None),
        ("ExecuteProcess(cmd=['ros2 bag play run'], shell=shell)", None),
        ("ExecuteProcess(cmd=['ros2 bag play run'], **more)", None),
        ("ExecuteProcess(cmd=['ros2', 'bag play'])", None),
        ("ExecuteProcess(cmd=[['ros2', ' run']])", None),
        ("ExecuteProcess(cmd=['/opt/my tools/run'])", None),
        ("Node(parameters=['config/a.yaml'])", "`config/a.yaml` is looked for in the folder that launch is started in"),
        ("Node(parameters=['absent/a.yaml', '/config/a.yaml', {'a': 'config/a.yaml'}, share])", None),
        ("Node(arguments=['config/a.yaml'])", None),
    ],
)  # fmt: skip
def test_misjoined(code: str, what: str | None, tmp_path: Path) -> None:
    (tmp_path / "config").mkdir()
    (tmp_path / "config" / "a.yaml").touch()
    path = str(tmp_path / "launch" / "a.launch.py")
    found = list(misjoined(ast.parse(FILE.format(code)), path))
    assert [one.what for one in found] == ([] if what is None else [what])
    assert all((one.place.path, one.place.line) == (path, 4) for one in found)
