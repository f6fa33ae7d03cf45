#include "properties/mutations/mutations.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect::properties {
namespace {

std::size_t any_place(std::size_t size) { return *rc::gen::inRange<std::size_t>(0, size); }

// Any index other than `old`, now and then one that names no point.
Vertex other_index(Vertex old, std::size_t points) {
  return *rc::gen::distinctFrom(rc::gen::inRange<Vertex>(-1, static_cast<Vertex>(points) + 1), old);
}

Mutant change_one_index(Simplices simplices, std::size_t points) {
  Simplex& simplex = simplices[any_place(simplices.size())];
  Vertex& v = simplex[any_place(simplex.size())];
  v = other_index(v, points);
  return {"one index changed", std::move(simplices)};
}

Mutant drop_one(Simplices simplices) {
  simplices.erase(simplices.begin() + static_cast<Vertex>(any_place(simplices.size())));
  return {"a simplex dropped", std::move(simplices)};
}

Mutant list_one_twice(Simplices simplices) {
  Simplex again = simplices[any_place(simplices.size())];
  std::rotate(again.begin(), again.begin() + static_cast<Vertex>(any_place(again.size())),
              again.end());
  simplices.push_back(std::move(again));
  return {"a simplex listed twice", std::move(simplices)};
}

Mutant replace_one(Simplices simplices, std::size_t points) {
  Simplex& simplex = simplices[any_place(simplices.size())];
  const auto index = rc::gen::inRange<Vertex>(0, static_cast<Vertex>(points));
  Simplex replacement = *rc::gen::container<Simplex>(simplex.size(), index);
  if (sorted(replacement) == sorted(simplex)) replacement[0] = replacement[1];
  simplex = std::move(replacement);
  return {"a simplex replaced", std::move(simplices)};
}

Mutant merge_points(Simplices simplices, std::size_t points) {
  const Vertex gone = *rc::gen::inRange<Vertex>(0, static_cast<Vertex>(points));
  const Vertex kept =
      *rc::gen::distinctFrom(rc::gen::inRange<Vertex>(0, static_cast<Vertex>(points)), gone);
  for (Simplex& simplex : simplices) std::replace(simplex.begin(), simplex.end(), gone, kept);
  return {"a point merged into another", std::move(simplices)};
}

Mutant exchange_everywhere(Simplices simplices, std::size_t points) {
  const Vertex a = *rc::gen::inRange<Vertex>(0, static_cast<Vertex>(points));
  const Vertex b = *rc::gen::inRange<Vertex>(0, static_cast<Vertex>(points));
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v = v == a ? b : v == b ? a : v;
  }
  return {"two vertices exchanged everywhere", std::move(simplices)};
}

Mutant exchange_between_two(Simplices simplices) {
  Simplex& first = simplices[any_place(simplices.size())];
  Simplex& second = simplices[any_place(simplices.size())];
  std::swap(first[any_place(first.size())], second[any_place(second.size())]);
  return {"two vertices exchanged between two simplices", std::move(simplices)};
}

// Replaces the two simplices of a facet by the joins of the edge between their apexes with the
// facet's ridges.
Mutant flip_a_facet(Simplices simplices) {
  std::vector<std::pair<FacetUse, FacetUse>> interior;
  for (const auto group : ByFacet(facet_uses(simplices))) {
    if (group.size() == 2) interior.emplace_back(group[0], group[1]);
  }
  if (interior.empty()) return list_one_twice(std::move(simplices));
  const auto& [first, second] = interior[any_place(interior.size())];
  const Vertex apex = simplices[first.simplex][first.opposite];
  const Vertex other_apex = simplices[second.simplex][second.opposite];
  for (std::size_t place = 0; place < first.facet.size(); ++place) {
    Simplex created = facet_opposite(first.facet, place);
    created.insert(created.end(), {apex, other_apex});
    simplices.push_back(std::move(created));
  }
  simplices.erase(simplices.begin() + static_cast<Vertex>(std::max(first.simplex, second.simplex)));
  simplices.erase(simplices.begin() + static_cast<Vertex>(std::min(first.simplex, second.simplex)));
  return {"the simplices of a facet flipped", std::move(simplices)};
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const Mutant& mutant) {
  out << mutant.what << ":\n";
  for (const Simplex& simplex : mutant.simplices) {
    for (const Vertex v : simplex) out << v << " ";
    out << "\n";
  }
  return out;
}

rc::Gen<Mutant> corruption(const Simplices& simplices, std::size_t points) {
  return rc::gen::exec([=] {
    switch (*rc::gen::inRange(0, 6)) {
      case 0:
        return drop_one(simplices);
      case 1:
        return list_one_twice(simplices);
      case 2:
        return replace_one(simplices, points);
      case 3:
        return merge_points(simplices, points);
      default:
        return change_one_index(simplices, points);
    }
  });
}

rc::Gen<Mutant> alteration(const Simplices& simplices, std::size_t points) {
  return rc::gen::exec([=] {
    switch (*rc::gen::inRange(0, 5)) {
      case 0:
        return exchange_everywhere(simplices, points);
      case 1:
        return exchange_between_two(simplices);
      case 2: {
        const Mutant once = *corruption(simplices, points);
        if (once.simplices.empty()) return once;
        return *corruption(once.simplices, points);
      }
      default:
        return flip_a_facet(simplices);
    }
  });
}

}  // namespace circumspect::properties
