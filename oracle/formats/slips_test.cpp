// One slip in a text of any format: a word where a number belongs, a number that is missing, or one
// that stands there twice. Whoever made it is told what it is and on which line, or it changes
// nothing.
#include <algorithm>
#include <functional>
#include <sstream>

#include <doctest/doctest.h>

#include "oracle/formats/format.hpp"
#include "oracle/formats/poly.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/formats/voronoi_file.hpp"
#include "oracle/formats/written_elements_test.hpp"

namespace circumspect::formats {
namespace {

// All that a reader says of a text.
class Said {
 public:
  template <class Read>
  static std::string of(const Result<Read>& read) {
    if (!read) return read.error().to_string();
    Said said;
    said.add(*read);
    return said.out_.str();
  }

 private:
  void add(const Rational& number) { out_ << number.get_str() << ' '; }
  void add(Vertex number) { out_ << number << ' '; }
  void add(std::size_t number) { out_ << number << ' '; }
  void add(const std::string& text) { out_ << text << '\n'; }
  template <class Each>
  void add(const std::vector<Each>& all) {
    out_ << '[';
    for (const Each& one : all) add(one);
    out_ << "]\n";
  }
  void add(const PointRows& points) { add(points.points()); }
  void add(const SimplexFile& file) {
    add(file.simplices.lists());
    out_ << "from " << file.first_index << ", of " << file.vertices_per_simplex << '\n';
    for (std::size_t i = 0; i < file.lines.size(); ++i) add(file.lines[i]);
    for (std::size_t i = 0; i < file.labels.size(); ++i) add(file.labels[i]);
  }
  void add(const PointFile& file) {
    out_ << "from " << file.first_index << ", of " << file.dimension << '\n';
    add(file.points);
    add(file.attributes);
    add(file.markers);
  }
  void add(const RawPoints& raw) {
    add(raw.points);
    add(raw.weights);
  }
  void add(const Contents& mesh) {
    add(mesh.simplices);
    if (mesh.points) add(*mesh.points);
    add(mesh.faces);
    add(mesh.nodes_between);
    add(mesh.notes);
  }
  void add(const ElementFile& file) {
    add(file.points);
    for (const SimplexFile* const list :
         {&file.edges, &file.triangles, &file.polygons, &file.tetrahedra, &file.other_solids}) {
      add(*list);
    }
    add(file.notes);
  }
  void add(const PolygonLines& polygon) {
    add(polygon.lines);
    add(polygon.hole_seeds);
  }
  void add(const DomainFile& file) {
    out_ << "from " << file.first_index << ", of " << file.dimension << '\n';
    add(file.input.points);
    add(file.input.segments);
    add(file.input.polygons);
    add(file.input.hole_seeds);
    add(file.labels);
    add(file.segment_lines);
    add(file.polygon_lines);
    add(file.polygon_markers);
    add(file.notes);
    add(file.faces);
  }
  void add(const NeighborFile& file) {
    out_ << "from " << file.first_index << ", of " << file.neighbors_per_simplex << '\n';
    add(file.neighbors);
  }
  void add(const ListedCell& cell) {
    out_ << (cell.is_unbounded ? "unbounded " : "");
    add(cell.corners);
  }
  void add(const VoronoiFile& file) {
    add(file.dimension);
    add(file.vertices);
    add(file.cells);
    add(file.ridges);
  }

