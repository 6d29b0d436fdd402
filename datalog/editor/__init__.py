"""What an editor asks about rules while they are written: what is wrong, what a name means, where it is used, what could stand here.

`occurrences` finds the names of a text by its tokens alone, so that it works between two keystrokes; `programs` checks whole programs
with the texts being edited in place of the files; `answers` puts both together; `server` speaks the Language Server Protocol.
"""
