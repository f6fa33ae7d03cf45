// Lists of indices, as the simplices of a mesh: in one piece of memory where all are of one length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "oracle/model/rows.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect {

class IndexLists {
 public:
  IndexLists() = default;
  IndexLists(Rows<std::int32_t> rows) : lists_(std::move(rows)) {}
  IndexLists(Rows<std::int64_t> rows) : lists_(std::move(rows)) {}
  // In rows of 32 bits if these hold all indices, in rows of 64 if lists are of one length, 1 at least.
  explicit IndexLists(std::vector<Simplex> lists);

  std::size_t size() const;
  bool empty() const { return size() == 0; }
  // How many indices every list has; 0 if there are none, or they differ.
  std::size_t columns() const;
  // Requires: i < size().
  Simplex operator[](std::size_t i) const;
  std::vector<Simplex> lists() const;

  // Null if they are not in such rows.
  template <class Index>
  const Rows<Index>* rows() const {
    return std::get_if<Rows<Index>>(&lists_);
  }
  // Calls `visitor` with Rows<std::int32_t>, Rows<std::int64_t> or std::vector<Simplex>.
  template <class Visitor>
  decltype(auto) visit(const Visitor& visitor) const {
    return std::visit(visitor, lists_);
  }

 private:
  std::variant<Rows<std::int32_t>, Rows<std::int64_t>, std::vector<Simplex>> lists_;
};

}  // namespace circumspect
