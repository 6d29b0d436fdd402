"""Python launch files: what is interpreted, and what stays unknown."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from ros2_launch_builder import HEAD, MANIFEST, composed, described, names, params, problems


def test_a_node_with_all_that_it_is_given(tmp_path: Path) -> None:
    entities = """Node(package='here', executable='run', name='n', namespace='ns', arguments=['-x', LaunchConfiguration('a')],
      remappings=[('in', 'out'), ('~/p', '/q')], parameters=[{'k': 1, 'deep': {'er': [1, 2]}, 's': LaunchConfiguration('a')}])"""
    found = described(tmp_path, f"DeclareLaunchArgument('a', default_value='true'), {entities}")
    (node,) = found.nodes
    assert (node.package, node.type, node.full_name, node.args, node.ros) == ("here", "run", "/ns/n", "-x true", 2)
    assert [(remap.source, remap.target) for remap in node.remaps] == [("in", "out"), ("~p", "/q")]
    assert params(found) == {"/ns/n/k": 1, "/ns/n/deep.er": [1, 2], "/ns/n/s": True}
    assert problems(found, tmp_path) == []


def test_a_list_of_remappings_that_nodes_share_is_at_one_place(tmp_path: Path) -> None:
    shared = "shared = [\n  ('in', 'out'),\n] + [('x', 'y')]\nown = ('a', 'b')"
    given = "Node(package='here', executable='run', name=name, remappings=[*shared, own])"
    found = described(tmp_path, f"*[{given} for name in 'nm'], Node(package='here', executable='run', name='o', remappings=shared)", shared)
    lines = [[(remap.source, remap.place.line) for remap in node.remaps] for node in found.nodes]
    first = lines[0][0][1]
    assert lines[0] == lines[1] == [("in", first), ("x", first + 1), ("a", first + 2)]
    assert lines[2] == lines[0][:2]


def test_the_home_folder_of_whoever_launches_is_not_known(tmp_path: Path) -> None:
    before = "from os.path import expanduser\nfrom pathlib import Path\nhomes = [expanduser('~') + '/a', str(Path('~/b').expanduser()), str(Path.home() / 'c'), expanduser('/d')]"
    found = described(
        tmp_path, "*[Node(package='here', executable='run', name=f'n{at}', arguments=[one]) for at, one in enumerate(homes)]", before
    )
    assert [node.args.strip("'") for node in found.nodes] == ["$(home ~)/a", "$(home ~)/b", "$(home ~)/c", "/d"]


def test_ros_arguments(tmp_path: Path) -> None:
    words = "['--flag', '--ros-args', '-r', 'n:a:=b', '-r', 'other:c:=d', '-r', '__ns:=/x', '-r', '__node:=n', '-p', 'k:=2', '--', 'last']"
    found = described(tmp_path, f"Node(package='here', executable='run', arguments={words})")
    (node,) = found.nodes
    assert (node.full_name, node.args) == ("/x/n", "--flag last")
    assert [(remap.source, remap.target) for remap in node.remaps] == [("a", "b")]
    assert params(found) == {"/x/n/k": 2}


@pytest.mark.parametrize(
    ("before", "entities", "expected"),
    [
        ("ld = []\nfor i in range(2):\n    ld.append(node(f'n{i}'))", "*ld", ["/n0", "/n1"]),
        ("made = [node('n' + str(i)) for i in (1, 2, 3) if i != 2]", "*made", ["/n1", "/n3"]),
        ("def make(name, *rest, prefix='p', **more):\n    return node(prefix + name, **more)", "make('a'), make('b', prefix='q', namespace='x')", ["/pa", "/x/qb"]),
        ("pair = {'a': 1, 'b': 2}", "*[node(key) for key, value in pair.items() if value > 1]", ["/b"]),
        ("x = 'a' if len([1]) == 1 else 'b'", "node(x), node('%s_%d' % (x, 3)), node('{}.{n}'.format(x, n=4).replace('.', '_'))", ["/a", "/a_3", "/a_4"]),
        ("first, *rest = ['a', 'b', 'c']", "node(first), node(rest[-1])", ["/a", "/c"]),
        ("n = 0\nwhile n < 3:\n    n += 1\n    if n == 2:\n        break", "node(f'n{n}')", ["/n2"]),
        ("try:\n    x = {}['k']\nexcept KeyError:\n    x = 'caught'", "node(x)", ["/caught"]),
        ("names = sorted(['b', 'a'], key=lambda s: s)\nlast = list(map(lambda s: s.upper(), names))", "*[node(x) for x in last]", ["/A", "/B"]),
        ("class C:\n    kind = 'k'\n    def __init__(self, n):\n        self.n = n\n    @property\n    def name(self):\n        return self.kind + self.n", "node(C('x').name)", ["/kx"]),
        ("p = Path(__file__).parent / 'a.b'", "node(p.stem), node(os.path.splitext(p.name)[0])", ["/a", "/a"]),
        ("import copy\nwritten = [{'n': 'a'}]\nshallow, deep = copy.copy(written), copy.deepcopy(written)\nwritten[0]['n'] += 'b'\nwritten.append(0)", "node(shallow[0]['n']), node(deep[0]['n'] + str(len(shallow)))", ["/ab", "/a1"]),
        ("class C:\n    pass\nc = C()\nx = ['a']\nif type(x) != list:\n    x = [x]\nif type(c) is C and type('s') in (str, int):\n    x += ['b']", "*[node(one) for one in x]", ["/a", "/b"]),
        ("def numbers():\n    yield 'a'\n    yield from ['b']", "*[node(x) for x in numbers()]", ["/a", "/b"]),
    ],
)  # fmt: skip
def test_python_as_engineers_write_it(tmp_path: Path, before: str, entities: str, expected: list[str]) -> None:
    found = described(tmp_path, entities, before)
    assert names(found) == expected
    assert not [problem for problem in found.problems if problem.kind != "duplicate-node"]


def test_a_file_that_was_written_below_a_folder_that_is_not_known(tmp_path: Path) -> None:
    before = "folder = get_package_share_directory('absent')\nwith open(folder + '/tmp/model.urdf', 'w') as out:\n    out.write('x')\nhere = os.path.dirname(__file__)\nopen(here + '/a/map.yaml', 'w')"
    found = described(
        tmp_path,
        "node(open(here + '/tmp/model.urdf').read() + open(here + '/b/map.yaml').read()), node('n', parameters=[here + '/tmp/other.yaml'])",
        before,
    )
    assert [problem.subject.rpartition("/")[2] for problem in found.problems if problem.kind == "file"] == ["other.yaml"]


def test_an_undecided_branch_gives_both_alternatives(tmp_path: Path) -> None:
    before = """ld = LaunchDescription()
