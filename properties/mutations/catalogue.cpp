#include "properties/mutations/catalogue.hpp"

namespace circumspect::properties {

std::vector<Mutation> catalogue() {
  std::vector<Mutation> all;
  for (const auto& part : {index_mutations(), facet_mutations(), cover_mutations(),
                           link_mutations(), point_mutations()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace circumspect::properties
