// Numbers and lists of indices in one piece of memory, into which large meshes are read.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "kernel/complex/simplex.hpp"

namespace circumspect {

// Leaves values that are made without an argument as the language makes them: numbers without a
// value, so that the threads that write them touch the memory first.
template <class Value>
class Uninitialized : public std::allocator<Value> {
 public:
  template <class Other>
  struct rebind {
    using other = Uninitialized<Other>;
  };
  Uninitialized() = default;
  template <class Other>
  Uninitialized(const Uninitialized<Other>&) noexcept {}
  template <class Other>
  void construct(Other* place) {
    ::new (static_cast<void*>(place)) Other;
  }
  template <class Other, class... Arguments>
  void construct(Other* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
  }
};
template <class Value>
using UninitializedVector = std::vector<Value, Uninitialized<Value>>;

// Numbers in one piece of memory, row after row; large meshes are read into these.

// It owns the memory, or views memory that outlives it. It can be moved, but not copied.
template <class Value>
class Rows {
 public:
  Rows() = default;
  // The values are not initialized. Requires: rows · columns fits std::size_t.
  Rows(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), own_(rows * columns), values_(own_.data()) {}
  // Takes the values over. Requires: whole rows, if there are columns.
  Rows(UninitializedVector<Value> values, std::size_t columns)
      : rows_(columns == 0 ? 0 : values.size() / columns),
        columns_(columns),
        own_(std::move(values)),
        values_(own_.data()) {}
  Rows(Rows&& other) noexcept { *this = std::move(other); }
  Rows& operator=(Rows&& other) noexcept {
    rows_ = std::exchange(other.rows_, 0);
    columns_ = std::exchange(other.columns_, 0);
    own_ = std::move(other.own_);
    values_ = std::exchange(other.values_, nullptr);
    return *this;
  }

  // A view of rows in memory, which it does not change. Requires: whole rows, if there are columns.
  static Rows of(std::span<const Value> values, std::size_t columns) {
    Rows rows;
    rows.columns_ = columns;
    rows.rows_ = columns == 0 ? 0 : values.size() / columns;
    rows.values_ = values.data();
    return rows;
  }

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::span<const Value> values() const { return {values_, rows_ * columns_}; }
  // Requires: it owns the memory.
  std::span<Value> values() {
    assert(!own_.empty() || rows_ * columns_ == 0);
    return {own_.data(), rows_ * columns_};
  }
  // Requires: i < rows(); for writing, that it owns the memory.
  std::span<const Value> row(std::size_t i) const {
    return values().subspan(i * columns_, columns_);
  }
  std::span<Value> row(std::size_t i) { return values().subspan(i * columns_, columns_); }

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  UninitializedVector<Value> own_;
  const Value* values_ = nullptr;
};

// A part of a list.
struct Slice {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  std::uint64_t size() const { return end - begin; }
  bool has(std::uint64_t item) const { return begin <= item && item < end; }
};

// One of several parts of any list, whose lengths differ by at most one. Together they are the
// list, in order.
struct PartOf {
  std::size_t part = 0;
  std::size_t parts = 1;

  // Requires: part <= parts.
  Slice slice(std::uint64_t count) const {
    const auto cut = [&](std::size_t i) {
      return count / parts * i + std::min<std::uint64_t>(i, count % parts);
    };
    return {cut(part), cut(part + 1)};
  }
  // The part that has the item. Requires: there are more items.
  static std::size_t with(std::uint64_t item, std::uint64_t count, std::size_t parts) {
    const std::uint64_t longer = count % parts, size = count / parts;  // so many have one more
    const std::uint64_t before = longer * (size + 1);
    return item < before ? item / (size + 1) : longer + (item - before) / size;
  }
};

// Lists of indices, such as the simplices of a mesh: in one piece of memory if all have the same
// length.

class IndexLists {
 public:
  IndexLists() = default;
  IndexLists(Rows<std::int32_t> rows) : lists_(std::move(rows)) {}
  IndexLists(Rows<std::int64_t> rows) : lists_(std::move(rows)) {}
  // In rows of 32 bits if these hold all indices, else in rows of 64 bits, if all lists have the
  // same length, at least 1.
  explicit IndexLists(std::vector<Simplex> lists);

  std::size_t size() const;
  bool empty() const { return size() == 0; }
  // How many indices every list has; 0 if there are no lists, or if the numbers differ.
  std::size_t columns() const;
  // Requires: i < size().
  Simplex operator[](std::size_t i) const;
  std::vector<Simplex> lists() const;

  // Null if the lists are not in such rows.
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
