#include "oracle/certificate/certificate.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>

#include "kernel/boxes/point_search.hpp"
#include "oracle/certificate/scaled_points.hpp"
#include "oracle/judge/fast/facet_matching.hpp"

namespace circumspect::certificate {

FaceUse face_use(std::span<const std::uint32_t> vertices, std::size_t cell, std::size_t place) {
  FaceUse use{{0, 0, 0}, static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(place)};
  std::size_t size = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i == place) continue;
    std::size_t at = size++;
    for (; at > 0 && use.face[at - 1] > vertices[i]; --at) use.face[at] = use.face[at - 1];
    use.face[at] = vertices[i];
  }
  return use;
}

std::vector<FaceUse> facets(const ExactMesh& mesh) {
  std::vector<FaceUse> uses;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const std::vector<std::uint32_t> vertices(mesh.simplices[s].begin(), mesh.simplices[s].end());
    for (std::size_t place = 0; place < vertices.size(); ++place) {
      uses.push_back(face_use(vertices, s, place));
    }
  }
  return uses;
}

void sort(std::vector<FaceUse>& uses) { std::sort(uses.begin(), uses.end()); }

std::vector<Vertex> lexicographic_order(const ScaledPoints& points) {
  // Rounding towards zero keeps the order of numbers, so doubles decide unless they are equal.
  std::vector<std::pair<double, Vertex>> order;
  order.reserve(points.size());
  for (Vertex v = 0; static_cast<std::size_t>(v) < points.size(); ++v) {
    order.emplace_back(points.coordinate(v, 0).get_d(), v);
  }
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first < b.first;
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      const int comparison =
          cmp(points.coordinate(a.second, axis), points.coordinate(b.second, axis));
      if (comparison != 0) return comparison < 0;
    }
    return a.second < b.second;
  });
  std::vector<Vertex> vertices;
  vertices.reserve(order.size());
  for (const auto& [x, v] : order) vertices.push_back(v);
  return vertices;
}

std::vector<std::size_t> numbers_in(const std::vector<Vertex>& order) {
  std::vector<std::size_t> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[static_cast<std::size_t>(order[i])] = i + 1;
  }
  return number;
}

namespace {

std::vector<CertifiedSimplex> with_vertices(const ExactMesh& mesh, std::size_t size) {
  std::vector<CertifiedSimplex> simplices(mesh.simplices.size());
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    assert(mesh.simplices[s].size() == size);
    std::copy_n(mesh.simplices[s].begin(), size, simplices[s].vertices.begin());
  }
  return simplices;
}

template <class Index>
std::vector<CertifiedSimplex> with_vertices(const Rows<Index>& rows) {
  std::vector<CertifiedSimplex> simplices(rows.rows());
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    const auto row = rows.row(s);
    std::copy(row.begin(), row.end(), simplices[s].vertices.begin());
  }
  return simplices;
}

std::vector<std::uint32_t> short_indices(std::span<const Vertex> vertices) {
  return {vertices.begin(), vertices.end()};
}

// The place of the vertex of `row` that is not in the facet of `other` opposite that place;
// nothing if the rest of the row is not that facet.
template <std::size_t kSize>
std::optional<std::size_t> place_beyond(std::span<const std::int32_t, kSize> row,
                                        std::span<const std::int32_t, kSize> other,
                                        std::size_t place) {
  std::optional<std::size_t> beyond;
  for (std::size_t i = 0; i < kSize; ++i) {
    const auto found = std::find(other.begin(), other.end(), row[i]);
    if (found != other.end() && found - other.begin() != static_cast<std::ptrdiff_t>(place)) {
      continue;
    }
    if (beyond) return std::nullopt;
    beyond = i;
  }
  return beyond;
}

// Sets what is across the facets that are linked. False if some link is wrong.
template <std::size_t kSize>
bool set_across(const fast::MeshView<kSize - 1, std::int32_t>& mesh,
                std::span<const std::int32_t> links, std::vector<CertifiedSimplex>& simplices) {
  bool are_right = true;
  for (std::size_t facet = 0; facet < links.size(); ++facet) {
    const std::size_t s = facet / kSize;
    if (links[facet] < static_cast<std::int64_t>(s)) continue;  // none, or it was looked at
    const auto other = static_cast<std::size_t>(links[facet]);
    const auto place = place_beyond(mesh.row(other), mesh.row(s), facet % kSize);
    are_right &= place.has_value();
    if (!place) continue;
    simplices[s].across[facet % kSize] = {static_cast<std::uint32_t>(other),
                                          static_cast<std::int32_t>(*place)};
    simplices[other].across[*place] = {static_cast<std::uint32_t>(s),
                                       static_cast<std::int32_t>(facet % kSize)};
  }
  return are_right;
}

