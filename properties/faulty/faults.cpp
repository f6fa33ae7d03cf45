#include "properties/faulty/fault.hpp"

namespace circumspect::faulty {

std::string_view name(Kind kind) {
  switch (kind) {
    case Kind::kPredicate:
      return "predicate";
    case Kind::kImplementation:
      return "implementation";
    case Kind::kCorruption:
      return "corruption";
    case Kind::kDomain:
      break;
  }
  return "domain";
}

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = [] {
    std::vector<Fault> table;
    for (const auto part : {predicate_faults, insertion_faults, flip_faults, preparation_faults,
                            weight_faults, corruptions, domain_faults}) {
      const std::vector<Fault> more = part();
      table.insert(table.end(), more.begin(), more.end());
    }
    return table;
  }();
  return all;
}

}  // namespace circumspect::faulty