  std::ostringstream out_;
};

// Is it noticed that a number is missing, or that there is one too many? Not one that may be left
// out, and not one where colours or further nodes may stand.
enum class Noticed { kAlways, kTooMany, kTooFew, kNever };

// A text and what reads it.
struct TextSample {
  std::string name;
  std::function<std::string(const std::string& text)> said;
  std::string text;
  Noticed noticed = Noticed::kAlways;
  bool has_end = true;  // so that it is noticed that the text is cut off
  bool has_name_of(const std::string& number) const {  // of a section or of the version
    return (name.starts_with("unv") && (number == "-1" || number.size() > 2)) ||
           (name.starts_with("vtk") && number.ends_with(".1"));
  }
};

// By the first of these that the format has: domain, mesh, points.
std::string said_of_text(const std::string& ending, const std::string& text) {
  const Source source = named(text);
  const Format& format = *format_of(ending, source);
  if (format.domain != nullptr) return Said::of(format.read_domain(source, kDouble));
  if (format.has_mesh()) return Said::of(format.read_mesh(source, kDouble));
  return Said::of(format.read_points(source, kDouble));
}

TextSample text_as(const std::string& ending, const std::string& text,
                   Noticed noticed = Noticed::kAlways, bool has_end = true) {
  const auto said = [ending](const std::string& slip) { return said_of_text(ending, slip); };
  return {ending, said, text, noticed, has_end};
}

template <class Reader>
TextSample text_read_by(const std::string& name, const std::string& text, Reader reader,
                        Noticed noticed = Noticed::kAlways, bool has_end = true) {
  const auto said = [reader](const std::string& slip) { return Said::of(reader(named(slip))); };
  return {name, said, text, noticed, has_end};
}

const WrittenMesh kMeshOfSlips = {
    {{0.5, 0.25, 0.125}, {21.5, 0.25, 0.125}, {0.5, 22.5, 0.125}, {0.5, 0.25, 23.5}},
    {{0, 3}, {0, 1, 2}, {1, 2, 3}, {0, 1, 2, 3}}};
const std::string kNodesOfSlips =
    "4 3 1 1\n0 0.5 0 0 9 7\n1 21 0 0 9 7\n2 0 22 0 9 7\n3 0 0 23 9 7\n";
const std::string kPlaneOfSlips = "4 2 0 1\n1 0 0 1\n2 24 0 1\n3 24 25 1\n4 0 25 1\n";

std::vector<TextSample> samples_of_lists() {
  std::vector<TextSample> samples = {
      text_as(".node", kNodesOfSlips),
      text_as(".ele", "2 4 1\n1 1 2 3 4 9\n2 2 3 4 5 9\n"),
      text_as(".poly", kPlaneOfSlips + "2 1\n1 1 2 7\n2 2 3 7\n1\n1 5 5.5\n1\n1 2 2 3 4\n"),
      text_as(".poly",
              kNodesOfSlips +
                  "2 1\n2 1 6\n3 0 1 2\n2 1 3\n1 0.25 0.25 0\n1 0 8\n3 1 2 3\n1\n1 .5 1 "
                  "1\n1\n1 1 1 1 5 6\n",
              Noticed::kTooMany, false),
      text_as(".smesh", kNodesOfSlips + "2 1\n3 0 1 2 6\n2 1 3 6\n1\n1 1 1 1\n", Noticed::kTooMany,
              false),
      text_as(".off", "OFF\n4 2 0\n0 0 0\n21 0 0\n0 22 0\n0 0 23\n3 0 1 2\n3 1 2 3\n",
              Noticed::kNever),
      text_as(".qhull", "3 rbox\n2\n0 0 0\n0.25 1e-3 7\n"),
      text_as(".qhull-i", "2\n0 1 2\n1 2 3\n", Noticed::kNever, false),
      text_as(".msh", "4 1 1\n0 0 0 1\n21 0 0 1\n0 22 0 1\n0 0 23 1\n1 2 3 4 7\n1 2 3 5\n"),
      text_as(".msh", "3 1 1\n0 0 1\n21 0 1\n0 22 1\n1 2 3 7\n1 2 5\n"),
      text_as(".mesh",
              "MFEM mesh v1.0\n\ndimension\n3\n\nelements\n1\n7 4 0 1 2 3\n\nboundary\n1\n"
              "5 2 0 1 2\n\nvertices\n4\n3\n0 0 0\n21 0 0\n0 22 0\n0 0 23\n"),
      text_as(".vol",
              "mesh3d\ndimension\n3\ngeomtype\n0\nsurfaceelements\n1\n1 5 1 0 3 1 2 3\n"
              "volumeelements\n1\n7 4 1 2 3 4\nedgesegmentsgi2\n1\n6 0 1 2 -1 -1 1 2 1 0 1 "
              "1\npoints\n4\n0 0 0\n21 0 0\n0 22 0\n0 0 23\nendmesh\n",
              Noticed::kNever),
      text_as(".bdf",
              "CORD2R,7,0,10.,0.,0.,10.,3.,4.\n,11.,0.,0.\nGRID,1,7,1.,5.,10.\nGRID,2\n"
              "GRID,3,,1.\nCTRIA3,1,9,1,2,3\n",
              Noticed::kNever, false),
      text_as(".msh",
              "$NOD\n3\n1 0 0 0\n2 21 0 0\n3 0 22 0\n$ENDNOD\n$ELM\n2\n1 2 7 1 3 1 2 3\n"
              "2 1 8 1 2 1 2\n$ENDELM\n"),
      text_read_by(
          "voronoi",
          "2\n4 3 1\n-10.101 -10.101\n0.5 0.5\n1.5 0.5\n1 2\n3 0 1 2\n3 0 2 3\n3 1 2 3\n2\n"
          "4 0 1 0 2\n4 1 2 2 3\n",
          [](const Source& source) { return read_voronoi(source, kDouble); }, Noticed::kAlways,
          false),
      text_read_by("neigh", "2 3\n0 -1 1 -1\n1 0 -1 -1\n",
                   [](const Source& source) { return read_neigh(source); }),
      text_read_by(
          "face", "2 1\n1 1 2 3 7 1 -1\n2 1 2 4 8 -1 2\n",
          [](const Source& source) { return read_face(source, 3); }, Noticed::kTooMany)};
  return samples;
}

std::vector<TextSample> samples_without_counts() {
  return {
      text_as(".json",
              "{\"circumspect\": 1, \"dimension\": 2, \"first_index\": 1,\n\"points\": [[0, 1e1],\n"
              "[2.5, 0],\n[3, 4]],\n\"weights\": [0, 1,\n2],\n\"simplices\": [[1, 2, 3]]}\n",
              Noticed::kNever),
      text_as(".stl",
              "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 21 0 0\nvertex 0 22 "
              "1\nendloop\nendfacet\nendsolid a\n"),
      text_as(
          ".ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
          "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"
          "21 0 0\n0 22 1\n3 0 1 2\n"),
      text_as(".obj", "v 0 0 0\nv 21 0 0\nv 0 22 0\nvt 0 0\nf 1/1 2/1 3/1\nl -1 -2\n",
              Noticed::kNever, false),
      text_as(".geojson",
              "{\"type\": \"Polygon\", \"properties\": {\"a\": [5, {\"b\": 6}]}, \"coordinates\":\n"
              "[[[0, 0],\n[24, 0],\n[24, 25]]]}\n",
              Noticed::kNever),
      text_as(".wkt", "POLYGON ((0 0,\n24 0,\n24 25,\n0 25))\n", Noticed::kNever),
      text_as(".csv", "id;x;y\n1;0.5;2\n2;1/3;4\n", Noticed::kNever, false),
      text_as(".xyz", "1 2 3\n4 5 6\n", Noticed::kNever, false)};
}

// Texts among the forms of one mesh.
std::vector<TextSample> samples_of_elements() {
  std::vector<TextSample> samples;
  for (const WrittenForm& form : all_forms(kMeshOfSlips)) {
    const bool is_text = std::all_of(form.text.begin(), form.text.end(), [](unsigned char c) {
      return c == '\n' || (c >= ' ' && c <= '~');
    });
    const bool has_words = form.name.find("base64") == std::string::npos &&
                           form.name.find("inline") == std::string::npos;
    if (!is_text || !has_words) continue;
    const auto said = [form](const std::string& text) {
      WrittenForm slip = form;
      slip.text = text;
      return Said::of(read_form(slip, kDouble));
    };
    // An empty field of a deck is 0, and a line of UCD may have the nodes of second order.
    const bool is_deck = form.extension == ".bdf" || form.name.starts_with("abaqus");
    const Noticed noticed = form.extension == ".msh" && form.name.find('4') == std::string::npos
                                ? Noticed::kNever
                            : is_deck            ? Noticed::kTooMany
                            : form.name == "ucd" ? Noticed::kTooFew
                                                 : Noticed::kAlways;
    samples.push_back({form.name, said, form.text, noticed, !is_deck && form.extension != ".vtk"});
  }
  return samples;
}

std::vector<TextSample> all_text_samples() {
  std::vector<TextSample> samples = samples_of_lists();
  for (const auto& more : {samples_without_counts(), samples_of_elements()}) {
    samples.insert(samples.end(), more.begin(), more.end());
  }
  return samples;
}

struct NumberInText {
  std::size_t begin = 0, size = 0, line = 0;
};

// The numbers in digits that stand alone.
std::vector<NumberInText> numbers_in(const std::string& text) {
  constexpr std::string_view kOfNumbers = "0123456789.-+/eE";
  std::vector<NumberInText> numbers;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n\t,;:()[]{}<>=\"\\*", at), text.size());
    const std::string_view word = std::string_view(text).substr(at, end - at);
    if (word.find_first_not_of(kOfNumbers) == std::string_view::npos &&
        word.find_first_of("0123456789") != std::string_view::npos) {
      const auto line =
          std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      numbers.push_back({at, end - at, static_cast<std::size_t>(line) + 1});
    }
    at = end + 1;
  }
  return numbers;
}

