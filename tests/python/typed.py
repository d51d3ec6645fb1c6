# SPDX-License-Identifier: GPL-2.0-or-later
"""What a user with a type checker writes; mypy --strict reads it, nobody runs it."""
from typing import List, Optional

import numpy as np
import numpy.typing as npt

import tetrarch as tt


def names(least: float) -> List[str]:
    return [M.name() for M in tt.census(3, boundary=2, volume=(least, 10.0))]


def angles(text: str) -> Optional[npt.NDArray[np.float64]]:
    M = tt.Manifold(text)
    volume: Optional[float] = M.volume()
    return M.dihedral_angles() if volume is not None else None


def flat(points: npt.NDArray[np.float64], triangles: npt.NDArray[np.int64]) -> npt.NDArray[np.float64]:
    found = tt.slit_map(points, triangles, domain="circular")
    return found.uv if found else np.empty((0, 2))


isometries: Optional[List[tt.Isometry]] = tt.Manifold("m004").is_isometric_to("4_1", return_isometries=True)
answer: Optional[bool] = tt.Manifold("m004").is_isometric_to("4_1")
solved = tt.hyperbolize("m004", method="flow", attempts=10)
verdict: str = solved.verdict
