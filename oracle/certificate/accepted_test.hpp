// For tests: checks that refutations have the evidence that each rule requires, and that
// certificates fulfil their conditions.
#pragma once

#include <algorithm>

#include "oracle/certificate/certificate_acceptor_test.hpp"
#include "oracle/certificate/document.hpp"

namespace circumspect::certificate {

class RefutationAcceptor {
 public:
  // Throws what is malformed.
  explicit RefutationAcceptor(const std::string& text) : tokens_(text) {
    header_ = read_header(tokens_, "circumspect-refutation");
    d_ = header_.dimension;
    tokens_.expect("points");
    points_.resize(tokens_.count());
    for (ListedPoint& point : points_) {
      point.at = tokens_.numbers(d_);
      if (header_.weighted()) point.weight = tokens_.integer();
      labelled_[tokens_.word()] = unscaled(header_, point.at, point.weight);
    }
    tokens_.expect("simplices");
    simplices_.resize(tokens_.count());
    for (std::vector<Integer>& simplex : simplices_) {
      simplex.resize(tokens_.count());
      for (Integer& v : simplex) v = tokens_.integer();
    }
    tokens_.expect("spans");
    spans_ = solid(around()).has_value();
    tokens_.expect("because");
  }

  const Header& header() const { return header_; }
  const LabelledPoints& labelled_points() const { return labelled_; }
  std::size_t simplex_count() const { return simplices_.size(); }

  // Does the evidence show the fault, and is there nothing after it? To be asked once.
  bool accepts() {
    if (!spans_ || !is_rule_of_claim() || !evidence()) return false;
    tokens_.expect("end");
    return tokens_.empty();
  }

 private:
  struct ListedPoint {
    Point at;
    Rational weight;
  };
  struct Entry {
    std::size_t simplex;
    std::size_t place;
  };

  bool is_rule_of_claim() const {
    const std::string kind = header_.rule.substr(0, header_.rule.find('.'));
    if (header_.rule == "delaunay.facet-not-local") return header_.claim != "triangulation";
    if (kind == "delaunay") return header_.claim == "delaunay";
    if (kind == "weighted") return header_.weighted();
    return true;
  }

  bool evidence() {
    const std::string& rule = header_.rule;
    if (rule == "simplex.wrong-dimension") return simplex().size() != d_ + 1;
    if (rule == "triangulation.unknown-vertex") return !names_point(entry());
    if (rule == "simplex.repeated-vertex") return is_repeated();
    if (rule == "simplex.degenerate") return is_degenerate();
    if (rule == "complex.duplicate-simplex") return is_duplicate();
    if (rule == "complex.facet-overused") return is_overused();
    if (rule == "complex.overlap") return overlap();
    if (rule == "triangulation.covered-twice") return is_covered_twice();
    if (rule == "triangulation.unused-point") {
      return header_.weighted() ? is_uncovered() : is_unused();
    }
    if (rule == "triangulation.hull-not-convex") return is_not_convex();
    if (rule == "triangulation.hull-not-closed") return is_not_closed();
    if (rule == "delaunay.vertex-in-ball" || rule == "weighted.point-below-plane") {
      const std::vector<Integer> ball = simplex();
      return is_below(ball, tokens_.integer());
    }
    if (rule == "delaunay.facet-not-local") return is_not_local();
    if (rule == "weighted.vertex-submerged") return is_submerged();
    return false;
  }

  std::size_t simplex_number() {
    const std::size_t number = tokens_.count();
    if (number < 1 || number > simplices_.size()) throw std::runtime_error("no such simplex");
    return number - 1;
  }
  const std::vector<Integer>& simplex() { return simplices_[simplex_number()]; }

  Entry read_entry() {
    const std::size_t number = simplex_number();
    return {number, tokens_.count()};
  }
  const Integer& at(const Entry& entry) const { return simplices_[entry.simplex].at(entry.place); }
  Integer entry() { return at(read_entry()); }
  bool names_point(const Integer& v) const {
    return v >= 1 && v <= Integer(static_cast<unsigned long>(points_.size()));
  }
  const ListedPoint& point(const Integer& v) const { return points_.at(v.get_ui() - 1); }

  // Nothing if it is not a simplex of points.
  std::optional<std::vector<Point>> solid(const std::vector<Integer>& vertices) const {
    std::vector<Point> corners;
    for (const Integer& v : vertices) {
      if (!names_point(v)) return std::nullopt;
      corners.push_back(point(v).at);
    }
    if (corners.size() != d_ + 1 || !barycentric(corners, corners.front())) return std::nullopt;
    return corners;
  }

