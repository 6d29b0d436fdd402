"""Files, paths, texts as values, the environment and the index of packages, for Python launch files."""

from __future__ import annotations

import copy
import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import yaml

from rosarch.extractor.launch.descriptions import evaluated
from rosarch.extractor.launch.formulas import Test
from rosarch.extractor.launch.model import LaunchError
from rosarch.extractor.launch.state import PART_COST
from rosarch.extractor.launch.unknowns import is_known
from rosarch.extractor.launch.yaml_values import Loader, YamlError
from rosarch.extractor.launch_ros2.expressions import Raised
from rosarch.extractor.launch_ros2.registry import native
from rosarch.extractor.launch_ros2.values import NOTHING, Either, Installed, Instance, Made, PathText, TextFile, Unknown, installed
from rosarch.extractor.urdf.command import xacro_call

if TYPE_CHECKING:
    from rosarch.extractor.launch_ros2.calls import Calls

_Call = Callable[..., Any]
_DUMPER = getattr(yaml, "CSafeDumper", yaml.SafeDumper)


# -- files and paths ----------------------------------------------------------------------------------------------------------


def _path(value: Any) -> str | None:
    return value.text if isinstance(value, PathText) else value if isinstance(value, str) else None


def _paths(values: tuple[Any, ...], run: Calls) -> list[str]:
    return [path if (path := _path(value)) is not None else run.world.as_text(value) for value in values]


@native("os.path.join")
def _join(run: Calls, *parts: Any) -> Any:
    if any(isinstance(part, (Made, Instance)) for part in parts):
        return NOTHING
    return os.path.join(*_paths(parts, run)) if parts else NOTHING


def _of_text(function: Callable[[str], Any]) -> _Call:
    def call(_run: Calls, path: Any, *_more: Any) -> Any:
        text = _path(path)
        return NOTHING if text is None else function(text)

    return call


_OF_TEXT: dict[str, Callable[[str], Any]] = {
    "dirname": os.path.dirname,
    "basename": os.path.basename,
    "normpath": os.path.normpath,
    "realpath": os.path.normpath,
    "abspath": os.path.normpath,
    "split": os.path.split,
    "splitext": os.path.splitext,
    "isabs": os.path.isabs,
}
for _name, _function in _OF_TEXT.items():
    native(f"os.path.{_name}")(_of_text(_function))


def _below_home(run: Calls, text: str) -> str:
    """A path with the home folder in place of `~`: an unknown one, as the reader of the sources need not be the user who launches them."""
    user, slash, rest = text.partition("/")
    return f"{run.world.state.unknowns.mark(f'$(home {user})', user)}{slash}{rest}" if user.startswith("~") else text


@native("os.path.expanduser")
def _expanded(run: Calls, path: Any) -> Any:
    text = _path(path)
    return NOTHING if text is None else _below_home(run, text)


@native("pathlib.Path.home")
def _home(run: Calls) -> PathText:
    return PathText(_below_home(run, "~"))


def _there(run: Calls, path: Any, *_more: Any) -> Any:
    """Whether there is such a file or folder; unknown for one that is elsewhere."""
    text = _path(path)
    if text is None or not is_known(text):
        return NOTHING
    world = run.world
    world.looked_for.add(text)
    if text in world.written or world.state.files.is_file(world.located(text)):
        return True
    below = any(text.startswith(folder) for folder in world.state.files.packages.packages.values())
    return os.path.isdir(text) if below else NOTHING


for _name in ("os.path.exists", "os.path.isfile", "os.path.isdir"):
    native(_name)(_there)


@native("pathlib.Path", "pathlib.PurePath", "pathlib.PosixPath")
def _new_path(run: Calls, *parts: Any) -> Any:
    return PathText("").joined(*_paths(parts, run)) if parts else PathText(".")


def _same_path(_run: Calls, owner: PathText, *_more: Any, **_named: Any) -> PathText:
    return PathText(os.path.normpath(owner.text))


