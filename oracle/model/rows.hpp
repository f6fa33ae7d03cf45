// Numbers in one piece of memory, row after row: what large meshes are read into.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace circumspect {

// The memory is its own, or somebody else's that outlives it. It moves, and is never copied.
template <class Value>
class Rows {
 public:
  Rows() = default;
  // The values are not initialized, so that the threads that write them touch the memory first.
  // Requires: rows · columns fits std::size_t.
  Rows(std::size_t rows, std::size_t columns)
      : rows_(rows),
        columns_(columns),
        own_(std::make_unique_for_overwrite<Value[]>(rows * columns)),
        values_(own_.get()) {}
  Rows(Rows&& other) noexcept { *this = std::move(other); }
  Rows& operator=(Rows&& other) noexcept {
    rows_ = std::exchange(other.rows_, 0);
    columns_ = std::exchange(other.columns_, 0);
    own_ = std::move(other.own_);
    values_ = std::exchange(other.values_, nullptr);
    return *this;
  }

  // Rows where they lie, which nothing here changes. Requires: whole rows, if there are columns.
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
  // Requires: the memory is its own.
  std::span<Value> values() {
    assert(own_ != nullptr || rows_ * columns_ == 0);
    return {own_.get(), rows_ * columns_};
  }
  // Requires: i < rows(); to write, that the memory is its own.
  std::span<const Value> row(std::size_t i) const {
    return values().subspan(i * columns_, columns_);
  }
  std::span<Value> row(std::size_t i) { return values().subspan(i * columns_, columns_); }

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::unique_ptr<Value[]> own_;
  const Value* values_ = nullptr;
};

}  // namespace circumspect
