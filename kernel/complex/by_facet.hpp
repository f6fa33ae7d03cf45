// The facets of a list of simplices one by one, each with all its uses:
//
//     for (const auto uses : ByFacet(facet_uses(simplices))) { … }
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "kernel/complex/simplex.hpp"

namespace circumspect {

// A range of spans. Requires: the uses of one facet are adjacent, as facet_uses() lists them; who
// hands over a list that is not a temporary keeps it.
template <class Use>
class ByFacet {
 public:
  explicit ByFacet(const std::vector<Use>& uses) : uses_(uses) {}
  explicit ByFacet(std::vector<Use>&& uses) : own_(std::move(uses)), uses_(own_) {}
  explicit ByFacet(const std::vector<Use>&&) = delete;  // nobody would keep it
  ByFacet(const ByFacet&) = delete;
  ByFacet& operator=(const ByFacet&) = delete;

  class Iterator {
   public:
    Iterator(const Use* first, const Use* end) : first_(first), end_(end) { find_last(); }
    std::span<const Use> operator*() const { return {first_, last_}; }
    Iterator& operator++() {
      first_ = last_;
      find_last();
      return *this;
    }
    bool operator==(const Iterator& other) const { return first_ == other.first_; }

   private:
    void find_last() {
      last_ =
          std::find_if(first_, end_, [&](const Use& use) { return use.facet != first_->facet; });
    }

    const Use* first_;  // of the current facet
    const Use* last_ = nullptr;
    const Use* end_;
  };

  Iterator begin() const { return {uses_.data(), uses_.data() + uses_.size()}; }
  Iterator end() const { return {uses_.data() + uses_.size(), uses_.data() + uses_.size()}; }

 private:
  std::vector<Use> own_;
  std::span<const Use> uses_;
};

}  // namespace circumspect
