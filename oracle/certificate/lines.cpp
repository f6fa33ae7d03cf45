#include "oracle/certificate/lines.hpp"

namespace circumspect::certificate {

Lines& Lines::operator<<(std::string_view token) {
  if (token.empty()) return *this;
  if (!at_start_) text_ += ' ';
  text_ += token;
  at_start_ = false;
  return *this;
}

Lines& Lines::operator<<(const Integer& number) {
  return *this << std::string_view(number.get_str());
}

Lines& Lines::gap() {
  text_ += ' ';
  return *this;
}

void Lines::end_line() {
  constexpr std::size_t kChunk = 1 << 16;
  text_ += '\n';
  at_start_ = true;
  if (text_.size() >= kChunk) flush();
}

void Lines::flush() {
  out_ << text_;
  text_.clear();
}

void write_first_line(Lines& lines, std::string_view kind, Claim claim, std::size_t dimension,
                      std::string_view more) {
  lines << kind << name(claim) << dimension;
  if (!more.empty()) lines << more;
  lines.end_line();
}

void write_scale(Lines& lines, const ScaledPoints& points) {
  lines << "scale" << points.scale_numerator << points.scale_denominator;
  lines.end_line();
}

void write_point(Lines& lines, const ScaledPoints& points, Vertex v, bool weighted) {
  for (std::size_t axis = 0; axis < points.dimension; ++axis) {
    lines << points.coordinate(v, axis);
  }
  if (!weighted) return;
  lines << (points.weights.empty() ? Integer(0) : points.weights[static_cast<std::size_t>(v)]);
}

void write_point(Lines& lines, const HomogeneousPoint& point) {
  for (const Integer& x : point.numerators) lines << x;
  lines << point.denominator;
}

}  // namespace circumspect::certificate
