// The judge as a function of Octave, for meshes as delaunay (x, y) returns them:
//     mkoctfile circumspect_check.cc -lcircumspect
#include <circumspect/circumspect.h>
#include <octave/oct.h>

#include <vector>

DEFUN_DLD(circumspect_check, args, , "\
-*- texinfo -*-\n\
@deftypefn {} {[@var{holds}, @var{text}] =} circumspect_check (@var{points}, @var{simplices})\n\
Whether the simplices, a row of indices from 1 each, are the Delaunay triangulation of the points, a row each; and\n\
what is said about it.\n\
@end deftypefn") {
  if (args.length() != 2) print_usage();
  // Octave stores columns; these are point after point, simplex after simplex.
  const Matrix points = args(0).matrix_value().transpose();
  const Matrix rows = args(1).matrix_value().transpose();
  std::vector<int64_t> simplices;
  for (octave_idx_type i = 0; i < rows.numel(); ++i) {
    if (rows(i) != octave::math::fix(rows(i)) || !(rows(i) < 9e15 && rows(i) > -9e15)) {
      error("circumspect_check: expected whole numbers as indices, found %g", rows(i));
    }
    simplices.push_back(static_cast<int64_t>(rows(i)) - 1);
  }
  circumspect_mesh mesh = CIRCUMSPECT_MESH;
  mesh.dimension = points.rows();
  mesh.point_count = points.cols();
  mesh.coordinates = points.data();
  mesh.simplex_count = rows.cols();
  mesh.vertices_of_simplex = rows.rows();
  mesh.index_bytes = 8;
  mesh.simplices = simplices.data();
  circumspect_verdict* verdict = nullptr;
  if (circumspect_check("delaunay", &mesh, nullptr, nullptr, &verdict) != CIRCUMSPECT_OK) {
    error("circumspect_check: %s", circumspect_last_error());
  }
  octave_value_list answer(2);
  answer(0) = circumspect_verdict_holds(verdict) == 1;
  answer(1) = std::string(circumspect_verdict_text(verdict));
  circumspect_verdict_free(verdict);
  return answer;
}
