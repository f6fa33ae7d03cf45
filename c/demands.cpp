#include "c/demands.hpp"

#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "c/guard.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::c {
namespace {

struct Demand {
  std::string_view word;
  Claim claim;
  void (*set)(check::Options&);
};

constexpr Demand kDemands[] = {
    {"manifold", Claim::kComplex, [](check::Options& o) { o.complex.manifold = true; }},
    {"connected", Claim::kComplex, [](check::Options& o) { o.complex.connected = true; }},
    {"closed", Claim::kComplex, [](check::Options& o) { o.complex.closed = true; }},
    {"faces", Claim::kComplex, [](check::Options& o) { o.complex.faces = true; }},
    {"oriented=positive", Claim::kComplex,
     [](check::Options& o) { o.complex.oriented = Orientations::kPositive; }},
    {"oriented=negative", Claim::kComplex,
     [](check::Options& o) { o.complex.oriented = Orientations::kNegative; }},
    {"allow-hanging-vertex", Claim::kComplex,
     [](check::Options& o) { o.complex.allow_hanging = true; }},
    {"allow-unused", Claim::kComplex, [](check::Options& o) { o.complex.allow_unused = true; }},
    {"all-boundary-points", Claim::kConvexHull,
     [](check::Options& o) { o.hull.all_boundary_points = true; }},
    {"only-extreme", Claim::kConvexHull, [](check::Options& o) { o.hull.only_extreme = true; }},
};

}  // namespace

void set_demands(const char* demands, Claim claim, check::Options& options) {
  std::istringstream words(demands == nullptr ? "" : demands);
  for (std::string word; words >> word;) {
    std::string known;
    bool is_known = false;
    for (const Demand& one : kDemands) {
      if (one.claim != claim) continue;
      known += fmt::format(" {}", one.word);
      if (one.word != word) continue;
      one.set(options);
      is_known = true;
    }
    if (is_known) continue;
    refuse_call(fmt::format("expected demands of the claim {}, {}; found '{}'", name(claim),
                            known.empty() ? "which has none" : "some of" + known,
                            on_one_line(word)));
  }
}

}  // namespace circumspect::c