PATH_METHODS: dict[str, _Call] = {
    **dict.fromkeys(("resolve", "absolute"), _same_path),
    "expanduser": lambda run, owner: PathText(_below_home(run, owner.text)),
    "joinpath": lambda run, owner, *parts: owner.joined(*_paths(parts, run)),
    "as_posix": lambda _run, owner: owner.text,
    "with_suffix": lambda _run, owner, suffix: PathText(os.path.splitext(owner.text)[0] + suffix),
    "with_name": lambda _run, owner, name: PathText(os.path.join(os.path.dirname(owner.text), name)),
    "read_text": lambda run, owner, *_more, **_named: text_at(run, owner),
    "write_text": lambda run, owner, text, *_more, **_named: _write_text(run, owner, text),
    "open": lambda run, owner, *more, **named: _open(run, owner, *more, **named),
    **dict.fromkeys(("exists", "is_file", "is_dir"), _there),
}


def text_at(run: Calls, path: Any) -> Any:
    """The text of a file, or what stands for it where it is not known."""
    world, path = run.world, _path(path)
    if path not in world.written and (world.state.unknowns.is_open(path) or world.is_handed(path)):
        return world.content_of(path)
    try:
        return world.source_of(path)
    except LaunchError as error:
        if error.kind in ("file", "unreadable") and not run.optional({"FileNotFoundError", "OSError"}, path):
            world.state.report(error)
        return world.content_of(path)


@native("open")
def _open(run: Calls, path: Any, mode: Any = "r", *_more: Any, **_named: Any) -> Any:
    text = _path(path)
    if text is None:
        return NOTHING
    if isinstance(mode, str) and ("w" in mode or "x" in mode):
        run.world.written[text] = ""
        return TextFile(text, "", written=True)
    found = text_at(run, text)
    return TextFile(text, found, written=not isinstance(mode, str) or "a" in mode or "+" in mode)


def _read(_run: Calls, owner: TextFile, *_more: Any) -> Any:
    return NOTHING if owner.text is None else owner.text


def _write(run: Calls, owner: TextFile, text: Any) -> None:
    owner.text = owner.text + text if isinstance(text, str) and owner.text is not None else None
    run.close(owner)


def _write_text(run: Calls, owner: PathText, text: Any, *_more: Any, **_named: Any) -> None:
    run.close(TextFile(owner.text, text if isinstance(text, str) else None, written=True))


FILE_METHODS: dict[str, _Call] = {
    "read": _read,
    "write": _write,
    "readlines": lambda _run, owner: owner.text.splitlines(keepends=True) if owner.text is not None and is_known(owner.text) else NOTHING,
    "close": lambda run, owner: run.close(owner),
}


@native("tempfile.NamedTemporaryFile", "tempfile.TemporaryFile")
def _temporary(run: Calls, *_arguments: Any, **_named: Any) -> Any:
    return TextFile(run.world.new_file(), "", written=True)


@native("tempfile.gettempdir")
def _temporary_folder(run: Calls) -> Any:
    return run.world.state.unknowns.mark("$(temporary folder)", "tempfile")


@native("tempfile.mktemp", "tempfile.mkdtemp")
def _temporary_name(run: Calls, *_arguments: Any, **_named: Any) -> Any:
    return run.world.new_file()


@native("glob.glob")
def _glob(run: Calls, pattern: Any, **_named: Any) -> Any:
    text = _path(pattern)
    try:
        return NOTHING if text is None or not is_known(text) else run.world.state.files.matching(text)
    except LaunchError:
        return NOTHING


# -- xacro --------------------------------------------------------------------------------------------------------------------


@native("xacro.process_file")
def _process_file(run: Calls, path: Any, *_more: Any, mappings: Any = None, **_named: Any) -> Any:
    """A document that xacro makes of a file, as Python hands it on."""
    file = _path(path)
    given = mappings if isinstance(mappings, dict) else {} if mappings is None else None
    if file is None or given is None or not all(isinstance(one, str) for pair in given.items() for one in pair):
        return NOTHING
    return Made("XacroDocument", {"file": file, "mappings": given}, run.world.state.here)


