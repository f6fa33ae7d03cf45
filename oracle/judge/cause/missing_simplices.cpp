// Simplices that are missing: holes that have the facets of one simplex.
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/judge/cause/rows.hpp"
#include "oracle/judge/cause/surface_edges.hpp"
#include "oracle/judge/quality/exact_measure.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// So many points without a simplex are tried as the missing corner.
constexpr std::size_t kMostUnused = 16;
// With more simplices than this, those that fit exactly into holes are not judged with the others,
// which would take as long as the verdict did.
constexpr std::size_t kMostMended = 50'000;

// The longest edge over the least height: what is thinner was hardly left out on purpose.
constexpr long kThin = 1'000'000;

// Bare facets, found by their vertices.
class BareFacets {
 public:
  BareFacets(const Mesh& mesh, const std::vector<BareFacet>& bare)
      : mesh_(mesh), bare_(bare), first_at_(mesh.points() + 1, 0) {
    side_of_apex_.reserve(bare.size());
    for (const BareFacet& facet : bare) {
      side_of_apex_.push_back(static_cast<signed char>(side_of(mesh, facet, facet.apex)));
      ++first_at_[static_cast<std::size_t>(facet.facet.front()) + 1];
    }
    std::partial_sum(first_at_.begin(), first_at_.end(), first_at_.begin());
  }

  std::size_t size() const { return bare_.size(); }
  const Simplex& vertices(std::size_t i) const { return bare_[i].facet; }

  // Is the point strictly on the other side of the facet than its apex?
  bool is_beyond(std::size_t i, Vertex point) const {
    return side_of(mesh_, bare_[i], point) * side_of_apex_[i] < 0;
  }

  std::optional<std::size_t> find(std::span<const Vertex> facet) const {
    const auto v = static_cast<std::size_t>(facet.front());
    for (std::size_t i = first_at_[v]; i < first_at_[v + 1]; ++i) {
      if (std::equal(facet.begin(), facet.end(), bare_[i].facet.begin())) return i;
    }
    return std::nullopt;
  }

 private:
  const Mesh& mesh_;
  const std::vector<BareFacet>& bare_;
  std::vector<std::size_t> first_at_;  // of the facets whose first vertex is that point
  std::vector<signed char> side_of_apex_ = {};
};

// The holes of a mesh: what bare facets enclose between them and with the convex hull.
class Holes {
 public:
  Holes(const Mesh& mesh, const std::vector<BareFacet>& bare)
      : corners_(mesh.dimension() + 1), bare_(mesh, bare), joined_(bare.size()) {
    join();
  }

  // The simplices, ascending, all of whose facets are bare and have them on the outer side.
  std::vector<Simplex> closed() const {
    std::vector<Simplex> found;
    for (const Corners& simplex : pairs_) {
      if (has_bare_facets(simplex)) {
        found.emplace_back(simplex.begin(),
                           simplex.begin() + static_cast<std::ptrdiff_t>(corners_));
      }
    }
    return found;
  }

  // Those between two or more bare facets that no others are joined to.
  std::vector<Simplex> open() {
    std::map<std::size_t, std::set<Vertex>> groups;
    for (std::size_t i = 0; i < bare_.size(); ++i) {
      const Simplex& facet = bare_.vertices(i);
      groups[joined_.find(i)].insert(facet.begin(), facet.end());
    }
    std::vector<Simplex> found;
    for (const auto& [group, vertices] : groups) {
      if (vertices.size() == corners_) found.emplace_back(vertices.begin(), vertices.end());
    }
    return found;
  }

  // Those, ascending, that join a point without a simplex to the only bare facet that it is beyond.
  std::vector<Simplex> at(const std::vector<Vertex>& unused) const {
    std::vector<Simplex> found;
    for (const Vertex v : unused) {
      std::size_t only = 0, count = 0;
      for (std::size_t i = 0; i < bare_.size(); ++i) {
        if (!bare_.is_beyond(i, v)) continue;
        only = i;
        ++count;
      }
      if (count != 1) continue;
      Simplex simplex = bare_.vertices(only);
      simplex.push_back(v);
      found.push_back(sorted(std::move(simplex)));
    }
    return found;
  }

 private:
  using Corners = std::array<Vertex, 4>;  // ascending; in the plane, the last counts for nothing

  struct RidgeUse {
    std::array<Vertex, 2> ridge;  // ascending; in the plane, the last counts for nothing
    std::size_t facet;
    Vertex far;
  };

