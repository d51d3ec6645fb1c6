# SPDX-License-Identifier: GPL-2.0-or-later
"""What is raised: bad data and bad calls. A mathematical no is a value, never an exception."""
from __future__ import annotations

from typing import Any, Optional

from . import _tetrarch


class TetrarchError(ValueError):
    """Bad data, or a bad call: one line that says what was found and what was expected.

    >>> import tetrarch as tt
    >>> try:
    ...     tt.Manifold("m0004")
    ... except tt.InputError as error:
    ...     print(error.code, error.file, error.line)
    unknown_name None None
    """

    #: the cause, a stable word: see InputError and PreconditionError
    code = "error"

    def __init__(self, message: str, file: Optional[str] = None, line: Optional[int] = None) -> None:
        super().__init__(message)
        #: what the error is about, as the caller named it; None: nothing that has a name
        self.file = file
        #: the line of that file, from 1; None: no line
        self.line = line


def shown(value: Any) -> str:
    """A value as it may stand in an error: one short line."""
    text = repr(value) if isinstance(value, (str, int, float, bytes)) else " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:57] + "..."


class InputError(TetrarchError):
    """Bad data from outside: a file, an array, an option. It has `code`, `file` and `line`.

    The code is one of "bad_value", "bad_option", "unknown_name", "wrong_kind" (a group where a mesh is expected), "bad_file" (that
    cannot be opened, read or written), "bad_content" (of a file), "no_memory", or, of what Python itself refuses, "bad_input".

    >>> import tetrarch as tt
    >>> issubclass(tt.InputError, ValueError), tt.InputError.code
    (True, 'bad_input')
    """

    code = "bad_input"


class PreconditionError(TetrarchError):
    """A call that cannot be: a structure is needed, and there is none.

    >>> import tetrarch as tt
    >>> try:
    ...     tt.Manifold("S^3").dihedral_angles()
    ... except tt.PreconditionError as error:
    ...     print(error.code)
    precondition
    """

    code = "precondition"


_tetrarch.set_error_types(InputError, PreconditionError)
