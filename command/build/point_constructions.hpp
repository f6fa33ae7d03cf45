// The constructions of the canonical Delaunay triangulation, by the names that users type.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "command/build/steps.hpp"
#include "kernel/complex/triangulation.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::cli {

// What a construction may be told, and what it may tell. Orders and locations concern
// Bowyer–Watson.
struct ConstructionOptions {
  delaunay::BowyerWatsonOptions bowyer_watson = {};
  delaunay::Statistics* statistics = nullptr;
  Steps* steps = nullptr;
};

using Construction = std::function<Triangulation(const PointSet&, const ConstructionOptions&)>;

// All give the same set of simplices. A new algorithm is one line here.
const std::map<std::string, Construction>& constructions();

// "bowyer-watson|by-definition|…"
std::string construction_names();

}  // namespace circumspect::cli
