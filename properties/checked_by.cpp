// Puts a checker of others to the test, as a program that `circumspect campaign` can run:
//
//     checked_by tetgen|cgal IN.node OUT.ele [RULE...]
//
// makes wrong meshes of the points, by properties/faulty (its corruptions) and
// properties/mutations, and hands each to the checker: `tetgen -rCC`, or is_valid() of CGAL's
// Delaunay_triangulation_3. The first wrong mesh that the checker calls a Delaunay triangulation
// becomes the "mesh of the program", which the campaign judges, groups by rule and makes small. If
// the checker sees through all, the exit code is 7: say --refusal-exit-code 7. What TetGen vouches
// for is the mesh that it writes. Meshes that leave out points are not tried, for who is handed
// simplices need not know of them; nor those that break one of the rules first. All follows from
// the points, which are distinct and span the space.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <optional>
#include <set>
#include <string>

#include <circumspect/judgement.hpp>
#include <rapidcheck.h>

#include "inputs/cases.hpp"
#include "inputs/in_doubles.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "properties/adapters/adapters.hpp"
#include "properties/faulty/fault.hpp"
#include "properties/mutations/mutations.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::adapters {
namespace {

constexpr int kSeesThroughAll = 7;
constexpr std::uint64_t kMutants = 24;

// The mesh that it calls Delaunay when it is handed this one; nothing, if it sees through it.
using Checker = std::function<std::optional<SimplexArray>(const PointArray&, const SimplexArray&)>;

void write_mesh(const std::string& stem, const PointArray& points, const SimplexArray& rows) {
  std::ofstream node(stem + ".node");
  node << generators::from(points);
  std::ofstream ele(stem + ".ele");
  ele << rows.size() << " 4 0\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ele << i;
    for (const std::int64_t v : rows[i]) ele << ' ' << v;
    ele << '\n';
  }
}

// What TetGen writes, if it says of it what it says when its checks find nothing.
std::optional<SimplexArray> vouched_by_tetgen(const PointArray& points, const SimplexArray& rows) {
  write_mesh("broken", points, rows);
  std::remove("broken.1.ele");
  std::FILE* const said = popen("timeout -s KILL 1 tetgen -rCC broken.ele 2>&1", "r");
  if (said == nullptr) return std::nullopt;
  std::string text;
  for (int c = std::fgetc(said); c != EOF; c = std::fgetc(said)) text += static_cast<char>(c);
  if (pclose(said) != 0 || text.find("the mesh appears to be consistent.") == std::string::npos ||
      text.find("The mesh is Delaunay.") == std::string::npos) {
    return std::nullopt;
  }
  const auto written = formats::read_mesh({.mesh = "broken.1.ele"});
  if (!written || written->mesh.exact_points() != generators::from(points).points) {
    return std::nullopt;
  }
  const std::vector<Simplex> simplices = written->mesh.simplices.lists();
  return SimplexArray(simplices.begin(), simplices.end());
}

std::optional<SimplexArray> vouched_by_cgal(const PointArray& points, const SimplexArray& rows) {
  if (cgal_is_valid_3(points, rows) != Opinion::kValid) return std::nullopt;
  return rows;
}

// Is it a list of tetrahedra of the points, in which each point is a vertex?
bool is_for_a_checker(const PointArray& points, const SimplexArray& rows) {
  std::vector<bool> used(points.size());
  for (const auto& row : rows) {
    std::vector<std::int64_t> corners = row;
    std::sort(corners.begin(), corners.end());
    if (corners.size() != 4 || corners.front() < 0 ||
        corners.back() >= static_cast<std::int64_t>(points.size()) ||
        std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
      return false;
    }
    for (const std::int64_t v : corners) used[static_cast<std::size_t>(v)] = true;
  }
  return std::find(used.begin(), used.end(), false) == used.end();
}

std::vector<SimplexArray> broken_meshes(const PointArray& points) {
  std::vector<SimplexArray> meshes;
  for (const faulty::Fault& fault : faulty::corruptions()) {
    if (!fault.oriented) meshes.push_back(fault.triangulate(points));
  }
  const PointSet set(generators::from(points).points);
  const auto right = delaunay::bowyer_watson(set).simplices();
  for (std::uint64_t seed = 0; seed < kMutants; ++seed) {
    const auto mutants = seed % 2 == 0 ? properties::alteration(right, set.size())
                                       : properties::corruption(right, set.size());
    const properties::Mutant mutant = mutants(rc::Random(seed), rc::kNominalSize).value();
    meshes.emplace_back(mutant.simplices.begin(), mutant.simplices.end());
  }
  std::erase_if(meshes, [&](const SimplexArray& rows) { return !is_for_a_checker(points, rows); });
  return meshes;
}

int run(const Checker& vouched, const std::string& in, const std::string& out,
        const std::set<std::string>& known_rules) {
  const auto read = formats::read_points(in, NumberReading::kDouble);
  if (!read) {
    std::cerr << read.error().to_string() << '\n';
    return 2;
  }
  const generators::PointsCase set{read->points.points.points(), {}};
  const bool repeats = generators::without_repeated_points(set).points.size() < set.points.size();
  if (repeats || PointSet(set.points).dimension() != 3) return kSeesThroughAll;
  const PointArray points = generators::array(set);
  for (const SimplexArray& rows : broken_meshes(points)) {
    if (judge("delaunay", points, rows).holds) continue;
    const auto vouched_for = vouched(points, rows);
    if (!vouched_for) continue;
    const Judgement judgement = judge("delaunay", points, *vouched_for);
    if (judgement.holds || known_rules.contains(judgement.rule)) continue;
    write_mesh("accepted", points, *vouched_for);
    return std::rename("accepted.ele", out.c_str()) == 0 ? 0 : 2;
  }
  return kSeesThroughAll;
}

}  // namespace
}  // namespace circumspect::adapters

int main(int count, char** arguments) {
  using namespace circumspect::adapters;
  const std::string name = count >= 4 ? arguments[1] : "";
  if (name != "tetgen" && name != "cgal") {
    std::cerr << "usage: checked_by tetgen|cgal IN.node OUT.ele [RULE...]\n";
    return 2;
  }
  return run(name == "tetgen" ? vouched_by_tetgen : vouched_by_cgal, arguments[2], arguments[3],
             {arguments + 4, arguments + count});
}
