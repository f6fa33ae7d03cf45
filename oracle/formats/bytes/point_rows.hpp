// Points of one dimension in one piece of memory: doubles, and exact numbers only from the first
// number on that is not a double.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::formats {

class PointRows {
 public:
  PointRows() = default;
  // Requires: all have the same number of coordinates.
  PointRows(const std::vector<Point>& points);
  PointRows(std::initializer_list<Point> points);

  std::size_t size() const { return columns_ == 0 ? 0 : numbers() / columns_; }
  bool empty() const { return numbers() == 0; }
  std::size_t columns() const { return columns_; }
  // A copy. Requires: i < size().
  Point operator[](std::size_t i) const;
  Point front() const { return (*this)[0]; }
  Point back() const { return (*this)[size() - 1]; }
  Rational at(std::size_t i, std::size_t column) const;

  // The points number by number. Requires, before the first one: columns > 0.
  void set_columns(std::size_t columns) { columns_ = columns; }
  // Memory for so many points, if that many fit the file, which is for the caller to know.
  void reserve(std::size_t points) { doubles_.reserve(points * columns_); }
  // Requires: finite, and not −0.
  void add(double number) {
    if (are_doubles_) {
      doubles_.push_back(number);
    } else {
      exact_.push_back(exact_value(number));
    }
  }
  void add(Rational number);
  void push_back(const Point& point);
  // Room for so many more doubles, to be written; empty if they have to be added one by one.
  std::span<double> grow(std::size_t count);
  // Takes back what has been added since there were so many numbers.
  void shrink_to(std::size_t numbers);
  std::size_t numbers() const { return are_doubles_ ? doubles_.size() : exact_.size(); }

  // Leaves out the last coordinate of each. Requires: columns() > 1.
  void drop_last_column();
  // The same points in this order.
  PointRows in_order(const std::vector<std::size_t>& order) const;

  // In the narrowest arrays; `columns`: of points, if there are none.
  Numbers as_numbers(std::size_t columns) &&;
  std::vector<Point> points() const;

  friend bool operator==(const PointRows& a, const PointRows& b) {
    return a.points() == b.points();
  }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Point;
    using difference_type = std::ptrdiff_t;
    using pointer = const Point*;
    using reference = Point;

    Iterator(const PointRows& rows, std::size_t at) : rows_(&rows), at_(at) {}
    Point operator*() const { return (*rows_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }

   private:
    const PointRows* rows_;
    std::size_t at_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  void become_exact();

  std::size_t columns_ = 0;
  bool are_doubles_ = true;
  UninitializedVector<double> doubles_;
  UninitializedVector<Rational> exact_;
};

}  // namespace circumspect::formats