bool is_said_of_fault(const std::string& said) {
  return said.starts_with("f:") || said.starts_with("f.");
}

}  // namespace

TEST_CASE("a word where a number belongs is shown with its line, in every text") {
  for (const TextSample& sample : all_text_samples()) {
    CAPTURE(sample.name);
    const std::string whole = sample.said(sample.text);
    REQUIRE_MESSAGE(!is_said_of_fault(whole), whole);
    for (const NumberInText& number : numbers_in(sample.text)) {
      if (sample.has_name_of(sample.text.substr(number.begin, number.size))) continue;
      std::string slip = sample.text;
      slip.replace(number.begin, number.size, number.size, '?');
      const std::string said = sample.said(slip);
      CAPTURE(slip);
      if (said == whole) continue;
      CHECK_MESSAGE(said.starts_with("f:" + std::to_string(number.line) + ": expected "), said);
      CHECK_MESSAGE(said.find('?') != std::string::npos, said);
    }
  }
}

TEST_CASE("a number that is missing, or stands there twice, changes no mesh unnoticed") {
  for (const TextSample& sample : all_text_samples()) {
    CAPTURE(sample.name);
    const std::string whole = sample.said(sample.text);
    for (const NumberInText& number : numbers_in(sample.text)) {
      std::string missing = sample.text, twice = sample.text;
      missing.erase(number.begin, number.size);
      twice.insert(number.begin, sample.text.substr(number.begin, number.size) + " ");
      std::vector<std::string> slips;
      if (sample.noticed == Noticed::kAlways || sample.noticed == Noticed::kTooFew)
        slips.push_back(missing);
      if (sample.noticed == Noticed::kAlways || sample.noticed == Noticed::kTooMany)
        slips.push_back(twice);
      for (const std::string& slip : slips) {
        const std::string said = sample.said(slip);
        CAPTURE(slip);
        CHECK_MESSAGE((is_said_of_fault(said) || said == whole), said);
      }
    }
  }
}

