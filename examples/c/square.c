/* A test that fails, as it should: the square is cut along the wrong diagonal. Exit code 1, and the witness.
 *   cc square.c $(pkg-config --cflags --libs circumspect-c) */
#include <circumspect/circumspect.h>
#include <stdio.h>

int main(void) {
  const double points[] = {0, 0, 1, 0, 0, 1, 0.9, 0.9};
  const int32_t triangles[] = {0, 1, 2, 1, 3, 2};
  circumspect_mesh mesh = CIRCUMSPECT_MESH;
  mesh.dimension = 2;
  mesh.point_count = 4;
  mesh.coordinates = points;
  mesh.simplex_count = 2;
  mesh.vertices_of_simplex = 3;
  mesh.simplices = triangles;
  circumspect_verdict* verdict = NULL;
  circumspect_check("delaunay", &mesh, NULL, NULL, &verdict);
  const int holds = circumspect_verdict_holds(verdict) == 1; /* if there is no verdict: -1 */
  if (!holds) printf("%s%s\n", circumspect_verdict_text(verdict), circumspect_last_error());
  circumspect_verdict_free(verdict);
  return holds ? 0 : 1;
}