which = 'x'
if os.environ['MODEL'] == 'a':
    which = 'z'
    ld.add_action(node('only_a'))
else:
    ld.add_action(node('other'))
ld.add_action(node('both', parameters=[{'p': which, 'model': 'm_' + os.environ['MODEL']}]))
return ld"""
    found = described(tmp_path, "", before)
    assert names(found) == [
        "/only_a if os.environ['MODEL'] == 'a'",
        "/other unless os.environ['MODEL'] == 'a'".replace("unless", "unless"),
        "/both",
    ]
    assert params(found) == {"/both/p": "$(os.environ['MODEL'] == 'a' ? z : x)", "/both/model": "m_$(env MODEL)"}
    assert problems(found, tmp_path)[0] == "launch/main.launch.py:21:8: environment variable `MODEL` is not set"
    known = described(tmp_path, "", before, environment={"MODEL": "a"})
    assert names(known) == ["/only_a", "/both"]
    assert params(known) == {"/both/p": "z", "/both/model": "m_a"}


@pytest.mark.parametrize(
    ("lines", "given"),
    [
        ("base = f'{os.getenv(\"BASE\")}.urdf'", "$(os.getenv('BASE')).urdf"),
        ("base = os.getenv('BASE')\nbase = 'a_' + base", "a_$(base)"),
        ("base = os.getenv('BASE')\nif base is None:\n    base = 'small'", "small"),
    ],
)
def test_a_variable_that_is_not_set_is_no_text(tmp_path: Path, lines: str, given: str) -> None:
    before = f"ld = LaunchDescription()\n{lines}\nld.add_action(node('one', parameters=[{{'base': base}}]))\nreturn ld"
    found = described(tmp_path, "", before)
    assert (params(found), problems(found, tmp_path)) == ({"/one/base": given}, [])


def test_what_a_file_raises_where_a_variable_is_not_set_is_no_fault(tmp_path: Path) -> None:
    found = described(tmp_path, "", "if os.getenv('BASE') is None:\n    raise RuntimeError('set BASE')")
    assert found.refusal is None


def test_whether_a_variable_is_set(tmp_path: Path) -> None:
    before = """ld = LaunchDescription()
