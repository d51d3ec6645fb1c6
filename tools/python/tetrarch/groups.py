# SPDX-License-Identifier: GPL-2.0-or-later
"""Abelian groups and finite presentations, as values."""
from __future__ import annotations

import math
import re
from typing import Any, Iterable, List, Optional, Sequence, Tuple, Union

from .errors import InputError, shown

__all__ = ["AbelianGroup", "FundamentalGroup"]


class AbelianGroup:
    """A finitely generated abelian group Z^rank + Z/d1 + ... + Z/dm with d1 | d2 | ... | dm.

    Isomorphic groups are equal, and a text is compared as the group that it names.

    >>> from tetrarch import AbelianGroup
    >>> group = AbelianGroup(1, [5])
    >>> group
    Z + Z/5
    >>> group.rank, group.torsion, group.order()
    (1, (5,), inf)
    >>> AbelianGroup(0, [2, 3]) == AbelianGroup("Z/6") == "Z/6"
    True
    """

    __slots__ = ("rank", "torsion")

    #: the number of infinite cyclic summands
    rank: int
    #: the orders of the finite ones, each of which divides the next
    torsion: Tuple[int, ...]

    def __init__(self, rank: Union[int, str] = 0, torsion: Iterable[int] = ()) -> None:
        if isinstance(rank, str):
            rank, torsion = _parsed(rank)
        if isinstance(rank, bool) or not isinstance(rank, int) or rank < 0:
            raise InputError("the rank of an abelian group is %s (expected an integer from 0)" % shown(rank))
        object.__setattr__(self, "rank", rank)
        object.__setattr__(self, "torsion", _invariant_factors(torsion))

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("groups never change")

    def order(self) -> Union[int, float]:
        """The number of elements; math.inf if the rank is not 0.

        >>> from tetrarch import AbelianGroup
        >>> AbelianGroup("Z/2 + Z/4").order()
        8
        """
        return math.inf if self.rank else math.prod(self.torsion)

    def betti_number(self) -> int:
        """The rank, by the name that SnapPy has for it.

        >>> from tetrarch import AbelianGroup
        >>> AbelianGroup("Z^2 + Z/3").betti_number()
        2
        """
        return self.rank

    def elementary_divisors(self) -> List[int]:
        """The torsion, then a 0 for each infinite summand, as SnapPy has them.

        >>> from tetrarch import AbelianGroup
        >>> AbelianGroup("Z + Z/5").elementary_divisors()
        [5, 0]
        """
        return [*self.torsion, *[0] * self.rank]

    def is_trivial(self) -> bool:
        """Whether it has one element.

        >>> from tetrarch import AbelianGroup
        >>> AbelianGroup().is_trivial()
        True
        """
        return self.rank == 0 and not self.torsion

    def __str__(self) -> str:
        free = [] if self.rank == 0 else ["Z" if self.rank == 1 else "Z^%d" % self.rank]
        return " + ".join(free + ["Z/%d" % d for d in self.torsion]) or "0"

    __repr__ = __str__

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):
            try:
                other = AbelianGroup(other)
            except InputError:
                return False
        if not isinstance(other, AbelianGroup):
            return NotImplemented
        return (self.rank, self.torsion) == (other.rank, other.torsion)

    def __hash__(self) -> int:
        return hash((self.rank, self.torsion))

    def __reduce__(self) -> Tuple[Any, ...]:
        return AbelianGroup, (self.rank, self.torsion)

    def __copy__(self) -> AbelianGroup:
        return self

    def __deepcopy__(self, memo: Any) -> AbelianGroup:
        return self


def _parsed(text: str) -> Tuple[int, List[int]]:
    rank, torsion = 0, []
    for part in text.replace(" ", "").split("+"):
        match = re.fullmatch(r"(0)|Z(?:\^(\d{1,6})|/(\d{1,4000}))?", part)
        if match is None:
            raise InputError("%s is no abelian group (expected a text such as Z^2 + Z/3)" % shown(text))
        if match[3]:
            torsion.append(int(match[3]))
        elif not match[1]:
            rank += int(match[2] or 1)
    return rank, torsion


def _invariant_factors(orders: Iterable[int]) -> Tuple[int, ...]:
    factors: List[int] = []
    for order in orders:
        if isinstance(order, bool) or not isinstance(order, int) or order < 1:
            raise InputError("a cyclic group has the order %s (expected an integer from 1)" % shown(order))
        for k, factor in enumerate(factors):
            factors[k], order = math.gcd(factor, order), math.lcm(factor, order)
        factors.append(order)
    return tuple(factor for factor in factors if factor > 1)


