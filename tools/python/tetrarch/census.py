# SPDX-License-Identifier: GPL-2.0-or-later
"""The stored tables of manifolds, as sequences."""
from __future__ import annotations

import functools
import json
import math
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union, overload

from . import _tetrarch
from .errors import InputError, shown
from .groups import AbelianGroup
from .manifold import Manifold
from .results import Record
from .triangulation import _integer

__all__ = ["Census", "CensusManifold", "census", "census_tables"]

_Range = Union[float, Tuple[Optional[float], Optional[float]], range]


class CensusManifold(Manifold):
    """A manifold of a table: a Manifold with the table's own entry, whose numbers have 30 digits.

    >>> import tetrarch as tt
    >>> M = tt.census(3)[16]
    >>> M.name(), M.entry.volume[:12], M.entry.boundary, M.entry.symmetries
    ('fmp3_17', '7.6365196295', [2], 2)
    """

    #: the table's entry: name, signature, volume, boundary, cusps, homology, cells, symmetries, ...
    entry: Record

    def __init__(self, entry: Dict[str, Any]) -> None:
        super().__init__(entry["name"])
        self.entry = Record(entry)

    def __getstate__(self) -> Any:
        return {"entry": self.entry.as_dict()}

    def __setstate__(self, state: Any) -> None:
        self.__init__(state["entry"])  # type: ignore[misc]


def census_tables(orientable: bool = True) -> List[int]:
    """The numbers of tetrahedra of which there are tables, of orientable manifolds or of the others.

    >>> import tetrarch as tt
    >>> tt.census_tables(), tt.census_tables(orientable=False)
    ([2, 3, 4], [2, 3])
    """
    return _tetrarch.stored_tables(bool(orientable))


@functools.lru_cache(maxsize=None)
def _entries(tetrahedra: int, orientable: bool) -> Tuple[Dict[str, Any], ...]:
    return tuple(json.loads(_tetrarch.table_text(tetrahedra, orientable))["manifolds"])


def _bounds(given: Any, name: str) -> Tuple[float, float]:
    if isinstance(given, range):
        given = (given.start, given.stop)
    if isinstance(given, (tuple, list)) and len(given) == 2:
        low, high = given
    else:
        low = high = given
    try:
        bounds = (-math.inf if low is None else float(low), math.inf if high is None else float(high))
    except (TypeError, ValueError, OverflowError):
        raise InputError("%s is %s (expected a number, or a pair of numbers)" % (name, shown(given))) from None
    if math.isnan(bounds[0]) or math.isnan(bounds[1]):
        raise InputError("%s is %s, which is no number" % (name, shown(given)))
    return bounds


def _genera(given: Any) -> List[int]:
    genera = [given] if not isinstance(given, (list, tuple)) else list(given)
    return sorted((_integer(genus, "boundary") for genus in genera), reverse=True)


class Census(Sequence[CensusManifold]):
    """A table of manifolds, or a part of one: a sequence of Manifolds in the order of their names.

    A slice of whole numbers is a part; so is a slice of fractions, by volume: `census(3)[7.0:7.5]`.

    >>> import tetrarch as tt
    >>> table = tt.census(3)
    >>> len(table), table[0].name(), [M.name() for M in table[:2]]
    (151, 'fmp3_1', ['fmp3_1', 'fmp3_2'])
    >>> table[7.0:7.5]
    Census(3, 12 manifolds)
    >>> "fmp3_5" in table, table["fmp3_5"].name()
    (True, 'fmp3_5')
    """

    def __init__(self, tetrahedra: int, entries: Sequence[Dict[str, Any]]) -> None:
        #: the number of tetrahedra
        self.tetrahedra = tetrahedra
        self._entries = entries

    def filter(self, *, volume: Optional[_Range] = None, boundary: Union[None, int, Sequence[int]] = None,
               homology: Union[None, str, AbelianGroup] = None, cusps: Optional[int] = None) -> "Census":
        """The part with these properties.

        volume: a pair (least, most), either may be None; boundary: the genus of the geodesic boundary, or the list of genera of its
        components; homology: a group or its name, "Z^2 + Z/3"; cusps: their number.

        >>> import tetrarch as tt
        >>> len(tt.census(3).filter(boundary=2, volume=(None, 7.5)))
        12
        >>> len(tt.census(3).filter(cusps=1)), len(tt.census(3).filter(homology="Z^3"))
        (1, 75)
        """
        kept = list(self._entries)
        if volume is not None:
            low, high = _bounds(volume, "volume")
            kept = [entry for entry in kept if low <= float(entry["volume"]) <= high]
        if boundary is not None:
            genera = _genera(boundary)
            kept = [entry for entry in kept if sorted(entry["boundary"], reverse=True) == genera]
        if homology is not None:
            group = homology if isinstance(homology, AbelianGroup) else AbelianGroup(_text(homology))
            kept = [entry for entry in kept if AbelianGroup(entry["homology"]) == group]
        if cusps is not None:
            count = _integer(cusps, "cusps")
            kept = [entry for entry in kept if entry["cusps"] == count]
        return Census(self.tetrahedra, kept)

    __call__ = filter

    def entries(self) -> List[Record]:
        """The table's entries alone, without making manifolds.

        >>> import tetrarch as tt
        >>> tt.census(2).entries()[0].volume[:6]
        '6.4519'
        """
        return [Record(entry) for entry in self._entries]

    def __len__(self) -> int:
        return len(self._entries)

    @overload
    def __getitem__(self, index: Union[int, str]) -> CensusManifold: ...
    @overload
    def __getitem__(self, index: slice) -> "Census": ...

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            if isinstance(index.start, float) or isinstance(index.stop, float):
                return self.filter(volume=(index.start, index.stop))
            return Census(self.tetrahedra, self._entries[index])
        if isinstance(index, str):
            for entry in self._entries:
                if entry["name"] == index:
                    return CensusManifold(entry)
            raise KeyError(index)
        return CensusManifold(self._entries[index])

    def __iter__(self) -> Iterator[CensusManifold]:
        return (CensusManifold(entry) for entry in self._entries)

    def __contains__(self, given: object) -> bool:
        name = given.name() if isinstance(given, Manifold) else given
        return any(entry["name"] == name for entry in self._entries)

    def __repr__(self) -> str:
        return "Census(%d, %d %s)" % (self.tetrahedra, len(self), "manifold" if len(self) == 1 else "manifolds")


def _text(given: Any) -> str:
    if not isinstance(given, str):
        raise InputError("homology is a %s (expected a group or its name)" % type(given).__name__)
    return given


def census(tetrahedra: int, *, volume: Optional[_Range] = None, boundary: Union[None, int, Sequence[int]] = None,
           homology: Union[None, str, AbelianGroup] = None, cusps: Optional[int] = None, orientable: bool = True) -> Census:
    """The table of hyperbolic manifolds with geodesic boundary (and cusps) of so many tetrahedra, or a part of it.

    The arguments are those of `Census.filter`; with orientable=False it is the table of those that are not orientable, in whose
    `boundary` a sphere with k crosscaps is -k. Source: Frigerio, Martelli, Petronio (2004) for the orientable ones.

    >>> import tetrarch as tt
    >>> tt.census(2)
    Census(2, 8 manifolds)
    >>> for M in tt.census(3, cusps=1):
    ...     print(M.name(), round(M.volume(), 6), M.homology())
    fmp3_25 7.797637 Z^3
    """
    number = _integer(tetrahedra, "tetrahedra")
    return Census(number, _entries(number, bool(orientable))).filter(volume=volume, boundary=boundary, homology=homology, cusps=cusps)
