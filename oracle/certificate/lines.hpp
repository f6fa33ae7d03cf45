// Writes lines of tokens, many of them.
#pragma once

#include <concepts>
#include <ostream>
#include <string>
#include <string_view>

#include "oracle/certificate/scaled_points.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::certificate {

class Lines {
 public:
  explicit Lines(std::ostream& out) : out_(out) {}
  ~Lines() { flush(); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  Lines& operator<<(std::string_view token);
  Lines& operator<<(const Integer& number);
  // Separates groups of tokens.
  Lines& gap();
  void end_line();

 private:
  void flush();

  std::ostream& out_;
  std::string text_;
  bool at_start_ = true;
};

// Any integer of the machine.
template <std::integral Number>
Lines& operator<<(Lines& lines, Number number) {
  return lines << std::string_view(std::to_string(number));
}

// A claim, its dimension and what else is said of it, after the first words of a file, `kind` and its
// version.
void write_first_line(Lines& lines, std::string_view kind, Claim claim, std::size_t dimension,
                      std::string_view more = "");

void write_scale(Lines& lines, const ScaledPoints& points);

// Coordinates, and the weight if `weighted`.
void write_point(Lines& lines, const ScaledPoints& points, Vertex v, bool weighted);

// Numerators and denominator.
void write_point(Lines& lines, const HomogeneousPoint& point);

}  // namespace circumspect::certificate
