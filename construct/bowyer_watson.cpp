#include "construct/bowyer_watson.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace circumspect::construct {
namespace {

template <std::size_t kVertices>
std::size_t place_of(const std::array<Place, kVertices>& vertices, Place v) {
  std::size_t place = 0;
  while (vertices[place] != v) ++place;
  return place;
}

template <std::size_t kVertices>
bool is_solid(const std::array<Place, kVertices>& vertices) {
  return std::find(vertices.begin(), vertices.end(), kGhost) == vertices.end();
}

template <std::size_t kVertices>
std::array<Place, kVertices - 1> facet_of(const std::array<Place, kVertices>& vertices,
                                          std::size_t opposite) {
  std::array<Place, kVertices - 1> facet;
  std::size_t size = 0;
  for (std::size_t i = 0; i < kVertices; ++i) {
    if (i != opposite) facet[size++] = vertices[i];
  }
  std::sort(facet.begin(), facet.end());
  return facet;
}

fast::Site<2> on_axes(const fast::Site<3>& site, std::size_t x, std::size_t y) {
  return {{site.at[x], site.at[y]}};
}

bool are_collinear(const fast::Site<3>& a, const fast::Site<3>& b, const fast::Site<3>& c) {
  fast::Stages stages;
  const auto vanishes = [&](std::size_t x, std::size_t y) {
    return fast::orientation(on_axes(a, x, y), on_axes(b, x, y), on_axes(c, x, y), stages) == 0;
  };
  return vanishes(0, 1) && vanishes(0, 2) && vanishes(1, 2);
}

}  // namespace

template <std::size_t kDimension>
std::optional<std::array<std::size_t, kDimension + 1>> first_independent(
    const std::vector<fast::Site<kDimension>>& sites) {
  if (sites.size() <= kDimension) return std::nullopt;
  std::array<std::size_t, kDimension + 1> found = {0, 1};
  std::size_t next = 2;
  if constexpr (kDimension == 3) {
    while (next < sites.size() && are_collinear(sites[0], sites[1], sites[next])) ++next;
    found[2] = next++;
  }
  fast::Stages stages;
  for (; next < sites.size(); ++next) {
    fast::SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kDimension; ++i) row[i] = sites[found[i]];
    row[kDimension] = sites[next];
    found[kDimension] = next;
    if (fast::orientation<kDimension>(row, stages) != 0) return found;
  }
  return std::nullopt;
}

// The solid simplex, and a ghost beyond each of its facets.
template <std::size_t kDimension, bool kWeighted>
BowyerWatson<kDimension, kWeighted>::BowyerWatson(std::vector<Site> sites, fast::Lattice lattice)
    : sites_(std::move(sites)), lattice_(lattice) {
  Cell solid;
  for (std::size_t i = 0; i < kVertices; ++i) solid.vertices[i] = static_cast<Place>(i);
  if (orientation_with(solid, 0, sites_[0]) < 0) std::swap(solid.vertices[0], solid.vertices[1]);
  cells_.push_back(solid);
  for (std::size_t i = 0; i < kVertices; ++i) {
    Cell ghost = solid;
    ghost.vertices[i] = kGhost;
    std::swap(ghost.vertices[(i + 1) % kVertices], ghost.vertices[(i + 2) % kVertices]);
    cells_.push_back(ghost);
  }
  for (std::size_t a = 0; a < cells_.size(); ++a) {
    for (std::size_t i = 0; i < kVertices; ++i) {
      for (std::size_t b = 0; b < cells_.size(); ++b) {
        for (std::size_t j = 0; a != b && j < kVertices; ++j) {
          if (facet_of(cells_[a].vertices, i) == facet_of(cells_[b].vertices, j)) {
            cells_[a].across[i] = {b, j};
          }
        }
      }
    }
  }
  looked_at_.assign(cells_.size(), 0);
}

