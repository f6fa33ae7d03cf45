// What every adapter in C# does: it answers the cases of `circumspect campaign --worker` (docs/workers.md).
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

public static class Lines
{
    public static void Serve(Func<double[][], IEnumerable<int[]>> triangulate)
    {
        TextWriter output = Console.Out;
        Console.SetOut(Console.Error); // libraries print what they like
        for (string header; (header = Console.In.ReadLine()) != null;)
        {
            var points = new double[int.Parse(header.Split(' ')[0])][];
            for (int i = 0; i < points.Length; i++)
            {
                points[i] = Console.In.ReadLine().Split(' ').Select(x => double.Parse(x, CultureInfo.InvariantCulture)).ToArray();
            }
            var text = new StringBuilder();
            try
            {
                var made = triangulate(points).ToList();
                text.Append(made.Count).Append('\n');
                foreach (var simplex in made) text.Append(string.Join(" ", simplex.Select(v => v >= 0 ? v : points.Length))).Append('\n');
            }
            catch (Exception error)
            {
                Console.Error.WriteLine(error);
                Environment.Exit(1);
            }
            output.Write(text);
            output.Flush();
        }
    }
}
