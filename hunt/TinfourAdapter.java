import java.util.*;
import org.tinfour.common.*;
import org.tinfour.standard.IncrementalTin;
import org.tinfour.utils.TriangleCollector;

public final class TinfourAdapter {
  /** Tinfour is told the spacing of the points, and merges what is nearer than 1e-5 of it: so it is told the least distance. */
  public static void main(String[] none) throws Exception {
    Lines.serve(points -> {
      double least = Double.POSITIVE_INFINITY;
      List<Vertex> vertices = new ArrayList<>();
      for (int i = 0; i < points.length; i++) {
        vertices.add(new Vertex(points[i][0], points[i][1], 0, i));
        for (int k = 0; k < i; k++) {
          least = Math.min(least, Math.hypot(points[i][0] - points[k][0], points[i][1] - points[k][1]));
        }
      }
      IncrementalTin tin = new IncrementalTin(least);
      if (!tin.add(vertices, null)) throw new IllegalStateException("add returns false: the TIN is not bootstrapped");
      List<int[]> made = new ArrayList<>();
      TriangleCollector.visitTriangles(tin, (Vertex[] t) ->
          made.add(new int[] {t[0].getIndex(), t[1].getIndex(), t[2].getIndex()}));
      return made;
    });
  }
}