// Matches the facets two by two; what is left over is the hull.
template <std::size_t kSize>
void match_facets_of(Certificate& certificate) {
  constexpr std::size_t kDimension = kSize - 1;
  std::vector<CertifiedSimplex>& simplices = certificate.simplices;
  std::vector<std::int32_t> rows;
  rows.reserve(simplices.size() * kSize);
  for (const CertifiedSimplex& simplex : simplices) {
    for (std::size_t i = 0; i < kSize; ++i) {
      rows.push_back(static_cast<std::int32_t>(simplex.vertices[i]));
    }
  }
  // The engine asks how many points there are, and not where.
  const std::vector<double> anywhere(certificate.points.size() * kDimension);
  const fast::MeshView<kDimension, std::int32_t> mesh{anywhere, {}, rows};
  // A complete proposal links two facets wrongly only if both are of the hull.
  for (const auto proposal : {fast::Proposal::kLikely, fast::Proposal::kComplete}) {
    const auto links = fast::matched_facets(mesh, 1, proposal);
    assert(links && links->overused.empty());
    if (set_across<kSize>(mesh, links->view(), simplices)) break;
  }
  std::vector<FaceUse> hull;
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    for (std::size_t place = 0; place < kSize; ++place) {
      if (simplices[s].across[place].place != Across::kHull) continue;
      hull.push_back(face_use(short_indices({simplices[s].vertices.data(), kSize}), s, place));
    }
  }
  sort(hull);
  for (const FaceUse& use : hull) {
    simplices[use.cell].across[use.place].cell =
        static_cast<std::uint32_t>(certificate.hull.size());
    certificate.hull.push_back({use.cell, use.place});
  }
}

void match_facets(Certificate& certificate) {
  certificate.points.dimension == 2 ? match_facets_of<3>(certificate)
                                    : match_facets_of<4>(certificate);
}

// The ridges of the hull lie in two hull facets each.
void match_ridges(Certificate& certificate) {
  const std::size_t size = certificate.points.dimension + 1;
  std::vector<FaceUse> uses;
  uses.reserve((size - 1) * certificate.hull.size());
  for (std::size_t h = 0; h < certificate.hull.size(); ++h) {
    const HullFacet& facet = certificate.hull[h];
    std::vector<std::uint32_t> vertices =
        short_indices(std::span(certificate.simplices[facet.simplex].vertices).first(size));
    vertices.erase(vertices.begin() + facet.place);
    for (std::size_t place = 0; place < vertices.size(); ++place) {
      uses.push_back(face_use(vertices, h, place));
    }
  }
  for_each_face(uses, [&](std::span<const FaceUse> group) {
    assert(group.size() == 2);
    const FaceUse& a = group.front();
    const FaceUse& b = group.back();
    certificate.hull[a.cell].across[a.place] = {b.cell, static_cast<std::int32_t>(b.place)};
    certificate.hull[b.cell].across[b.place] = {a.cell, static_cast<std::int32_t>(a.place)};
  });
}

// Points that are not vertices, which only a weighted triangulation has, are looked for.
void find_incidences(Certificate& certificate) {
  const std::size_t size = certificate.points.dimension + 1;
  std::vector<std::optional<Incidence>> found(certificate.points.size());
  for (std::size_t s = 0; s < certificate.simplices.size(); ++s) {
    for (std::size_t place = 0; place < size; ++place) {
      const auto v = static_cast<std::size_t>(certificate.simplices[s].vertices[place]);
      if (!found[v]) found[v] = Incidence{static_cast<std::uint32_t>(s), place};
    }
  }
  std::vector<std::size_t> others;
  for (std::size_t v = 0; v < found.size(); ++v) {
    if (!found[v]) others.push_back(v);
  }
  const std::vector<std::uint32_t> simplices = simplices_that_contain(certificate, others);
  for (std::size_t i = 0; i < others.size(); ++i) {
    found[others[i]] = Incidence{simplices[i], std::nullopt};
  }
  for (const std::optional<Incidence>& incidence : found) {
    certificate.incidences.push_back(*incidence);
  }
}

