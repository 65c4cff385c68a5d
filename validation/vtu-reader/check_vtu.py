"""Read the snapshots of the example `write_snapshot` with independent readers and compare every value.

Usage: python check_vtu.py DIR      (DIR is what the example wrote)

Needs numpy and vtk (the library that ParaView is built on); meshio is used as well when it is installed. Ends with
status 0 if every array is equal, bit for bit, to the values computed here.
"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

UNITS = {
    "pressure": "Pa",
    "temperature": "K",
    "velocity": "m/s",
    "stress": "Pa",
    "velocity_gradient": "1/s",
    "body": "-",
    "neighbours": "-",
    "index": "-",
}


def expected(count):
    """The values that the example gives to particle i."""
    i = np.arange(count, dtype=np.float64)
    points = np.stack([i / 7.0, -i / 3.0, np.zeros(count)], axis=1)
    return {
        "points": points,
        "pressure": 1e5 + i / 11.0,
        "temperature": np.full(count, np.nan),
        "velocity": points,
        "stress": np.outer(i, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]),
        "velocity_gradient": (np.arange(9 * count).astype(np.float32) / np.float32(9.0)).reshape(count, 9),
        "body": (np.arange(count) % 5).astype(np.uint8),
        "neighbours": (2**32 - 1 - np.arange(count)).astype(np.uint32),
        "index": -np.arange(count, dtype=np.int64),
    }


def compare(reader, path, name, found, wanted):
    found = np.asarray(found).reshape(wanted.shape)
    if found.dtype != wanted.dtype:
        sys.exit(f"{reader}: {path}: {name} has type {found.dtype}, not {wanted.dtype}")
    if not np.array_equal(found, wanted, equal_nan=wanted.dtype.kind == "f"):
        sys.exit(f"{reader}: {path}: {name} differs")


def check_with_vtk(path, time):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    problems = []
    reader = vtk.vtkXMLUnstructuredGridReader()
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_, event=event: problems.append(event))
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    count = grid.GetNumberOfPoints()
    if problems or grid.GetNumberOfCells() != count:
        sys.exit(f"vtk: {path}: {problems}, {count} points, {grid.GetNumberOfCells()} cells")
    if any(grid.GetCellType(cell) != vtk.VTK_VERTEX for cell in range(count)):
        sys.exit(f"vtk: {path}: there are cells that are not vertices")
    if any(grid.GetCell(cell).GetPointId(0) != cell for cell in range(count)):
        sys.exit(f"vtk: {path}: cells and points do not correspond")
    if grid.GetFieldData().GetArray("TimeValue").GetValue(0) != time:
        sys.exit(f"vtk: {path}: the time is wrong")
    values = expected(count)
    if count:
        compare("vtk", path, "points", vtk_to_numpy(grid.GetPoints().GetData()), values["points"])
    data = grid.GetPointData()
    if data.GetNumberOfArrays() != len(UNITS):
        sys.exit(f"vtk: {path}: {data.GetNumberOfArrays()} arrays instead of {len(UNITS)}")
    for name, unit in UNITS.items():
        array = data.GetArray(name)
        compare("vtk", path, name, vtk_to_numpy(array), values[name])
        if array.GetInformation().Get(vtk.vtkDataArray.UNITS_LABEL()) != unit:
            sys.exit(f"vtk: {path}: the unit of {name} is not {unit}")
    labels = [data.GetArray("stress").GetComponentName(k) for k in range(6)]
    if labels != ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]:
        sys.exit(f"vtk: {path}: the components of the stress are called {labels}")
    return count


def check_with_meshio(path, count):
    import meshio

    mesh = meshio.read(path)
    values = expected(count)
    compare("meshio", path, "points", mesh.points, values["points"])
    for name in UNITS:
        compare("meshio", path, name, mesh.point_data[name], values[name])


def main():
    folder = Path(sys.argv[1])
    root = ElementTree.parse(folder / "fields.pvd").getroot()
    sets = root.findall("Collection/DataSet")
    if root.get("type") != "Collection" or len(sets) != 3:
        sys.exit("fields.pvd is not a collection of three snapshots")
    try:
        import meshio  # noqa: F401

        with_meshio = True
    except ImportError:
        with_meshio = False
    for item in sets:
        path = folder / item.get("file")
        count = check_with_vtk(path, float(item.get("timestep")))
        readers = "vtk"
        if with_meshio and count:
            check_with_meshio(path, count)
            readers += ", meshio"
        print(f"{path.name}: {count} particles, {len(UNITS)} arrays equal ({readers})")


if __name__ == "__main__":
    main()
