"""Errors a user can meet, each one line on stderr, and the exit codes."""

from __future__ import annotations

import errno
import sys
from collections.abc import Callable
from typing import Any

import typer

CLEAN, FINDINGS, USAGE, INTERRUPTED, BROKEN_PIPE = 0, 1, 2, 130, 141

_NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EROFS)

# click's own base class of wrong usage, wherever this version of typer takes click from
_UsageError: Any = typer.BadParameter.__mro__[1]


class InputError(Exception):
    """Something is wrong with what the user gave; the text is one line that says what."""


def run(command: Callable[[], Any], traceback: bool = False) -> int:
    """Run `command`; turn every exception into one line on stderr and an exit code."""
    try:
        result = command()
        if result == INTERRUPTED:  # so typer reports Ctrl-C
            raise KeyboardInterrupt
        return result if isinstance(result, int) else CLEAN
    except (KeyboardInterrupt, typer.Abort):
        print("rosarch: interrupted", file=sys.stderr)
        return INTERRUPTED
    except InputError as error:
        return _fail(str(error))
    except OSError as error:
        if isinstance(error, PermissionError) and error.filename:
            return _fail(f"{error.filename}: permission denied")
        if error.errno not in _NO_ROOM and not (error.errno == errno.EIO and error.filename):
            return _unexpected(error, traceback)
        return _fail(f"{error.filename or 'disk'}: cannot write ({(error.strerror or str(error)).lower()})")
    except ImportError as error:
        return _unexpected(error, traceback) if traceback else _fail(str(error), "a part of the installation is missing or too old")
    except _UsageError as error:
        return _fail(error.format_message(), _usage_hint(error))
    except Exception as error:  # the boundary of the program: nobody above can say more
        return _unexpected(error, traceback)


def _unexpected(error: Exception, traceback: bool) -> int:
    if traceback:
        raise error
    text = str(error).strip().partition("\n")[0]
    return _fail(f"unexpected {type(error).__name__}: {text}", "this is a defect of rosarch; --traceback shows where")


def _fail(message: str, hint: str = "") -> int:
    from rosarch.reports.printable import printable

    lines = f"rosarch: error: {message}{f' ({hint})' if hint else ''}".split("\n")
    print("\n".join(map(printable, lines)), file=sys.stderr)
    return USAGE


def _usage_hint(error: Any) -> str:
    context = getattr(error, "ctx", None)
    return f"see {context.command_path} --help" if context else ""
