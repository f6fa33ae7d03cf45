// The formats of domains: what is read, what is refused, and the messages.
#include <sstream>

#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/element_domain.hpp"
#include "oracle/formats/medit.hpp"
#include "oracle/formats/obj.hpp"
#include "oracle/formats/poly.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/formats/vtk.hpp"

namespace circumspect::formats {
namespace {

using Line = std::vector<Vertex>;

Result<PointFile> no_points() { return tl::unexpected(FormatError{"f.node", 0, "points", "none"}); }

Result<DomainFile> poly(const std::string& text) {
  return read_poly({"f", text}, kDouble, no_points);
}
Result<DomainFile> smesh(const std::string& text) {
  return read_smesh({"f", text}, kDouble, no_points);
}

// The four corners of a tetrahedron, from 1.
const std::string kFour = "4 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
const std::string kSquareFrom1Node = "4 2 0 1\n1 0 0 1\n2 4 0 1\n3 4 4 1\n4 0 4 1\n";

std::string poly_error(const std::string& behind_points) {
  return error_of(poly(kFour + behind_points));
}
std::string square_error(const std::string& behind_points) {
  return error_of(poly(kSquareFrom1Node + behind_points));
}

}  // namespace

TEST_CASE("poly in the plane: segments, holes, regions") {
  const auto file = poly(kSquareFrom1Node +
                         "5 1 # segments\n1 1 2 7\n2 2 3 7\n3 3 4 7\n4 4 1 7\n9 1 3 0\n"
                         "1\n1 1 0.5\n1\n1 3 1 5 0.25\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->dimension == 2);
  CHECK(file->first_index == 1);
  CHECK(file->label(3) == 4);
  CHECK(file->input.segments == std::vector<Line>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}});
  CHECK(file->segment_lines == std::vector<std::size_t>{7, 8, 9, 10, 11});
  CHECK(file->input.hole_seeds == std::vector<Point>{{1, Rational(1, 2)}});
  CHECK(file->input.polygons.empty());
  CHECK(file->notes.empty());
}

TEST_CASE("poly in the plane: what is refused") {
  CHECK(square_error("1 0\n1 1 5\n0\n") == "f:7: expected a vertex from 1 to 4, found 5");
  CHECK(square_error("1 0\n1 0 1\n0\n") == "f:7: expected a vertex from 1 to 4, found 0");
  CHECK(square_error("1 0\n1 2 2\n0\n") == "f:7: expected another end than the first, found \"2\"");
  CHECK(square_error("1 1\n1 1 2\n0\n") ==
        "f:7: expected 4 columns (an index, 2 ends, a marker), found 3");
  CHECK(square_error("2 0\n1 1 2\n") == "f:7: expected segment 2 of 2, found the end of the file");
  CHECK(square_error("1 0\n1 1 2\n") ==
        "f:7: expected a header \"holes\", found the end of the file");
  CHECK(square_error("0\n1\n1 2\n") ==
        "f:8: expected 3 columns (an index, 2 coordinates), found 2");
  CHECK(square_error("0\n0\n1\n1 2 2\n") ==
        "f:9: expected 4 or 5 columns (an index, 2 coordinates, an attribute, a bound), found 3");
  CHECK(square_error("0\n0\n0\n0\n") ==
        "f:9: expected the end of the file after the last list, found \"0\"");
  CHECK(error_of(poly("1 4\n1 0 0 0 0\n0\n0\n")) ==
        "f:2: expected points of dimension 2 or 3, found dimension 4");
  CHECK(error_of(poly("0 2\n0\n0\n")) == "f.node: expected points, found none");
}