TEST_CASE("voronoi: a vertex has as many numbers as there are axes") {
  const std::string begin = "2\n3 1 1\n-10.101 -10.101\n0.5 0.5\n";
  const auto said = [&](const std::string& vertex) {
    return error_of(read_voronoi(named(begin + vertex), kDouble));
  };
  CHECK(said("0.5\n") == "f:5: expected vertex 2 with 2 coordinates, found 1 numbers");
  CHECK(said("0.5 1 2\n") == "f:5: expected vertex 2 with 2 coordinates alone, found \"2\"");
  const auto file =
      read_voronoi(named("2\n3 2 1\n-10.101 -10.101\n0.5 0.5\n2 1\n2 1 2\n3 0 2 1\n"), kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->vertices == std::vector<Point>{{Rational(1, 2), Rational(1, 2)}, {2, 1}});
  REQUIRE(file->cells.size() == 2);
  CHECK(file->cells[0].corners == Simplex{0, 1});
  CHECK(file->cells[1].corners == Simplex{1, 0});
  CHECK(error_of(read_voronoi(named("2\n3\n"), kDouble)) ==
        "f:2: expected a line \"vertices cells 1\", found 1 numbers");
}

TEST_CASE("a text that is cut off before a number is refused, or changes nothing") {
  for (const TextSample& sample : all_text_samples()) {
    if (!sample.has_end) continue;
    CAPTURE(sample.name);
    const std::string whole = sample.said(sample.text);
    for (const NumberInText& number : numbers_in(sample.text)) {
      const std::string slip = sample.text.substr(0, number.begin);
      const std::string said = sample.said(slip);
      CAPTURE(slip);
      CHECK_MESSAGE((is_said_of_fault(said) || said == whole), said);
    }
  }
}

}  // namespace circumspect::formats
