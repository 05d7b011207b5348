"""Exact signs for geometry, and the tessellations and Voronoi diagrams built on them.

    t = signum.triangulate([[0, 0, 1], [4, 0, 2], [0, 3, 1]], "euclidean")
    t.faces, t.hidden, t.vertices()

Sites are rows of NumPy arrays; results are arrays of int32 and float64. docs/python.md says more.
signum.plot draws with Matplotlib, signum.frames speaks to pandas, Shapely and GeoPandas; both are
imported by who wants them.
"""

from . import effects
from ._signum import *
from ._signum import __version__
from .simulation import Run, Simulation

__all__ = [
    "BrokenStructure",
    "Cells",
    "DynamicTessellation",
    "FiniteValidation",
    "KineticTessellation",
    "Run",
    "Simulation",
    "SpaceCells",
    "SpaceTessellation",
    "State",
    "Tessellation",
    "Validation",
    "Voronoi",
    "ccw",
    "effects",
    "exists",
    "hidden",
    "in_circle",
    "in_circle_infinite",
    "in_sphere",
    "meeting_time",
    "nearer",
    "sign_of_sum",
    "triangulate",
    "triangulate_space",
    "validate",
    "voronoi",
]