if 'MODEL' in os.environ:
    ld.add_action(node('model_' + os.environ['MODEL']))
if 'HOME' not in os.environ:
    ld.add_action(node('homeless'))
ld.add_action(node('always'))
return ld"""
    unset = described(tmp_path, "", before)
    assert (names(unset), problems(unset, tmp_path)) == (["/always"], [])
    assert names(described(tmp_path, "", before, environment={"MODEL": "a"})) == ["/model_a", "/always"]


def test_an_action_that_prepares_something_and_starts_as_its_base_class_does(tmp_path: Path) -> None:
    before = """class Prepared(Node):
    def __init__(self, name):
        super().__init__(package='p', executable=name, name=name)
    def execute(self, context):
        with open(self.cmd_file, 'r') as file:
            for line in file:
                if len(line) == 0 or line[0] == '#':
                    continue
        return super().execute(context)"""
    found = described(tmp_path, "Prepared('first'), node('second')", before)
    assert (names(found), problems(found, tmp_path)) == (["/first", "/second"], [])


def test_an_action_of_the_workspace_that_declares_arguments(tmp_path: Path) -> None:
    before = """from typing import Text
class Declared(GroupAction):
    def __init__(self, source):
        actions = [DeclareLaunchArgument('source', default_value=source)]
        if isinstance(source, Text):
            actions.append(DeclareLaunchArgument('early', default_value='a'))
        super().__init__(actions=actions, scoped=False)
    def execute(self, context):
        self._GroupAction__actions = [*self._GroupAction__actions, DeclareLaunchArgument('late', default_value='b')]
        return super().execute(context)"""
    node = "Node(package='p', executable='e', name=[LaunchConfiguration(one) for one in ('source', 'early', 'late')])"
    found = described(tmp_path, f"Declared('s'), {node}", before)
    assert (names(found), problems(found, tmp_path)) == (["/sab"], [])


def test_a_file_of_parameters_that_is_no_yaml_as_far_as_it_is_known(tmp_path: Path) -> None:
    before = """import tempfile
import yaml
with tempfile.NamedTemporaryFile(mode='w', delete=False) as made:
    made.write('/**:\\n')
    made.write(os.environ['MORE'])
    made.write('\\n  x: 1\\n')"""
    node = "Node(package='p', executable='e', name='n', parameters=[made.name])"
    found = described(tmp_path, node, before)
    assert (names(found), [one for one in problems(found, tmp_path) if "YAML" in one]) == (["/n"], [])
    written = described(tmp_path, node, before.replace("os.environ['MORE']", "'}'"))
    assert [one for one in problems(written, tmp_path) if "YAML" in one]


def test_arguments_of_unknown_names(tmp_path: Path) -> None:
    before = """import re
found = {}
for line in ('a: b', 'c: d'):
    word = re.match('(.*): (.*)', line)
    if word:
        found[word.group(1)] = word.group(2)
declared = [DeclareLaunchArgument(name, default_value=str(value)) for name, value in found.items()]"""
    found = described(tmp_path, "*declared, node(LaunchConfiguration('a'))", before)
    assert (names(found), problems(found, tmp_path)) == (["/$(var a)"], [])
    assert problems(described(tmp_path, "node(LaunchConfiguration('a'))", "declared = []"), tmp_path) != []


def test_of_which_kind_a_value_is(tmp_path: Path) -> None:
    before = """import launch
