"""pandas, Shapely and GeoPandas."""

import geopandas
import numpy as np
import pandas
import pytest
from shapely.geometry import LineString, Point, box
from shapely.ops import unary_union

import signum
from signum import frames

RNG = np.random.default_rng(23)
SITES = np.column_stack([RNG.uniform(0, 10, (30, 2)), RNG.uniform(0, 1.5, 30)])
TABLE = pandas.DataFrame({"name": list("abcdefghij") * 3, "r": SITES[:, 2], "y": SITES[:, 1], "x": SITES[:, 0]})
BOX = (-1.0, -1.0, 11.0, 11.0)


def test_a_table_and_back():
    assert np.array_equal(frames.sites_of(TABLE), SITES)
    assert np.array_equal(frames.sites_of(TABLE.drop(columns="r")), SITES[:, :2])
    assert np.array_equal(frames.sites_of(TABLE.rename(columns={"r": "radius"})), SITES)
    t = signum.triangulate(frames.sites_of(TABLE))
    table = frames.sites_frame(t)
    assert list(table.columns) == ["x", "y", "r", "hidden_by"]
    assert table[["x", "y", "r"]].equals(TABLE[["x", "y", "r"]])
    hidden = table[table.hidden_by >= 0]
    assert hidden.index.tolist() == t.hidden[:, 0].tolist()
    assert hidden.hidden_by.tolist() == t.hidden[:, 1].tolist() != []


def test_tables_that_lack_something():
    with pytest.raises(ValueError, match="no column y"):
        frames.sites_of(TABLE.drop(columns="y"))
    with pytest.raises(ValueError, match="more than one radius: r, radius"):
        frames.sites_of(TABLE.assign(radius=1.0))
    with pytest.raises(ValueError, match="two columns x"):
        frames.sites_of(pandas.DataFrame([[0, 1, 2], [3, 4, 5]], columns=["x", "y", "x"]))
    with pytest.raises(ValueError, match="row 0 has 9007199254740993"):
        frames.sites_of(pandas.DataFrame({"x": [2**53 + 1, 1], "y": [0, 1]}))


def test_weights_are_not_taken_for_radii():
    weights = TABLE.rename(columns={"r": "weight"})
    with pytest.raises(ValueError, match="weight_is='weight'"):
        frames.sites_of(weights)
    assert np.array_equal(frames.sites_of(weights, weight_is="weight"), SITES)
    with pytest.raises(ValueError, match="weight_is='radius'"):
        frames.sites_of(TABLE, weight_is="weight")


def test_points_of_shapely_and_geopandas():
    points = [Point(x, y) for x, y in SITES[:, :2]]
    assert np.array_equal(frames.sites_of(points), SITES[:, :2])
    assert np.array_equal(frames.sites_of(geopandas.GeoSeries(points)), SITES[:, :2])
    table = geopandas.GeoDataFrame({"r": SITES[:, 2]}, geometry=points)
    assert np.array_equal(frames.sites_of(table), SITES)
    for wrong in (LineString([(0, 0), (1, 1)]), Point()):
        with pytest.raises(ValueError, match="row 1 is no point"):
            frames.sites_of([points[0], wrong])


@pytest.mark.parametrize("metric", ["power", "euclidean", "manhattan", "supremum"])
def test_cells_as_polygons(metric):
    cells = signum.voronoi(signum.triangulate(SITES, metric)).clip(BOX)
    table = frames.cells_geodataframe(cells, tolerance=1e-4, crs="EPSG:3857")
    assert table.crs == "EPSG:3857" and len(table) == 30
    assert table.geometry.is_valid.all()
    assert np.allclose(table.geometry.area, table["area"], atol=1e-2)
    assert np.array_equal(table["area"], cells.areas)
    assert table.geometry.is_empty.tolist() == (cells.areas == 0).tolist()
    # They cover the box, and each holds its site.
    assert unary_union(list(table.geometry)).symmetric_difference(box(*BOX)).area < 1e-6
    for site, cell in zip(SITES[cells.areas > 0], table.geometry[cells.areas > 0]):
        # In the power metric a centre may lie outside its cell.
        assert metric == "power" or cell.buffer(1e-3).contains(Point(site[:2]))


def test_a_cell_that_the_box_cuts_in_pieces():
    # The point's cell ends below in a hyperbola; beside that the disc's cell is on both sides.
    t = signum.triangulate([[0, 0, 5], [0, 30, 0], [0, -30, 0]])
    geometries = frames.cells_geometries(signum.voronoi(t).clip((-100, 18, 100, 20)))
    assert [g.geom_type for g in geometries] == ["MultiPolygon", "Polygon", "Polygon"]
    assert len(geometries[0].geoms) == 2 and geometries[2].is_empty


def test_cells_of_space():
    cells = signum.triangulate_space(RNG.uniform(0, 1, (12, 4)) * [9, 9, 9, 0.5]).clip()
    table = frames.cells_frame(cells)
    assert {"x", "y", "z", "r", "volume", "area", "centroid_z", "hidden_by"} <= set(table.columns)
    low, high = np.array(cells.box)
    assert np.isclose(table.volume.sum(), np.prod(high - low))
