#include "kernel/piecewise_linear/breach_kind.hpp"

#include <algorithm>
#include <array>

namespace circumspect {
namespace {

constexpr auto sorted_kinds() {
  std::array all = {
#define BREACH(number, name, ...) BreachEntry{BreachKind::name, __VA_ARGS__},
#include "kernel/piecewise_linear/breaches.def"
  };
  std::sort(all.begin(), all.end(),
            [](const BreachEntry& a, const BreachEntry& b) { return a.kind < b.kind; });
  return all;
}

constexpr std::array kKinds = sorted_kinds();

constexpr bool is_unique() {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (kKinds[i].kind == kKinds[j].kind) return false;
      if (kKinds[i].identifier == kKinds[j].identifier) return false;
    }
  }
  return true;
}
static_assert(is_unique(), "breaches.def: a number or an identifier is given twice");

const BreachEntry& entry(BreachKind kind) {
  return *std::find_if(kKinds.begin(), kKinds.end(),
                       [&](const BreachEntry& one) { return one.kind == kind; });
}

}  // namespace

std::span<const BreachEntry> breach_kinds() { return kKinds; }
std::string_view identifier(BreachKind kind) { return entry(kind).identifier; }
std::string_view meaning(BreachKind kind) { return entry(kind).meaning; }

}  // namespace circumspect