// Swaps two vertices where that makes the orientation positive, and parts each simplex from the
// sample point. That is the barycentre of the first, in the interior of what the mesh covers, so on
// the inner side of all hull facets, and in no other simplex (docs/theory/points.md).
void orient_and_part(Certificate& certificate) {
  const std::size_t size = certificate.points.dimension + 1;
  const std::array<Vertex, 4>& first = certificate.simplices.front().vertices;
  certificate.sample = barycentre(certificate.points, Simplex(first.begin(), first.begin() + size));
  Sidedness sidedness(certificate.points);
  for (std::size_t s = 0; s < certificate.simplices.size(); ++s) {
    CertifiedSimplex& simplex = certificate.simplices[s];
    const auto vertices = std::span(simplex.vertices).first(size);
    if (sidedness.orientation(vertices) < 0) std::swap(vertices[size - 2], vertices[size - 1]);
    if (s == 0) continue;
    simplex.separating = sidedness.separating_place(vertices, 1, certificate.sample);
    assert(simplex.separating);
  }
}

Certificate completed(Claim claim, ScaledPoints points, std::vector<CertifiedSimplex> simplices) {
  assert(!simplices.empty());
  assert(points.size() < std::numeric_limits<std::uint32_t>::max());
  assert(simplices.size() < std::size_t{1} << 29);  // facets are numbered
  Certificate certificate{claim, std::move(points)};
  certificate.order = lexicographic_order(certificate.points);
  certificate.simplices = std::move(simplices);
  orient_and_part(certificate);
  match_facets(certificate);
  match_ridges(certificate);
  find_incidences(certificate);
  return certificate;
}

}  // namespace

Certificate certificate_of(const ExactMesh& mesh, Claim claim, ScaledPoints points) {
  auto simplices = with_vertices(mesh, points.dimension + 1);
  return completed(claim, std::move(points), std::move(simplices));
}

std::optional<Certificate> certificate_of(const Mesh& mesh, const Verdict& verdict) {
  const Claim claim = verdict.claim();
  const std::size_t d = mesh.dimension();
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  const bool is_plain = verdict.holds() && !mesh.is_weighted() && !mesh.copies &&
                        (claim == Claim::kTriangulation || claim == Claim::kDelaunay);
  if (!is_plain || doubles == nullptr || (d != 2 && d != 3)) return std::nullopt;
  if (mesh.simplices.empty() || mesh.simplices.columns() != d + 1) return std::nullopt;
  return mesh.simplices.visit([&]<class Lists>(const Lists& lists) -> std::optional<Certificate> {
    if constexpr (std::is_same_v<Lists, std::vector<Simplex>>) {
      return std::nullopt;
    } else {
      auto points = scaled_to_integers(*doubles);
      if (!points) return std::nullopt;
      Certificate certificate = completed(claim, std::move(*points), with_vertices(lists));
      certificate.standing = standing_of(verdict);
      return certificate;
    }
  });
}

std::string_view standing_of(const Verdict& verdict) {
  if (verdict.unique.value_or(false)) return "unique";
  return verdict.canonical.value_or(false) ? "canonical" : "";
}

namespace {

// A certificate as the search for points wants it.
class Located {
 public:
  explicit Located(const Certificate& certificate)
      : certificate_(certificate), sidedness_(certificate.points) {}

  std::size_t size() const { return certificate_.simplices.size(); }
  std::size_t row_size() const { return certificate_.points.dimension + 1; }
  std::size_t points() const { return certificate_.points.size(); }
  std::size_t vertex(std::size_t s, std::size_t place) const {
    return static_cast<std::size_t>(certificate_.simplices[s].vertices[place]);
  }
  // Simplices of a certificate are positively oriented.
  int side(std::size_t s, std::size_t place, std::size_t point) const {
    std::array<Vertex, 4> moved = certificate_.simplices[s].vertices;
    moved[place] = static_cast<Vertex>(point);
    return sidedness_.orientation(std::span<const Vertex>(moved).first(row_size()));
  }
  std::size_t across(std::size_t s, std::size_t place) const {
    const Across& beyond = certificate_.simplices[s].across[place];
    return beyond.place == Across::kHull ? kNoSimplex : beyond.cell;
  }

 private:
  const Certificate& certificate_;
  mutable Sidedness sidedness_;  // keeps the memory of its numbers
};

}  // namespace

std::vector<std::uint32_t> simplices_that_contain(const Certificate& certificate,
                                                  std::span<const std::size_t> points) {
  const Located located(certificate);
  std::vector<std::uint32_t> simplices;
  simplices.reserve(points.size());
  for (const std::size_t s : PointSearch(located).simplices_with(points)) {
    assert(s != kNoSimplex);
    simplices.push_back(static_cast<std::uint32_t>(s));
  }
  return simplices;
}

}  // namespace circumspect::certificate
