"""Where sources say what is expected of them: `expect: ...` and the like, at the start of a comment, or of a line of one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from rosarch.extractor.suppressions import Comment, comments, without_end

_MARK = re.compile(
    r"(?:^|(?<=\n))[ \t]*(?:(?://+|/\*+|\*|\#+|<!--+)[ \t]*)?(?P<word>expect(?:-(?P<sense>not|only))?):(?:[ \t]+(?P<text>[^\n]*))?"
)


@dataclass(frozen=True)
class Marked:
    """An expectation as it is written, at `path:line:column`; `sense` is "", "not" or "only".

    It is about the lines `first` to `last`; `beside` says whether it follows code, on its line.
    """

    path: str
    line: int
    column: int
    text: str
    text_column: int
    sense: str
    first: int
    last: int
    beside: bool


def marked(path: str, text: str) -> Iterator[Marked]:
    """The expectations in a text; the kind of file that `path` names decides which comments there are."""
    for comment in comments(path, text) if "expect" in text else ():
        for match in _MARK.finditer(comment.text):
            yield _marked(path, comment, match)


def _marked(path: str, comment: Comment, match: re.Match[str]) -> Marked:
    line, column = comment.place(match.start("word"))
    told = without_end(match["text"] or "").strip()
    begin = comment.place(match.start("text"))[1] if match["text"] else column
    return Marked(path, line, column, told, begin, match["sense"] or "", comment.first, comment.last, comment.beside)
