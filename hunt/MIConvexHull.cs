using System.Linq;
using MIConvexHull;

public static class MIConvexHullAdapter
{
    public static void Main()
    {
        Lines.Serve(points =>
        {
            var vertices = points.Select((p, i) => new Indexed { Position = p, Index = i }).ToList();
            return Triangulation.CreateDelaunay<Indexed>(vertices).Cells.Select(c => c.Vertices.Select(v => v.Index).ToArray());
        });
    }

    public sealed class Indexed : IVertex
    {
        public double[] Position { get; set; }
        public int Index;
    }
}
