"""Pictures with Matplotlib: draw() for any result, animate() for what moves."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib import pyplot
from matplotlib.animation import FuncAnimation
from matplotlib.collections import LineCollection, PatchCollection, PolyCollection
from matplotlib.patches import Circle, Polygon
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from . import _signum
from .simulation import Simulation

# Colours that survive colour blindness and print.
SITE, CELL, EDGE, HIDDEN = "#0072b2", "#555555", "#d55e00", "#999999"
_CORNERS = {
    "manhattan": np.array([[1, 0], [0, 1], [-1, 0], [0, -1]]),
    "supremum": np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]),
}


def draw(result: Any, ax: Any = None, *, sites: bool = True, **options: Any) -> Any:
    """Draws any result of signum, and gives the axes it is drawn in.

    A Tessellation or DynamicTessellation, with edges straight from centre to centre; a Voronoi or Cells,
    with its sites, whose edges are the true ones; a KineticTessellation or Simulation as it is now, a
    State; a SpaceTessellation; SpaceCells as polyhedra. ax: axes of Matplotlib (of projection '3d' for
    what lies in space), new ones if there are none. sites: whether to draw the sites as well. options: for
    the collection of lines, polygons or patches that shows the result. Raises TypeError for anything else.
    """
    if isinstance(result, Simulation):
        result = result.state()
    if isinstance(result, (_signum.DynamicTessellation, _signum.KineticTessellation)):
        result = result.tessellation()
    if isinstance(result, _signum.Voronoi):
        result = result.clip()
    for kind, painter in _PAINTERS.items():
        if isinstance(result, kind):
            return painter(result, ax, sites, options)
    raise TypeError(f"there is no picture of a {type(result).__name__}")


def animate(moving: Any, times: Iterable[float], ax: Any = None, **options: Any) -> FuncAnimation:
    """Draws a Simulation or a KineticTessellation at rising times, and gives the animation.

    It runs while the animation does, which is when it is saved or shown; frames are drawn once each and
    in order. options: for FuncAnimation, such as interval in milliseconds. Raises TypeError for what does
    not move.
    """
    if not isinstance(moving, (Simulation, _signum.KineticTessellation)):
        raise TypeError(f"a {type(moving).__name__} does not move")
    ax = _axes(ax)
    limits: Any = moving.effects.box if isinstance(moving, Simulation) else None

    def frame(time: float) -> list[Any]:
        ax.clear()
        if isinstance(moving, Simulation):
            moving.run(time, log=False)
            _draw_state(moving.state(), ax, True, {}, time)
        else:
            moving.advance(time)
            draw(moving, ax)
        if limits is not None:
            ax.set_xlim(limits[0][0], limits[1][0])
            ax.set_ylim(limits[0][1], limits[1][1])
        ax.set_title(f"t = {time:.4g}")
        return []

    options.setdefault("repeat", False)
    return FuncAnimation(ax.figure, frame, frames=list(times), init_func=lambda: [], **options)


def _axes(ax: Any, in_space: bool = False) -> Any:
    if ax is None:
        ax = pyplot.figure().add_subplot(projection="3d" if in_space else None)
    if not in_space:
        ax.set_aspect("equal")
    return ax


def _discs(centres: Any, radii: Any, corners: Any = None, **options: Any) -> PatchCollection:
    """Discs, or what has these corners around its centre."""
    if corners is None:
        patches: list[Any] = [Circle(c, r) for c, r in zip(centres, radii)]
    else:
        patches = [Polygon(c + r * corners) for c, r in zip(centres, radii)]
    return PatchCollection(patches, **options)


def _draw_sites(tessellation: Any, ax: Any) -> None:
    sites = tessellation.sites
    radii = sites[:, 2]
    if tessellation.weight_is == "weight":
        radii = np.sqrt(np.maximum(radii, 0))
    hidden = np.zeros(len(sites), bool)
    hidden[tessellation.hidden[:, 0]] = True
    corners = _CORNERS.get(tessellation.metric)
    for which, colour in ((~hidden, SITE), (hidden, HIDDEN)):
        drawn = which & (radii > 0)
        ax.add_collection(
            _discs(sites[drawn, :2], radii[drawn], corners, facecolor=colour, alpha=0.25, zorder=1)
        )
        ax.plot(*sites[which, :2].T, ".", color=colour, markersize=3, zorder=3)


def _draw_tessellation(tessellation: Any, ax: Any, sites: bool, options: dict[str, Any]) -> Any:
    ax = _axes(ax)
    edges = tessellation.edges()
    edges = edges[(edges >= 0).all(axis=1)]
    style = {"color": EDGE, "linewidth": 0.7, "zorder": 2} | options
    ax.add_collection(LineCollection(tessellation.sites[edges, :2], **style))
    if sites:
        _draw_sites(tessellation, ax)
    ax.autoscale_view()
    return ax


def _draw_cells(cells: Any, ax: Any, sites: bool, options: dict[str, Any]) -> Any:
    ax = _axes(ax)
    points, first, _ = cells.polygons()
    style = {"facecolor": "none", "edgecolor": CELL, "linewidth": 0.7, "zorder": 2} | options
    ax.add_collection(PolyCollection(np.split(points, first[1:-1]) if len(first) > 1 else [], **style))
    if sites:
        _draw_sites(cells.voronoi.tessellation, ax)
    x0, y0, x1, y1 = cells.box
    ax.set_xlim(x0, x1)
    ax.set_ylim(y0, y1)
    return ax


def _draw_space(tessellation: Any, ax: Any, sites: bool, options: dict[str, Any]) -> Any:
    ax = _axes(ax, in_space=True)
    edges = tessellation.edges()
    edges = edges[(edges >= 0).all(axis=1)]
    centres = tessellation.sites[:, :3]
    style = {"color": EDGE, "linewidth": 0.5} | options
    ax.add_collection3d(Line3DCollection(centres[edges], **style))
    if sites:
        ax.scatter(*centres.T, color=SITE, s=5)
    return ax


def _draw_polyhedra(cells: Any, ax: Any, sites: bool, options: dict[str, Any]) -> Any:
    ax = _axes(ax, in_space=True)
    faces = []
    for site in range(len(cells)):
        corners, of_faces, _ = cells.polyhedron(site)
        faces += [corners[face] for face in of_faces]
    style = {"facecolor": SITE, "edgecolor": CELL, "linewidth": 0.3, "alpha": 0.12} | options
    ax.add_collection3d(Poly3DCollection(faces, **style))
    for low, high, limit in zip(*cells.box, (ax.set_xlim, ax.set_ylim, ax.set_zlim)):
        limit(low, high)
    return ax


def _draw_state(state: Any, ax: Any, sites: bool, options: dict[str, Any], time: float | None = None) -> Any:
    centres = state.centres(time)
    if state.dimension == 3:
        ax = _axes(ax, in_space=True)
        ax.scatter(*centres.T, s=20, color=SITE)
        return ax
    ax = _axes(ax)
    style = {"facecolor": SITE, "edgecolor": "black", "linewidth": 0.3} | options
    ax.add_collection(_discs(centres, state.radius, **style))
    ax.autoscale_view()
    return ax


_PAINTERS = {
    _signum.Tessellation: _draw_tessellation,
    _signum.Cells: _draw_cells,
    _signum.SpaceTessellation: _draw_space,
    _signum.SpaceCells: _draw_polyhedra,
    _signum.State: _draw_state,
}
