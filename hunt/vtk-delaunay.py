import vtk

from lines import serve


def triangulate(points):
    """vtkDelaunay2D of the plane z = 0, vtkDelaunay3D of space, with their own tolerances."""
    own = vtk.vtkPoints()
    own.SetDataTypeToDouble()
    for point in points:
        own.InsertNextPoint(*point, *([0.0] if len(point) == 2 else []))
    data = vtk.vtkPolyData()
    data.SetPoints(own)
    method = vtk.vtkDelaunay2D() if len(points[0]) == 2 else vtk.vtkDelaunay3D()
    method.SetInputData(data)
    method.Update()
    made = method.GetOutput()
    simplices = []
    for i in range(made.GetNumberOfCells()):
        cell = made.GetCell(i)  # the next call writes over it
        simplices.append([cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())])
    return simplices


serve(triangulate)
