// Reads certificates and refutations and holds them against proofs/CERTIFICATE.md, for tests. It
// shares nothing with what writes them: plain rational arithmetic by way of barycentric coordinates.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/kernel/exact/determinant.hpp"
#include "reference/kernel/exact/point.hpp"

namespace circumspect::certificate {

// The tokens of a file, comments dropped.
class Tokens {
 public:
  explicit Tokens(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line.substr(0, line.find('#')));
      for (std::string word; words >> word;) words_.push_back(word);
    }
  }
  std::string word() {
    if (words_.empty()) throw std::runtime_error("expected more, found the end");
    std::string first = words_.front();
    words_.pop_front();
    return first;
  }
  Integer integer() { return Integer(word()); }
  std::size_t count() { return integer().get_ui(); }
  void expect(const std::string& wanted) {
    const std::string found = word();
    if (found != wanted) throw std::runtime_error("expected " + wanted + ", found " + found);
  }
  std::vector<Rational> numbers(std::size_t size) {
    std::vector<Rational> row;
    for (std::size_t i = 0; i < size; ++i) row.emplace_back(integer());
    return row;
  }
  Point rational_point(std::size_t dimension) {
    const std::vector<Rational> x = numbers(dimension + 1);
    if (sign(x.back()) <= 0) throw std::runtime_error("expected a positive denominator");
    return (Rational(1) / x.back()) * Point(x.begin(), x.end() - 1);
  }
  bool empty() const { return words_.empty(); }

 private:
  std::deque<std::string> words_;
};

// The barycentric coordinates of q; nothing if the simplex is degenerate.
inline std::optional<std::vector<Rational>> barycentric(const std::vector<Point>& simplex,
                                                        const Point& q) {
  RationalMatrix rows;
  std::vector<Rational> right_sides = q;
  for (std::size_t axis = 0; axis < q.size(); ++axis) {
    rows.emplace_back();
    for (const Point& p : simplex) rows.back().push_back(p[axis]);
  }
  rows.emplace_back(simplex.size(), Rational(1));
  right_sides.emplace_back(1);
  return solve(rows, right_sides);
}

// The set of places with positive coordinates; nothing if one is negative.
inline std::optional<std::set<std::size_t>> carrier(const std::vector<Rational>& coordinates) {
  std::set<std::size_t> positive;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (sign(coordinates[i]) < 0) return std::nullopt;
    if (sign(coordinates[i]) > 0) positive.insert(i);
  }
  return positive;
}

// What both kinds of files begin with.
struct Header {
  std::string claim;
  std::size_t dimension;
  std::string rule;      // of a refutation
  std::string standing;  // of a certificate, perhaps
  Rational scale;

  bool weighted() const { return claim == "weighted-delaunay"; }
};

inline Header read_header(Tokens& tokens, const std::string& kind) {
  Header header;
  tokens.expect(kind);
  tokens.expect(kind == "circumspect-refutation" ? "2" : "1");
  header.claim = tokens.word();
  header.dimension = tokens.count();
  if (kind == "circumspect-refutation") header.rule = tokens.word();
  std::string next = tokens.word();
  if (next == "unique" || next == "canonical") {
    header.standing = next;
    next = tokens.word();
  }
  if (next != "scale") throw std::runtime_error("expected scale, found " + next);
  const Integer p = tokens.integer();
  const Integer q = tokens.integer();
  if (p <= 0 || q <= 0 || gcd(p, q) != 1) throw std::runtime_error("scale");
  header.scale = Rational(p) / q;
  return header;
}

// |p|² less the weight, in a file's own scale.
inline Rational height_of(const Point& point, const Rational& weight) {
  return squared_length(point) - weight;
}

// How far q⁺ is below the witness plane. Requires: the simplex is not degenerate.
inline Rational depth(const std::vector<Point>& simplex, const std::vector<Rational>& heights,
                      const Point& q, const Rational& height) {
  return inner_product(*barycentric(simplex, q), heights) - height;
}

// The points of the user that a file says it is about, by label: coordinates and then the weight.
using LabelledPoints = std::map<std::string, std::vector<Rational>>;

inline std::vector<Rational> unscaled(const Header& header, Point point, const Rational& weight) {
  point = header.scale * point;
  if (header.weighted()) point.push_back(weight * header.scale * header.scale);
  return point;
}

}  // namespace circumspect::certificate
