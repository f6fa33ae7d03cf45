import java.io.*;
import java.util.*;

/** What every adapter in Java does: reads points from the standard input, writes triangles to the standard output. */
public final class Lines {
  public interface Triangulator { List<int[]> triangulate(double[][] points) throws Exception; }

  /** From a point that a library returns back to its index; it has to be the same doubles. */
  public static Map<List<Double>, Integer> indices(double[][] points) {
    Map<List<Double>, Integer> known = new HashMap<>();
    for (int i = 0; i < points.length; i++) known.put(List.of(points[i][0] + 0.0, points[i][1] + 0.0), i);
    return known;
  }

  public static void serve(Triangulator triangulator) throws IOException {
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
    PrintStream out = System.out;
    System.setOut(System.err); // libraries print what they like
    for (String header; (header = in.readLine()) != null; ) {
      double[][] points = new double[Integer.parseInt(header.split(" ")[0])][];
      for (int i = 0; i < points.length; i++) {
        points[i] = Arrays.stream(in.readLine().split(" ")).mapToDouble(Double::parseDouble).toArray();
      }
      StringBuilder text = new StringBuilder();
      try {
        List<int[]> made = triangulator.triangulate(points);
        text.append(made.size()).append(' ').append(points[0].length + 1).append('\n');
        for (int[] simplex : made) {
          for (int vertex : simplex) text.append(vertex).append(' ');
          text.append('\n');
        }
      } catch (Exception | StackOverflowError error) {
        text.setLength(0);
        text.append("raised ").append(error.toString().split("\n")[0]).append('\n');
      }
      out.print(text);
      out.flush();
    }
  }
}
