// A mesh of elements is the same in every form of every format, and its numbers are to the last bit.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/written_elements_test.hpp"

namespace circumspect::formats {
namespace {

const WrittenMesh kTwoTetrahedra = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {1.0 / 3, -1e-300, 4}, {0, 0, -1}},
    {{0, 3}, {0, 1, 2}, {1, 2, 3}, {0, 1, 2, 3}, {0, 2, 1, 5}}};

// Vertices counted from 0.
std::vector<Simplex> from_zero(const SimplexFile& list, Vertex first_index) {
  std::vector<Simplex> simplices = list.simplices;
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v -= first_index;
  }
  return simplices;
}

// What differs between a form and the mesh; empty if nothing does.
std::string difference(const WrittenForm& form, const WrittenMesh& mesh) {
  const Result<ElementFile> file = read_form(form, kDouble);
  if (!file) return form.name + ": " + file.error().to_string();
  const ElementFile expected = elements_of(mesh);
  if (file->points.points != expected.points.points) return form.name + ": other points";
  const Vertex first = file->points.first_index;
  if (from_zero(file->tetrahedra, first) != expected.tetrahedra.simplices) {
    return form.name + ": other tetrahedra";
  }
  if (!form.has_faces) return "";
  if (from_zero(file->triangles, first) != expected.triangles.simplices) {
    return form.name + ": other triangles";
  }
  if (from_zero(file->edges, first) != expected.edges.simplices) return form.name + ": other edges";
  return "";
}

double any_double() {
  const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::isfinite(value) ? value : 1.5;
}

WrittenMesh any_mesh() {
  WrittenMesh mesh;
  const int points = *rc::gen::inRange(1, 12);
  for (int i = 0; i < points; ++i) {
    mesh.points.push_back({any_double(), any_double(), any_double()});
  }
  const int cells = *rc::gen::inRange(0, 12);
  for (int i = 0; i < cells; ++i) {
    const auto size = *rc::gen::inRange<std::size_t>(2, 5);
    mesh.cells.push_back(*rc::gen::container<std::vector<int>>(size, rc::gen::inRange(0, points)));
  }
  return mesh;
}

}  // namespace

TEST_CASE("the same mesh in every form") {
  for (const WrittenForm& form : all_forms(kTwoTetrahedra)) {
    CHECK_MESSAGE(difference(form, kTwoTetrahedra) == "", difference(form, kTwoTetrahedra));
  }
}

TEST_CASE("any mesh of any doubles in every form") {
  CHECK(rc::check("forms", [] {
    const WrittenMesh mesh = any_mesh();
    for (const WrittenForm& form : all_forms(mesh)) RC_ASSERT(difference(form, mesh) == "");
  }));
}

TEST_CASE("no form ends early: every text that is cut off is refused") {
  for (const WrittenForm& form : all_forms(kTwoTetrahedra)) {
    CAPTURE(form.name);
    // What stands behind the last number that counts may be missing: attributes, and blanks.
    const std::string whole = form.extension == ".vtk"
                                  ? form.text.substr(0, form.text.find("\nCELL_DATA") + 1)
                                  : form.text;
    const std::size_t last = whole.find_last_not_of(" \n");
    const std::size_t step = 1 + whole.size() / 300;
    for (std::size_t size = 0; size < last; size += step) {
      WrittenForm cut = form;
      cut.text.resize(size);
      const Result<ElementFile> file = read_form(cut, kDouble);
      CAPTURE(size);
      // A section of VTK's that is missing altogether cannot be missed, nor half a number of text.
      if (!file) CHECK(file.error().to_string().starts_with("f"));
      if (file) CHECK(form.extension != ".msh");
      if (file) CHECK(form.extension != ".vtu");
    }
  }
}

TEST_CASE("what surfaces and cells of other shapes become") {
  ElementFile file;
  CHECK(!add_element(file, ElementShape::kPolyline, {0, 1, 2}, "a polyline", 1));
  CHECK(file.edges.simplices == std::vector<Simplex>{{0, 1}, {1, 2}});
  CHECK(!add_element(file, ElementShape::kStrip, {0, 1, 2, 3, 4}, "a strip", 2));
  CHECK(file.triangles.simplices == std::vector<Simplex>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
  CHECK(check_simplices(file, "f"));
  CHECK(!add_element(file, ElementShape::kPixel, {0, 1, 2, 3}, "a pixel", 3));
  CHECK(file.polygons.simplices == std::vector<Simplex>{{0, 1, 3, 2}});
  CHECK(check_simplices(file, "f").error().to_string() ==
        "f:3: expected edges, triangles and tetrahedra, found a pixel");
  CHECK(add_element(file, ElementShape::kPolygon, {0, 1}, "a polygon", 4) ==
        "a polygon of 3 vertices or more");
  CHECK(!add_element(file, ElementShape::kCurved, {0, 1, 2}, "an edge of second order", 5));
  CHECK(check_simplices(file, "f").error().to_string() ==
        "f:5: expected edges, triangles and tetrahedra, found an edge of second order");
  file.points.dimension = 3;
  file.points.points.assign(5, {0, 0, 0});
  CHECK(domain_of(file, "f").error().to_string() ==
        "f:5: expected elements of first order, found an edge of second order");
}

TEST_CASE("points of one height are those of the plane, unless there are cells of space") {
  const auto dimension_of = [](double height, const std::vector<int>& cell) {
    ElementFile file = elements_of({{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}, {1, 1, height}}, {cell}});
    take_for_plane(file, "f");
    return file.points.dimension;
  };
  CHECK(dimension_of(7, {0, 1, 2}) == 2);
  CHECK(dimension_of(7.5, {0, 1, 2}) == 3);
  CHECK(dimension_of(7, {0, 1, 2, 3}) == 3);
}

}  // namespace circumspect::formats
