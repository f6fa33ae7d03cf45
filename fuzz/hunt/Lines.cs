// What every adapter in C# does: reads points from the standard input, writes simplices to the standard output.
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
                text.AppendFormat("{0} {1}\n", made.Count, points[0].Length + 1);
                foreach (var simplex in made) text.Append(string.Join(" ", simplex)).Append('\n');
            }
            catch (Exception error)
            {
                text.Clear().AppendFormat("raised {0}: {1}\n", error.GetType().Name, error.Message.Split('\n')[0]);
            }
            output.Write(text);
            output.Flush();
        }
    }
}