template <std::size_t kDimension, bool kWeighted>
auto BowyerWatson<kDimension, kWeighted>::sites_of(const Cell& cell, std::size_t replaced,
                                                   const Site& site) const
    -> std::array<const Site*, kVertices> {
  std::array<const Site*, kVertices> sites;
  for (std::size_t i = 0; i < kVertices; ++i) {
    sites[i] = i == replaced ? &site : &sites_[static_cast<std::size_t>(cell.vertices[i])];
  }
  return sites;
}

template <std::size_t kDimension, bool kWeighted>
int BowyerWatson<kDimension, kWeighted>::orientation_with(const Cell& cell, std::size_t replaced,
                                                          const Site& site) {
  return std::apply(
      [&](const auto*... one) { return fast::orientation(*one..., stages_, lattice_); },
      sites_of(cell, replaced, site));
}

template <std::size_t kDimension, bool kWeighted>
bool BowyerWatson<kDimension, kWeighted>::is_solid_in_conflict(const Cell& cell, const Site& site) {
  const auto sites = sites_of(cell, kVertices, site);
  const int side = std::apply(
      [&](const auto*... one) {
        return fast::Ball<kDimension, kWeighted>(*one..., lattice_).contains(site, stages_);
      },
      sites);
  if (side != 0) return side > 0;
  fast::SiteRow<kDimension> row;
  for (std::size_t i = 0; i < kVertices; ++i) row[i] = *sites[i];
  return fast::perturbed_sign_of_zero<kDimension>(row, 1, site, stages_, lattice_) > 0;
}

// A site in the plane of a ghost's facet is in the facet's (perturbed) open circumdisk iff it is in
// the circumball of the solid cell on the other side: the disk is where the plane cuts the ball,
// and the site's barycentric coordinate at the cell's other vertex is zero.
template <std::size_t kDimension, bool kWeighted>
bool BowyerWatson<kDimension, kWeighted>::is_in_conflict(std::size_t cell, const Site& site) {
  const Cell& one = cells_[cell];
  if (is_solid(one.vertices)) return is_solid_in_conflict(one, site);
  const std::size_t ghost = place_of(one.vertices, kGhost);
  const int side = orientation_with(one, ghost, site);
  if (side != 0) return side > 0;
  return is_solid_in_conflict(cells_[one.across[ghost].cell()], site);
}

// Walks through facets that the site is strictly beyond. In a Delaunay triangulation, weighted or
// not, no such walk meets a cell twice; it ends in a ghost, beyond whose facet the site is, or in
// the solid cell that contains it.
template <std::size_t kDimension, bool kWeighted>
std::size_t BowyerWatson<kDimension, kWeighted>::cell_towards(const Site& site) {
  std::size_t cell = recent_;
  std::size_t from = kVertices;
  while (is_solid(cells_[cell].vertices)) {
    std::size_t out = 0;
    while (out < kVertices && (out == from || orientation_with(cells_[cell], out, site) >= 0)) {
      ++out;
    }
    if (out == kVertices) return cell;
    const Across next = cells_[cell].across[out];
    cell = next.cell();
    from = next.place();
  }
  return cell;
}

template <std::size_t kDimension, bool kWeighted>
void BowyerWatson<kDimension, kWeighted>::dig_cavity(std::size_t first, Place inserted) {
  const Site& site = sites_[static_cast<std::size_t>(inserted)];
  in_cavity_ = 2 * static_cast<std::uint32_t>(inserted) + 1;
  const std::uint32_t outside = in_cavity_ - 1;
  cavity_.assign(1, first);
  boundary_.clear();
  looked_at_[first] = in_cavity_;
  for (std::size_t i = 0; i < cavity_.size(); ++i) {
    for (std::size_t place = 0; place < kVertices; ++place) {
      const std::size_t beyond = cells_[cavity_[i]].across[place].cell();
      if (looked_at_[beyond] != in_cavity_ && looked_at_[beyond] != outside) {
        looked_at_[beyond] = is_in_conflict(beyond, site) ? in_cavity_ : outside;
        if (is_in_cavity(beyond)) cavity_.push_back(beyond);
      }
      if (!is_in_cavity(beyond)) boundary_.emplace_back(cavity_[i], place);
    }
  }
}

