"""Everything that reads what others wrote: each target takes the bytes of one input, and raises only for a defect.

What a reader refuses, it refuses with an exception of its own, which a target expects, or with a diagnostic.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import quoteattr

MANIFEST = (
    "<package><name>{}</name><version>1.2.3</version><description>d</description><maintainer email='a@b.cd'>m</maintainer>"
    "<license>BSD</license><buildtool_depend>catkin</buildtool_depend></package>"
)
_WORKSPACE = {
    "here/package.xml": MANIFEST.format("here"),
    "here/CMakeLists.txt": "project(here)\nadd_executable(node node.cpp)\n",
    "here/node.cpp": "int main() {}\n",
    "here/params.yaml": "a: 1\n",
    "here/launch/other.launch": '<launch><arg name="a" default="1"/><node name="$(arg a)" pkg="here" type="node"/></launch>',
    "here/other.xacro": '<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:property name="p" value="1"/></robot>',
    "here/src/here/more.py": "def more(gen):\n    gen.add('m', int_t, 0, 'd', 1)\n",
}


@dataclass(frozen=True)
class Target:
    """A reader: `run` hands it an input, in a folder of its own; `words` mean something to it."""

    name: str
    run: Callable[[bytes, Path], None]
    words: tuple[bytes, ...]


TARGETS: dict[str, Target] = {}


def target(words: str) -> Callable[[Callable[[bytes, Path], None]], Callable[[bytes, Path], None]]:
    """Register a function as the target of its name."""

    def register(run: Callable[[bytes, Path], None]) -> Callable[[bytes, Path], None]:
        TARGETS[run.__name__] = Target(run.__name__, run, tuple(word.encode() for word in words.split()))
        return run

    return register


def prepare(folder: Path) -> None:
    """Write the workspace that inputs become part of."""
    for name, text in _WORKSPACE.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")


@target(
    '.decl .input .output .type .comp .init .override .functor .plan .include :- = != count:{ } max sum:{ $A [a,b] match( "x" _ nil as('
)
def datalog(data: bytes, folder: Path) -> None:
    """Rules: parsed, checked and compiled."""
    from rosarch.datalog import DatalogError, load_program

    path = folder / "rules.dl"
    path.write_bytes(data)
    for source, preprocess in ((path, False), (path, True)):
        try:
            load_program(source, preprocess=preprocess)
        except DatalogError as error:
            str(error)


@target("number symbol float 1 -2147483648 0x7f nil [a,b] \t \\t ()")
def facts(data: bytes, folder: Path) -> None:
    """A file of facts, as rows of relations of several shapes."""
    from rosarch.datalog import DatalogError, load_program, read_facts
    from rosarch.datalog.files.facts import write_facts

    schema = folder / "schema.dl"
    if not schema.is_file():
        schema.write_text(
            ".type P = [a: symbol, b: number]\n.type L = [h: P, t: L]\n.type A = X {} | Y { n: number, l: L }\n"
            ".decl s(a: symbol, b: symbol)\n.decl n(a: number, b: float, c: unsigned)\n.decl r(a: P, b: L)\n.decl d(a: A)\n"
            ".input s, n, r, d\n"
        )
    program = load_program(schema)
    for name in ("s", "n", "r", "d"):
        (folder / f"{name}.facts").write_bytes(data)
    for strict in (False, True):
        try:
            program.read_facts(folder, strict=strict)
        except DatalogError as error:
            str(error)
    try:
        rows = read_facts(folder, [program.relations["s"]])
    except DatalogError:
        return
    write_facts(folder / "again", rows, program.relations)
    read_facts(folder / "again", [program.relations["s"]])


@target('{ } [ ] : , null true 1e5 "root" "components" "folder" "sources"')
def facts_manifest(data: bytes, folder: Path) -> None:
    """The manifest of a folder of facts."""
    from rosarch.extractor.manifest import ManifestError, facts_folder, read_manifest

    (folder / "manifest.json").write_bytes(data)
    facts_folder(folder)
    try:
        read_manifest(folder)
    except ManifestError as error:
        str(error)


@target("root source component diagnostic call(call, name) location(node, file, line, column) \t \t1")
def facts_text(data: bytes, folder: Path) -> None:
    """The facts of a workspace as one text."""
    from rosarch.extractor.facts_text import read_facts_text
    from rosarch.extractor.manifest import ManifestError

    (folder / "facts.txt").write_bytes(data)
    try:
        read_facts_text(folder / "facts.txt")
    except ManifestError as error:
        str(error)


def _compose(folder: Path, name: str, data: bytes) -> None:
    from rosarch.extractor.launch import Files, PackagePath, compose, record
    from rosarch.extractor.launch.facts import launch_rows

    path = folder / "here" / name
    path.write_bytes(data)
    composition = compose([path], {"b": "2"}, files=Files(PackagePath([folder]), str(folder)), environment={"HOME": "/home/me"})
    launch_rows(composition, folder)
    json.dumps(record(composition))
    for problem in composition.problems:
        str(problem)


@target(
    "import from as def class self. __init__ super(). lambda x: x for in if elif else: while True: try: except Exception, e: finally: with return yield await async"
    " global nonlocal @property f'{x}' '%s' % ( ) [ ] { } : = += := * ** print 'a' exec raise match case _: rospy.Publisher( create_timer( partial( \n \t \0 <> ` 0777 u''"
)  # fmt: skip
def python_source(data: bytes, folder: Path) -> None:
    """A script and a module that it imports, or that imports itself; all facts fit the schema."""
    from rosarch.extractor.facts import validate
    from rosarch.extractor.python.extract import extract_program
    from rosarch.extractor.workspace.model import PythonEntry

    script, module = folder / "here" / "node.py", folder / "here" / "tools.py"
    script.write_bytes(b"from tools import *\nimport tools\n" + data)
    module.write_bytes(data)
    entry = PythonEntry(script, "__main__", None, (folder / "here",), (("__main__", script), ("tools", module)))
    rows, problems = extract_program(folder, entry)
    validate(rows)
    for problem in problems:
        str(problem)


@target(
    "<launch> </launch> <node <group <include <arg <param <rosparam <remap <env <machine <test ns= name= pkg= type= args= if= unless= value="
    " default= file= command= textfile= binfile= from= to= pass_all_args= clear_params= $(arg $(find $(env $(optenv $(anon $(eval $(dirname)"
    " <!DOCTYPE <!ENTITY &x; <![CDATA[ ]]> subst_value="
)  # fmt: skip
def launch(data: bytes, folder: Path) -> None:
    """A launch file, composed, as facts and as a record."""
    _compose(folder, "main.launch", data)


@target(
    "from import launch launch_ros.actions launch.actions * LaunchDescription([ Node( GroupAction([ IncludeLaunchDescription( OpaqueFunction(function= ]) ) = : def"
    " generate_launch_description(): return if else for in while True: lambda class yield try: except: with open( as os.path.join( os.environ[ ] LaunchConfiguration("
    " PythonExpression([ 10**9 'a'*9**9 range( f'{ .format( .append( .add_action( self super().__init__( .perform(context) \\n \\t yaml.safe_load( { } **kw *args"
)  # fmt: skip
def launch_py(data: bytes, folder: Path) -> None:
    """A launch file in Python, interpreted; and the same text as a module that one imports."""
    (folder / "here" / "launch" / "tools.py").write_bytes(data)
    main = b"from tools import *\nfrom launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([make()])\n"
    for text in (data, main):
        _compose(folder, "launch/main.launch.py", text)


@target(
    "<launch> </launch> <node pkg= exec= name= namespace= args= if= unless= <param from= value= type= <remap to= <let <arg default= <choice <include file= <group"
    " scoped= <push_ros_namespace <set_remap <node_container <composable_node plugin= <load_composable_node target= <for_each values= <for len= <executable cmd="
    " $(var $(eval ' $(find-pkg-share $(env $(dirname) $(anon $(command $(not $(and $(if $(file-content launch: - node: {pkg: exec: } children: \\"
)  # fmt: skip
def launch_ros2(data: bytes, folder: Path) -> None:
    """A launch file of ROS 2 in XML and in YAML, and the same text as a file of parameters."""
    for name in ("main.launch.xml", "main.launch.yaml"):
        _compose(folder, name, b"<launch>%s</launch>" % data if name.endswith("xml") and b"<launch" not in data else data)
    (folder / "here" / "p.yaml").write_bytes(data)
    _compose(
        folder,
        "other.launch.xml",
        b'<launch><node pkg="here" exec="x" name="n"><param from="$(dirname)/p.yaml" allow_substs="true"/></node></launch>',
    )


@target(
    "a: - &a *a <<: !!python/object: !!binary !degrees rad(pi/2) deg(90) | > --- ... 0x1f 1:30 2001-99-99 ? {a,b} [1,[2]] ~ .inf 0o7 1_0"
)
def rosparam_yaml(data: bytes, folder: Path) -> None:
    """A YAML file that a launch file loads, and the same text within one."""
    main = b'<launch><arg name="b"/><rosparam file="$(find here)/params.yaml" ns="x"/><rosparam subst_value="true"><![CDATA[%s]]></rosparam></launch>'
    (folder / "here" / "params.yaml").write_bytes(data)
    _compose(folder, "main.launch", main % data.replace(b"]]>", b""))


@target(
    "$(arg $(find $(env $(optenv $(anon $(dirname) $(eval ) + - * / ** % << arg(' ' lambda for in if else [ ] { : } f'{ .format( 10**9 'a'*9 __ not"
)
def substitution(data: bytes, folder: Path) -> None:
    """A text with `$(...)`, by itself, as an expression, and as one of xacro."""
    from rosarch.extractor.launch.evaluation import EvalFailed, Unsupported, radians

    text = "".join(c for c in _text(data) if c.isprintable() or c == "\n")
    values = (text, f"$(eval {text})", f"$(arg a) {text}")
    params = "".join(f"<param name='p{n}' value={quoteattr(value)}/>" for n, value in enumerate(values))
    _compose(folder, "main.launch", f"<launch><arg name='a' default='1'/><arg name='b'/>{params}</launch>".encode())
    inner = "".join(f"<l v={quoteattr(value)}/>" for value in (text, f"${{{text}}}"))
    xacro(f"<robot xmlns:xacro='http://ros.org/wiki/xacro'><xacro:property name='a' value='1'/>{inner}</robot>".encode(), folder)
    with suppress(EvalFailed, Unsupported):
        radians(text)


@target(
    "<xacro:property <xacro:macro <xacro:include <xacro:if <xacro:unless <xacro:insert_block <xacro:arg <xacro:call <xacro:element"
    " name= value= params= filename= ${ $( } default= *block **block :=^ ^| := scope= ns= xacro.load_yaml( <gazebo> <plugin> <robot> </robot> <sdf>"
)  # fmt: skip
def xacro(data: bytes, folder: Path) -> None:
    """A robot description: evaluated in each dialect, written, and its plug-ins; as URDF or SDF as it is."""
    from rosarch.extractor.launch import Files, PackagePath
    from rosarch.extractor.launch.unknowns import Unknowns
    from rosarch.extractor.urdf import IN_ORDER, NOETIC, TRADITIONAL, expand, plugins, write

    (folder / "here" / "robot.xacro").write_bytes(data)
    for dialect in (NOETIC, IN_ORDER, TRADITIONAL):
        unknowns = Unknowns()
        files = Files(PackagePath([folder]), str(folder))
        found = expand(f"{folder}/here/robot.xacro", {"b": "2"}, files=files, environment={}, unknowns=unknowns, dialect=dialect)
        if found.document is not None:
            unknowns.render(write(found.document, "robot.xacro"))
            plugins(found.document.root)
        for problem in found.problems:
            str(problem)


@target(
    '<package> </package> <name> <depend> <export> <build_type> plugin="${prefix}/p.xml" format="3" condition="$A == 1" <!ENTITY <!DOCTYPE &x;'
)
def package_xml(data: bytes, folder: Path) -> None:
    """The manifest of a package, in a workspace that is searched for it."""
    from rosarch.extractor.launch import PackagePath
    from rosarch.extractor.workspace.manifests import read_manifest

    other = folder / "other"
    other.mkdir(exist_ok=True)
    (other / "package.xml").write_bytes(data)
    for problem in read_manifest(other / "package.xml")[1]:
        str(problem)
    _ = PackagePath([folder]).packages


def _extracted(folder: Path) -> None:
    """The workspace up to its components and messages, with all diagnostics shown."""
    from rosarch.extractor.messages import load_messages, message_classes
    from rosarch.extractor.workspace import components, discover
    from rosarch.reports.diagnostics import diagnostic_line

    workspace = discover(folder, timeout=10.0)
    problems = list(workspace.diagnostics)
    components(workspace, problems)
    message_classes(load_messages(workspace.packages, with_common=False))
    for problem in problems:
        diagnostic_line(problem, folder)


@target(
    "project( add_executable( target_link_libraries( set( list( string( file( foreach( endforeach() if( endif() while( endwhile() function("
    " endfunction() macro( endmacro() include( add_subdirectory( catkin_package( find_package( math( get_filename_component( ${ } $<TARGET: REGEX"
    " MATCHES APPEND GLOB_RECURSE REPLACE [[ ]] ; ARGN execute_process( configure_file( READ STRINGS .. / return() break() PARENT_SCOPE CACHE"
)  # fmt: skip
def cmake(data: bytes, folder: Path) -> None:
    """The CMake file of a package, evaluated."""
    (folder / "here" / "CMakeLists.txt").write_bytes(data)
    _extracted(folder)


@target(
    "setup( entry_points= scripts= package_dir= {'console_scripts': ['a = here.b:main']} [options.entry_points] console_scripts = #!/usr/bin/python"
    " import rospy from . import * from .. import if __name__ == '__main__': f'{ } % + ( ) [ ] : = \\t"
)
def python_packaging(data: bytes, folder: Path) -> None:
    """A `setup.py`, a `setup.cfg` and a script with the same text: the nodes that they tell of."""
    for name in ("setup.py", "setup.cfg", "script.py"):
        (folder / "here" / name).write_bytes(data)
    (folder / "here" / "here.py").write_bytes(b"import rospy\n" + data)
    _extracted(folder)


@target("int32 string[] float64[9] uint8 Header header A=1 --- geometry_msgs/Pose[<=3] string<=5 # wstring byte[ ] \\t")
def interface(data: bytes, folder: Path) -> None:
    """A message, service or action, and the C++ headers for it."""
    from rosarch.extractor.messages import header_text, load_messages
    from rosarch.extractor.workspace import Package

    package = folder / "here"
    for kind in ("msg", "srv", "action"):
        (package / kind).mkdir(exist_ok=True)
        (package / kind / f"Thing.{kind}").write_bytes(data)
    store = load_messages([Package("here", package, package / "package.xml")], with_common=False)
    for name in ("here/Thing.h", "here/ThingRequest.h", "here/ThingAction.h", "here/ThingGoal.h"):
        header_text(store, name)
    for problem in store.diagnostics:
        str(problem)


@target(
    "gen.add( gen.const( gen.enum( exit(gen.generate( int_t double_t str_t bool_t ParameterGenerator() for in range( def import from if % * ** + 'a' 9999"
)
def reconfigure_cfg(data: bytes, folder: Path) -> None:
    """A `.cfg` file of dynamic_reconfigure."""
    from rosarch.extractor.messages import load_messages
    from rosarch.extractor.workspace import Package

    path = folder / "here" / "Thing.cfg"
    path.write_bytes(data)
    package = Package("here", folder / "here", folder / "here" / "package.xml", cfg_files=(path,))
    for problem in load_messages([package], with_common=False).diagnostics:
        str(problem)


@target('here: type: double default_value: [ ] { } __map_a: string_array_fixed_2 none read_only: !!python & * \\t - # ? | > "')
def parameter_library(data: bytes, folder: Path) -> None:
    """The YAML file of a library of parameters: the header that it makes has its lines."""
    from rosarch.extractor.messages.parameter_library import ParameterHeaders, made_from
    from rosarch.extractor.workspace import Package

    path = folder / "here" / "parameters.yaml"
    path.write_bytes(data)
    package = Package("here", folder / "here", folder / "here" / "package.xml", parameter_files=(("parameters", path),))
    found = ParameterHeaders.of([package], folder)
    for problem in found.diagnostics:
        str(problem)
    for name, text in found.texts.items():
        made = made_from(text.encode())
        if name.startswith("rosarch_parameters/") and made != "here/parameters.yaml":
            raise ValueError(f"made from {made}")


@target(
    "<library <class path= name= type= base_class_type= <class_libraries> </library> <description> <?xml ?> <!DOCTYPE <!ENTITY &x; </several><several>"
)
def plugin_xml(data: bytes, folder: Path) -> None:
    """A description of plug-ins."""
    from rosarch.extractor.workspace.plugins import parse_plugins

    for problem in parse_plugins(_text(data), folder / "plugins.xml")[1]:
        str(problem)


@target('[ ] { } "file": "directory": "command": "arguments": "output": -I -isystem -D -U -o \\" \' .. / null 1')
def compile_commands(data: bytes, folder: Path) -> None:
    """`compile_commands.json`."""
    from rosarch.extractor.workspace.compile_commands import read_compile_commands

    (folder / "compile_commands.json").write_bytes(data)
    for problem in read_compile_commands(folder).diagnostics:
        str(problem)


@target(
    'rosarch: ignore[ ] // /* */ # <!-- --> """ R"( )" expect: expect-not: publisher subscriber -> = queue= latched on if finding port( , !'
)
def comments(data: bytes, folder: Path) -> None:
    """Suppressions and expectations in files of every kind."""
    from rosarch.evaluation.expectations.comments import marked
    from rosarch.evaluation.expectations.grammar import ExpectationError, parse
    from rosarch.extractor.suppressions import suppressions_in

    text = _text(data)
    for path in ("a.cpp", "a.launch", "a.py", "a.yaml", "CMakeLists.txt", "a.msg"):
        suppressions_in(path, text)
        for found in marked(path, text):
            try:
                parse(found)
            except ExpectationError as error:
                str(error)


