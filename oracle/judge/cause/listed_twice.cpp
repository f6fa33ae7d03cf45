// Simplices that are listed more than once.
#include <algorithm>
#include <numeric>
#include <type_traits>

#include <fmt/format.h>

#include "oracle/judge/cause/rows.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::check {
namespace {

// With more simplices, the others are not judged, which would take as long as the verdict.
constexpr std::size_t kMostJudged = 50'000;

// Each simplex once, in their order; and the first that repeats an earlier one.
struct Once {
  IndexLists lists = {};
  Simplex repeated = {};
};
Once once(const IndexLists& lists) {
  return lists.visit([]<class Lists>(const Lists& rows) -> Once {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return {};
    } else {
      std::vector<Simplex> keys;
      for (std::size_t i = 0; i < rows.rows(); ++i) {
        keys.push_back(sorted(Simplex(rows.row(i).begin(), rows.row(i).end())));
      }
      std::vector<std::size_t> order(keys.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
      std::vector<std::size_t> kept;
      Once found;
      std::size_t first = rows.rows();
      for (std::size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || keys[order[i]] != keys[order[i - 1]]) {
          kept.push_back(order[i]);
        } else if (order[i] < first) {
          first = order[i];
          found.repeated.assign(rows.row(first).begin(), rows.row(first).end());
        }
      }
      std::sort(kept.begin(), kept.end());
      Lists fewer(kept.size(), rows.columns());
      for (std::size_t i = 0; i < kept.size(); ++i) {
        const auto from = rows.row(kept[i]);
        std::copy(from.begin(), from.end(), fewer.row(i).begin());
      }
      found.lists = std::move(fewer);
      return found;
    }
  });
}

}  // namespace

std::optional<Cause> listed_twice(Case& of) {
  const Mesh& mesh = of.mesh();
  Once kept = once(mesh.simplices);
  if (kept.repeated.empty()) return std::nullopt;
  const std::size_t copies = mesh.simplices.size() - kept.lists.size();
  const auto noun = report::simplices_noun(static_cast<int>(mesh.simplices.columns()) - 1, copies);
  const std::string first = report::labels(mesh, kept.repeated);
  std::string words = copies == 1 ? fmt::format("1 {} is listed twice: {}", noun, first)
                                  : fmt::format("{} {} are listed again: {} and {} more", copies,
                                                noun, first, copies - 1);
  std::size_t explains = of.count(Rule::kDuplicateSimplex);
  if (mesh.simplices.size() <= kMostJudged) {
    const auto mended = of.mended(with_simplices(mesh, std::move(kept.lists)));
    if (mended && mended->holds) {
      words += "; listed once, the claim holds";
      explains = mended->explains;
    }
  }
  return of.cause("listed-twice", std::move(words), explains);
}

}  // namespace circumspect::check
