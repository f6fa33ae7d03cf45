#include "oracle/judge/failing_complex.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/boundary_of.hpp"
#include "oracle/judge/complex/judge_complex.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/part_of_mesh.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::check {
namespace {

using Places = std::vector<std::size_t>;

// Some simplices of a mesh, in rows of their own.
template <std::size_t kDimension, typename Index>
struct Chosen {
  using View = fast::MeshView<kDimension, Index>;

  Chosen(const View& all, Places chosen) : places(std::move(chosen)) {
    rows.reserve(places.size() * View::kVertices);
    for (const std::size_t s : places) {
      const auto row = all.row(s);
      rows.insert(rows.end(), row.begin(), row.end());
    }
    view = {all.coordinates, {}, rows};
  }
  Chosen(const Chosen&) = delete;
  Chosen& operator=(const Chosen&) = delete;

  Places places;  // in the whole mesh, ascending
  std::vector<Index> rows = {};
  View view = {};
};

// What the fast engine finds of a mesh.
template <std::size_t kDimension, typename Index>
class Searched {
 public:
  using View = fast::MeshView<kDimension, Index>;
  static constexpr std::size_t kVertices = kDimension + 1;

  Searched(const View& listed, unsigned threads) : listed_(listed), threads_(threads) { merge(); }

  // False if it finds nothing out.
  bool run() {
    auto faults = fast::faults(merged_, fast::Question::kTriangulation, threads_);
    if (!faults) return false;
    set_apart(*faults);
    if (compared.empty()) return false;
    const bool are_all = compared.size() == merged_.size();
    const Chosen<kDimension, Index> chosen(merged_, are_all ? Places() : compared);
    const View& view = are_all ? merged_ : chosen.view;
    if (!are_all) {
      faults = fast::faults(view, fast::Question::kTriangulation, threads_);
      if (!faults) return false;
    }
    take_signs(*faults);
    if (!faults->facets_match()) {
      auto links = fast::matched_facets(view, threads_);
      if (!links) return false;
      faults->links = std::move(*links);
    }
    leave_out(view, *faults, faults->links);
    take_facets(view, faults->links);
    return true;
  }

  std::vector<Duplicate> equal = {};
  Places apart = {};     // simplices that are not compared
  Places twins = {};     // those with the vertices of another, compared or not
  Places compared = {};  // those that are
  Places improper = {};  // of these, one at least of every two that do not meet as they should
  Places turned = {};    // of these, those oriented unlike most
  std::size_t first_of_most = 0;
  std::size_t positive = 0, negative = 0;
  std::vector<std::array<Index, kDimension>> open_facets = {};
  std::vector<std::size_t> part_of = {};  // of those that are compared
  std::size_t parts = 0;

  const View& merged() const { return merged_; }

 private:
  void merge() {
    merged_ = {listed_.coordinates, {}, listed_.simplices};
    Mesh points;
    points.coordinates = Rows<double>::of(listed_.coordinates, kDimension);
    equal = equal_points(points);
    if (equal.empty()) return;
    std::map<Index, Index> first;
    for (const auto& [kept, again] : equal) {
      first.emplace(static_cast<Index>(again), static_cast<Index>(kept));
    }
    rows_.assign(listed_.simplices.begin(), listed_.simplices.end());
    for (Index& v : rows_) {
      const auto found = first.find(v);
      if (found != first.end()) v = found->second;
    }
    merged_.simplices = rows_;
  }

  std::array<Index, kVertices> set_of(std::size_t s) const {
    std::array<Index, kVertices> set;
    const auto row = merged_.row(s);
    std::copy(row.begin(), row.end(), set.begin());
    std::sort(set.begin(), set.end());
    return set;
  }