@target('PLUGINLIB_EXPORT_CLASS( PLUGINLIB_DECLARE_CLASS( #include " < > /* */ // R"( \\ , ) #if #define #pragma once __has_include')
def source_text(data: bytes, folder: Path) -> None:
    """A C++ source, as far as it is read as text: includes, registered plug-ins."""
    from rosarch.extractor.cxx.includes import HeaderFinder
    from rosarch.extractor.cxx.units import odd_source
    from rosarch.extractor.workspace.plugins import registrations

    path = folder / "here" / "node.cpp"
    path.write_bytes(data)
    registrations(path)
    odd_source(path)
    scratch = folder / "scratch"
    scratch.mkdir(exist_ok=True)
    finder = HeaderFinder(folder, scratch, lambda _name: None)
    finder.fingerprint(finder.closure(path))


@target(
    "class struct template<typename> [&](auto) operator() ros::NodeHandle nh; nh.advertise< nh.subscribe( ; { } switch case goto try catch #include <ros/ros.h>"
)
def cxx(data: bytes, folder: Path) -> None:
    """A C++ source: parsed, healed, walked. A crash of libclang costs its process; what is asked for here is that nothing else happens."""

    from rosarch.extractor.cxx import libclang
    from rosarch.extractor.cxx.includes import HeaderFinder
    from rosarch.extractor.cxx.translation_unit import CompileUnit, build_prelude, extract_unit
    from rosarch.extractor.facts import validate

    prelude, scratch = folder / "prelude.pch", folder / "scratch"
    scratch.mkdir(exist_ok=True)
    if not prelude.is_file():
        build_prelude(prelude)
    path = folder / "here" / "node.cpp"
    path.write_bytes(data)
    finder = HeaderFinder(folder, scratch, lambda _name: None)
    try:
        validate(extract_unit(CompileUnit(path), folder, finder, prelude, heal=True))
    except libclang.ParseError as error:
        str(error)


