import il.ac.idc.jdt.*;
import java.util.*;

public final class JdtAdapter {
  public static void main(String[] none) throws Exception {
    Lines.serve(points -> {
      Map<List<Double>, Integer> index = Lines.indices(points);
      List<Point> sites = new ArrayList<>();
      for (double[] p : points) sites.add(new Point(p[0], p[1]));
      List<int[]> made = new ArrayList<>();
      for (Triangle t : new DelaunayTriangulation(sites).getTriangulation()) {
        if (t.isHalfplane()) continue;
        int[] simplex = new int[3];
        Point[] corners = {t.getA(), t.getB(), t.getC()};
        for (int k = 0; k < 3; k++) {
          simplex[k] = index.getOrDefault(List.of(corners[k].getX() + 0.0, corners[k].getY() + 0.0), -1);
        }
        made.add(simplex);
      }
      return made;
    });
  }
}
