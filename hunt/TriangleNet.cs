using System.Linq;
using TriangleNet.Geometry;
using TriangleNet.Meshing.Algorithm;

public static class TriangleNetAdapter
{
    public static void Main()
    {
        Lines.Serve(points =>
        {
            var vertices = points.Select((p, i) => new Vertex(p[0], p[1]) { Label = i + 1 }).ToList();
            var mesh = new Dwyer().Triangulate(vertices, new TriangleNet.Configuration());
            return mesh.Triangles.Select(t => new[] { 0, 1, 2 }.Select(k => t.GetVertex(k).Label - 1).ToArray()).ToList();
        });
    }
}
