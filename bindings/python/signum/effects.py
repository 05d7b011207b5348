"""What acts on the balls of a simulation: what is not named is not computed.

Lengths, times and masses are in units of one's own; vectors have two numbers in the plane, three in
space. docs/motion.md says what each effect does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

Vector = Sequence[float]


@dataclass(frozen=True)
class SpeedLaw:
    """Restitution that depends on the speed of approach: 1 - e goes as speed to the power."""

    speed: float = 1.0
    power: float = 0.2


@dataclass(frozen=True)
class Friction:
    """Balls spin, and surfaces that slide at a strike exchange momentum along them.

    coefficient: of two balls; wall_coefficient: of a ball and a wall or an obstacle;
    tangential_restitution: from -1 to 1; inertia: I / m r², None for that of discs (0.5) or balls (0.4).
    """

    coefficient: float = 0.0
    wall_coefficient: float = 0.0
    tangential_restitution: float = 0.0
    inertia: float | None = None


@dataclass(frozen=True)
class Shake:
    """The box's sides go to and fro by amplitude sin(frequency t + phase), in radians."""

    amplitude: Vector
    frequency: float
    phase: float = 0.0


@dataclass(frozen=True)
class Growth:
    """All radii grow: at time t they are r (1 + rate t), up to the time `until`."""

    rate: float
    until: float


@dataclass(frozen=True)
class Fluid:
    """A fluid with velocity + gradient · x drags balls along; needs time steps."""

    velocity: Vector | None = None
    gradient: Sequence[Vector] | None = None
    linear: float = 0.0
    quadratic: float = 0.0


@dataclass(frozen=True)
class LastingContacts:
    """Balls that would part slower than `speed` stay in contact; needs time steps."""

    speed: float
    tolerance: float = 1e-10
    sweeps: int = 1000


@dataclass(frozen=True)
class HalfSpace:
    """Balls are where normal · x >= offset + speed t."""

    normal: Vector
    offset: float
    speed: float = 0.0


@dataclass(frozen=True)
class Sphere:
    """A circle or sphere with its centre at centre + velocity t, and balls outside or inside."""

    centre: Vector
    radius: float
    velocity: Vector | None = None
    inside: bool = False


@dataclass(frozen=True)
class Segment:
    """A thin wall in the plane, struck from both sides and at its ends."""

    start: Vector
    end: Vector


@dataclass(frozen=True)
class Effects:
    """All that acts on balls.

    gravity: the acceleration of all balls; restitution, wall_restitution: from 0 to 1, elastic;
    box: two corners, walls around all balls or, if periodic, the cell of a periodic world;
    time_step: forces act by kicks in steps of that time, 0 for none.
    """

    gravity: Vector | None = None
    restitution: float = 1.0
    wall_restitution: float = 1.0
    speed_law: SpeedLaw | None = None
    contact_duration: float = 0.0
    friction: Friction | None = None
    box: Sequence[Vector] | None = None
    periodic: bool = False
    shake: Shake | None = None
    obstacles: Sequence[HalfSpace | Sphere | Segment] = ()
    growth: Growth | None = None
    fluid: Fluid | None = None
    contacts: LastingContacts | None = None
    time_step: float = 0.0
