// The ways in which an input can fail to be a piecewise linear complex: stable identifiers. Book:
// Definition 4.3. The list (kernel/piecewise_linear/breaches.def) may grow.
#pragma once

#include <span>
#include <string_view>

namespace circumspect {

enum class BreachKind {
#define BREACH(number, name, ...) name = number,
#include "kernel/piecewise_linear/breaches.def"
};

struct BreachEntry {
  BreachKind kind;
  std::string_view identifier;  // "plc.crossing-segments"; never changes its meaning
  std::string_view meaning;     // what is wrong, one clause
  std::string_view witness;     // which fields of a Breach are set, and to what
};

// All kinds, by their numbers.
std::span<const BreachEntry> breach_kinds();
std::string_view identifier(BreachKind kind);
std::string_view meaning(BreachKind kind);

}  // namespace circumspect