class FundamentalGroup:
    """A finite presentation of a group.

    `words` holds the relators as tuples of letters: generator g is g + 1, its inverse -(g + 1).

    >>> import tetrarch as tt
    >>> group = tt.Manifold("fmp3_17").fundamental_group()
    >>> group.num_generators(), len(group.relators())
    (3, 1)
    >>> group.abelianization() == tt.Manifold("fmp3_17").homology()
    True
    """

    __slots__ = ("_generators", "words")

    #: the relators
    words: Tuple[Tuple[int, ...], ...]

    def __init__(self, generators: int, words: Iterable[Sequence[int]] = ()) -> None:
        self._generators = int(generators)
        self.words = tuple(tuple(int(letter) for letter in word) for word in words)
        for word in self.words:
            for letter in word:
                if not 1 <= abs(letter) <= self._generators:
                    raise InputError("the letter %d names no generator (there are %d)" % (letter, self._generators))

    def num_generators(self) -> int:
        """How many generators there are.

        >>> import tetrarch as tt
        >>> tt.FundamentalGroup(2, [(1, 2, -1, -2)]).num_generators()
        2
        """
        return self._generators

    def generators(self) -> List[str]:
        """Their names: a to z, or g1, g2, ... if there are more.

        >>> import tetrarch as tt
        >>> tt.FundamentalGroup(2).generators()
        ['a', 'b']
        """
        return [self._letter(g + 1) for g in range(self._generators)]

    def relators(self) -> List[str]:
        """The relators as texts; capitals are inverses.

        >>> import tetrarch as tt
        >>> tt.FundamentalGroup(2, [(1, 2, -1, -2)]).relators()
        ['abAB']
        """
        return ["".join(self._letter(letter) for letter in word) for word in self.words]

    def abelianization(self) -> AbelianGroup:
        """The group made abelian: the first homology of a space that has this fundamental group.

        >>> import tetrarch as tt
        >>> tt.FundamentalGroup(2, [(1, 2, -1, -2), (1, 1, 1)]).abelianization()
        Z + Z/3
        """
        rows = [[sum((letter == g + 1) - (letter == -g - 1) for letter in word) for g in range(self._generators)]
                for word in self.words]
        divisors = _smith_diagonal(rows)
        return AbelianGroup(self._generators - len(divisors), divisors)

    def _letter(self, letter: int) -> str:
        index = abs(letter) - 1
        if self._generators > 26:
            return ("g%d" if letter > 0 else "G%d") % (index + 1)
        return chr((97 if letter > 0 else 65) + index)

    def __str__(self) -> str:
        relators = ", ".join(self.relators())
        return "< " + (", ".join(self.generators()) + " " if self._generators else "") + "|" + (
            " " + relators if relators else "") + " >"

    __repr__ = __str__

    def __eq__(self, other: object) -> bool:
        """The same presentation. Whether two presentations give the same group is undecidable."""
        if not isinstance(other, FundamentalGroup):
            return NotImplemented
        return (self._generators, self.words) == (other._generators, other.words)

    def __hash__(self) -> int:
        return hash((self._generators, self.words))


def _smith_diagonal(rows: List[List[int]]) -> List[int]:
    """The entries other than 0 of a diagonal form, by row and column operations over the integers."""
    diagonal: List[int] = []
    rows = [row for row in rows if any(row)]
    while rows:
        place: Optional[Tuple[int, int]] = min(((abs(x), (i, j)) for i, row in enumerate(rows) for j, x in enumerate(row) if x))[1]
        assert place is not None
        i, j = place
        pivot = rows[i]
        clean = True
        for k, row in enumerate(rows):
            if k != i and row[j]:
                q = row[j] // pivot[j]
                rows[k] = [x - q * p for x, p in zip(row, pivot)]
                clean = clean and rows[k][j] == 0
        if not clean:
            continue
        for m in range(len(pivot)):
            if m != j and pivot[m]:
                q = pivot[m] // pivot[j]
                for row in rows:
                    row[m] -= q * row[j]
                clean = clean and pivot[m] == 0
        if clean:
            diagonal.append(abs(pivot[j]))
            rows = [row for k, row in enumerate(rows) if k != i and any(row)]
    return diagonal
