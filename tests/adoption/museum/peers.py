"""Triangulations by libraries of Python: peers.py NAME SITES DIMENSION prints a face a line."""
import sys

import numpy

name, path, dimension = sys.argv[1:]
points = numpy.loadtxt(path, ndmin=2)


def first_at():
    """The number of the first site at each place."""
    numbers = {}
    for number, point in enumerate(map(tuple, points)):
        numbers.setdefault(point, number)
    return numbers


def by_scipy():
    from scipy.spatial import Delaunay

    return Delaunay(points).simplices


def by_shapely():
    from shapely.geometry import MultiPoint
    from shapely.ops import triangulate

    numbers = first_at()
    return [[numbers[p] for p in list(face.exterior.coords)[:3]]
            for face in triangulate(MultiPoint(points))]


def by_vtk():
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    in_space = numpy.zeros((len(points), 3))
    in_space[:, : points.shape[1]] = points
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(in_space, deep=1))
    given = vtk.vtkPolyData()
    given.SetPoints(places)
    maker = vtk.vtkDelaunay2D() if dimension == "2" else vtk.vtkDelaunay3D()
    maker.SetTolerance(0.0)
    maker.SetInputData(given)
    maker.Update()
    made = maker.GetOutput()
    ids = []
    for k in range(made.GetNumberOfCells()):
        cell = made.GetCell(k)  # the next call changes it
        ids.append([cell.GetPointId(m) for m in range(cell.GetNumberOfPoints())])
    # Points of its output may be numbered anew.
    numbers = first_at()
    places = vtk_to_numpy(made.GetPoints().GetData()) if made.GetPoints() else None
    size = int(dimension) + 1
    return [[numbers[tuple(places[i][: points.shape[1]])] for i in face]
            for face in ids if len(face) == size]


for face in {"scipy": by_scipy, "shapely": by_shapely, "vtk": by_vtk}[name]():
    print(*face)