from absent import Other
class Base: pass
class Derived(Base): pass
given = LaunchConfiguration('x')
ld = LaunchDescription()
for name, found in (
    ('substitution', isinstance(given, launch.Substitution)),
    ('action', isinstance(given, launch.Action)),
    ('base', isinstance(Derived(), Base)),
    ('text', isinstance('x', str)),
):
    if found:
        ld.add_action(node(name))
if isinstance('x', Other):
    ld.add_action(node('perhaps'))
return ld"""
    assert names(described(tmp_path, "", before)) == ["/substitution", "/base", "/text", "/perhaps if isinstance('x', Other)"]


def test_nodes_that_are_started_again_when_a_process_has_ended(tmp_path: Path) -> None:
    before = """def nodes(*_event):
    return [node('first')]
main = node('main')
def at_exit(outcome):
    return RegisterEventHandler(OnProcessExit(target_action=main, on_exit=outcome))"""
    again = described(tmp_path, "main, *nodes(), at_exit(nodes)", before)
    assert (names(again), problems(again, tmp_path)) == (["/main", "/first"], [])
    assert names(described(tmp_path, "main, at_exit(nodes), *nodes()", before)) == ["/main", "/first"]
    other = "Node(package='here', executable='run', name='first')"
    assert names(described(tmp_path, f"main, *nodes(), at_exit([{other}])", before)) == ["/main", "/first", "/first"]


def test_the_lines_of_a_file(tmp_path: Path) -> None:
    written = tmp_path / "src" / "here" / "names.txt"
    written.parent.mkdir(parents=True)
    written.write_text("# names\nleft\nright\n")
    before = f"""ld = LaunchDescription()
for line in open({str(written)!r}):
    if line[0] != '#':
        ld.add_action(node(line.strip()))
return ld"""
    assert names(described(tmp_path, "", before)) == ["/left", "/right"]


def test_an_undecided_return(tmp_path: Path) -> None:
    before = "if os.path.exists('/elsewhere'):\n    return LaunchDescription([node('early')])\nother = node('late')"
    found = described(tmp_path, "other", before)
    assert names(found) == ["/early if os.path.exists('/elsewhere')", "/late unless os.path.exists('/elsewhere')"]


def test_an_opaque_function_sees_the_context(tmp_path: Path) -> None:
    before = """def setup(context, suffix):
    name = LaunchConfiguration('name').perform(context) + context.launch_configurations['name'] + suffix
    count = int(context.perform_substitution(LaunchConfiguration('count')))
    nodes = [node(f'{name}{i}') for i in range(count)]
    if IfCondition(LaunchConfiguration('more')).evaluate(context):
        nodes.append(node('more'))
    return nodes"""
    arguments = "DeclareLaunchArgument('name', default_value='n'), DeclareLaunchArgument('count', default_value='2'), DeclareLaunchArgument('more', default_value='true')"
    found = described(tmp_path, f"{arguments}, OpaqueFunction(function=setup, args=['_'])", before, {"count": "1"})
    assert names(found) == ["/nn_0", "/more"]


COMMAND = """def setup(context, started):
    cmd = started.cmd.copy()
    CHANGE
    started.cmd.clear()
    started.cmd.extend([normalize_to_list_of_substitutions(x) for x in cmd])
    return [started]"""


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            "if LaunchConfiguration('state').perform(context): cmd.insert(1, LaunchConfiguration('state')); cmd.insert(1, '-load')",
            "-load s -a b",
        ),
        ("cmd.append('-r'); cmd.append('x:=y')", "-a b"),
        ("cmd.pop(1)", "b"),
    ],
)
def test_code_changes_the_command_line_of_a_node(tmp_path: Path, change: str, words: str) -> None:
    before = "from launch.utilities import normalize_to_list_of_substitutions\n" + COMMAND.replace("CHANGE", change)
    state = "DeclareLaunchArgument('state', default_value='s')"
    found = described(tmp_path, f"{state}, OpaqueFunction(function=setup, args=[node('n', arguments=['-a', 'b'])])", before)
    (started,) = found.nodes
    assert started.args == words
    assert [(remap.source, remap.target) for remap in started.remaps] == ([("x", "y")] if "x:=y" in change else [])


def test_a_substitution_of_the_workspace(tmp_path: Path) -> None:
    helper = """from launch import Substitution
