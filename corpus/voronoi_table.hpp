// The rows of voronoi/expected.tsv, for the tests in this folder.
#pragma once

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "corpus/expected_table.hpp"

namespace circumspect::corpus {

inline const std::string kVoronoiFolder = CIRCUMSPECT_CORPUS_DIR "/voronoi/";

// A diagram in qvoronoi's form, its sites, and the rules that it breaks. If corners were rounded,
// it is judged within 1e-12; its vertices and ridges are, if that is asked for.
struct VoronoiRow {
  std::string cells, sites;
  bool is_rounded = false, has_structure = false;
  std::set<std::string> broken = {};
};

inline std::vector<VoronoiRow> voronoi_rows() {
  std::ifstream file(kVoronoiFolder + "expected.tsv");
  std::vector<VoronoiRow> rows;
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> cells = split(line, '\t');
    const auto has = [&](const char* option) {
      return cells.at(2).find(option) != std::string::npos;
    };
    VoronoiRow row{cells.at(0), cells.at(1), has("--within"), has("--structure")};
    if (cells.at(3) != "holds") row.broken = {cells.at(3)};
    rows.push_back(row);
  }
  return rows;
}

}  // namespace circumspect::corpus
