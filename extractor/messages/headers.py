"""C++ headers as the ROS 1 generators would write them, for a parser that sees no generated files.

Sources: https://wiki.ros.org/roscpp/Overview/Messages, gencpp, actionlib, dynamic_reconfigure. The structs are plain, not templates, and
depend on one prelude, `ros/message_prelude.h`. A struct is called `Name_`, so that a field may be called like its message.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from rosarch.extractor.messages.model import PRIMITIVES, UNBOUNDED, Config, Constant, Field, Message, MessageStore

PRELUDE = "ros/message_prelude.h"
_CXX = {
    "bool": "uint8_t", "byte": "int8_t", "char": "uint8_t", "float32": "float", "float64": "double", "string": "std::string",
    "wstring": "std::wstring", "time": "ros::Time", "duration": "ros::Duration",
}  # fmt: skip
_CONFIG_CXX = {"int": "int", "double": "double", "bool": "bool", "string": "std::string"}


def header_index(store: MessageStore) -> Mapping[str, str]:
    """From each header's name, as code includes it, to the interface it comes from. A message wins over a service of its name."""
    index: dict[str, str] = {}
    for name in store.configs:
        index[f"{name}Config.h"] = name
    for name in (*store.services, *store.messages):
        index[f"{name}.h"] = name
    return index


def header_text(store: MessageStore, header: str) -> str | None:
    """The text of a header such as `std_msgs/Bool.h`; None when no interface is called so."""
    name = header.removesuffix(".h")
    if name == header:
        return None
    if name in store.messages:
        return _message_header(store.messages[name], store)
    if name in store.services:
        return _service_header(name)
    config = store.configs.get(name.removesuffix("Config")) if name.endswith("Config") else None
    return _config_header(config) if config else None


def generate_headers(store: MessageStore, out_dir: Path, packages: Iterable[str] | None = None) -> tuple[Path, ...]:
    """Write the headers of all packages, or of some; a file whose text would not change is left alone."""
    wanted = None if packages is None else set(packages)
    written: list[Path] = []
    for header in sorted(header_index(store)):
        text = header_text(store, header) if wanted is None or header.partition("/")[0] in wanted else None
        if text is None:
            continue
        path = out_dir / header
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        written.append(path)
    return tuple(written)


def _page(includes: Iterable[str], package: str, body: Iterable[str]) -> str:
    lines = ["#pragma once", f"#include <{PRELUDE}>", *(f"#include <{name}>" for name in includes)]
    return "\n".join([*lines, "", f"namespace {package} {{", *body, f"}}  // namespace {package}", ""])


def _message_header(message: Message, store: MessageStore) -> str:
    package, _, short = message.name.partition("/")
    struct = f"{short}_"
    used = dict.fromkeys(field.type for field in message.fields if field.type not in PRIMITIVES)
    includes = [f"{name}.h" for name in used if name in store.messages and name != message.name]
    body = [
        f"struct {struct} {{",
        f"  typedef {struct} Type;",
        f"  typedef boost::shared_ptr<{struct}> Ptr;",
        f"  typedef boost::shared_ptr<{struct} const> ConstPtr;",
        *(f"  {_constant(constant)}" for constant in message.constants),
    ]
    for field in message.fields:
        cxx = _field_type(field, store)
        if cxx is None:
            body.append(f"  // {field.name}: unknown type {field.type}")
            continue
        body += [f"  typedef {cxx} _{field.name}_type;", f"  _{field.name}_type {field.name};"]
    body += [
        "};",
        f"typedef {struct} {short};",
        f"typedef boost::shared_ptr<{struct}> {short}Ptr;",
        f"typedef boost::shared_ptr<{struct} const> {short}ConstPtr;",
    ]
    return _page(includes, package, body)


def _field_type(field: Field, store: MessageStore) -> str | None:
    if field.type in PRIMITIVES:
        item = _CXX.get(field.type, f"{field.type}_t")
    elif field.type in store.messages:
        item = f"::{field.type.replace('/', '::')}_"
    else:
        return None
    if field.array is None:
        return item
    return f"std::vector<{item}>" if field.array == UNBOUNDED else f"boost::array<{item}, {field.array}>"


def _constant(constant: Constant) -> str:
    if constant.type in ("string", "wstring"):
        return f"static const {_CXX[constant.type]} {constant.name};"
    if constant.type in ("float32", "float64"):
        return f"static const {_CXX[constant.type]} {constant.name};"
    return f"enum {{ {constant.name} = {integer_value(constant)} }};"


def integer_value(constant: Constant) -> str:
    """The value of a constant as an integer literal; what genmsg would reject is 0, so that the header still compiles."""
    text = {"true": "1", "false": "0"}.get(constant.value.lower(), constant.value)
    try:
        number = int(text, 0)
    except ValueError:
        try:
            number = int(text)
        except ValueError:
            return "0"
    return f"{number}{'u' if number > 0x7FFFFFFF else ''}"


def _service_header(name: str) -> str:
    package, _, short = name.partition("/")
    body = [
        f"struct {short} {{",
        f"  typedef {short}Request Request;",
        f"  typedef {short}Response Response;",
        "  typedef Request RequestType;",
        "  typedef Response ResponseType;",
        "  Request request;",
        "  Response response;",
        "};",
    ]
    return _page([f"{name}Request.h", f"{name}Response.h"], package, body)


def _config_header(config: Config) -> str:
    package, _, short = config.name.partition("/")
    name = f"{short}Config"
    body = [
        f"class {name} {{",
        "public:",
        *(f"  {_CONFIG_CXX[parameter.type]} {parameter.name};" for parameter in config.parameters),
        f"  {name}();",
        "  bool __fromMessage__(dynamic_reconfigure::Config& message);",
        "  void __toMessage__(dynamic_reconfigure::Config& message) const;",
        "  uint32_t __level__(const " + name + "& config) const;",
        "  void __clamp__();",
        f"  static const {name}& __getDefault__();",
        f"  static const {name}& __getMax__();",
        f"  static const {name}& __getMin__();",
        "};",
    ]
    for constant in config.constants:
        if constant.type == "string":
            body.append(f"const char* const {short}_{constant.name} = {_quoted(constant.value)};")
        else:
            body.append(f"const {_CONFIG_CXX[constant.type]} {short}_{constant.name} = {constant.value.lower()};")
    return _page(["dynamic_reconfigure/Config.h"], package, body)


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
    return f'"{escaped}"'
