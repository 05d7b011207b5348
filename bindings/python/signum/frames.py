"""To and from pandas, Shapely and GeoPandas, each of which is imported when it is asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._signum import Cells, SpaceCells, SpaceTessellation, Tessellation

__all__ = ["cells_frame", "cells_geodataframe", "cells_geometries", "sites_frame", "sites_of"]

_RADII = ("r", "radius", "weight", "w")


def sites_of(table: Any) -> npt.NDArray[np.float64]:
    """The sites of a DataFrame with columns x, y and perhaps z and r, or of points of Shapely.

    A DataFrame: columns x, y, z if it is there, and r, radius, weight or w if one is there, whatever
    else it has. A GeoSeries, a GeoDataFrame or a list of points: x and y, and the column r and so on of a
    GeoDataFrame. The array has a row each, in the order of the table. Raises ValueError for a column
    that is missing, for two radii, and for what is no point, naming the row.
    """
    if hasattr(table, "geometry"):
        return _sites_of_points(table.geometry, table if hasattr(table, "columns") else None)
    if not hasattr(table, "columns"):
        return _sites_of_points(table, None)
    missing = [name for name in ("x", "y") if name not in table.columns]
    if missing:
        raise ValueError(f"the table has no column {' and no column '.join(missing)}")
    names = ["x", "y"] + (["z"] if "z" in table.columns else []) + _radius_of(table)
    return np.ascontiguousarray(table[names].to_numpy(np.float64))


def _radius_of(table: Any) -> list[str]:
    names = [name for name in _RADII if name in table.columns]
    if len(names) > 1:
        raise ValueError(f"the table has more than one radius: {', '.join(names)}")
    return names


def _sites_of_points(points: Any, table: Any) -> npt.NDArray[np.float64]:
    columns: list[Any] = [[], []]
    for row, point in enumerate(points):
        if getattr(point, "geom_type", "") != "Point" or point.is_empty:
            raise ValueError(f"row {row} is no point: {point}")
        columns[0].append(point.x)
        columns[1].append(point.y)
    if table is not None:
        columns += [table[name].to_numpy(np.float64) for name in _radius_of(table)]
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
