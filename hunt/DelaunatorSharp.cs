using System.Linq;
using DelaunatorSharp;

public static class DelaunatorSharpAdapter
{
    public static void Main()
    {
        Lines.Serve(points =>
        {
            var made = new Delaunator(points.Select(p => (IPoint)new Point(p[0], p[1])).ToArray()).Triangles;
            return Enumerable.Range(0, made.Length / 3).Select(i => new[] { made[3 * i], made[3 * i + 1], made[3 * i + 2] });
        });
    }
}