  bool is_repeated() {
    const std::vector<Integer>& vertices = simplex();
    const std::size_t i = tokens_.count();
    const std::size_t j = tokens_.count();
    return i != j && vertices.at(i) == vertices.at(j);
  }

  bool is_degenerate() {
    const std::vector<Integer>& vertices = simplex();
    for (const Integer& v : vertices) {
      if (!names_point(v)) return false;
    }
    return vertices.size() == d_ + 1 && !solid(vertices);
  }

  bool is_duplicate() {
    const std::size_t a = simplex_number();
    const std::size_t b = simplex_number();
    return a != b && ascending(simplices_[a]) == ascending(simplices_[b]);
  }

  static std::vector<Integer> ascending(std::vector<Integer> vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  std::vector<Integer> facet(const Entry& entry) const {
    std::vector<Integer> vertices = simplices_[entry.simplex];
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(entry.place));
    return ascending(vertices);
  }

  bool is_overused() {
    const Entry a = read_entry();
    const Entry b = read_entry();
    const Entry c = read_entry();
    for (const Entry& one : {a, b, c}) {
      if (!solid(simplices_[one.simplex])) return false;
    }
    return std::set{a.simplex, b.simplex, c.simplex}.size() == 3 && facet(a) == facet(b) &&
           facet(b) == facet(c);
  }

  // The vertices with positive coordinates; nothing unless the simplex contains q.
  std::optional<std::set<Integer>> carrier_of(std::size_t s, const Point& q) const {
    const auto corners = solid(simplices_[s]);
    if (!corners) return std::nullopt;
    const auto places = carrier(*barycentric(*corners, q));
    if (!places) return std::nullopt;
    std::set<Integer> vertices;
    for (const std::size_t place : *places) vertices.insert(simplices_[s][place]);
    return vertices;
  }

  bool overlap() {
    const std::size_t a = simplex_number();
    const std::size_t b = simplex_number();
    const Point q = tokens_.rational_point(d_);
    const auto in_a = carrier_of(a, q);
    const auto in_b = carrier_of(b, q);
    return in_a && in_b && *in_a != *in_b;
  }

  bool is_covered_twice() {
    const std::size_t a = simplex_number();
    const std::size_t b = simplex_number();
    const Point q = tokens_.rational_point(d_);
    const auto in_a = carrier_of(a, q);
    return in_a && in_a->size() == d_ + 1 && carrier_of(b, q) &&
           ascending(simplices_[a]) != ascending(simplices_[b]);
  }

  // Does one simplex only have the facet?
  bool is_on_boundary(const Entry& entry) const {
    const std::vector<Integer> wanted = facet(entry);
    std::size_t uses = 0;
    for (std::size_t s = 0; s < simplices_.size(); ++s) {
      const std::vector<Integer> vertices = ascending(simplices_[s]);
      uses +=
          std::includes(vertices.begin(), vertices.end(), wanted.begin(), wanted.end()) ? 1u : 0u;
    }
    return uses == 1 && solid(simplices_[entry.simplex]);
  }

  bool is_beyond(const Entry& entry, const Integer& v) const {
    return names_point(v) &&
           sign(barycentric(*solid(simplices_[entry.simplex]), point(v).at)->at(entry.place)) < 0;
  }

  bool is_not_convex() {
    const Entry a = read_entry();
    const Integer v = tokens_.integer();
    return is_on_boundary(a) && is_beyond(a, v);
  }

  bool is_not_closed() {
    const Entry a = read_entry();
    const Entry b = read_entry();
    const Entry c = read_entry();
    const std::vector<Integer> first = facet(a);
    std::size_t shared = 0;
    for (const Integer& v : first) {
      const auto in = [&](const Entry& other) {
        const std::vector<Integer> vertices = facet(other);
        return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
      };
      shared += in(b) && in(c) ? 1u : 0u;
    }
    return is_on_boundary(a) && is_on_boundary(b) && is_on_boundary(c) &&
           std::set{first, facet(b), facet(c)}.size() == 3 && shared + 1 == d_;
  }

  bool is_unused() {
    const Integer v = tokens_.integer();
    if (!names_point(v)) return false;
    for (const std::vector<Integer>& vertices : simplices_) {
      if (std::find(vertices.begin(), vertices.end(), v) != vertices.end()) return false;
    }
    return true;
  }

