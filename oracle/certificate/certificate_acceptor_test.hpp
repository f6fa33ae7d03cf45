// For tests: reads certificates and refutations, and checks them by proofs/CERTIFICATE.md. It
// shares no code with the writers: it uses plain rational arithmetic and barycentric coordinates.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"

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

// The conditions on certificates, one by one.

class CertificateAcceptor {
 public:
  // Throws what is malformed.
  explicit CertificateAcceptor(const std::string& text) : tokens_(text) {
    header_ = read_header(tokens_, "circumspect-certificate");
    d_ = header_.dimension;
    read_points();
    read_simplices();
    read_hull();
    tokens_.expect("sample");
    sample_simplex_ = tokens_.count();
    sample_ = tokens_.rational_point(d_);
    tokens_.expect("end");
    if (!tokens_.empty()) throw std::runtime_error("expected nothing after end");
  }

  const Header& header() const { return header_; }
  const LabelledPoints& labelled_points() const { return labelled_; }
  std::size_t simplex_count() const { return simplices_.size(); }

  // "accepted", or the first condition that does not hold.
  std::string verdict() const {
    for (std::size_t p = 1; p < points_.size(); ++p) {
      if (!(points_[p - 1].at < points_[p].at)) return "points-increasing";
    }
    for (std::size_t s = 0; s < simplices_.size(); ++s) {
      const std::string fault = simplex_fault(s);
      if (!fault.empty()) return fault;
    }
    for (std::size_t p = 0; p < points_.size(); ++p) {
      if (!is_used(p)) return "point-used";
    }
    for (std::size_t h = 0; h < hull_.size(); ++h) {
      const std::string fault = hull_fault(h);
      if (!fault.empty()) return fault;
    }
    return sample_fault();
  }

 private:
  struct ListedPoint {
    Point at;
    Rational weight;
    std::size_t simplex;
    std::string place;
  };
  struct Facet {
    bool hull;
    std::size_t cell;   // from 1
    std::size_t place;  // from 0
  };
  struct ListedSimplex {
    std::vector<std::size_t> vertices;  // from 1
    std::vector<Facet> facets;
    std::string separating;
  };
  struct ListedHullFacet {
    std::size_t simplex;
    std::size_t place;
    std::vector<Facet> ridges;
  };

  void read_points() {
    tokens_.expect("points");
    points_.resize(tokens_.count());
    for (ListedPoint& point : points_) {
      point.at = tokens_.numbers(d_);
      if (header_.weighted()) point.weight = tokens_.integer();
      point.simplex = tokens_.count();
      point.place = tokens_.word();
      labelled_[tokens_.word()] = unscaled(header_, point.at, point.weight);
    }
  }

  void read_simplices() {
    tokens_.expect("simplices");
    simplices_.resize(tokens_.count());
    for (ListedSimplex& simplex : simplices_) {
      for (std::size_t i = 0; i <= d_; ++i) simplex.vertices.push_back(tokens_.count());
      for (std::size_t i = 0; i <= d_; ++i) {
        const std::string first = tokens_.word();
        const bool hull = first == "-";
        const std::size_t cell = hull ? tokens_.count() : std::stoul(first);
        simplex.facets.push_back({hull, cell, hull ? 0 : tokens_.count()});
      }
      simplex.separating = tokens_.word();
    }
  }

  void read_hull() {
    tokens_.expect("hull");
    hull_.resize(tokens_.count());
    for (ListedHullFacet& facet : hull_) {
      facet.simplex = tokens_.count();
      facet.place = tokens_.count();
      for (std::size_t a = 0; a < d_; ++a) {
        const std::size_t cell = tokens_.count();
        facet.ridges.push_back({false, cell, tokens_.count()});
      }
    }
  }

  bool names_simplex(std::size_t number) const {
    return number >= 1 && number <= simplices_.size();
  }

  std::vector<Point> coordinates(std::size_t s) const {
    std::vector<Point> at;
    for (const std::size_t v : simplices_[s].vertices) at.push_back(points_[v - 1].at);
    return at;
  }

  std::vector<Rational> heights(std::size_t s) const {
    std::vector<Rational> row;
    for (const std::size_t v : simplices_[s].vertices) row.push_back(height(v - 1));
    return row;
  }

  Rational height(std::size_t p) const { return height_of(points_[p].at, points_[p].weight); }

  bool is_used(std::size_t p) const {
    const ListedPoint& point = points_[p];
    if (!names_simplex(point.simplex)) return false;
    const std::size_t s = point.simplex - 1;
    if (point.place != "-") {
      const std::size_t place = std::stoul(point.place);
      return place <= d_ && simplices_[s].vertices[place] == p + 1;
    }
    if (!header_.weighted() || !carrier(*barycentric(coordinates(s), point.at))) return false;
    return sign(depth(coordinates(s), heights(s), point.at, height(p))) <= 0;
  }

