# SPDX-License-Identifier: GPL-2.0-or-later
"""What a call found, as objects: the members of the program's JSON are attributes."""
from __future__ import annotations

import json
import keyword
import re
from typing import Any, Dict, Iterator, List, Optional, Tuple

__all__ = ["Record", "Result"]


def _wrapped(value: Any) -> Any:
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list):
        return [_wrapped(item) for item in value]
    return value


def attribute_name(field: str) -> str:
    """The name by which Python's syntax reaches a field."""
    name = re.sub(r"\W", "_", field)
    return name + "_" if keyword.iskeyword(name) else name


class Record:
    """Named values, read as attributes or as members.

    >>> from tetrarch import Record
    >>> record = Record({"kind": "inverted", "place": {"line": 7}})
    >>> record.kind, record["kind"], record.place.line
    ('inverted', 'inverted', 7)
    >>> sorted(record), record.as_dict()["place"]
    (['kind', 'place'], {'line': 7})
    """

    _fields: Dict[str, Any]

    def __init__(self, fields: Dict[str, Any]) -> None:
        object.__setattr__(self, "_fields", dict(fields))

    def as_dict(self) -> Dict[str, Any]:
        """The values in a dictionary of their own, as JSON has them.

        >>> from tetrarch import Record
        >>> Record({"edges": 1}).as_dict()
        {'edges': 1}
        """
        copied: Dict[str, Any] = json.loads(json.dumps(self._fields))
        return copied

    def get(self, name: str, default: Any = None) -> Any:
        """The value of that name, or `default` if there is none.

        >>> from tetrarch import Record
        >>> Record({"edges": 1}).get("faces", 0)
        0
        """
        return _wrapped(self._fields[name]) if name in self._fields else default

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        fields = self.__dict__.get("_fields", {})
        if name not in fields:  # from_ is the field from
            name = next((field for field in fields if attribute_name(field) == name), name)
        if name not in fields:
            raise AttributeError("%s has no %r (it has: %s)" % (type(self).__name__, name, ", ".join(fields)))
        return _wrapped(fields[name])

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("results never change")

    def __getitem__(self, name: str) -> Any:
        return _wrapped(self._fields[name])

    def __contains__(self, name: object) -> bool:
        return name in self._fields

    def __iter__(self) -> Iterator[str]:
        return iter(self._fields)

    def __len__(self) -> int:
        return len(self._fields)

    def __dir__(self) -> List[str]:
        return sorted({*super().__dir__(), *self._fields})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Record) and self._fields == other._fields

    def __hash__(self) -> int:
        return hash(json.dumps(self._fields))

    def __repr__(self) -> str:
        return "%s(%s)" % (type(self).__name__, ", ".join("%s=%.60r" % item for item in self._fields.items()))

    def __reduce__(self) -> Tuple[Any, ...]:
        return _restored, (type(self), self.__dict__.copy())


def _restored(kind: Any, state: Dict[str, Any]) -> Any:
    record = kind.__new__(kind)
    record.__dict__.update(state)
    return record


class Result(Record):
    """What a command found. Its fields are attributes; beside them stands how it came out.

    It is true if the answer is yes or the work is done: `verdict` says "yes", "no" (proved) or "undecided".
    Where a field has the name of one of these, `result["text"]` is the field.

    >>> import tetrarch as tt
    >>> found = tt.hyperbolize("cPcbbbihq")
    >>> found.verdict, bool(found), round(found.volume, 6), found.warnings
    ('yes', True, 6.45199, [])
    >>> print(found)                                          # doctest: +ELLIPSIS
    outcome     geometric, on the triangulation given
    ...
    """

    #: "yes", "no" (which is proved) or "undecided"
    verdict: str
    #: what the program prints, for people
    text: str
    #: what is to be known besides, a sentence each
    warnings: List[str]
    #: the paths of the files that were written
    files: List[str]
    #: what was made: a Manifold, Triangulation, Mesh or FundamentalGroup; None: nothing
    value: Any

    def __init__(self, fields: Optional[Dict[str, Any]], verdict: str = "yes", text: str = "",
                 warnings: Optional[List[str]] = None, files: Optional[List[str]] = None, value: Any = None) -> None:
        super().__init__(fields or {})
        self.__dict__.update(verdict=verdict, text=text, warnings=warnings or [], files=files or [], value=value)

    @property
    def records(self) -> List[Record]:
        """The lines of a result that is a list, such as that of `census_enumerate`, each an object.

        >>> import tetrarch as tt
        >>> [manifold.name for manifold in tt.census_enumerate(tetrahedra=2).records][:2]
        ['fmp2_1', 'fmp2_2']
        """
        return [Record(json.loads(line)) for line in self.text.splitlines() if line.startswith("{")]

    @property
    def lines(self) -> List[str]:
        """The lines of the text, such as the signatures that `census_gluings` lists.

        >>> import tetrarch as tt
        >>> len(tt.census_gluings(tetrahedra=1).lines)
        5
        """
        return self.text.splitlines()

    def __bool__(self) -> bool:
        return self.verdict == "yes"

    def __str__(self) -> str:
        return self.text.rstrip("\n")