  std::vector<RidgeUse> ridge_uses() const {
    std::vector<RidgeUse> uses;
    uses.reserve(bare_.size() * (corners_ - 1));
    for (std::size_t i = 0; i < bare_.size(); ++i) {
      const Simplex& facet = bare_.vertices(i);
      for (const Vertex far : facet) {
        RidgeUse use{{}, i, far};
        std::copy_if(facet.begin(), facet.end(), use.ridge.begin(),
                     [far](Vertex v) { return v != far; });
        uses.push_back(use);
      }
    }
    std::sort(uses.begin(), uses.end(), [](const RidgeUse& a, const RidgeUse& b) {
      return std::tie(a.ridge, a.facet) < std::tie(b.ridge, b.facet);
    });
    return uses;
  }

  // Two facets with a common ridge enclose something if each is beyond the other.
  void join() {
    const std::vector<RidgeUse> uses = ridge_uses();
    for (std::size_t i = 0, first = 0; i < uses.size(); ++i) {
      if (uses[i].ridge != uses[first].ridge) first = i;
      for (std::size_t j = first; j < i; ++j) {
        const RidgeUse &a = uses[i], &b = uses[j];
        if (!bare_.is_beyond(a.facet, b.far) || !bare_.is_beyond(b.facet, a.far)) continue;
        joined_.unite(a.facet, b.facet);
        const Simplex& facet = bare_.vertices(a.facet);
        Corners simplex = {};
        std::merge(facet.begin(), facet.end(), &b.far, &b.far + 1, simplex.begin());
        pairs_.push_back(simplex);
      }
    }
    keep_each_once(pairs_);
  }

  bool has_bare_facets(const Corners& simplex) const {
    for (std::size_t place = 0; place < corners_; ++place) {
      std::array<Vertex, 3> facet = {};
      std::size_t size = 0;
      for (std::size_t k = 0; k < corners_; ++k) {
        if (k != place) facet[size++] = simplex[k];
      }
      const auto found = bare_.find(std::span(facet).first(size));
      if (!found || !bare_.is_beyond(*found, simplex[place])) return false;
    }
    return true;
  }

  std::size_t corners_;  // of a simplex
  BareFacets bare_;
  DisjointSets joined_;
  std::vector<Corners> pairs_ = {};  // the corners of two facets that are joined, ascending
};

IndexLists with_more(const Mesh& mesh, const std::vector<Simplex>& more) {
  return mesh.simplices.visit([&]<class Lists>(const Lists& lists) -> IndexLists {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return {};
    } else {
      Lists all(lists.rows() + more.size(), lists.columns());
      auto to = std::copy(lists.values().begin(), lists.values().end(), all.values().begin());
      for (const Simplex& simplex : more) to = std::copy(simplex.begin(), simplex.end(), to);
      return all;
    }
  });
}

// Programs with a tolerance take points for collinear, or coplanar, that are nearly so. The square
// of the greatest height of all, if each is thin.
std::optional<Rational> squared_height_of_slivers(int dimension, const Mesh& mesh,
                                                  const std::vector<Simplex>& missing) {
  Rational greatest = 0;
  for (const Simplex& simplex : missing) {
    const auto ratio = quality::measured(Measure::kAspectRatio, mesh, simplex, dimension);
    if (!ratio || ratio->value < Rational(kThin) * kThin) return std::nullopt;
    const auto edge = quality::measured(Measure::kEdge, mesh, simplex, dimension);
    greatest = std::max<Rational>(greatest, edge->value / ratio->value);
  }
  return greatest;
}

std::string words_of(int dimension, const Mesh& mesh, const std::vector<Simplex>& missing) {
  const std::size_t count = missing.size();
  const auto noun = report::simplices_noun(dimension, count);
  const std::string first = report::labels(mesh, missing.front());
  const auto height = squared_height_of_slivers(dimension, mesh, missing);
  const std::string thin =
      !height ? ""
              : fmt::format(", {} {} high, as if {} corners were taken for {}",
                            count == 1 ? "at most" : "each at most",
                            report::square_root_rounded_up(*height), count == 1 ? "its" : "their",
                            dimension == 2 ? "collinear" : "coplanar");
  if (count == 1) return fmt::format("1 {} is missing: {} fills the hole{}", noun, first, thin);
  return fmt::format("{} {} are missing: {} and {} more fill the holes{}", count, noun, first,
                     count - 1, thin);
}