from launch.utilities import perform_substitutions

class Upper(Substitution):
    def __init__(self, text):
        super().__init__()
        self.text = text

    def perform(self, context):
        return perform_substitutions(context, [self.text]).upper()
"""
    main = (
        HEAD
        + "from here.tools import Upper\ndef generate_launch_description():\n    return LaunchDescription([node(Upper(TextSubstitution(text='abc')))])\n"
    )
    found = composed(tmp_path, {"main.launch.py": main, "here/__init__.py": "", "here/tools.py": helper})
    assert names(found) == ["/ABC"]


@pytest.mark.parametrize(("build", "started"), [("ament_python_install_package(loader)", ["/a", "/b"]), ("ament_package()", ["/b"])])
def test_helpers_that_another_package_installs_under_another_name(tmp_path: Path, build: str, started: list[str]) -> None:
    other = tmp_path / "tools"
    helpers = {"loader/__init__.py": "", "loader/nodes.py": HEAD + "def more():\n    return [node('a')]\n"}
    for name, text in {"package.xml": MANIFEST.format("tools"), "CMakeLists.txt": f"project(tools)\n{build}\n", **helpers}.items():
        (other / name).parent.mkdir(parents=True, exist_ok=True)
        (other / name).write_text(text)
    main = "from loader import nodes\ndef generate_launch_description():\n    return LaunchDescription(nodes.more() + [node('b')])\n"
    assert names(composed(tmp_path, {"main.launch.py": HEAD + main})) == started


def test_a_configuration_that_code_sets_to_what_is_not_known(tmp_path: Path) -> None:
    main = (
        HEAD
        + "import elsewhere\ndef setup(context):\n    context.launch_configurations['rate'] = elsewhere.rate()\n"
        + "    return [node('n', parameters=[{'rate': LaunchConfiguration('rate')}])]\n"
        + "def generate_launch_description():\n    return LaunchDescription([OpaqueFunction(function=setup)])\n"
    )
    assert params(composed(tmp_path, {"main.launch.py": main})) == {"/n/rate": "$(elsewhere.rate())"}


def test_no_file_of_parameters(tmp_path: Path) -> None:
    found = described(
        tmp_path, "DeclareLaunchArgument('file', default_value=''), node('n', parameters=[LaunchConfiguration('file'), {'a': 1}])"
    )
    assert params(found) == {"/n/a": 1}
    assert problems(found, tmp_path) == []


def test_a_rewritten_file_of_parameters(tmp_path: Path) -> None:
    main = (
        HEAD
        + """from nav2_common.launch import RewrittenYaml, LaunchConfigAsBool, ReplaceString, HasNodeParams
def generate_launch_description():
    path = os.path.join(get_package_share_directory('here'), 'p.yaml')
    plain = ReplaceString(source_file=path, replacements={'NAME': 'named'})
    rewritten = RewrittenYaml(source_file=plain, root_key=LaunchConfiguration('ns'), convert_types=True,
        param_rewrites={'use_sim_time': LaunchConfigAsBool('sim'), 'n.ros__parameters.deep.er': '0.5', 'n.ros__parameters.fresh': 'x'},
        value_rewrites={'THIS': 'that'})
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='1'), DeclareLaunchArgument('ns', default_value='robot'),
        node('n', namespace='robot', parameters=[ParameterFile(rewritten, allow_substs=True)],
             condition=IfCondition(HasNodeParams(path, 'n')))])
"""
    )
    yaml = "n:\n  ros__parameters:\n    use_sim_time: false\n    who: NAME\n    deep: {er: 1.0, list: [THIS, 3]}\n    arg: $(var ns)\n"
    found = composed(tmp_path, {"main.launch.py": main, "p.yaml": yaml})
    assert problems(found, tmp_path) == ["main.launch.py:18:1: package `nav2_common` is not on the package path"]
    assert params(found) == {
        "/robot/n/use_sim_time": True, "/robot/n/who": "named", "/robot/n/deep.er": 0.5, "/robot/n/deep.list": ["that", 3],
        "/robot/n/arg": "robot", "/robot/n/fresh": "x",
    }  # fmt: skip


def test_a_rewritten_file_with_what_is_not_known(tmp_path: Path) -> None:
    main = (
        HEAD
        + """from nav2_common.launch import RewrittenYaml
