import java.util.*;
import org.locationtech.jts.geom.*;
import org.locationtech.jts.triangulate.DelaunayTriangulationBuilder;

public final class JtsAdapter {
  public static void main(String[] none) throws Exception {
    Lines.serve(points -> {
      Map<List<Double>, Integer> index = Lines.indices(points);
      List<Coordinate> sites = new ArrayList<>();
      for (double[] p : points) sites.add(new Coordinate(p[0], p[1]));
      DelaunayTriangulationBuilder builder = new DelaunayTriangulationBuilder();
      builder.setSites(sites);
      Geometry triangles = builder.getTriangles(new GeometryFactory());
      List<int[]> made = new ArrayList<>();
      for (int i = 0; i < triangles.getNumGeometries(); i++) {
        Coordinate[] c = triangles.getGeometryN(i).getCoordinates();
        int[] simplex = new int[3];
        for (int k = 0; k < 3; k++) simplex[k] = index.getOrDefault(List.of(c[k].x + 0.0, c[k].y + 0.0), -1);
        made.add(simplex);
      }
      return made;
    });
  }
}