  // As definition::set_apart does.
  void set_apart(const fast::Faults& faults) {
    apart = faults.unsound;
    twins = faults.duplicates;
    std::set<std::array<Index, kVertices>> known;
    for (const std::size_t s : faults.duplicates) {
      const bool is_sound = !std::binary_search(faults.unsound.begin(), faults.unsound.end(), s);
      if (is_sound && !known.insert(set_of(s)).second) apart.push_back(s);
    }
    keep_each_once(apart);
    Places all(merged_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::set_difference(all.begin(), all.end(), apart.begin(), apart.end(),
                        std::back_inserter(compared));
  }

  // The sign of det[p_1 − p_0; …; p_d − p_0] is that of the orientation in the plane, and the other
  // in space.
  void take_signs(const fast::Faults& faults) {
    for (const std::size_t place : faults.turned) turned.push_back(compared[place]);
    const bool are_positive = (faults.orientation_of_most > 0) == (kDimension == 2);
    (are_positive ? positive : negative) = compared.size() - turned.size();
    (are_positive ? negative : positive) = turned.size();
    // Of as many of both signs the positive ones count as most, in the sense of the claim.
    if (positive == negative && !are_positive) {
      Places others;
      std::set_difference(compared.begin(), compared.end(), turned.begin(), turned.end(),
                          std::back_inserter(others));
      turned = std::move(others);
    }
    const auto turned_first = std::mismatch(turned.begin(), turned.end(), compared.begin()).second;
    first_of_most = *turned_first;
  }

  // The simplices of facets that are not of one or two simplices on opposite sides.
  static Places with_faulty_facets(const fast::Faults& faults) {
    Places found;
    for (const auto& [first, second] : faults.same_side) {
      found.insert(found.end(), {first.simplex(), second.simplex()});
    }
    for (const auto& group : faults.overused) {
      for (const fast::FacetId facet : group) found.push_back(facet.simplex());
    }
    return found;
  }

  // The facets that are in one simplex only, of those that are not left out.
  static std::vector<fast::FacetId> boundary(const fast::OwnedLinks& links,
                                             const std::vector<bool>& is_left_out) {
    std::vector<fast::FacetId> facets;
    for (std::size_t i = 0; i < links.count; ++i) {
      const std::int32_t across = links.view()[i];
      const bool is_alone = across < 0 || is_left_out[static_cast<std::size_t>(across)];
      if (is_alone && !is_left_out[i / kVertices])
        facets.emplace_back(i / kVertices, i % kVertices);
    }
    return facets;
  }

  // The simplices with which the boundary is at fault.
  static Places at_fault(const View& view, const std::vector<fast::FacetId>& facets,
                         const std::vector<bool>& is_left_out) {
    const BoundaryOf<kDimension, Index> around(view, facets);
    Places found = around.improper();
    for (std::size_t& place : found) place = facets[place].simplex();
    if (!found.empty()) return found;
    const Places pairs = around.just_outside(around.classes().unsettled);
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
      if (!is_left_out[pairs[i]]) found.insert(found.end(), {pairs[i], pairs[i + 1]});
    }
    return found;
  }

  // As left_out_of_complex does. Without those of faulty facets, all other facets are in one or two
  // simplices on opposite sides; so it stays if more are left out.
  void leave_out(const View& all, const fast::Faults& faults, const fast::OwnedLinks& links) {
    constexpr int kRounds = 12;
    std::vector<bool> is_left_out(all.size(), false);
    Places left_out = with_faulty_facets(faults);
    for (int round = 1;; ++round) {
      keep_each_once(left_out);
      if (round == kRounds || 2 * left_out.size() > all.size()) {
        left_out.resize(all.size());
        std::iota(left_out.begin(), left_out.end(), std::size_t{0});
        break;
      }
      for (const std::size_t s : left_out) is_left_out[s] = true;
      const Places more = at_fault(all, boundary(links, is_left_out), is_left_out);
      if (more.empty()) break;
      left_out.insert(left_out.end(), more.begin(), more.end());
    }
    for (const std::size_t place : left_out) improper.push_back(compared[place]);
  }