  int orientation(std::size_t s) const {
    const std::vector<Point> at = coordinates(s);
    SquareMatrix matrix(d_);
    for (std::size_t i = 0; i < d_; ++i) {
      for (std::size_t axis = 0; axis < d_; ++axis) {
        matrix(i, axis) = Rational(at[i][axis] - at[d_][axis]).get_num();
      }
    }
    return sign(determinant(matrix));
  }

  std::string simplex_fault(std::size_t s) const {
    for (const std::size_t v : simplices_[s].vertices) {
      if (v < 1 || v > points_.size()) return "vertex-known";
    }
    if (orientation(s) <= 0) return "simplex-positive";
    for (std::size_t i = 0; i <= d_; ++i) {
      const std::string fault = facet_fault(s, i);
      if (!fault.empty()) return fault;
    }
    return "";
  }

  static std::vector<std::size_t> without(std::vector<std::size_t> vertices, std::size_t place) {
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(place));
    return vertices;
  }

  static bool are_the_same_set(std::vector<std::size_t> a, std::vector<std::size_t> b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
  }

  std::string facet_fault(std::size_t s, std::size_t i) const {
    const Facet& facet = simplices_[s].facets[i];
    if (facet.hull) {
      const bool known = facet.cell >= 1 && facet.cell <= hull_.size();
      if (!known || hull_[facet.cell - 1].simplex != s + 1 || hull_[facet.cell - 1].place != i) {
        return "hull-pointer";
      }
      return "";
    }
    if (!names_simplex(facet.cell) || facet.place > d_) return "facet-matched";
    const ListedSimplex& other = simplices_[facet.cell - 1];
    for (const std::size_t v : other.vertices) {
      if (v < 1 || v > points_.size()) return "vertex-known";
    }
    const std::size_t apex = other.vertices[facet.place] - 1;
    const std::vector<Rational> of_apex = *barycentric(coordinates(s), points_[apex].at);
    if (!are_the_same_set(without(simplices_[s].vertices, i),
                          without(other.vertices, facet.place)) ||
        sign(of_apex[i]) >= 0) {
      return "facet-matched";
    }
    const Facet& back = other.facets[facet.place];
    if (back.hull || back.cell != s + 1 || back.place != i) return "back-pointer";
    if (header_.claim != "triangulation" &&
        sign(depth(coordinates(s), heights(s), points_[apex].at, height(apex))) > 0) {
      return "facet-locally-delaunay";
    }
    return "";
  }

  std::vector<std::size_t> hull_vertices(std::size_t h) const {
    return without(simplices_[hull_[h].simplex - 1].vertices, hull_[h].place);
  }

  std::string hull_fault(std::size_t h) const {
    const ListedHullFacet& facet = hull_[h];
    if (!names_simplex(facet.simplex) || facet.place > d_) return "hull-pointer";
    const Facet& pointer = simplices_[facet.simplex - 1].facets[facet.place];
    if (!pointer.hull || pointer.cell != h + 1) return "hull-pointer";
    for (std::size_t a = 0; a < d_; ++a) {
      const Facet& ridge = facet.ridges[a];
      if (ridge.cell < 1 || ridge.cell > hull_.size() || ridge.place >= d_) return "ridge-matched";
      if (!are_the_same_set(without(hull_vertices(h), a),
                            without(hull_vertices(ridge.cell - 1), ridge.place))) {
        return "ridge-matched";
      }
      const Facet& back = hull_[ridge.cell - 1].ridges[ridge.place];
      if (back.cell != h + 1 || back.place != a) return "ridge-back-pointer";
      const std::size_t far = hull_vertices(ridge.cell - 1)[ridge.place] - 1;
      const auto of_far = *barycentric(coordinates(facet.simplex - 1), points_[far].at);
      if (sign(of_far[facet.place]) < 0) return "hull-locally-convex";
    }
    return "";
  }

  std::string sample_fault() const {
    if (!names_simplex(sample_simplex_)) return "sample-inside";
    for (std::size_t s = 0; s < simplices_.size(); ++s) {
      const std::vector<Rational> of_sample = *barycentric(coordinates(s), sample_);
      const std::string& separating = simplices_[s].separating;
      if (s + 1 == sample_simplex_) {
        if (separating != "-") return "sample-inside";
        for (const Rational& x : of_sample) {
          if (sign(x) <= 0) return "sample-inside";
        }
      } else if (separating == "-" || std::stoul(separating) > d_ ||
                 sign(of_sample[std::stoul(separating)]) >= 0) {
        return "sample-outside";
      }
    }
    for (const ListedHullFacet& facet : hull_) {
      const auto of_sample = *barycentric(coordinates(facet.simplex - 1), sample_);
      if (sign(of_sample[facet.place]) <= 0) return "sample-inside-hull";
    }
    return "accepted";
  }

  Tokens tokens_;
  Header header_;
  std::size_t d_ = 0;
  std::vector<ListedPoint> points_;
  LabelledPoints labelled_;
  std::vector<ListedSimplex> simplices_;
  std::vector<ListedHullFacet> hull_;
  std::size_t sample_simplex_ = 0;
  Point sample_;
};

}  // namespace circumspect::certificate
