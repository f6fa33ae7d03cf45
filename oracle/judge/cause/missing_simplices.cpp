// Simplices that are missing: holes that have the facets of one simplex.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/judge/cause/rows.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// So many points without a simplex are tried as the missing corner.
constexpr std::size_t kMostUnused = 16;
// With more simplices than this, those that fit exactly into holes are not judged with the others,
// which would take as long as the verdict did.
constexpr std::size_t kMostMended = 50'000;

// The holes of a mesh: what bare facets enclose between them and with the convex hull.
class Holes {
 public:
  explicit Holes(const Mesh& mesh) : mesh_(mesh), bare_(bare_facets(mesh)), joined_(bare_.size()) {
    join();
  }

  // The simplices, ascending, all of whose facets are bare and have them on the outer side.
  std::vector<Simplex> closed() const {
    std::vector<Simplex> found;
    for (const Simplex& simplex : pairs_) {
      if (has_bare_facets(simplex)) found.push_back(simplex);
    }
    return found;
  }

  // Those between two or more bare facets that no others are joined to.
  std::vector<Simplex> open() {
    std::map<std::size_t, std::set<Vertex>> groups;
    std::map<std::size_t, std::size_t> sizes;
    for (std::size_t i = 0; i < bare_.size(); ++i) {
      groups[joined_.find(i)].insert(bare_[i].facet.begin(), bare_[i].facet.end());
      ++sizes[joined_.find(i)];
    }
    std::vector<Simplex> found;
    for (const auto& [group, vertices] : groups) {
      if (sizes[group] > 1 && vertices.size() == mesh_.dimension() + 1) {
        found.emplace_back(vertices.begin(), vertices.end());
      }
    }
    return found;
  }

  // Those that join a point without a simplex to the only bare facet that it is beyond.
  std::vector<Simplex> at(const std::vector<Vertex>& unused) const {
    std::vector<Simplex> found;
    for (const Vertex v : unused) {
      const BareFacet* only = nullptr;
      std::size_t count = 0;
      for (const BareFacet& facet : bare_) {
        if (!is_beyond(mesh_, facet, v)) continue;
        only = &facet;
        ++count;
      }
      if (count != 1) continue;
      found.push_back(only->facet);
      found.back().push_back(v);
    }
    return found;
  }

 private:
  // Two facets with a common ridge enclose something if each is beyond the other.
  void join() {
    std::vector<Simplex> facets;
    for (const BareFacet& one : bare_) facets.push_back(one.facet);
    for (const auto group : ByFacet(facet_uses(facets))) {
      for (std::size_t i = 0; i < group.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const BareFacet &a = bare_[group[i].simplex], &b = bare_[group[j].simplex];
          const Vertex far_a = a.facet[group[i].opposite], far_b = b.facet[group[j].opposite];
          if (!is_beyond(mesh_, a, far_b) || !is_beyond(mesh_, b, far_a)) continue;
          joined_.unite(group[i].simplex, group[j].simplex);
          Simplex simplex = a.facet;
          simplex.push_back(far_b);
          pairs_.insert(sorted(std::move(simplex)));
        }
      }
    }
  }

  bool has_bare_facets(const Simplex& simplex) const {
    for (std::size_t place = 0; place < simplex.size(); ++place) {
      const Simplex facet = facet_opposite(simplex, place);
      const auto found = std::lower_bound(
          bare_.begin(), bare_.end(), facet,
          [](const BareFacet& bare, const Simplex& key) { return bare.facet < key; });
      const bool is_bare = found != bare_.end() && found->facet == facet;
      if (!is_bare || !is_beyond(mesh_, *found, simplex[place])) return false;
    }
    return true;
  }

  const Mesh& mesh_;
  std::vector<BareFacet> bare_;
  DisjointSets joined_;
  std::set<Simplex> pairs_ = {};  // the corners of two facets that are joined
};

std::vector<Vertex> unused_points(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.points(), false);
  mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      for (const auto v : lists.values()) {
        if (mesh.names(v)) is_used[static_cast<std::size_t>(v)] = true;
      }
    }
  });
  std::vector<Vertex> unused;
  for (std::size_t v = 0; v < is_used.size() && unused.size() <= kMostUnused; ++v) {
    if (!is_used[v]) unused.push_back(static_cast<Vertex>(v));
  }
  return unused;
}

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

std::string words_of(const Mesh& mesh, const std::vector<Simplex>& missing) {
  const auto noun = report::simplices_noun(static_cast<int>(mesh.dimension()), missing.size());
  const std::string first = report::labels(mesh, missing.front());
  if (missing.size() == 1) return fmt::format("1 {} is missing: {} fills the hole", noun, first);
  return fmt::format("{} {} are missing: {} and {} more fill the holes", missing.size(), noun,
                     first, missing.size() - 1);
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

}  // namespace

std::optional<Cause> missing_simplices(Case& of) {
  if (of.verdict().claim() == Claim::kComplex) return std::nullopt;
  Holes holes(of.mesh());
  std::vector<Simplex> missing = holes.closed();
  const bool are_closed = !missing.empty();
  if (!are_closed) {
    missing = holes.open();
    if (of.breaks(Rule::kUnusedPoint)) {
      const std::vector<Vertex> unused = unused_points(of.mesh());
      if (unused.size() <= kMostUnused) {
        const std::vector<Simplex> more = holes.at(unused);
        missing.insert(missing.end(), more.begin(), more.end());
      }
    }
  }
  if (missing.empty()) return std::nullopt;
  const std::string words = words_of(of.mesh(), missing);
  if (are_closed && of.mesh().simplices.size() > kMostMended) {
    return at_holes(of, words, missing);
  }
  const auto mended = of.mended(with_simplices(of.mesh(), with_more(of.mesh(), missing)));
  // A notch between two facets may be meant, unless nothing else is wrong.
  if (!mended || mended->explains == 0 || (!are_closed && !mended->holds)) return std::nullopt;
  return of.cause("missing-simplex", words, mended->explains);
}

}  // namespace circumspect::check