@native("xacro.parse")
def _parse(run: Calls, source: Any, *_more: Any, **_named: Any) -> Any:
    return _process_file(run, source.name) if isinstance(source, TextFile) else NOTHING


@native("xacro.process_doc")
def _process_doc(_run: Calls, document: Any, *_more: Any, mappings: Any = None, **_named: Any) -> Any:
    if isinstance(document, Made) and document.kind == "XacroDocument" and isinstance(mappings, dict):
        document.arguments["mappings"] = mappings
    return None


@native("xacro.process")
def _process(run: Calls, path: Any, *_more: Any, **named: Any) -> Any:
    document = _process_file(run, path, **named)
    return document if document is NOTHING else xml_of(run, document)


def xml_of(run: Calls, document: Made) -> Any:
    """`document.toxml()`: what xacro prints."""
    words = ["xacro", document.arguments["file"], *(f"{name}:={value}" for name, value in document.arguments["mappings"].items())]
    call, world = xacro_call(words), run.world
    if call is None or world.state.unknowns.is_open(call.file) or world.is_made(call.file):
        return NOTHING
    printed, robot = evaluated(world.state, call, installed=True)
    if printed is None:
        return NOTHING
    world.described[printed] = robot
    return printed


# -- texts as values ----------------------------------------------------------------------------------------------------------


_WITH_YAML_6 = frozenset({"jazzy", "kilted", "rolling"})


@native("yaml.load")
def _load_so(run: Calls, source: Any, *loader: Any, **named: Any) -> Any:
    """Since PyYAML 6, which is in the distributions since Jazzy, a loader must be given."""
    if not (loader or named) and run.world.environment.get("ROS_DISTRO") in _WITH_YAML_6:
        raise Raised("TypeError", "load() missing 1 required positional argument: 'Loader'")
    return _load(run, source)


@native("yaml.safe_load", "yaml.full_load")
def _load(run: Calls, source: Any, *_more: Any, **_named: Any) -> Any:
    text = source.text if isinstance(source, TextFile) else source
    if not isinstance(text, str) or run.world.state.unknowns.is_open(text):
        return NOTHING
    files = run.world.state.files
    try:
        found, lines = files.yaml(text, Loader)
        value = copy.deepcopy(found)
        path = source.name if isinstance(source, TextFile) and not source.written else files.with_text(text)
        if path is not None:
            run.world.note_read(value, path, lines)
        return value
    except YamlError as error:
        raise Raised("YAMLError", error.message) from None


@native("json.load", "json.loads")
def _json(run: Calls, source: Any, **named: Any) -> Any:
    return _load(run, source, **named)


@native("yaml.dump", "yaml.safe_dump", "json.dumps", "json.dump")
def _dump(run: Calls, data: Any, stream: Any = None, **_named: Any) -> Any:
    plain = certain(run, data)
    text = NOTHING if plain is NOTHING else _written(plain)
    if isinstance(stream, TextFile):
        stream.text = None if text is NOTHING else (stream.text or "") + text
        run.close(stream)
        return None
    return text


def _written(data: Any) -> str:
    text = _yaml(data, _DUMPER)
    # libyaml escapes characters beyond the basic plane, such as those that stand for unknown parts
    return _yaml(data, yaml.SafeDumper) if "\\U001" in text else text


def _yaml(data: Any, dumper: Any) -> str:
    text: str = yaml.dump(data, Dumper=dumper, sort_keys=False, allow_unicode=True, width=1 << 20)
    return text


def certain(run: Calls, value: Any) -> Any:
    """A value with texts for what is unknown in it; NOTHING when it cannot be written as a text."""
    if isinstance(value, (Unknown, Either, PathText)):
        return run.world.as_text(value)
    if isinstance(value, (dict, list, tuple)):
        run.world.state.spend(PART_COST * len(value))
    if isinstance(value, dict):
        return {certain(run, key): certain(run, item) for key, item in value.items() if item is not NOTHING}
    if isinstance(value, (list, tuple)):
        return [certain(run, item) for item in value]
    return value if value is None or isinstance(value, (str, int, float)) else NOTHING


# -- the environment and the index of packages --------------------------------------------------------------------------------


