// Judges every Voronoi diagram of corpus/voronoi, by lemma and by definition.
#include <fstream>

#include <doctest/doctest.h>

#include "corpus/voronoi_table.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/voronoi_file.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"

namespace circumspect::corpus {
namespace {

constexpr std::size_t kTooManyByDefinition = 20;

VoronoiDiagram diagram_of(const VoronoiRow& row) {
  const auto points = formats::read_points(kVoronoiFolder + row.sites, NumberReading::kDouble);
  const auto source = formats::load(kVoronoiFolder + row.cells);
  REQUIRE(points);
  REQUIRE(source);
  auto file = formats::read_voronoi(*source, NumberReading::kDouble);
  REQUIRE(file);
  return {PointSet(points->points.points.points()), file->vertices, file->cells, file->neighbors,
          file->ridges};
}

}  // namespace

TEST_CASE("each diagram breaks the rule that its table names, or holds") {
  std::size_t by_definition = 0;
  for (const VoronoiRow& row : voronoi_rows()) {
    INFO(row.cells);
    const VoronoiDiagram diagram = diagram_of(row);
    const Rational distance = row.is_rounded ? Rational(1, 1'000'000'000'000) : Rational(0);
    for (const bool definition : {false, true}) {
      if (definition && diagram.sites.size() > kTooManyByDefinition) continue;
      by_definition += definition ? 1 : 0;
      const Verdict verdict =
          check::judge_voronoi(diagram, {}, distance * distance, definition, 1, row.has_structure);
      CHECK(broken_rules(verdict) == row.broken);
    }
  }
  CHECK(by_definition >= 6);
}

}  // namespace circumspect::corpus
