#include <algorithm>

#include "oracle/certificate/certificate.hpp"

namespace circumspect::certificate {

Lines& Lines::operator<<(std::string_view token) {
  if (token.empty()) return *this;
  if (!at_start_) append(" ");
  append(token);
  at_start_ = false;
  return *this;
}

Lines& Lines::operator<<(const Integer& number) {
  if (!number.fits_slong_p()) return *this << std::string_view(number.get_str());
  return *this << number.get_si();
}

Lines& Lines::gap() {
  append(" ");
  return *this;
}

void Lines::end_line() {
  append("\n");
  at_start_ = true;
}

void Lines::append(std::string_view text) {
  if (text.size() > text_.size() - used_) flush();
  if (text.size() > text_.size()) {
    out_ << text;
    return;
  }
  std::copy(text.begin(), text.end(), text_.begin() + static_cast<std::ptrdiff_t>(used_));
  used_ += text.size();
}

void Lines::flush() {
  out_ << std::string_view(text_.data(), used_);
  used_ = 0;
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

void begin_section(Lines& lines, std::string_view name, std::size_t count) {
  lines << name << count;
  lines.end_line();
}

void write_point(Lines& lines, const HomogeneousPoint& point) {
  for (const Integer& x : point.numerators) lines << x;
  lines << point.denominator;
}

}  // namespace circumspect::certificate
