/* Judges two meshes of one square from C: one is Delaunay, the other is not. Exit code 0 if the judge says
 * so.   cc check.c $(pkg-config --cflags --libs circumspect-c) */
#include <circumspect/circumspect.h>
#include <stdio.h>

int main(void) {
  /* The last point is a little inside the circle of the others. */
  const double points[] = {0, 0, 1, 0, 0, 1, 0.9, 0.9};
  const int32_t meshes[2][6] = {{0, 1, 3, 0, 3, 2}, {0, 1, 2, 1, 3, 2}};
  int surprises = 0;
  for (int which = 0; which < 2; ++which) {
    circumspect_mesh mesh = CIRCUMSPECT_MESH;
    mesh.dimension = 2;
    mesh.point_count = 4;
    mesh.coordinates = points;
    mesh.simplex_count = 2;
    mesh.vertices_of_simplex = 3;
    mesh.simplices = meshes[which];
    circumspect_verdict* verdict = NULL;
    if (circumspect_check("delaunay", &mesh, NULL, NULL, &verdict) != CIRCUMSPECT_OK) {
      fprintf(stderr, "%s\n", circumspect_last_error());
      return 1;
    }
    fputs(circumspect_verdict_text(verdict), stdout);
    if (circumspect_verdict_holds(verdict) != (which == 0)) ++surprises;
    for (int64_t i = 0; i < circumspect_verdict_violation_count(verdict); ++i) {
      circumspect_violation violation;
      circumspect_verdict_violation(verdict, i, &violation, sizeof violation);
      printf("%s: vertex %d in a ball of squared radius %s\n", violation.rule,
             (int)violation.vertices[0], violation.squared_radius->exact);
    }
    circumspect_verdict_free(verdict);
  }
  return surprises == 0 ? 0 : 1;
}
