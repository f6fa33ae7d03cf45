// Numbers in one piece of memory, row after row: what large meshes are read into.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace circumspect::formats {

template <class Value>
class FlatRows {
 public:
  FlatRows() = default;
  // The values are not initialized, so that the threads that write them touch the memory first.
  // Requires: rows · columns fits std::size_t.
  FlatRows(std::size_t rows, std::size_t columns)
      : rows_(rows),
        columns_(columns),
        values_(std::make_unique_for_overwrite<Value[]>(rows * columns)) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::span<const Value> values() const { return {values_.get(), rows_ * columns_}; }
  std::span<Value> values() { return {values_.get(), rows_ * columns_}; }
  // Requires: i < rows().
  std::span<const Value> row(std::size_t i) const {
    return values().subspan(i * columns_, columns_);
  }
  std::span<Value> row(std::size_t i) { return values().subspan(i * columns_, columns_); }

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::unique_ptr<Value[]> values_;
};

}  // namespace circumspect::formats
