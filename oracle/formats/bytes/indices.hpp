// Integers in one piece of memory: of 32 bits until one does not fit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::formats {

class Indices {
 public:
  std::size_t size() const { return is_wide_ ? wide_.size() : narrow_.size(); }
  Vertex operator[](std::size_t i) const { return is_wide_ ? wide_[i] : Vertex{narrow_[i]}; }
  Vertex back() const { return (*this)[size() - 1]; }

  // Memory for so many, if that many fit the file, which is for the caller to know.
  void reserve(std::size_t count) { narrow_.reserve(count); }
  void push_back(Vertex index) {
    if (!is_wide_ && fits(index)) {
      narrow_.push_back(static_cast<std::int32_t>(index));
      return;
    }
    if (!is_wide_) widen();
    wide_.push_back(index);
  }
  // Room for so many more of 32 bits, to be written; empty if they have to be added one by one.
  std::span<std::int32_t> grow(std::size_t count) {
    if (is_wide_) return {};
    const std::size_t before = narrow_.size();
    narrow_.resize(before + count);
    return std::span(narrow_).subspan(before);
  }
  // Takes back what has been added since there were so many.
  void shrink_to(std::size_t count) { is_wide_ ? wide_.resize(count) : narrow_.resize(count); }

  // Replaces each by `other(index)`.
  template <class Other>
  void replace_each(const Other& other) {
    for (std::size_t i = 0; !is_wide_ && i < narrow_.size(); ++i) {
      const Vertex index = other(Vertex{narrow_[i]});
      if (fits(index)) {
        narrow_[i] = static_cast<std::int32_t>(index);
        continue;
      }
      // From here on in 64 bits; those before have been replaced.
      widen();
      for (std::size_t j = i; j < wide_.size(); ++j) wide_[j] = other(wide_[j]);
      return;
    }
    for (std::int64_t& index : wide_) index = other(index);
  }

  // In rows; requires: whole ones, and columns > 0.
  IndexLists as_rows(std::size_t columns) && {
    if (is_wide_) return IndexLists(Rows<std::int64_t>(std::move(wide_), columns));
    return IndexLists(Rows<std::int32_t>(std::move(narrow_), columns));
  }

 private:
  static bool fits(Vertex index) { return index == static_cast<std::int32_t>(index); }
  void widen() {
    wide_.assign(narrow_.begin(), narrow_.end());
    narrow_ = {};
    is_wide_ = true;
  }

  bool is_wide_ = false;
  UninitializedVector<std::int32_t> narrow_;
  UninitializedVector<std::int64_t> wide_;
};

}  // namespace circumspect::formats
