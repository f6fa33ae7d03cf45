#include "oracle/judge/cause/case.hpp"

#include <utility>
#include <variant>

#include "oracle/judge/judge.hpp"

namespace circumspect::check {
namespace {

// As many are judged as a complex in about a fifth of a second, if few do not fit.
constexpr std::size_t kMostAsComplex = 300'000;

Numbers viewed(const Numbers& numbers) {
  return std::visit(
      []<class Value>(const Rows<Value>& rows) -> Numbers {
        return Rows<Value>::of(rows.values(), rows.columns());
      },
      numbers);
}

}  // namespace

std::size_t Case::count(Rule rule) const {
  const auto tally = verdict_.tallies().find(rule);
  return tally == verdict_.tallies().end() ? 0 : tally->second.count;
}

std::size_t Case::violations() const {
  std::size_t all = 0;
  for (const auto& [rule, tally] : verdict_.tallies()) all += tally.count;
  return all;
}

const std::vector<BareFacet>& Case::bare() {
  if (!bare_) bare_ = known_ ? bare_facets(mesh_, known_->boundary) : bare_facets(mesh_);
  return *bare_;
}

std::optional<Case::Mended> Case::mended(const Mesh& mesh) {
  if (std::exchange(has_mended_, true)) return std::nullopt;
  const std::optional<Verdict> after = judge_(mesh);
  if (!after) return std::nullopt;
  Mended found{.holds = after->holds()};
  for (const auto& [rule, tally] : after->tallies()) found.left += tally.count;
  for (const auto& [rule, tally] : verdict_.tallies()) {
    const auto left = after->tallies().find(rule);
    const std::size_t still = left == after->tallies().end() ? 0 : left->second.count;
    if (still < tally.count) found.explains += tally.count - still;
  }
  return found;
}

const Verdict* Case::as_complex() {
  if (verdict_.claim() == Claim::kComplex) return &verdict_;
  if (!as_complex_ && mesh_.simplices.size() <= kMostAsComplex && !mesh_.simplices.empty()) {
    auto judged = judge(Claim::kComplex, mesh_, nullptr, {.max_violations = 200});
    if (judged) as_complex_ = std::move(*judged);
  }
  return as_complex_ ? &*as_complex_ : nullptr;
}

Cause Case::cause(std::string name, std::string words, std::size_t explains) const {
  return {std::move(name), std::move(words), explains, violations(), false};
}

Mesh with_simplices(const Mesh& mesh, IndexLists simplices) {
  Mesh other;
  other.coordinates = viewed(mesh.coordinates);
  other.weights = viewed(mesh.weights);
  other.simplices = std::move(simplices);
  other.labels = mesh.labels;
  other.first_index = mesh.first_index;
  other.faces = mesh.faces;
  return other;
}

std::vector<Vertex> unused_points(const Mesh& mesh, std::size_t most) {
  std::vector<bool> is_used(mesh.points(), false);
  mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      for (const auto v : lists.values()) {
        if (mesh.names(v)) is_used[static_cast<std::size_t>(v)] = true;
      }
    }
  });
  std::vector<Vertex> unused;
  for (std::size_t v = 0; v < is_used.size() && unused.size() <= most; ++v) {
    if (!is_used[v]) unused.push_back(static_cast<Vertex>(v));
  }
  return unused;
}

}  // namespace circumspect::check
