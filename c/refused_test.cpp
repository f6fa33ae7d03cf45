// Wrong calls, null handles and exhausted memory: every path is safe.
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <random>
#include <string>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

#include "c/calls_test.hpp"

// Allocations of this program fail from a given one on, so that every path without memory is taken.
namespace {
thread_local long allocations_left = -1;  // −1: any number

void* allocated(std::size_t size) {
  if (allocations_left == 0) throw std::bad_alloc();
  if (allocations_left > 0) --allocations_left;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace

void* operator new(std::size_t size) { return allocated(size); }
void* operator new[](std::size_t size) { return allocated(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocated(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace circumspect::c {
namespace {

TEST_CASE("calls that are wrong are refused, and say what was expected") {
  const auto refused = [](auto change, const std::string& message,
                          circumspect_status expected = CIRCUMSPECT_INVALID_ARGUMENT) {
    circumspect_mesh mesh = mesh_of(kPoints, kRight);
    change(mesh);
    CHECK(check("delaunay", &mesh).status == expected);
    INFO(circumspect_last_error());
    CHECK(has(circumspect_last_error(), message));
  };
  refused([](auto& mesh) { mesh.struct_size = 3; }, "CIRCUMSPECT_MESH");
  refused([](auto& mesh) { mesh.dimension = 0; }, "a dimension from 1 to 64, found 0");
  refused([](auto& mesh) { mesh.dimension = -2; }, "found -2");
  refused([](auto& mesh) { mesh.point_count = -1; }, "a number of points, found -1");
  refused([](auto& mesh) { mesh.point_count = std::numeric_limits<std::int64_t>::max(); },
          "expected fewer points");
  refused([](auto& mesh) { mesh.coordinates = nullptr; }, "expected coordinates, found NULL");
  refused([](auto& mesh) { mesh.simplex_count = -5; }, "a number of simplices, found -5");
  refused([](auto& mesh) { mesh.vertices_of_simplex = -1; }, "found -1");
  refused([](auto& mesh) { mesh.vertices_of_simplex = 0; }, "vertices of a simplex, found 0");
  refused([](auto& mesh) { mesh.simplices = nullptr; }, "expected simplices, found NULL");
  refused([](auto& mesh) { mesh.index_bytes = 2; }, "4 or 8 bytes, found 2");
  refused([](auto& mesh) { mesh.triangle_count = 1; }, "expected triangles, found NULL");
  refused([](auto& mesh) { mesh.edge_count = -1; }, "a number of edges, found -1");
  static const std::vector<double> infinite = {0, 0, 1, 0, 0, HUGE_VAL, 0.9, 0.9};
  refused([](auto& mesh) { mesh.coordinates = infinite.data(); }, "found inf at place 5",
          CIRCUMSPECT_INPUT_FAULT);

  const circumspect_mesh mesh = mesh_of(kPoints, kRight);
  CHECK(check("", &mesh).status == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(check("delauney", &mesh).status == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "one of triangulation delaunay weighted-delaunay"));
  CHECK(check("cdt", &mesh).status == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(check("delaunay", nullptr).status == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(circumspect_check("delaunay", &mesh, nullptr, nullptr, nullptr) ==
        CIRCUMSPECT_INVALID_ARGUMENT);
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.threads = -1;
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  options = CIRCUMSPECT_OPTIONS;
  options.max_violations = -1;
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  options.struct_size = 0;
  CHECK(check("delaunay", &mesh, nullptr, &options).status == CIRCUMSPECT_INVALID_ARGUMENT);
  circumspect_domain domain = square();
  CHECK(check("delaunay", &mesh, &domain).status == CIRCUMSPECT_INVALID_ARGUMENT);
  domain.segment_count = -1;
  CHECK(check("cdt", &mesh, &domain).status == CIRCUMSPECT_INVALID_ARGUMENT);
  domain = square();
  domain.struct_size = 1;
  CHECK(check("cdt", &mesh, &domain).status == CIRCUMSPECT_INVALID_ARGUMENT);
  domain = square();
  domain.point_count = 0;
  CHECK(check("cdt", &mesh, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  domain = tetrahedron();
  CHECK(check("cdt", &mesh, &domain).status == CIRCUMSPECT_INPUT_FAULT);
  CHECK(has(circumspect_last_error(), "points of dimension 3, as those of the domain, found 2"));
}

// Structs whose members hold anything. No count that is accepted is larger than the arrays.
class AnyMembers {
 public:
  template <class... Choices>
  auto one_of(Choices... choices) {
    const std::array<std::common_type_t<Choices...>, sizeof...(choices)> all = {choices...};
    return all[random_() % all.size()];
  }

  void draw_arrays() {
    for (double& x : numbers_) x = one_of(0.0, 1.0, 2.0, 0.5, -1.0, 1e308, 5e-324);
    if (one_of(0, 1, 2, 3, 4, 5, 6, 7) == 0) {
      numbers_[one_of(0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U)] = one_of(HUGE_VAL, std::nan(""));
    }
    for (std::int64_t& v : indices_) v = one_of(std::int64_t{0}, 1, 2, 3, 3, -1, kMost, kLeast);
    starts_ = {0, one_of(std::int64_t{1}, 1, 1, -1), 2, 3, one_of(std::int64_t{4}, 4, 4, kMost)};
    lines_ = {0, 3, one_of(std::int64_t{6}, 6, 6, kMost), 9, 12};
  }

  circumspect_mesh mesh() {
    circumspect_mesh mesh = CIRCUMSPECT_MESH;
    mesh.dimension = one_of(std::int64_t{2}, 2, 2, 3, 1, 0, kMost);
    mesh.point_count = count();
    mesh.coordinates =
        one_of(numbers_.data(), numbers_.data(), numbers_.data(), static_cast<double*>(nullptr));
    mesh.weights = one_of(numbers_.data(), static_cast<double*>(nullptr));
    mesh.simplex_count = count();
    mesh.vertices_of_simplex = one_of(std::int64_t{3}, 3, 3, 2, 4, 0, -2);
    mesh.index_bytes = one_of(std::int64_t{4}, 8, 8, 3);
    mesh.simplices = one_of(indices_.data(), indices_.data(), static_cast<std::int64_t*>(nullptr));
    mesh.neighbors = one_of(indices_.data(), static_cast<std::int64_t*>(nullptr));
    mesh.edge_count = one_of(std::int64_t{0}, 2, -1, kMost);
    mesh.edges = indices_.data();
    return mesh;
  }

  circumspect_domain domain() {
    circumspect_domain domain = CIRCUMSPECT_DOMAIN;
    domain.dimension = one_of(std::int64_t{2}, 3);
    domain.point_count = count();
    domain.coordinates = numbers_.data();
    domain.segment_count = count();
    domain.segments = indices_.data();
    domain.polygon_count = domain.dimension == 3 ? one_of(std::int64_t{4}, 1, 0, -1) : 0;
    domain.polygon_starts = starts_.data();
    domain.line_starts = lines_.data();
    domain.corners = indices_.data();
    domain.polygon_hole_count = one_of(std::int64_t{0}, 0, 1, 2, -1, kMost);
    domain.polygons_of_holes = indices_.data();
    domain.polygon_hole_seeds = numbers_.data();
    return domain;
  }

 private:
  static constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  static constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

  std::int64_t count() {
    return one_of(std::int64_t{-1}, 0, 1, 2, 3, 4, 4, kLeast, kMost, kMost / 8);
  }

  std::mt19937_64 random_{20260101};
  std::vector<double> numbers_ = std::vector<double>(64);
  std::vector<std::int64_t> indices_ = std::vector<std::int64_t>(64);
  std::vector<std::int64_t> starts_, lines_;
};

TEST_CASE("whatever the members hold, the answer is a status") {
  AnyMembers any;
  std::size_t judged = 0;
  for (int round = 0; round < 4000; ++round) {
    any.draw_arrays();
    const circumspect_mesh mesh = any.mesh();
    const circumspect_domain domain = any.domain();
    circumspect_options options = CIRCUMSPECT_OPTIONS;
    options.with_pictures = any.one_of(0, 1);
    const bool with_domain = any.one_of(true, false, false);
    circumspect_verdict* verdict = nullptr;
    const circumspect_status status = circumspect_check(
        with_domain ? "cdt" : any.one_of("delaunay", "weighted-delaunay", "triangulation"), &mesh,
        with_domain ? &domain : nullptr, &options, &verdict);
    CHECK(status != CIRCUMSPECT_INTERNAL_ERROR);
    CHECK((status == CIRCUMSPECT_OK) == (verdict != nullptr));
    judged += verdict != nullptr;
    circumspect_verdict_free(verdict);
  }
  CHECK(judged > 20);
}

TEST_CASE("drawings that cannot be made are refused") {
  const auto refused = [](const char* family, std::int64_t dimension, std::int64_t points,
                          const std::string& message) {
    circumspect_drawing* drawing = nullptr;
    CHECK(circumspect_generate(family, dimension, points, 1, &drawing) ==
          CIRCUMSPECT_INVALID_ARGUMENT);
    CHECK(drawing == nullptr);
    INFO(circumspect_last_error());
    CHECK(has(circumspect_last_error(), message));
  };
  refused(nullptr, 3, 12, "the name of a family, found NULL");
  refused("spheres", 3, 12, "found 'spheres'");
  refused("a\nb", 3, 12, "found 'a\\x0");
  refused("protected-solids", 3, 12, "a family of points");
  refused("sphere", 1, 12,
          "sphere exists in dimension 2 and above; expected such a dimension, found 1");
  refused("sphere", -1, 12, "found -1");
  refused("sphere", 3, 0, "from 1 to 1000000 points, found 0");
  refused("sphere", 3, std::numeric_limits<std::int64_t>::max(), "found 9223372036854775807");
  CHECK(circumspect_generate("sphere", 3, 12, 1, nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
  circumspect_drawing* drawing = nullptr;
  for (const char* const family : {"sphere", "a\nb", static_cast<const char*>(nullptr)}) {
    CHECK(circumspect_generate_domain(family, 12, 1, &drawing) == CIRCUMSPECT_INVALID_ARGUMENT);
    CHECK(has(circumspect_last_error(), "the name of a family"));
  }
  CHECK(circumspect_generate_domain("planar-grid", 0, 1, &drawing) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_last_error(), "from 1 to 1000000 points, found 0"));
  CHECK(circumspect_generate_domain("planar-grid", 9, 1, nullptr) == CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(drawing == nullptr);
}

TEST_CASE("no handle at all") {
  circumspect_verdict_free(nullptr);
  circumspect_triangulation_free(nullptr);
  circumspect_document_free(nullptr);
  circumspect_drawing_free(nullptr);
  CHECK(circumspect_drawing_mesh(nullptr) == nullptr);
  CHECK(circumspect_drawing_domain(nullptr) == nullptr);
  CHECK(circumspect_verdict_holds(nullptr) == -1);
  CHECK(circumspect_verdict_unique(nullptr) == -1);
  CHECK(circumspect_verdict_canonical(nullptr) == -1);
  CHECK(std::string(circumspect_verdict_text(nullptr)).empty());
  CHECK(std::string(circumspect_verdict_json(nullptr)).empty());
  CHECK(circumspect_verdict_rule_count(nullptr) == 0);
  CHECK(circumspect_verdict_violation_count(nullptr) == 0);
  CHECK(circumspect_triangulation_dimension(nullptr) == -1);
  CHECK(circumspect_triangulation_simplices(nullptr, 3, nullptr) == 0);
  CHECK(std::string(circumspect_document_text(nullptr)).empty());
  circumspect_violation violation;
  CHECK(circumspect_verdict_violation(nullptr, 0, &violation, sizeof violation) ==
        CIRCUMSPECT_INVALID_ARGUMENT);
  CHECK(has(circumspect_version(), "."));
}

TEST_CASE("where memory ends, at whatever allocation, the call says so and nothing is lost") {
  const circumspect_mesh wrong = mesh_of(kPoints, kWrong);
  const std::vector<std::int32_t> halves = {0, 1, 2, 0, 2, 3};
  const circumspect_mesh mesh = mesh_of(kCorners, halves);
  const circumspect_domain domain = square();
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.threads = 1;
  options.without_json = 1;
  const auto survives = [](auto call) {
    for (long count = 0; count < 20000; ++count) {
      allocations_left = count;
      const circumspect_status status = call();
      allocations_left = -1;
      if (status == CIRCUMSPECT_OK) return count;
      REQUIRE(status == CIRCUMSPECT_OUT_OF_MEMORY);
      REQUIRE(has(circumspect_last_error(), "more memory"));
    }
    return -1L;
  };
  circumspect_verdict* verdict = nullptr;
  CHECK(survives([&] {
          return circumspect_check("delaunay", &wrong, nullptr, &options, &verdict);
        }) > 10);
  circumspect_verdict_free(verdict);
  CHECK(survives([&] { return circumspect_check("cdt", &mesh, &domain, &options, &verdict); }) >
        10);
  circumspect_verdict_free(verdict);
  circumspect_triangulation* built = nullptr;
  CHECK(survives([&] { return circumspect_delaunay(&mesh, &built); }) > 10);
  circumspect_triangulation_free(built);
  circumspect_drawing* drawing = nullptr;
  CHECK(survives([&] { return circumspect_generate("sphere+ulp", 2, 5, 1, &drawing); }) > 10);
  circumspect_drawing_free(drawing);
  CHECK(survives([&] { return circumspect_generate_domain("planar-segments", 3, 1, &drawing); }) >
        10);
  circumspect_drawing_free(drawing);
  circumspect_document* document = nullptr;
  int answer = 0;
  CHECK(survives([&] { return circumspect_certify("delaunay", &wrong, &answer, &document); }) > 10);
  circumspect_document_free(document);
}

}  // namespace
}  // namespace circumspect::c
