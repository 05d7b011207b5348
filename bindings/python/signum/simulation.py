"""Balls that move and strike, in the exact order."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _signum
from ._signum import State
from .effects import Effects

__all__ = ["Run", "Simulation"]


@dataclass(frozen=True)
class Run:
    """How a run ended, and its log.

    ending: 'until', 'strikes', 'nothing' (nothing meets any more) or 'collapse' (a ball strikes in
    place without end). log: a structured array of time, wall, a, b and impulse, a row a strike in the
    exact order; a < b are numbers of balls, or a that of a ball and b that of a wall.
    """

    ending: str
    log: npt.NDArray[np.void]


class Simulation:
    """Balls that move and strike.

    balls: x, y, r, vx, vy and perhaps a mass, or x, y, z, r, vx, vy, vz and perhaps a mass, a row each;
    without one it is r to the power of the dimension. effects: the keywords of signum.effects.Effects,
    such as box=((0, 0), (1, 1)) or gravity=(0, -9.81). structure: what proposes pairs, 'auto', 'pairs',
    'cells', 'tree', 'segments', 'levels', 'lists' or 'delaunay'; the log does not depend on it.
    arithmetic: 'exact' or 'naive'.

    Raises ValueError, naming the row, for a ball that is not finite, overlaps an earlier one or is
    outside its walls. One call at a time: while one runs in another thread the next one raises
    RuntimeError.
    """

    def __init__(
        self,
        balls: npt.ArrayLike,
        *,
        structure: str = "auto",
        arithmetic: str = "exact",
        **effects: Any,
    ) -> None:
        self.effects = Effects(**effects)
        self._simulation = _signum._Simulation(balls, self.effects, structure, arithmetic)

    def __reduce_ex__(self, protocol: object) -> tuple[Any, ...]:
        raise TypeError("cannot pickle or copy a Simulation")

    def run(
        self,
        until: float = inf,
        *,
        strikes: int | None = None,
        log: bool = True,
        progress: Callable[[float], object] | None = None,
    ) -> Run:
        """Goes on to a time, events at that time included, or for so many strikes: a Run.

        log: whether to keep the strikes. Nothing happens where `until` is past. progress is called now
        and then, with 0: there is no telling how far it is. On Ctrl-C the simulation stands where it
        was stopped, and goes on from there; the log up to there is lost. Raises ValueError for a time that is NaN, and where a ball
        flies so fast that the clock cannot tell its strike from a miss.
        """
        return Run(*self._simulation.run(until, strikes, log, progress))

    def state(self) -> State:
        """Where all balls are now, a copy."""
        return self._simulation.state()

    @property
    def counts(self) -> dict[str, float]:
        """What was done up to now: strikes, pairs asked (checks) and so on, by name."""
        return self._simulation.counts()