  // What facets say of all that are compared.
  void take_facets(const View& view, const fast::OwnedLinks& links) {
    std::vector<bool> is_overused(links.overused.empty() ? 0 : links.count, false);
    DisjointSets joined(view.size());
    for (const auto& group : links.overused) {
      for (const std::uint64_t facet : group) {
        is_overused[facet] = true;
        joined.unite(facet / kVertices, group.front() / kVertices);
      }
    }
    for (std::size_t i = 0; i < links.count; ++i) {
      const std::int32_t across = links.view()[i];
      if (across >= 0) {
        joined.unite(i / kVertices, static_cast<std::size_t>(across));
      } else if (is_overused.empty() || !is_overused[i]) {
        open_facets.push_back(
            fast::facet_of<kVertices, Index>(view.row(i / kVertices), i % kVertices));
      }
    }
    for (std::size_t s = 0; s < view.size(); ++s) {
      part_of.push_back(joined.find(s));
      parts += part_of.back() == s ? 1 : 0;
    }
  }

  const View& listed_;
  unsigned threads_;
  std::vector<Index> rows_ = {};  // with equal points merged, if there are any
  View merged_ = {};
};

// The simplices whose boxes meet the box of one of these.
template <std::size_t kDimension, typename Index>
Places near(const fast::MeshView<kDimension, Index>& mesh, const Places& among,
            const Places& improper) {
  if (improper.empty()) return {};
  const auto box_of = [&](std::size_t s) {
    return fast::box_of_points<kDimension>(mesh.coordinates, std::span<const Index>(mesh.row(s)));
  };
  std::vector<fast::AxisBox> boxes;
  for (const std::size_t s : improper) boxes.push_back(box_of(s));
  fast::AxisBox all = boxes.front();
  for (const fast::AxisBox& box : boxes) all.add(box);
  const fast::BoxTree tree(std::move(boxes));
  Places found;
  for (const std::size_t s : among) {
    const fast::AxisBox own = box_of(s);
    if (!own.meets(all)) continue;
    std::size_t steps = ~std::size_t{0};
    const bool meets_none = tree.all_near(
        steps, [&](const fast::AxisBox& box) { return !box.meets(own); },
        [](std::uint32_t) { return false; });
    if (!meets_none) found.push_back(s);
  }
  return found;
}

// The points that no simplex names, whatever it is.
template <std::size_t kDimension, typename Index>
Places unused_points(const fast::MeshView<kDimension, Index>& mesh) {
  std::vector<bool> is_used(mesh.points(), false);
  for (const Index v : mesh.simplices) {
    if (mesh.names_point(v)) is_used[static_cast<std::size_t>(v)] = true;
  }
  Places unused;
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) unused.push_back(v);
  }
  return unused;
}

// The simplices whose sign is not as demanded; all, if that is most of them.
template <class Found>
Places wrongly_turned(const Found& found, Orientations demanded) {
  if (demanded == Orientations::kAny) return {};
  const bool most_are_positive = found.positive >= found.negative;
  const bool most_are_right =
      demanded == Orientations::kSame || most_are_positive == (demanded == Orientations::kPositive);
  if (most_are_right) return found.turned;
  Places most;
  std::set_difference(found.compared.begin(), found.compared.end(), found.turned.begin(),
                      found.turned.end(), std::back_inserter(most));
  return most;
}

// The vertices of a face by a part's own numbers; empty if it has not all of them.
template <class Part, class Face>
Simplex in_part(const Part& part, const Face& face) {
  Simplex own;
  for (const auto v : face) {
    const Vertex place = part.place_of(v);
    if (place < 0) return {};
    own.push_back(place);
  }
  return sorted(std::move(own));
}

// The first simplex, which is in the first part and tells whether all span space, the first that is
// oriented as most, and the first of another part: what witnesses name beside what is wrong.
template <class Found>
Places first_ones(const Found& found) {
  Places ones = {found.compared.front(), found.first_of_most};
  std::size_t other = 0;
  while (other < found.part_of.size() && found.part_of[other] == found.part_of.front()) ++other;
  if (other < found.part_of.size()) ones.push_back(found.compared[other]);
  return ones;
}

