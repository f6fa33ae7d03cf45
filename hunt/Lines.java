import java.io.*;
import java.util.*;

/** What every adapter in Java does: it answers the cases of {@code circumspect campaign --worker} (docs/workers.md). */
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
      List<int[]> made = null;
      try {
        made = triangulator.triangulate(points);
      } catch (Exception | StackOverflowError error) {
        error.printStackTrace();
        System.exit(1);
      }
      StringBuilder text = new StringBuilder().append(made.size()).append('\n');
      for (int[] simplex : made) {
        for (int vertex : simplex) text.append(vertex >= 0 ? vertex : points.length).append(' ');
        text.append('\n');
      }
      out.print(text);
      out.flush();
    }
  }
}