// What simplices explain that fit exactly into holes: the violations at their faces.
Cause at_holes(const Case& of, const std::string& words, const std::vector<Simplex>& missing) {
  const std::vector<Violation>& listed = of.verdict().violations();
  Cause cause{"missing-simplex", words, 0, listed.size(), listed.size() < of.violations()};
  for (const Violation& violation : listed) {
    const auto& face = violation.witness.face;
    const bool is_there = face && std::any_of(missing.begin(), missing.end(),
                                              [&](const Simplex& s) { return has_face(s, *face); });
    cause.explains += is_there ? 1 : 0;
  }
  return cause;
}

// Does the verdict name a facet that nothing covers, an edge that a segment lacks, or a vertex that
// is no point of the mesh, and would these leave it so? With them the claim would not hold, either,
// which would take as long to find out as the verdict did.
bool leave_faults(const Case& of, const std::vector<Simplex>& missing) {
  // How far the domain's cells have to be moved depends on all simplices.
  if (of.verdict().within || of.verdict().beyond) return false;
  const auto are_face_of_one = [&](const Simplex& face) {
    return std::any_of(missing.begin(), missing.end(),
                       [&](const Simplex& simplex) { return has_face(simplex, face); });
  };
  // A point that gets a simplex may cut the edge in two.
  const bool may_be_cut = of.breaks(Rule::kUnusedPoint);
  const std::vector<Violation>& listed = of.verdict().violations();
  return std::any_of(listed.begin(), listed.end(), [&](const Violation& violation) {
    const Witness& witness = violation.witness;
    const bool is_bare = violation.rule == Rule::kUncovered && witness.simplices.size() == 1;
    const bool is_absent = violation.rule == Rule::kSegmentMissing && !may_be_cut;
    const bool has_no_point = violation.rule == Rule::kDomainVertexMissing && witness.point;
    return has_no_point ||
           ((is_bare || is_absent) && witness.face && !are_face_of_one(*witness.face));
  });
}

// Where the walls of a domain are not convex, facets enclose a notch that is meant. Of a hole the
// verdict names a face, if it names one for each violation and lists them all.
void leave_out_notches(const Case& of, std::vector<Simplex>& missing) {
  const std::vector<Violation>& listed = of.verdict().violations();
  if (listed.size() < of.violations() ||
      !std::all_of(listed.begin(), listed.end(),
                   [](const Violation& one) { return one.witness.face.has_value(); })) {
    return;
  }
  std::erase_if(missing, [&](const Simplex& simplex) {
    return std::none_of(listed.begin(), listed.end(),
                        [&](const Violation& one) { return has_face(simplex, *one.witness.face); });
  });
}

// Around each of the holes of a surface three edges go.
std::optional<Cause> missing_in_surface(Case& of) {
  const auto loops = loops_of(edges_of_holes(of));
  if (!loops || loops->empty()) return std::nullopt;
  const auto is_of_three = [](const std::vector<Vertex>& loop) { return loop.size() == 3; };
  if (!std::all_of(loops->begin(), loops->end(), is_of_three)) return std::nullopt;
  const auto mended = of.mended(with_simplices(of.mesh(), with_more(of.mesh(), *loops)));
  if (!mended || mended->explains == 0) return std::nullopt;
  return of.cause("missing-simplex", words_of(2, of.mesh(), *loops), mended->explains);
}

}  // namespace

std::optional<Cause> missing_simplices(Case& of) {
  if (of.verdict().claim() == Claim::kComplex) return missing_in_surface(of);
  Holes holes(of.mesh(), of.bare());
  std::vector<Simplex> missing = holes.closed();
  const bool are_closed = !missing.empty();
  if (!are_closed) {
    missing = holes.open();
    if (of.breaks(Rule::kUnusedPoint)) {
      const std::vector<Vertex> unused = unused_points(of.mesh(), kMostUnused);
      if (unused.size() <= kMostUnused) {
        const std::vector<Simplex> more = holes.at(unused);
        missing.insert(missing.end(), more.begin(), more.end());
      }
    }
    leave_out_notches(of, missing);
  }
  if (missing.empty()) return std::nullopt;
  const auto words = [&] {
    return words_of(static_cast<int>(of.mesh().dimension()), of.mesh(), missing);
  };
  if (are_closed && of.mesh().simplices.size() > kMostMended) {
    return at_holes(of, words(), missing);
  }
  if (!are_closed && leave_faults(of, missing)) return std::nullopt;
  const auto mended = of.mended(with_simplices(of.mesh(), with_more(of.mesh(), missing)));
  // A notch between two facets may be meant, unless nothing else is wrong.
  if (!mended || mended->explains == 0 || (!are_closed && !mended->holds)) return std::nullopt;
  return of.cause("missing-simplex", words(), mended->explains);
}

}  // namespace circumspect::check