// What is known of the whole mesh; the findings are about a part of it.
template <class Found, class Part>
void take_whole(const Found& whole, const Part& part, const Places& unused, Findings& found) {
  found.apart.unused_points.clear();
  for (const std::size_t v : unused) {
    found.apart.unused_points.push_back(part.place_of(static_cast<Vertex>(v)));
  }
  for (const auto& facet : whole.open_facets) {
    Simplex own = in_part(part, facet);
    if (!own.empty()) found.open_facets.push_back(std::move(own));
  }
  std::sort(found.open_facets.begin(), found.open_facets.end());
  found.boundary_facets = whole.open_facets.size();
  found.parts = whole.parts;
  found.positive = whole.positive;
  found.negative = whole.negative;
  const Places& compared = whole.compared;
  for (const std::size_t place : found.apart.compared) {
    const auto at = std::lower_bound(compared.begin(), compared.end(), part.simplices()[place]);
    found.part_of.push_back(whole.part_of[static_cast<std::size_t>(at - compared.begin())]);
  }
}

template <class Found, class Part>
Verdict verdict_of_part(const Found& whole, const Part& part, const Places& unused,
                        const ComplexDemands& demands, std::size_t max_violations) {
  const definition::ListedComplex listed = part.listed();
  std::vector<bool> may_be_improper(part.simplices().size(), false);
  for (const std::size_t s : whole.improper) may_be_improper[part.place_of_simplex(s)] = true;
  Findings found = findings_of_part(listed, may_be_improper);
  take_whole(whole, part, unused, found);
  Verdict verdict = verdict_of_findings(listed, found, demands, max_violations);
  verdict.name_in_whole(part.vertices(), part.simplices());
  return verdict;
}

}  // namespace

template <std::size_t kDimension, typename Index>
std::optional<Verdict> failing_complex(const fast::MeshView<kDimension, Index>& mesh,
                                       const ComplexDemands& demands, std::size_t max_violations,
                                       unsigned threads) {
  if (demands.manifold || demands.closed) return std::nullopt;
  Searched<kDimension, Index> whole(mesh, threads);
  if (!whole.run()) return std::nullopt;
  Places simplices = near(whole.merged(), whole.compared, whole.improper);
  Places turned = wrongly_turned(whole, demands.oriented);
  const std::size_t all_turned = turned.size();
  if (max_violations > 0) turned.resize(std::min(turned.size(), max_violations));
  for (const Places& more : {whole.apart, whole.twins, first_ones(whole), turned}) {
    simplices.insert(simplices.end(), more.begin(), more.end());
  }
  const Places unused = unused_points(mesh);
  Places points = unused;
  for (const auto& [kept, again] : whole.equal) {
    points.insert(points.end(), {static_cast<std::size_t>(kept), static_cast<std::size_t>(again)});
  }
  const Part<kDimension, Index> part(mesh, std::move(simplices), points);
  Verdict verdict = verdict_of_part(whole, part, unused, demands, max_violations);
  const Rule rule = demands.oriented == Orientations::kSame ? Rule::kOrientation : Rule::kInverted;
  const auto counted = verdict.tallies().find(rule);
  std::size_t turned_in_part = counted == verdict.tallies().end() ? 0 : counted->second.count;
  for (; turned_in_part < all_turned; ++turned_in_part) verdict.count(rule);
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.course = {true, "", 0, 0};
  return verdict;
}

template std::optional<Verdict> failing_complex(const fast::MeshView<2, std::int32_t>&,
                                                const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> failing_complex(const fast::MeshView<2, std::int64_t>&,
                                                const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> failing_complex(const fast::MeshView<3, std::int32_t>&,
                                                const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> failing_complex(const fast::MeshView<3, std::int64_t>&,
                                                const ComplexDemands&, std::size_t, unsigned);

}  // namespace circumspect::check
