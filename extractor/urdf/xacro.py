"""A xacro file, evaluated."""

from __future__ import annotations

from collections.abc import Mapping

from rosarch.extractor.launch.files import Files
from rosarch.extractor.launch.model import LaunchError, Place
from rosarch.extractor.launch.unknowns import Unknowns
from rosarch.extractor.urdf.context import Context
from rosarch.extractor.urdf.document import Document, DocumentError, parse
from rosarch.extractor.urdf.expander import Expander, Frame
from rosarch.extractor.urdf.model import NOETIC, Dialect, Expansion, XacroError
from rosarch.extractor.urdf.symbols import Symbols, Table
from rosarch.extractor.urdf.traditional import collect


def expand(
    path: str,
    arguments: Mapping[str, str] | None = None,
    *,
    files: Files,
    environment: Mapping[str, str] | None = None,
    unknowns: Unknowns | None = None,
    dialect: Dialect = NOETIC,
    installed: bool = False,
) -> Expansion:
    """What xacro makes of a file. What depends on something absent stays unknown, as `unknowns` has it, and the rest is evaluated.

    Args:
        path: the file.
        arguments: values of its arguments.
        files: reads files and knows the packages.
        environment: the environment variables that `$(env)` and `$(optenv)` see.
        unknowns: those that `arguments` may have.
        dialect: how xacro reads it.
        installed: whether packages are looked for where they are installed; a file there may come from elsewhere in their sources.
    """
    context = Context(files, environment or {}, unknowns or Unknowns(), arguments or {}, installed)
    expander = Expander(context, dialect)
    frame = Frame(Table(), Symbols(dialect))
    context.here = Place(path, 1)
    document: Document | None = None
    try:
        with context.file(path):
            source = files.parsed(path, parse)
            if not dialect.in_order:
                source = collect(source, expander, frame)
            document = expander.root(source, frame)
    except (LaunchError, XacroError) as error:
        context.report(LaunchError("xacro", error.subject, error.message))
    except DocumentError as error:
        context.here = error.place
        context.report(LaunchError("xml", path, error.message))
    except RecursionError:
        context.report(LaunchError("xacro", path, "definitions nested too deeply"))
    read, meant = tuple(context.read), tuple(context.meant)
    return Expansion(document, tuple(context.problems), read, expander.bare_tags, context.work, context.incomplete, meant)
