#include "oracle/formats/bytes/point_rows.hpp"

#include <algorithm>
#include <utility>

namespace circumspect::formats {

PointRows::PointRows(const std::vector<Point>& points) {
  for (const Point& point : points) push_back(point);
}

PointRows::PointRows(std::initializer_list<Point> points) {
  for (const Point& point : points) push_back(point);
}

Point PointRows::operator[](std::size_t i) const {
  Point point;
  point.reserve(columns_);
  for (std::size_t column = 0; column < columns_; ++column) point.push_back(at(i, column));
  return point;
}

Rational PointRows::at(std::size_t i, std::size_t column) const {
  const std::size_t place = i * columns_ + column;
  return are_doubles_ ? exact_value(doubles_[place]) : exact_[place];
}

void PointRows::become_exact() {
  exact_.reserve(doubles_.size() + 1);
  for (const double number : doubles_) exact_.push_back(exact_value(number));
  doubles_ = {};
  are_doubles_ = false;
}

void PointRows::add(Rational number) {
  if (are_doubles_) {
    if (const auto same = as_double(number)) {
      doubles_.push_back(*same + 0.0);  // 0 for −0
      return;
    }
    become_exact();
  }
  exact_.push_back(std::move(number));
}

void PointRows::push_back(const Point& point) {
  if (columns_ == 0) columns_ = point.size();
  for (const Rational& coordinate : point) add(coordinate);
}

std::span<double> PointRows::grow(std::size_t count) {
  if (!are_doubles_) return {};
  const std::size_t before = doubles_.size();
  doubles_.resize(before + count);
  return std::span(doubles_).subspan(before);
}

void PointRows::shrink_to(std::size_t numbers) {
  if (are_doubles_) {
    doubles_.resize(numbers);
  } else {
    exact_.resize(numbers);
  }
}

namespace {

// Leaves out the last number of each row.
template <class Values>
void drop_last(Values& values, std::size_t columns) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % columns == columns - 1) continue;
    if (kept != i) values[kept] = std::move(values[i]);
    ++kept;
  }
  values.resize(kept);
}

template <class Values>
Values reordered(const Values& values, std::size_t columns, const std::vector<std::size_t>& order) {
  Values others;
  others.reserve(values.size());
  for (const std::size_t row : order) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row * columns);
    others.insert(others.end(), first, first + static_cast<std::ptrdiff_t>(columns));
  }
  return others;
}

}  // namespace

void PointRows::drop_last_column() {
  drop_last(doubles_, columns_);
  drop_last(exact_, columns_);
  --columns_;
  // What is left may be doubles.
  if (!are_doubles_) *this = PointRows(points());
}

PointRows PointRows::in_order(const std::vector<std::size_t>& order) const {
  PointRows others;
  others.columns_ = columns_;
  others.are_doubles_ = are_doubles_;
  others.doubles_ =
      reordered(doubles_, columns_, are_doubles_ ? order : std::vector<std::size_t>{});
  others.exact_ = reordered(exact_, columns_, are_doubles_ ? std::vector<std::size_t>{} : order);
  return others;
}

Numbers PointRows::as_numbers(std::size_t columns) && {
  if (columns_ != 0) columns = columns_;
  if (are_doubles_) return Rows<double>(std::move(doubles_), columns);
  return Rows<Rational>(std::move(exact_), columns);
}

std::vector<Point> PointRows::points() const {
  std::vector<Point> all;
  all.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) all.push_back((*this)[i]);
  return all;
}

}  // namespace circumspect::formats
