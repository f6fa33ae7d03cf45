import io.github.jdiemke.triangulation.*;
import java.util.*;

public final class JdiemkeAdapter {
  public static void main(String[] none) throws Exception {
    Lines.serve(points -> {
      Map<List<Double>, Integer> index = Lines.indices(points);
      List<Vector2D> own = new ArrayList<>();
      for (double[] p : points) own.add(new Vector2D(p[0], p[1]));
      DelaunayTriangulator triangulator = new DelaunayTriangulator(own);
      triangulator.triangulate();
      List<int[]> made = new ArrayList<>();
      for (Triangle2D t : triangulator.getTriangles()) {
        made.add(new int[] {index.get(List.of(t.a.x + 0.0, t.a.y + 0.0)), index.get(List.of(t.b.x + 0.0, t.b.y + 0.0)),
                            index.get(List.of(t.c.x + 0.0, t.c.y + 0.0))});
      }
      return made;
    });
  }
}