TEST_CASE("poly in space: facets of several polygons, with holes, slits and lone vertices") {
  const auto file = poly(kFour +
                         "3 1\n"
                         "1 0 5\n3 1 2 3\n"
                         "2 1 -1 # with a slit and a hole\n3 1 2\n   4\n2 1 2\n1 0.25 0.125 1/3\n"
                         "1\n2 3 4\n"
                         "1\n7 0.1 0.1 0.1\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->dimension == 3);
  REQUIRE(file->input.polygons.size() == 2);
  CHECK(file->input.polygons[0].lines == std::vector<Line>{{0, 1, 2}});
  CHECK(file->input.polygons[1].lines == std::vector<Line>{{0, 1, 3}, {0, 1}});
  CHECK(file->input.polygons[1].hole_seeds ==
        std::vector<Point>{{Rational(1, 4), Rational(1, 8), Rational(1, 3)}});
  CHECK(file->polygon_lines == std::vector<std::size_t>{7, 9});
  CHECK(file->polygon_markers == std::vector<Vertex>{5, -1});
  CHECK(file->input.segments == std::vector<Line>{{2, 3}});
  CHECK(file->segment_lines == std::vector<std::size_t>{14});
  CHECK(file->input.hole_seeds.size() == 1);
}

TEST_CASE(
    "poly in space: what has the area of a polygon keeps its marker where points are merged") {
  const auto file = poly(
      "5 3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 0 0\n5 0 0 1\n"
      "3 1\n1 0 4\n3 2 3 4\n1 0 5\n3 1 2 3\n1 0 6\n3 1 4 5\n0\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->polygon_markers == std::vector<Vertex>{4, 5, 6});
  const DomainFile merged = with_duplicates_merged(*file);
  CHECK(merged.input.polygons.size() == 2);
  CHECK(merged.polygon_markers == std::vector<Vertex>{5, 6});
}

TEST_CASE("poly in space: a facet without a marker has none, whatever the one before it has") {
  const auto file = poly(kFour + "2 1\n1 0 5\n3 1 2 3\n1\n3 1 2 4\n0\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->polygon_markers == std::vector<Vertex>{5, 0});
}

TEST_CASE(
    "a domain each of whose parts has points of its own is the same one when they are merged") {
  const std::string points = "9 2\n1 9 9\n2 0 0\n3 1 0\n4 1 0\n5 0 1\n6 0 1\n7 0 0\n8 0 0\n9 0 0\n";
  const auto apart = poly(points + "4\n1 2 3\n2 4 5\n3 6 7\n4 8 9\n0\n");
  REQUIRE_MESSAGE(apart, error_of(apart));
  const DomainFile merged = with_duplicates_merged(*apart);
  CHECK(merged.input.points == std::vector<Point>{{9, 9}, {0, 0}, {1, 0}, {0, 1}});
  CHECK(merged.labels == std::vector<Vertex>{1, 2, 3, 5});
  CHECK(merged.input.segments == std::vector<Line>{{1, 2}, {2, 3}, {3, 1}});
  CHECK(merged.segment_lines == std::vector<std::size_t>{12, 13, 14});
  const auto facets = poly(
      "7 3\n1 9 9 9\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 1 0 0\n6 0 0 0\n7 0 0 1\n"
      "2\n1\n3 2 3 4\n1\n3 5 6 7\n0\n");
  REQUIRE_MESSAGE(facets, error_of(facets));
  const DomainFile joined = with_duplicates_merged(*facets);
  REQUIRE(joined.input.polygons.size() == 2);
  CHECK(joined.input.polygons[0].lines == std::vector<Line>{{1, 2, 3}});
  CHECK(joined.input.polygons[1].lines == std::vector<Line>{{2, 1, 4}});
}

TEST_CASE("poly: corners that repeat the one before, and facets of segments alone") {
  const auto repeats = poly(kFour + "2\n1\n5 1 2 2 3 1\n1\n2 4 4\n0\n");
  REQUIRE_MESSAGE(repeats, error_of(repeats));
  REQUIRE(repeats->input.polygons.size() == 1);
  CHECK(repeats->input.polygons[0].lines == std::vector<Line>{{0, 1, 2}});
  CHECK(repeats->input.segments.empty());
  CHECK(repeats->notes ==
        std::vector<std::string>{"f:7: a corner that repeats the one before it was left out",
                                 "f:9: a corner that repeats the one before it was left out"});
  // A vertex that is met again later stays: the line runs along a slit.
  const auto slit = poly(kFour + "1\n1\n5 1 2 3 4 3\n0\n");
  REQUIRE(slit);
  CHECK(slit->input.polygons[0].lines == std::vector<Line>{{0, 1, 2, 3, 2}});
  // Three segments in a cycle enclose something, two do not.
  const auto cycle = poly(kFour + "2\n3\n2 1 2\n2 2 3\n2 3 1\n2\n2 1 2\n2 2 4\n0\n");
  REQUIRE(cycle);
  REQUIRE(cycle->input.polygons.size() == 1);
  CHECK(cycle->input.polygons[0].lines == std::vector<Line>{{0, 1}, {1, 2}, {2, 0}});
  CHECK(cycle->input.segments == std::vector<Line>{{0, 1}, {1, 3}});
}

TEST_CASE("poly in space: what is refused, and a list of holes that is not there") {
  CHECK(poly_error("1 2\n") == "f:6: expected 0 or 1 markers, found \"2\"");
  CHECK(poly_error("1\n0\n0\n") == "f:7: expected a facet of at least 1 polygon, found \"0\"");
  CHECK(poly_error("1\n1 0 4\n3 1 2 3\n0\n") ==
        "f:7: expected the end of the line (0 markers a facet), found \"4\"");
  CHECK(poly_error("1\n1\n0\n0\n") == "f:8: expected a polygon of at least 1 corner, found \"0\"");
  CHECK(poly_error("1\n1\n3 1 2 5\n0\n") == "f:8: expected a vertex from 1 to 4, found 5");
  CHECK(poly_error("1\n1\n3 1 2 3 4\n0\n") ==
        "f:8: expected the end of the line after 3 corners, found \"4\"");
  CHECK(poly_error("1\n1\n3 1 2\n") == "f:8: expected corner 3 of 3, found the end of the file");
  CHECK(poly_error("1\n1 1\n3 1 2 3\n1 0 0\n0\n") ==
        "f:9: expected 4 columns (an index, 3 coordinates), found 3");
  CHECK(poly_error("2\n1\n3 1 2 3\n") == "f:8: expected facet 2 of 2, found the end of the file");
  CHECK(poly_error("999999999999\n1\n9999999999 1 2 3\n") ==
        "f:8: expected corner 4 of 9999999999, found the end of the file");
  CHECK(poly_error("1\n1 9999999999\n3 1 2 3\n1 0 0 0\n") ==
        "f:9: expected hole 2 of 9999999999, found the end of the file");
  CHECK(error_of(poly("2 3\n1 0 0 0\n3 1 0 0\n0\n0\n")) ==
        "f:3: expected index 2, one more than the line before, found \"3\"");
  const auto without_holes = poly(kFour + "1\n1\n3 1 2 3\n");
  REQUIRE(without_holes);
  CHECK(without_holes->notes ==
        std::vector<std::string>{"f: ends before the list of holes, read as none"});
}

TEST_CASE("smesh: facets of one polygon each, with markers; points from 0 or elsewhere") {
  const auto file = smesh(kFour + "4 1\n3 1 2 3 9\n3 1 2\n 4 0\n2 3 4\n3 2 3 4 7\n0\n0\n");
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->input.polygons.size() == 3);
  CHECK(file->polygon_lines == std::vector<std::size_t>{7, 8, 11});
  CHECK(file->polygon_markers == std::vector<Vertex>{9, 0, 7});
  CHECK(file->input.segments == std::vector<Line>{{2, 3}});
  CHECK(error_of(smesh(kFour + "1 0\n3 1 2 3 9\n0\n")) ==
        "f:7: expected the end of the line after 3 corners and 0 markers, found \"9\"");
  CHECK(error_of(smesh(kSquareFrom1Node + "0\n0\n")) ==
        "f: expected points in space, for a .smesh file, found points in the plane");
  const ScratchFolder folder;
  const std::string path = folder.write("x.1.smesh", "0 3 0 0\n1 1\n3 0 1 2 -1\n0\n0\n");
  CHECK(error_of(read_domain(path, kDouble)) ==
        folder.path("x.1.node") + ": expected a file with the points of " + path +
            ", found no file of that name, and no points in " + path);
  folder.write("x.1.node", "3 3\n0 0 0 0\n1 1 0 0\n2 0 1 0\n");
  const auto read = read_domain(path, kDouble);
  REQUIRE_MESSAGE(read, error_of(read));
  CHECK(read->input.points.size() == 3);
  CHECK(read->points_name == folder.path("x.1.node"));
  folder.write("x.1.node", "1 2\n0 0 0\n");
  CHECK(error_of(read_domain(path, kDouble)) ==
        path + ":1: expected points of dimension 3, found dimension 2");
}

TEST_CASE("off: faces are polygons in space, their edges segments in the plane") {
  const ScratchFolder folder;
  const auto surface = read_domain(
      folder.write("a.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 0 1\n4 0 1 2 3\n2 1 3\n"), kDouble);
  REQUIRE_MESSAGE(surface, error_of(surface));
  CHECK(surface->input.polygons.front().lines == std::vector<Line>{{0, 1, 2, 3}});
  CHECK(surface->input.segments == std::vector<Line>{{1, 3}});
  CHECK(surface->polygon_lines == std::vector<std::size_t>{7});
  const auto flat = read_domain(
      folder.write("b", "nOFF 2\n4 2\n0 0\n1 0\n1 1\n0 1\n3 0 1 2\n3 0 2 3\n"), kDouble);
  REQUIRE_MESSAGE(flat, error_of(flat));
  CHECK(flat->input.segments == std::vector<Line>{{0, 1}, {1, 2}, {0, 2}, {2, 3}, {0, 3}});
  // A face of one point many times has no edge.
  const auto point =
      read_domain(folder.write("d", "nOFF 2\n3 2\n0 0\n1 0\n0 1\n3 1 1 1\n3 0 1 2\n"), kDouble);
  REQUIRE_MESSAGE(point, error_of(point));
  CHECK(point->input.segments == std::vector<Line>{{0, 1}, {1, 2}, {0, 2}});
  CHECK(error_of(read_domain(folder.write("e", "nOFF 4\n1 0\n0 0 0 0\n"), kDouble)) ==
        folder.path("e") + ": expected points of dimension 2 or 3, found dimension 4");
  CHECK(error_of(read_domain(folder.write("c.off", "OFF\n1 1\n0 0 0\n3 0 0 1\n"), kDouble)) ==
        folder.path("c.off") + ":4: expected a vertex from 0 to 0, found 1");
}

TEST_CASE("medit: sections in any order, those of no interest read over") {
  const std::string text =
      "MeshVersionFormatted 2\nDimension\n3\nVertices 5\n0 0 0 1 1 0 0 1\n0 1 0 1\n0 0 1 1\n"
      "0.1 0.1 0.1 0\nCorners 2\n1\n2\nGeometry \"the End of.mesh\"\nAngleOfCornerBound 45\n"
      "Edges 1\n1 2 3\nTriangles 2 1 2 3 0\n1 2 4 0\nNormals 1\n0 0 1\nTetrahedra 1\n1 2 3 5 0\n"
      "Unknown 2\n1 2 3\nEnd\n";
  const auto medit = read_medit({"f", text}, kDouble);
  REQUIRE_MESSAGE(medit, medit.error().to_string());
  CHECK(medit->points.points.size() == 5);
  CHECK(medit->triangles.simplices == std::vector<Simplex>{{1, 2, 3}, {1, 2, 4}});
  CHECK(medit->tetrahedra.simplices == std::vector<Simplex>{{1, 2, 3, 5}});
  const auto domain = domain_of(*medit, "f");
  REQUIRE_MESSAGE(domain, error_of(domain));
  CHECK(domain->input.points.size() == 4);
  CHECK(domain->labels == std::vector<Vertex>{1, 2, 3, 4});
  CHECK(domain->notes.size() == 1);
  CHECK(domain->input.segments == std::vector<Line>{{0, 1}});
  CHECK(domain->input.polygons.size() == 2);
  std::ostringstream out;
  write_medit(out, *medit);
  const auto again = read_medit({"f", out.str()}, kDouble);
  REQUIRE_MESSAGE(again, again.error().to_string());
  CHECK(again->points == medit->points);
  CHECK(again->tetrahedra.simplices == medit->tetrahedra.simplices);
}

TEST_CASE("medit: the last keyword may be missing, as in what CDT writes") {
  const std::string text = "MeshVersionFormatted 2\nDimension\n3\nVertices\n1\n0 0 0 1\n";
  const auto file = read_medit({"f", text}, NumberReading::kDouble);
  REQUIRE(file);
  CHECK(file->notes ==
        std::vector<std::string>{
            "f: no keyword End; if the file was cut off, it is in between sections"});
  CHECK(read_medit({"f", text + "End\n"}, NumberReading::kDouble)->notes.empty());
  CHECK(read_medit({"f", text + "End\n1\n"}, NumberReading::kDouble).error().to_string() ==
        "f:8: expected the end of the file after End, found \"1\"");
}

TEST_CASE("medit in the plane: edges are the domain, else those of the triangles") {
  const std::string vertices = "MeshVersionFormatted 1 Dimension 2 Vertices 3 0 0 0 1 0 0 0 1 0 ";
  const auto with_edges = domain_of(
      *read_medit({"f", vertices + "Edges 1 1 2 0 Triangles 1 1 2 3 0 End"}, kDouble), "f");
  REQUIRE(with_edges);
  CHECK(with_edges->input.segments == std::vector<Line>{{0, 1}});
  CHECK(with_edges->input.points.size() == 2);
  const auto without =
      domain_of(*read_medit({"f", vertices + "Triangles 1 1 2 3 0 End"}, kDouble), "f");
  REQUIRE(without);
  CHECK(without->input.segments == std::vector<Line>{{0, 1}, {1, 2}, {0, 2}});
}

TEST_CASE("polygons of a domain are in the order of the file, triangles among others") {
  const std::vector<std::size_t> lines = {9, 10, 11, 12};
  const std::vector<Line> polygons = {{0, 1, 2, 3}, {4, 5, 6}, {0, 1, 4, 5}, {1, 2, 3}};
  const auto corners_of = [](const DomainFile& domain) {
    std::vector<Line> all;
    for (const PolygonLines& polygon : domain.input.polygons) all.push_back(polygon.lines.front());
    return all;
  };
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 1\n5 0 0\n6 0 0\n5 1 0\n";
  const auto obj = read_obj({"f",
                             "# a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nv 5 0 0\nv 6 0 0\n"
                             "v 5 1 0\nf 1 2 3 4\nf 5 6 7\nf 1 2 5 6\nf 2 3 4\n"},
                            kDouble);
  REQUIRE_MESSAGE(obj, error_of(obj));
  const auto of_obj = domain_of(*obj, "f");
  REQUIRE_MESSAGE(of_obj, error_of(of_obj));
  CHECK(corners_of(*of_obj) == polygons);
  CHECK(of_obj->polygon_lines == lines);
  // One line of a VTK file may hold all of its cells.
  const auto vtk = read_vtk({"f",
                             "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 7 "
                             "float\n" +
                                 points + "POLYGONS 4 18\n4 0 1 2 3 3 4 5 6 4 0 1 4 5 3 1 2 3\n"},
                            kDouble);
  REQUIRE_MESSAGE(vtk, error_of(vtk));
  const auto of_vtk = domain_of(*vtk, "f");
  REQUIRE_MESSAGE(of_vtk, error_of(of_vtk));
  CHECK(corners_of(*of_vtk) == polygons);
}

}  // namespace circumspect::formats
