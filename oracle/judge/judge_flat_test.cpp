// The fast judge on every mesh of the corpus, and on grids with facets that are not locally Delaunay: what
// it says is what the slow one says, and it speaks up where the claim holds or that is all that is wrong.
#include "oracle/judge/judge_flat.hpp"

#include <algorithm>
#include <filesystem>

#include <doctest/doctest.h>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/judge/mesh_of_doubles.hpp"
#include "oracle/judge/shaken_grid_test.hpp"
#include "oracle/judge/witness_text_test.hpp"

namespace circumspect::check {
namespace {

namespace fs = std::filesystem;

// The files with simplices of a folder and those below, in order.
std::vector<std::string> meshes_below(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(CIRCUMSPECT_CORPUS_DIR + folder)) {
    if (entry.path().extension() == ".ele") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// As the command makes one; none if there are equal points.
std::optional<Mesh> mesh_of(const formats::RawMesh& raw, Claim claim) {
  if (!duplicates(raw.points.points).empty()) return std::nullopt;
  std::vector<Rational> weights;
  for (const std::vector<Rational>& row : raw.points.attributes) {
    if (claim == Claim::kWeightedDelaunay) weights.push_back(row.front());
  }
  Mesh mesh{PointSet(raw.points.points, weights), raw.simplices.simplices, {}, raw.first_index};
  if (raw.neighbors)
    mesh.neighbors = Neighbors{raw.neighbors->neighbors, raw.neighbors->first_index};
  return mesh;
}

// Is all that is wrong that some facets are not locally Delaunay?
bool is_about_facets(const Verdict& verdict) {
  return std::all_of(verdict.tallies().begin(), verdict.tallies().end(), [](const auto& tally) {
    return tally.first == Rule::kFacetNotLocal || tally.first == Rule::kVertexSubmerged;
  });
}

// Judges a mesh fast and slowly; true if there is a fast verdict.
bool compare(const formats::MeshRequest& request, Claim claim, const Options& options) {
  const auto flat = formats::read_flat_mesh(request);
  if (!flat) return false;
  const std::optional<FlatVerdict> fast = judge_flat(claim, *flat, options, 2);
  if (claim == Claim::kWeightedDelaunay && flat->points.weights.rows() == 0) {
    CHECK(!fast);
    return false;
  }
  const auto raw = formats::read_mesh(request);
  REQUIRE(raw.has_value());
  const std::optional<Mesh> mesh = mesh_of(*raw, claim);
  if (!mesh) {
    CHECK(!fast);
    return false;
  }
  const Verdict slow = judge(claim, *mesh, options);
  const std::optional<Verdict> of_mesh = judge_as_doubles(claim, *mesh, options, 2);
  CHECK(of_mesh.has_value() == fast.has_value());
  if (!fast) {
    const auto ambient = static_cast<int>(mesh->points.ambient_dimension());
    const bool in_scope = ambient == slow.dimension && (ambient == 2 || ambient == 3);
    const bool has_unused_points = claim == Claim::kWeightedDelaunay;
    CHECK(!(in_scope && is_about_facets(slow) && (slow.holds() || !has_unused_points)));
    return false;
  }
  CHECK(text_of(fast->verdict, fast->named) == text_of(slow, *mesh));
  CHECK(text_of(*of_mesh, *mesh) == text_of(slow, *mesh));
  return true;
}

}  // namespace

TEST_CASE("the corpus: a fast verdict is the slow one, and there is one where the claim holds") {
  std::size_t verdicts = 0;
  for (const std::string folder : {"/accept", "/reject", "/peers", "/regressions", "/findings"}) {
    for (const std::string& path : meshes_below(folder)) {
      CAPTURE(path);
      for (const Claim claim :
           {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
        verdicts += compare({path}, claim, {}) ? 1 : 0;
        verdicts += compare({path}, claim, {.oriented = true}) ? 1 : 0;
      }
      formats::MeshRequest request{path};
      request.with_neighbors = true;
      verdicts += compare(request, Claim::kDelaunay, {}) ? 1 : 0;
    }
  }
  CHECK(verdicts > 100);
}

TEST_CASE("grids with many facets that are not locally Delaunay: the words, the order, the count") {
  for (const std::size_t dimension : {2u, 3u}) {
    for (const Claim claim : {Claim::kDelaunay, Claim::kWeightedDelaunay}) {
      const Mesh mesh =
          shaken_grid(dimension, dimension == 2 ? 9 : 5, claim == Claim::kWeightedDelaunay);
      REQUIRE(triangulation(mesh).holds());
      const auto flat = mesh_of_doubles(mesh);
      REQUIRE(flat);
      for (const std::size_t most : {0u, 1u, 20u}) {
        const Options options{.max_violations = most};
        const Verdict slow = judge(claim, mesh, options);
        CHECK(slow.tallies().begin()->second.count > 20);
        for (const unsigned threads : {1u, 2u}) {
          const auto fast = judge_flat(claim, *flat, options, threads);
          REQUIRE(fast);
          CHECK(text_of(fast->verdict, fast->named) == text_of(slow, mesh));
          CHECK(text_of(*judge_as_doubles(claim, mesh, options, threads), mesh) ==
                text_of(slow, mesh));
        }
      }
    }
  }
}

TEST_CASE("given neighbours are judged where indices have 64 bits, too") {
  formats::FlatMesh square;
  const auto fill = [](auto& rows, const auto& numbers) {
    std::copy(numbers.begin(), numbers.end(), rows.values().begin());
  };
  fill(square.points.coordinates = formats::FlatRows<double>(4, 2),
       std::vector<double>{0, 0, 1, 0, 0, 1, 2, 2});
  fill(square.simplices.emplace<formats::FlatRows<std::int64_t>>(2, 3),
       std::vector<std::int64_t>{0, 1, 2, 1, 3, 2});
  fill(square.neighbors.emplace(2, 3), std::vector<std::int32_t>{1, -1, -1, -1, 0, -1});
  const auto verdict = judge_flat(Claim::kDelaunay, square);
  REQUIRE(verdict);
  CHECK(verdict->verdict.holds());
  std::swap(square.neighbors->row(0)[0], square.neighbors->row(0)[1]);
  CHECK(!judge_flat(Claim::kDelaunay, square));
}

TEST_CASE("one facet that is not locally Delaunay: no more of the mesh is named than it needs") {
  Mesh mesh = shaken_grid(3, 5, false, 0);
  REQUIRE(delaunay(mesh).holds());
  std::vector<Point> points = mesh.points.points();
  points[62][0] += Rational(1) / 1024;  // the middle of the grid
  mesh.points = PointSet(points);
  const auto fast = judge_flat(Claim::kDelaunay, *mesh_of_doubles(mesh));
  REQUIRE(fast);
  CHECK(!fast->verdict.holds());
  CHECK(text_of(fast->verdict, fast->named) == text_of(delaunay(mesh), mesh));
  CHECK(fast->named.simplices.size() < 40);
  CHECK(fast->named.points.size() < 40);
}

TEST_CASE("meshes that are no arrays of doubles are not judged so") {
  const PointSet square({{0, 0}, {1, 0}, {0, 1}, {Rational(1) / 3, 1}});
  CHECK(!mesh_of_doubles({square, {{0, 1, 2}, {1, 3, 2}}}));
  const PointSet heavy({{0, 0}, {1, 0}, {0, 1}}, {Rational(1) / 3, 0, 0});
  CHECK(!mesh_of_doubles({heavy, {{0, 1, 2}}}));
  const PointSet good({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  CHECK(mesh_of_doubles({good, {{0, 1, 2}, {1, 3, 2}}}));
  CHECK(!mesh_of_doubles({good, {{0, 1, 2}, {1, 3}}}));
  CHECK(!mesh_of_doubles({good, {}}));
  CHECK(!mesh_of_doubles({good, {{0, 1, Vertex{1} << 40}, {1, 3, 2}}}));
  CHECK(!mesh_of_doubles({good, {{0, 1, -2}, {1, 3, 2}}}));
  // A neighbour before the first, counted from 1, is not "none".
  Mesh listed{good, {{0, 1, 2}, {1, 3, 2}}};
  listed.neighbors = Neighbors{{{2, -1, -1}, {-1, 1, -1}}, 1};
  CHECK(mesh_of_doubles(listed)->neighbors->row(0)[0] == 1);
  CHECK(judge_as_doubles(Claim::kDelaunay, listed).has_value());
  listed.neighbors->rows[0][1] = 0;
  CHECK(!mesh_of_doubles(listed));
  CHECK(
      !judge_as_doubles(Claim::kDelaunay, {good, {{0, 1, 2}, {1, 3, 2}}}, {.by = By::kDefinition}));
}

TEST_CASE("no fast verdict by definition, about a domain, or beyond space") {
  const std::string path = meshes_below("/accept").front();
  const auto flat = formats::read_flat_mesh({path});
  REQUIRE(flat);
  CHECK(!judge_flat(Claim::kDelaunay, *flat, {.by = By::kDefinition}));
  CHECK(!judge_flat(Claim::kCdt, *flat));
  CHECK(!judge_flat(Claim::kDelaunay, formats::FlatMesh{}));
}

}  // namespace circumspect::check