  std::vector<Integer> around() {
    std::vector<Integer> vertices;
    for (std::size_t i = 0; i <= d_; ++i) vertices.push_back(tokens_.integer());
    return vertices;
  }

  bool is_uncovered() {
    const Integer v = tokens_.integer();
    if (!names_point(v)) return false;
    const Point& q = point(v).at;
    for (const std::vector<Integer>& vertices : simplices_) {
      const std::size_t place = tokens_.count();
      const auto corners = solid(vertices);
      if (!corners || sign(barycentric(*corners, q)->at(place)) >= 0) return false;
    }
    return true;
  }

  Rational height(const Integer& v) const { return height_of(point(v).at, point(v).weight); }

  Rational depth_of(const std::vector<Integer>& vertices, const Integer& v) const {
    std::vector<Rational> heights;
    for (const Integer& corner : vertices) heights.push_back(height(corner));
    return depth(*solid(vertices), heights, point(v).at, height(v));
  }

  bool is_below(const std::vector<Integer>& vertices, const Integer& v) const {
    return names_point(v) && solid(vertices) && sign(depth_of(vertices, v)) > 0;
  }

  bool is_not_local() {
    const Entry a = read_entry();
    const Entry b = read_entry();
    return facet(a) == facet(b) && solid(simplices_[b.simplex]) &&
           is_below(simplices_[a.simplex], at(b)) && is_beyond(a, at(b));
  }

  bool is_submerged() {
    const Integer v = entry();
    const std::vector<Integer> vertices = around();
    const auto corners = solid(vertices);
    return corners && names_point(v) && carrier(*barycentric(*corners, point(v).at)) &&
           sign(depth_of(vertices, v)) < 0;
  }

  Tokens tokens_;
  Header header_;
  std::size_t d_ = 0;
  std::vector<ListedPoint> points_;
  LabelledPoints labelled_;
  std::vector<std::vector<Integer>> simplices_;
  bool spans_ = false;
};

// Writes what proves a verdict and holds it against its conditions, for tests.

inline std::string text_of(const ExactMesh& mesh, const Document& document) {
  std::ostringstream out;
  write(out, mesh, document);
  return out.str();
}

// Are these the points of the user's mesh, scaled back?
inline bool are_points_of(const ExactMesh& mesh, const LabelledPoints& points) {
  if (points.size() != mesh.points.size()) return false;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const auto found = points.find(std::to_string(mesh.label(v)));
    if (found == points.end()) return false;
    Point expected = mesh.points[v];
    if (found->second.size() > expected.size()) expected.push_back(mesh.points.weight(v));
    if (found->second != expected) return false;
  }
  return true;
}

// What is wrong with the document, whatever it is; empty if it proves its claim about this mesh.
inline std::string fault_of(const ExactMesh& mesh, const Verdict& verdict,
                            const std::string& text) {
  const auto fault = [&](const auto& acceptor) -> std::string {
    if (acceptor.header().claim != name(verdict.claim())) return "another claim";
    if (acceptor.header().dimension != mesh.points.ambient_dimension()) return "another dimension";
    if (!are_points_of(mesh, acceptor.labelled_points())) return "other points";
    return acceptor.simplex_count() == mesh.simplices.size() ? "" : "other simplices";
  };
  if (verdict.holds()) {
    const CertificateAcceptor acceptor(text);
    const std::string condition = acceptor.verdict();
    const bool unique = verdict.unique.value_or(false);
    const std::string standing = unique                              ? "unique"
                                 : verdict.canonical.value_or(false) ? "canonical"
                                                                     : "";
    if (acceptor.header().standing != standing) return "another standing";
    return condition == "accepted" ? fault(acceptor) : condition;
  }
  RefutationAcceptor acceptor(text);
  return acceptor.accepts() ? fault(acceptor) : "no evidence of " + acceptor.header().rule;
}

// What is wrong with what is written about the mesh.
inline std::string fault_of(const ExactMesh& mesh, const Verdict& verdict) {
  const auto document = document_of(mesh, verdict);
  if (!document) return document.error();
  return fault_of(mesh, verdict, text_of(mesh, *document));
}

// The rule that a refutation is about; empty if it is none or there is none.
inline std::string refuted_rule(const ExactMesh& mesh, const Verdict& verdict) {
  const auto document = document_of(mesh, verdict);
  if (!document || !std::holds_alternative<RefutationWithPoints>(*document)) return "";
  return std::string(identifier(std::get<RefutationWithPoints>(*document).refutation.rule));
}

}  // namespace circumspect::certificate
