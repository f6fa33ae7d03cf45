// Simplices as lists of indices in one piece of memory, with the end of each list only if their
// lengths differ.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

#include "kernel/complex/simplex.hpp"
#include "oracle/formats/bytes/indices.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::formats {

class SimplexRows {
 public:
  SimplexRows() = default;
  SimplexRows(const std::vector<Simplex>& lists);
  SimplexRows(std::initializer_list<Simplex> lists);
  // Lists of one length. Requires: whole ones, and columns > 0.
  SimplexRows(Indices indices, std::size_t columns);

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  // The length of every list; 0 if there are none, or if they differ.
  std::size_t columns() const { return ends_.empty() ? columns_ : 0; }
  // A copy. Requires: i < size().
  Simplex operator[](std::size_t i) const;
  std::size_t size_of(std::size_t i) const { return end_of(i) - begin_of(i); }
  Simplex front() const { return (*this)[0]; }
  Simplex back() const { return (*this)[size_ - 1]; }

  void push_back(std::span<const Vertex> list);
  void push_back(std::initializer_list<Vertex> list) {
    push_back(std::span(list.begin(), list.size()));
  }
  // Memory for so many indices, if that many fit the file, which is for the caller to know.
  void reserve(std::size_t indices) { indices_.reserve(indices); }

  // Replaces each index by `other(index)`.
  template <class Other>
  void replace_each(const Other& other) {
    indices_.replace_each(other);
  }

  IndexLists as_index_lists() &&;
  std::vector<Simplex> lists() const;

  friend bool operator==(const SimplexRows& a, const SimplexRows& b) {
    return a.lists() == b.lists();
  }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Simplex;
    using difference_type = std::ptrdiff_t;
    using pointer = const Simplex*;
    using reference = Simplex;

    Iterator(const SimplexRows& rows, std::size_t at) : rows_(&rows), at_(at) {}
    Simplex operator*() const { return (*rows_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    const SimplexRows* rows_;
    std::size_t at_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size_}; }

 private:
  std::size_t begin_of(std::size_t i) const {
    return ends_.empty() ? i * columns_ : i == 0 ? 0 : ends_[i - 1];
  }
  std::size_t end_of(std::size_t i) const { return ends_.empty() ? (i + 1) * columns_ : ends_[i]; }

  std::size_t size_ = 0;
  std::size_t columns_ = 0;        // of the first
  std::vector<std::size_t> ends_;  // empty while all have as many
  Indices indices_;
};

}  // namespace circumspect::formats