// Joins each facet of the cavity to the site, which takes the place of the vertex inside. The cells
// of the cavity stay until all are joined, and their facets of the boundary lead to the new cells.
template <std::size_t kDimension, bool kWeighted>
bool BowyerWatson<kDimension, kWeighted>::fill_cavity(Place inserted) {
  for (const Across facet : boundary_) {
    std::size_t created = cells_.size();
    if (free_.empty()) {
      if (created == kMostCells) return false;
      cells_.emplace_back();
      looked_at_.push_back(0);
    } else {
      created = free_.back();
      free_.pop_back();
    }
    Cell& inside = cells_[facet.cell()];
    Cell& cell = cells_[created];
    cell = {inside.vertices};
    cell.vertices[facet.place()] = inserted;
    const Across outside = inside.across[facet.place()];
    cell.across[facet.place()] = outside;
    cells_[outside.cell()].across[outside.place()] = {created, facet.place()};
    inside.across[facet.place()] = {created, facet.place()};
    if (is_solid(cell.vertices)) recent_ = created;
  }
  for (const Across facet : boundary_) {
    const std::size_t created = cells_[facet.cell()].across[facet.place()].cell();
    for (std::size_t place = 0; place < kVertices; ++place) {
      if (cells_[created].across[place].is_known()) continue;
      const Across other = turned(facet, place);
      cells_[created].across[place] = other;
      cells_[other.cell()].across[other.place()] = {created, place};
    }
  }
  free_.insert(free_.end(), cavity_.begin(), cavity_.end());
  return true;
}

// The new cell of a facet of the boundary has another new cell across the facet opposite `place`.
// Both have the ridge of the facet without the vertex at that place: turning around it through the
// cavity leads to the facet of the boundary that the other one is joined to.
template <std::size_t kDimension, bool kWeighted>
Across BowyerWatson<kDimension, kWeighted>::turned(Across facet, std::size_t place) const {
  const Cell* cell = &cells_[facet.cell()];
  Place beside = cell->vertices[facet.place()];  // the facet to pass has this and the ridge
  while (true) {
    const Across next = cell->across[place];
    const std::size_t passed = place_of(cell->vertices, beside);
    if (!is_in_cavity(next.cell())) return {next.cell(), passed};
    cell = &cells_[next.cell()];
    place = place_of(cell->vertices, beside);
    beside = cell->vertices[next.place()];
  }
}

template <std::size_t kDimension, bool kWeighted>
bool BowyerWatson<kDimension, kWeighted>::insert(Place inserted) {
  const Site& site = sites_[static_cast<std::size_t>(inserted)];
  const std::size_t first = cell_towards(site);
  if constexpr (kWeighted) {
    if (!is_in_conflict(first, site)) {  // submerged; the next site is near, too
      recent_ = first;
      return true;
    }
  }
  dig_cavity(first, inserted);
  return fill_cavity(inserted);
}

template <std::size_t kDimension, bool kWeighted>
std::vector<Place> BowyerWatson<kDimension, kWeighted>::solid_cells() const {
  std::vector<bool> is_free(cells_.size());
  for (const std::size_t cell : free_) is_free[cell] = true;
  std::vector<Place> vertices;
  vertices.reserve(cells_.size() * kVertices);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const auto& own = cells_[c].vertices;
    if (!is_free[c] && is_solid(own)) vertices.insert(vertices.end(), own.begin(), own.end());
  }
  return vertices;
}

template class BowyerWatson<2, false>;
template class BowyerWatson<2, true>;
template class BowyerWatson<3, false>;
template class BowyerWatson<3, true>;
template std::optional<std::array<std::size_t, 3>> first_independent<2>(
    const std::vector<fast::Site<2>>&);
template std::optional<std::array<std::size_t, 4>> first_independent<3>(
    const std::vector<fast::Site<3>>&);

}  // namespace circumspect::construct
