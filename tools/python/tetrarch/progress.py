# SPDX-License-Identifier: GPL-2.0-or-later
"""How a long call tells how far it is."""
from __future__ import annotations

import sys
import time
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Union

from .errors import InputError

#: Called with the name of a stage and the fraction done, None where that is not known.
Report = Callable[[str, Optional[float]], None]
#: None: a bar in a terminal or notebook; False: nothing; or a function.
Progress = Union[None, bool, Report]

_PATIENCE = 2.0  # seconds without a bar


class _Bar:
    """A bar of tqdm's, from the third second on; nothing where there is no tqdm."""

    def __init__(self) -> None:
        self._start = time.monotonic()
        self._bar: Any = None
        self._stage = ""

    def __call__(self, stage: str, fraction: Optional[float]) -> None:
        if time.monotonic() - self._start < _PATIENCE:
            return
        if self._bar is None or (stage != self._stage and self._bar is not False):
            self.close()
            self._stage = stage
            try:
                from tqdm.auto import tqdm  # type: ignore
            except ImportError:
                self._bar = False
                return
            self._bar = tqdm(total=1.0, desc=stage, leave=False, bar_format="{desc}: {percentage:3.0f}%|{bar}| {elapsed}")
        if self._bar and fraction is not None:
            self._bar.n = min(max(fraction, 0.0), 1.0)
            self._bar.refresh()

    def close(self) -> None:
        if self._bar:
            self._bar.close()


def _is_watched() -> bool:
    try:
        return "ipykernel" in sys.modules or bool(sys.stderr.isatty())
    except (AttributeError, ValueError):
        return False


@contextmanager
def reporting(progress: Progress) -> Iterator[Optional[Report]]:
    """The function to be called while a call lasts, None for none."""
    if progress is None or progress is True:
        if not _is_watched():
            yield None
            return
        bar = _Bar()
        try:
            yield bar
        finally:
            bar.close()
    elif progress is False:
        yield None
    elif callable(progress):
        yield progress
    else:
        raise InputError("progress is a %s (expected None, False or a function of stage and fraction)" % type(progress).__name__)