import elsewhere
def generate_launch_description():
    path = os.path.join(get_package_share_directory('here'), 'p.yaml')
    return LaunchDescription([node('n', parameters=[RewrittenYaml(source_file=path, param_rewrites={'a': elsewhere.rate()})])])
"""
    )
    found = composed(tmp_path, {"main.launch.py": main, "p.yaml": "n:\n  ros__parameters: {a: 1, b: 2}\n"})
    assert params(found) == {"/n/a": "$(elsewhere.rate())", "/n/b": 2}


def test_a_rewritten_file_that_must_not_be_read(tmp_path: Path) -> None:
    main = (
        HEAD
        + """from nav2_common.launch import RewrittenYaml
def generate_launch_description():
    return LaunchDescription([
        node('n', parameters=[RewrittenYaml(source_file='PATH', param_rewrites={}, convert_types=True)]),
        node('m', parameters=['PATH'])])
""".replace("PATH", str(tmp_path / "elsewhere" / "p.yaml"))
    )
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere" / "p.yaml").write_text("n:\n  ros__parameters: {a: 1}\n")
    found = composed(tmp_path / "workspace", {"main.launch.py": main})
    assert params(found) == {}
    assert {setting.name for setting in found.unread} == {"/n", "/m"}


def test_a_file_that_is_read_and_one_that_is_not_there(tmp_path: Path) -> None:
    before = """with open(os.path.join(get_package_share_directory('here'), 'v.yaml')) as f:
    values = yaml.safe_load(f)['/**']['ros__parameters']
with open(os.path.join(get_package_share_directory('gone'), 'r.urdf')) as f:
    robot = f.read()"""
    text = HEAD + "def generate_launch_description():\n" + "".join(f"    {line}\n" for line in before.splitlines())
    text += "    return LaunchDescription([node('n', parameters=[values, {'robot_description': robot}])])\n"
    found = composed(tmp_path, {"main.launch.py": text, "v.yaml": "/**:\n  ros__parameters: {a: 1, b: {c: x}}\n"})
    assert {(setting.name, Path(setting.place.path).name, setting.place.line) for setting in found.params} >= {
        ("/n/a", "v.yaml", 2), ("/n/b.c", "v.yaml", 2)
    }  # fmt: skip
    assert params(found) == {"/n/a": 1, "/n/b.c": "x", "/n/robot_description": "$(file-content $(find-pkg-share gone)/r.urdf)"}
    assert problems(found, tmp_path) == ["main.launch.py:21:28: package `gone` is not on the package path"]


def test_files_with_the_same_text(tmp_path: Path) -> None:
    load = """    with open(os.path.join(get_package_share_directory('here'), '{}.yaml')) as f:
        {} = yaml.safe_load({})['/**']['ros__parameters']