def environment_item(run: Calls, name: Any) -> Any:
    """`os.environ[name]`."""
    if not isinstance(name, str) or not is_known(name):
        return NOTHING
    world = run.world
    value = world.context.variable(name)
    if value is not None:
        return value
    if world.context.lacks(name):
        world.state.report(LaunchError("env", name, f"environment variable `{name}` is not set"))
    return world.state.unknowns.mark(f"$(env {name})")


def environment_has(run: Calls, name: str) -> bool:
    """`name in os.environ`."""
    return not run.world.context.lacks(name)


@native("os.environ.copy")
def environment(run: Calls) -> dict[Any, Any]:
    """`os.environ` as a map: what is set here, and what may be set where launch runs."""
    more = Unknown("os.environ", run.world.state.here)
    return {**run.world.context.variables(), more: more}


def set_environment(run: Calls, name: Any, value: Any) -> None:
    """`os.environ[name] = value`: the environment of launch itself."""
    if isinstance(name, str) and is_known(name):
        run.world.context.environment[name] = run.world.as_text(run.guarded(value, run.world.context.variable(name) or ""))


@native("os.environ.setdefault")
def _set_default(run: Calls, name: Any, value: Any) -> Any:
    if isinstance(name, str) and not environment_has(run, name):
        set_environment(run, name, value)
    return _environment(run, name)


@native("os.environ.update")
def _update_environment(run: Calls, more: Any = None, **named: Any) -> None:
    for name, value in {**(more if isinstance(more, dict) else {}), **named}.items():
        set_environment(run, name, value)


@native("os.environ.pop")
def _unset_environment(run: Calls, name: Any, default: Any = None) -> Any:
    found = _environment(run, name, default)
    if isinstance(name, str):
        run.world.context.environment[name] = None
    return found


@native("os.getenv", "os.environ.get")
def _environment(run: Calls, name: Any, default: Any = None) -> Any:
    if not isinstance(name, str) or not is_known(name):
        return NOTHING
    value = run.world.context.variable(name)
    if value is not None:
        return value
    run.unset = run.unset or default is None
    if default is not None or run.world.context.lacks(name):
        return default
    return run.world.state.unknowns.mark(f"$(env {name})")


native("os.environ")(lambda _run: NOTHING)


@native("ament_index_python.packages.get_package_share_directory", "ament_index_python.get_package_share_directory")
def _share(run: Calls, package: Any = None, **named: Any) -> Any:
    return run.world.share(_package_name(run, package if package is not None else named.get("package_name")))


@native("ament_index_python.packages.get_package_share_path", "ament_index_python.get_package_share_path")
def _share_path(run: Calls, package: Any) -> Any:
    return PathText(run.world.share(_package_name(run, package)))


@native("ament_index_python.packages.get_package_prefix", "ament_index_python.get_package_prefix")
def _prefix(run: Calls, package: Any) -> Any:
    return run.world.prefix(_package_name(run, package))


def _package_name(run: Calls, name: Any) -> str:
    """The name of a package, which no substitution is: that has no value before launch carries something out."""
    if not isinstance(name, Made):
        return run.world.as_text(name)
    state = run.world.state
    state.report(LaunchError("python", "TypeError", f"TypeError: {name.kind} is no name of a package"))
    return state.unknowns.mark(f"$({name.kind})")


@native("ament_index_python.resources.has_resource", "ament_index_python.has_resource")
def _has_resource(run: Calls, kind: Any, name: Any = None, **_named: Any) -> Any:
    if kind != "packages" or not isinstance(name, str) or not is_known(name):
        return NOTHING
    there = installed(name)
    return True if run.installs(name) else Unknown(there, run.world.state.here, truth=Test(there))


@native("ament_index_python.packages.get_packages_with_prefixes", "ament_index_python.get_packages_with_prefixes")
def _packages(_run: Calls) -> Any:
    return Installed()


@native("ament_index_python.resources.get_resources", "ament_index_python.get_resources")
def _resources(_run: Calls, kind: Any, **_named: Any) -> Any:
    return Installed() if kind == "packages" else NOTHING
