// What a command line asks for that does not go together, as a table: a row is a condition and what
// is said where it is met.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace circumspect::cli {

struct UsageFault {
  UsageFault(bool is_there, std::string what) : text(is_there ? std::move(what) : "") {}
  UsageFault(std::string found) : text(std::move(found)) {}  // that something else found, or none

  std::string text;  // one line; empty if it is not there
};

// The text of the first fault that is there; empty if none is.
inline std::string first_fault(const std::vector<UsageFault>& rows) {
  for (const UsageFault& row : rows) {
    if (!row.text.empty()) return row.text;
  }
  return "";
}

// Whether something was asked for, and how users ask for it.
struct Asked {
  bool is_given;
  std::string name;
};

// Two that do not go together.
inline UsageFault contradiction(const Asked& one, const Asked& other, const std::string& why = "") {
  return {one.is_given && other.is_given,
          fmt::format("expected no {} beside {}, found it{}{}", one.name, other.name,
                      why.empty() ? "" : ": ", why)};
}

// One that needs the other.
inline UsageFault dependence(const Asked& one, const Asked& needed, const std::string& why = "") {
  return {one.is_given && !needed.is_given,
          fmt::format("expected {} beside {}, found none{}{}", needed.name, one.name,
                      why.empty() ? "" : ": ", why)};
}

}  // namespace circumspect::cli
