import java.util.*;
import org.waveware.delaunator.*;

public final class DelaunatorJavaAdapter {
  public static void main(String[] none) throws Exception {
    Lines.serve(points -> {
      List<DPoint> own = new ArrayList<>();
      for (double[] p : points) own.add(new DPoint(p[0], p[1]));
      int[] flat = new Delaunator(own).triangles;
      List<int[]> made = new ArrayList<>();
      for (int i = 0; i + 2 < flat.length; i += 3) made.add(new int[] {flat[i], flat[i + 1], flat[i + 2]});
      return made;
    });
  }
}