@target(
    "checks: fail-on: ignore-paths: launch: package-path: environment: baseline: - {a: } high error &a *a !!x topic-type-mismatch file: arguments:"
)
def configuration(data: bytes, folder: Path) -> None:
    """`.rosarch.yml`."""
    from rosarch.findings.configuration_reader import ConfigurationError, read_configuration

    try:
        read_configuration(_text(data), ".rosarch.yml", ["topic-type-mismatch", "parameter-type"])
    except ConfigurationError as error:
        str(error)


@target(
    "component: package: system: ports: - {id: a, kind: publisher} params: reactive: input: output: &a *a <<: !!python/name: null 2001-01-01 0x1"
)
def truth(data: bytes, folder: Path) -> None:
    """A model written by hand, and the same text as an experiment."""
    from rosarch.datalog import DatalogError
    from rosarch.evaluation.experiments.plan import PlanError, read_experiment
    from rosarch.evaluation.experiments.truth import TruthError, read_truth

    below = folder / "truth"
    below.mkdir(exist_ok=True)
    (below / "a.yml").write_bytes(data)
    try:
        read_truth(below)
    except TruthError as error:
        str(error)
    try:
        read_experiment(below / "a.yml")
    except (PlanError, TruthError, DatalogError) as error:
        str(error)


@target(
    '{ } [ ] : , "package" "components" "ports" "name" "kind" "from_arg" "pattern" "{1}" "(a+)+$" NaN 1e999 true null "rosarch_baseline" "findings"'
)
def documents(data: bytes, folder: Path) -> None:
    """JSON of several kinds: a file of the library, a baseline."""
    from rosarch.findings.baseline import BaselineError, read_baseline
    from rosarch.library.reading import read_library_file

    path = folder / "library.json"
    path.write_bytes(data)
    str(read_library_file(path))
    try:
        read_baseline(_text(data), "baseline.json")
    except BaselineError as error:
        str(error)


@target("#ROSBAG op= conn= time= topic= type= callerid= message_definition= compression=bz2 compression=lz4 size= \\x02 \\x05 \\x07")
def recording(data: bytes, folder: Path) -> None:
    """A bag of ROS 1: what can be read of it is summarised."""
    from rosarch.observation.recording import RecordingError, open_recording
    from rosarch.observation.summary import summarise

    path = folder / "run.bag"
    path.write_bytes(data)
    with suppress(RecordingError):
        summarise(open_recording(path), [("/a", "/b")])