"""
    text = HEAD + "def generate_launch_description():\n" + load.format("a", "a", "f") + load.format("b", "b", "f")
    text += load.format("a", "c", "f.read()")  # of which of the two files, the text does not say
    text += "    return LaunchDescription([node(name, parameters=[one]) for name, one in (('a', a), ('b', b), ('c', c))])\n"
    values = "/**:\n  ros__parameters: {x: 1}\n"
    found = composed(tmp_path, {"main.launch.py": text, "a.yaml": values, "b.yaml": values})
    assert {(setting.name, Path(setting.place.path).name) for setting in found.params} == {
        ("/a/x", "a.yaml"), ("/b/x", "b.yaml"), ("/c/x", "main.launch.py")
    }  # fmt: skip


@pytest.mark.parametrize(
    ("text", "nodes", "said"),
    [
        ("x = (\n", [], ["main.launch.py:1:5: not Python: '(' was never closed"]),
        ("print 'two'\n", [], ["main.launch.py:1:1: not Python: Missing parentheses in call to 'print'. Did you mean print(...)?"]),
        ("import sys\nsys.exit(0)\n", [], ["main.launch.py:2:1: SystemExit: the program ends", "main.launch.py:2:1: what `main.launch.py` starts is not known"]),
        ("x = 1\n", [], ["main.launch.py:1:1: main.launch.py has no function generate_launch_description"]),
        (HEAD + "def generate_launch_description():\n    ld = LaunchDescription([node('a')])\n    [][3]\n    ld.add_action(node('b'))\n    return ld\n", ["/a"],
         ["main.launch.py:20:5: IndexError: list index out of range"]),
        (HEAD + "import elsewhere\ndef generate_launch_description():\n    return LaunchDescription([node('a'), elsewhere.make(1), node('b')])\n", ["/a", "/b"],
         ["main.launch.py:20:42: what `elsewhere.make(1)` starts is not known"]),
        (HEAD + "def generate_launch_description():\n    return generate_launch_description()\n", [],
         ["main.launch.py:18:1: what `calls nested too deeply` starts is not known"]),
        (HEAD + "import elsewhere\ndef generate_launch_description():\n    x, y = [part for part in elsewhere.pose()]\n    return LaunchDescription([node('a')])\n", ["/a"], []),
        (HEAD + "def generate_launch_description():\n    while True:\n        pass\n", [],
         ["main.launch.py:1:1: not understood from here on: a loop with too many rounds", "main.launch.py:1:1: what `main.launch.py` starts is not known"]),
    ],
)  # fmt: skip
def test_what_cannot_be_interpreted(tmp_path: Path, text: str, nodes: list[str], said: list[str]) -> None:
    found = composed(tmp_path, {"main.launch.py": text})
    assert names(found) == nodes
    assert problems(found, tmp_path) == said


def test_helpers_of_packages_that_are_not_there(tmp_path: Path) -> None:
    before = """from controller_manager.launch_utils import generate_controllers_spawner_launch_description, generate_load_controller_launch_description
one = generate_load_controller_launch_description('arm', controller_params_file='/p.yaml')
two = generate_controllers_spawner_launch_description(['a', 'b'], extra_spawner_args=['--inactive'])"""
    found = described(tmp_path, "one, two", before)
    assert [(node.package, node.type, node.args) for node in found.nodes] == [
        ("controller_manager", "spawner", "arm --controller-manager controller_manager --param-file /p.yaml"),
        ("controller_manager", "spawner", "a b --controller-manager controller_manager --inactive"),
    ]
    assert problems(found, tmp_path) == ["launch/main.launch.py:19:5: package `controller_manager` is not on the package path"]


IMPORTS = """import os
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node
def node(name):
    return Node(package='here', executable='run', name=name)
BEFORE
def generate_launch_description():
    return LaunchDescription([ITEMS])
