"""To and from pandas, Shapely and GeoPandas, each of which is imported when it is asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._exact import doubles
from ._signum import Cells, SpaceCells, SpaceTessellation, Tessellation

__all__ = ["cells_frame", "cells_geodataframe", "cells_geometries", "sites_frame", "sites_of"]

_THIRD = {"radius": ("r", "radius"), "weight": ("w", "weight")}


def sites_of(table: Any, *, weight_is: str = "radius") -> npt.NDArray[np.float64]:
    """The sites of a DataFrame with columns x, y and perhaps z and r, or of points of Shapely.

    A DataFrame: columns x, y, z if it is there, and r or radius if one is there, whatever else it has;
    with weight_is="weight", which triangulate() is to be told as well, w or weight instead. A GeoSeries, a
    GeoDataFrame or a list of points: x and y, in whatever units they are, and the column r and so on of a
    GeoDataFrame. The array has a row each, in the order of the table. Raises ValueError for a column
    that is missing or there twice, for weights where radii are asked for and the reverse, and for what is no
    point or no double, naming the row.
    """
    if weight_is not in _THIRD:
        raise ValueError(f"weight_is: radius or weight, not {weight_is!r}")
    if hasattr(table, "geometry"):
        return _sites_of_points(table.geometry, table if hasattr(table, "columns") else None, weight_is)
    if not hasattr(table, "columns"):
        return _sites_of_points(table, None, weight_is)
    missing = [name for name in ("x", "y") if name not in table.columns]
    if missing:
        raise ValueError(f"the table has no column {' and no column '.join(missing)}")
    names = ["x", "y"] + (["z"] if "z" in table.columns else []) + _third_of(table, weight_is)
    return np.column_stack([_column(table, name) for name in names])


def _column(table: Any, name: str) -> npt.NDArray[np.float64]:
    if list(table.columns).count(name) > 1:
        raise ValueError(f"the table has two columns {name}")
    return doubles(table[name].to_numpy())


def _third_of(table: Any, weight_is: str) -> list[str]:
    names = [name for name in _THIRD[weight_is] if name in table.columns]
    other = "weight" if weight_is == "radius" else "radius"
    others = [name for name in _THIRD[other] if name in table.columns]
    if not names and others:
        raise ValueError(f"the table has a column {others[0]}: say weight_is={other!r}, here and to triangulate()")
    if len(names) > 1:
        raise ValueError(f"the table has more than one {weight_is}: {', '.join(names)}")
    return names


def _sites_of_points(points: Any, table: Any, weight_is: str) -> npt.NDArray[np.float64]:
    columns: list[Any] = [[], []]
    for row, point in enumerate(points):
        if getattr(point, "geom_type", "") != "Point" or point.is_empty:
            raise ValueError(f"row {row} is no point: {point}")
        columns[0].append(point.x)
        columns[1].append(point.y)
    if table is not None:
        columns += [_column(table, name) for name in _third_of(table, weight_is)]
    return np.column_stack(columns).astype(np.float64)


def sites_frame(tessellation: Tessellation | SpaceTessellation) -> Any:
    """The sites as a DataFrame: x, y, (z,) r and hidden_by, -1 for a visible site.

    Instead of r there is w where the sites carry weights, and nothing where they are points of space.
    """
    import pandas

    sites = tessellation.sites
    third = "w" if tessellation.weight_is == "weight" else "r"
    names = ["x", "y", third] if isinstance(tessellation, Tessellation) else ["x", "y", "z", third]
    frame = pandas.DataFrame(sites, columns=names[: sites.shape[1]])
    hidden_by = np.full(len(sites), -1, np.int32)
    hidden_by[tessellation.hidden[:, 0]] = tessellation.hidden[:, 1]
    frame["hidden_by"] = hidden_by
    return frame


def cells_frame(cells: Cells | SpaceCells) -> Any:
    """The cells as a DataFrame, a row a site: the columns of sites_frame(), and what cells measure.

    In the plane area, perimeter, centroid_x and centroid_y; in space volume, area and the centroid.
    """
    if isinstance(cells, Cells):
        frame = sites_frame(cells.voronoi.tessellation)
        frame["area"] = cells.areas
        frame["perimeter"] = cells.perimeters
    else:
        frame = sites_frame(cells.tessellation)
        frame["volume"] = cells.volumes
        frame["area"] = cells.areas
    for axis, numbers in zip("xyz", cells.centroids.T):
        frame[f"centroid_{axis}"] = numbers
    return frame


def cells_geometries(cells: Cells, tolerance: float | None = None) -> npt.NDArray[np.object_]:
    """The cells as polygons of Shapely, an array with one a site.

    Arcs get as many points as keep within tolerance. A cell that the box cuts in pieces is a MultiPolygon,
    one of a hidden site or outside the box an empty Polygon. Raises ValueError for a tolerance that is not
    positive.
    """
    from shapely import wkt
    from shapely.geometry import MultiPolygon, Polygon

    points, first, sites = cells.polygons(tolerance)
    of_site: list[list[Any]] = [[] for _ in range(len(cells))]
    for site, begin, end in zip(sites, first[:-1], first[1:]):
        of_site[site].append(Polygon(points[begin:end]))
    geometries = np.empty(len(cells), object)
    nothing = wkt.loads("POLYGON EMPTY")
    for site, own in enumerate(of_site):
        geometries[site] = MultiPolygon(own) if len(own) > 1 else own[0] if own else nothing
    return geometries


def cells_geodataframe(cells: Cells, tolerance: float | None = None, crs: Any = None) -> Any:
    """cells_frame() with the cells as its geometry: a GeoDataFrame. crs: that of the sites' coordinates."""
    import geopandas

    return geopandas.GeoDataFrame(
        cells_frame(cells), geometry=cells_geometries(cells, tolerance), crs=crs
    )
