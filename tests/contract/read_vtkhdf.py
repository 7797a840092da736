"""What VTK's own reader finds in files of one frame each: read_vtkhdf.py TARGET.npz FILE..."""
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader


def read(path):
    reader = vtkHDFReader()
    if not reader.CanReadFile(path):
        raise SystemExit(f"{path}: VTK cannot read it")
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutputDataObject(0)
    data = grid.GetPointData()
    arrays = {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}
    cells = grid.GetCells()
    arrays |= {
        "class": numpy.array(grid.GetClassName()),
        "points": vtk_to_numpy(grid.GetPoints().GetData()),
        "types": vtk_to_numpy(grid.GetCellTypesArray()),
        "offsets": vtk_to_numpy(cells.GetOffsetsArray()),
        "connectivity": vtk_to_numpy(cells.GetConnectivityArray()),
    }
    return arrays


if __name__ == "__main__":
    found = {f"{k}.{name}": values for k, path in enumerate(sys.argv[2:]) for name, values in read(path).items()}
    numpy.savez(sys.argv[1], **found)