"""


@pytest.mark.parametrize(
    ("before", "items", "said"),
    [
        ("", "other", "NameError: name 'other' is not defined"),
        ("def setup(context):\n    return [node('b'), other]", "OpaqueFunction(function=setup)", "NameError: name 'other' is not defined"),
        ("def setup():\n    return other", "node('a')", None),
        ("try:\n    name = unicode('a')\nexcept NameError:\n    name = 'a'", "node(name)", None),
        ("from elsewhere import *", "other", "what `other` starts is not known"),
        ("globals().update(more())", "other", "what `other` starts is not known"),
        ("def more():\n    global other\n    other = node('a')\nmore()", "other", None),
        ("if os.path.exists('/elsewhere'):\n    other = node('a')", "other", None),
    ],
)  # fmt: skip
def test_names_that_nothing_defines(tmp_path: Path, before: str, items: str, said: str | None) -> None:
    found = problems(composed(tmp_path, {"main.launch.py": IMPORTS.replace("BEFORE", before).replace("ITEMS", items)}), tmp_path)
    assert (said is None and not found) or (said is not None and any(said in text for text in found)), found
    assert (said is not None and "NameError" in said) == any("NameError" in text for text in found)


@pytest.mark.parametrize(
    ("use", "said"),
    [
        ("str(x)", None),
        ("f'{x}' + '%s' % x + '{}'.format(x)", None),
        ("x == [x]", None),
        ("5 in x", None),
        ("sorted([x, x])", None),
        ("str(c) + f'{c}'", None),
        ("c == [c]", None),
        ("LaunchDescription(c)", None),
        ("yaml.dump(x)", "main.launch.py:23:9: more than 64 Mi characters of text, the rest is left out"),
        ("d.append(LaunchDescription(x))", "main.launch.py:23:18: AttributeError: 'list' object has no attribute 'visit'"),
        ("d.append(c)", "main.launch.py:16:12: AttributeError: 'list' object has no attribute 'visit'"),
        ("d.append(Node(package='here', executable='run', parameters=[{'p': x}]))", "main.launch.py:23:18: TypeError: 'int' object is not iterable"),
    ],
)  # fmt: skip
def test_lists_that_hold_each_other_and_themselves(
    tmp_path: Path, use: str, said: str | None, at_most: Callable[[float], AbstractContextManager[None]]
) -> None:
    """Unfolded, they would have 2 ** 60 parts, or never end."""
    before = f"x, c, d = [1], [], []\nc.append(c)\nfor _ in range(60):\n    x = [x, x]\ny = {use}"
    with at_most(4):
        composition = described(tmp_path, "node('a'), *d", before)
    assert names(composition) == ([] if said and "23:9" in said else ["/a"])
    assert [text.rpartition("/")[2] for text in problems(composition, tmp_path)] == ([said] if said else [])


@pytest.mark.parametrize(
    "use",
    [
        "if 'gone' in get_packages_with_prefixes():\n        add(get_package_share_directory('gone'))",
        "if has_resource('packages', 'gone'):\n        add(get_package_share_directory('gone'))",
        "try:\n        add(get_package_share_directory('gone'))\n    except PackageNotFoundError:\n        pass",
        "if there('gone'):\n        add(get_package_share_directory('gone'))",
        "if 'gone' in get_packages_with_prefixes():\n        found.append(Node(package='gone_move_group', executable='x'))",
        "share = there('gone') and get_package_share_directory('gone')\n    if there('gone'):\n        found.append(Node(package='gone', executable='x'))",
    ],
)
def test_packages_that_are_used_when_they_are_installed(tmp_path: Path, use: str) -> None:
    text = f"""{HEAD}
from ament_index_python.packages import PackageNotFoundError, get_packages_with_prefixes
from ament_index_python.resources import has_resource

def there(name):
    try:
        get_package_share_directory(name)
        return True
    except PackageNotFoundError:
        return False

def generate_launch_description():
    found = [node('always')]
    def add(folder):
        found.append(IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(folder, 'launch', 'x.launch.py'))))
    {use}
    return LaunchDescription(found)
"""
    found = composed(tmp_path, {"main.launch.py": text})
    assert problems(found, tmp_path) == []
    assert [reference for reference in found.references if getattr(reference, "package", "") == "gone"] == []
    assert names(found)[0] == "/always"
    assert all(part.conditions for part in (*found.nodes[1:], *found.includes))


@pytest.mark.parametrize(
    "write",
    [
        "with open(path, 'w') as out:\n        out.write(made)",
        "out = open(path, 'w')\n    out.write(made)",
        "Path(path).write_text(made)",
        "subprocess.run(['make', '-o', path])",
        "os.system('make > ' + path)",
    ],
)
def test_files_that_the_launch_file_writes(tmp_path: Path, write: str) -> None:
    text = f"""{HEAD}
import subprocess
def generate_launch_description():
    made = subprocess.run(['seq', '3']).stdout.decode()
    path = os.path.join(get_package_share_directory('here'), 'tmp', 'x.yaml')
    {write}
    with open(path) as back:
        text = back.read()
    return LaunchDescription([node('n', parameters=[path, {{'text': text}}])])
"""
    found = composed(tmp_path, {"main.launch.py": text})
    assert [problem for problem in found.problems if problem.kind == "file"] == []
    assert "file-content" in str(params(found)["/n/text"])
