#include "oracle/judge/fast/predicates/exact_ball.hpp"

#include <algorithm>
#include <bit>

#include "oracle/judge/fast/predicates/exact_sign.hpp"

namespace circumspect::fast {
namespace {

std::uint64_t magnitude(std::int64_t x) { return static_cast<std::uint64_t>(x < 0 ? -x : x); }

void assign(Fixed<1>& result, std::int64_t value) {
  result = {{static_cast<std::uint64_t>(value)}};
}
void assign(Narrow<1>& result, std::int64_t value) { result = {value}; }

template <typename T>
std::array<T, 2> shifted(const std::array<std::int64_t, 2>& at, int shift) {
  std::array<T, 2> result;
  for (std::size_t i = 0; i < 2; ++i) assign(result[i], at[i] >> shift);
  return result;
}
template <typename T>
std::array<T, 3> shifted(const std::array<std::int64_t, 3>& at, int shift) {
  std::array<T, 3> result;
  for (std::size_t i = 0; i < 3; ++i) assign(result[i], at[i] >> shift);
  return result;
}

template <typename T>
auto lifted(const std::array<T, 2>& at) {
  const auto h = height(at[0], at[1]);
  return Row2<T, std::decay_t<decltype(h)>>{at[0], at[1], h};
}
template <typename T>
auto lifted(const std::array<T, 3>& at) {
  const auto h = height(at[0], at[1], at[2]);
  return Row3<T, std::decay_t<decltype(h)>>{at[0], at[1], at[2], h};
}

template <typename T>
auto cofactors_of(const std::array<std::array<std::int64_t, 2>, 2>& rows, int shift) {
  return cofactors(lifted(shifted<T>(rows[0], shift)), lifted(shifted<T>(rows[1], shift)));
}
template <typename T>
auto cofactors_of(const std::array<std::array<std::int64_t, 3>, 3>& rows, int shift) {
  return cofactors(lifted(shifted<T>(rows[0], shift)), lifted(shifted<T>(rows[1], shift)),
                   lifted(shifted<T>(rows[2], shift)));
}

template <typename Cofactors, typename T, typename H>
int sign_of(const Cofactors& cofactors, const Row2<T, H>& query) {
  return in_circle(cofactors, query).sign();
}
template <typename Cofactors, typename T, typename H>
int sign_of(const Cofactors& cofactors, const Row3<T, H>& query) {
  return in_sphere(cofactors, query).sign();
}

}  // namespace

template <std::size_t kDimension>
ExactBall<kDimension>::ExactBall(const SiteRow<kDimension>& vertices) : vertices_(vertices) {
  double largest = 0;
  for (const auto& vertex : vertices) largest = std::max(largest, largest_coordinate(vertex));
  unit_ = GridUnit::of(largest);
  if (!unit_) return;
  bool exact = unit_->divide(vertices.back(), last_);
  for (std::size_t i = 0; i < kDimension; ++i) {
    exact &= unit_->divide(vertices[i], rows_[i]);
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      rows_[i][axis] -= last_[axis];
      any_ |= static_cast<std::uint64_t>(rows_[i][axis]);
      widest_ |= magnitude(rows_[i][axis]);
    }
  }
  if (!exact) unit_.reset();
}

template <std::size_t kDimension>
int ExactBall<kDimension>::contains(const Site<kDimension>& query, Stages& stages) {
  Whole at;
  if (!unit_ || GridUnit::exponent_of(largest_coordinate(query)) > unit_->largest_exponent ||
      !unit_->divide(query, at)) {
    return exact_ball_sign(vertices_, query, false, stages);
  }
  std::uint64_t any = any_, widest = widest_;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    at[axis] -= last_[axis];
    any |= static_cast<std::uint64_t>(at[axis]);
    widest |= magnitude(at[axis]);
  }
  const int shift = any == 0 ? 0 : std::countr_zero(any);
  if (static_cast<int>(std::bit_width(widest >> shift)) > kNarrowBits<kDimension, kDimension + 2>) {
    ++stages.fixed;
    if (!fixed_) fixed_ = cofactors_of<Fixed<1>>(rows_, 0);
    return sign_of(*fixed_, lifted(shifted<Fixed<1>>(at, 0)));
  }
  // The cofactors are kept for the factor of two that the rows have in common.
  if (any_ == 0 || shift != std::countr_zero(any_)) {
    return exact_ball_sign(vertices_, query, false, stages);
  }
  ++stages.narrow;
  if (!narrow_) narrow_ = cofactors_of<Narrow<1>>(rows_, shift);
  return sign_of(*narrow_, lifted(shifted<Narrow<1>>(at, shift)));
}

template class ExactBall<2>;
template class ExactBall<3>;

}  // namespace circumspect::fast
