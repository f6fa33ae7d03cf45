// Gathers the faulty simplices and points of all ranks at the first rank.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/exact/each_once.hpp"
#include "oracle/distributed/local_mesh.hpp"
#include "oracle/distributed/ranks.hpp"
#include "oracle/judge/fast/mesh_view.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::distributed {

// A part of a mesh as a mesh of its own, with simplices and points renumbered in the order of the
// whole; an index that names no point of the whole is kept, and names none of the part. All ranks
// but the first have an empty one.
template <std::size_t kDimension>
class Gathered {
 public:
  // Gathers the simplices of these facets, with their vertices, and further points. Called by all
  // ranks; only the first rank's arguments count.
  Gathered(Ranks& ranks, const LocalMesh<kDimension>& mesh, std::vector<FacetName> wanted,
           const std::vector<NumberedPoint<kDimension>>& further)
      : first_index_(mesh.dealt().first_index), weighted_(mesh.is_weighted()) {
    for (FacetName& name : wanted) name = simplex_of_name(name);
    keep_each_once(wanted);
    std::vector<std::vector<std::uint32_t>> asked(ranks.size());
    if (ranks.is_first()) {
      for (const FacetName name : wanted) {
        asked[static_cast<std::size_t>(name.rank)].push_back(name.facet / kVertices);
      }
    }
    std::vector<Found> own;
    for (const std::uint32_t s : ranks.exchanged(std::move(asked))) {
      Found& found = own.emplace_back();
      found.place = mesh.place(s);
      found.name = {static_cast<std::int32_t>(ranks.rank()),
                    static_cast<std::uint32_t>(s * kVertices)};
      for (std::size_t i = 0; i < kVertices; ++i) {
        found.row[i] = mesh.vertex(s, i);
        found.is_point[i] = mesh.view().row(s)[i] >= 0;
        if (!found.is_point[i]) continue;
        found.sites[i] = mesh.site(mesh.view().row(s)[i]);
      }
    }
    number(ranks.at_first(std::move(own)), further);
  }

  fast::MeshView<kDimension, std::int64_t> view() const {
    return {coordinates_, weights_, simplices_};
  }

  // The name of a simplex or a facet in the part. Requires: the part has the simplex.
  std::size_t simplex(FacetName name) const {
    const auto found =
        std::lower_bound(names_.begin(), names_.end(), simplex_of_name(name),
                         [](const auto& entry, FacetName wanted) { return entry.first < wanted; });
    return found->second;
  }
  fast::FacetId facet(FacetName name) const { return {simplex(name), name.facet % kVertices}; }

  // The number of a point in the part. Requires: the part has the point.
  std::size_t point(std::uint64_t index) const {
    return static_cast<std::size_t>(
        std::lower_bound(labels_.begin(), labels_.end(), static_cast<Vertex>(index)) -
        labels_.begin());
  }

  // For the report: vertices have the names that they have in the whole.
  Mesh named() const {
    Mesh mesh;
    Rows<double> coordinates(labels_.size(), kDimension);
    std::copy(coordinates_.begin(), coordinates_.end(), coordinates.values().begin());
    mesh.coordinates = std::move(coordinates);
    if (weighted_) {
      Rows<double> weights(labels_.size(), 1);
      std::copy(weights_.begin(), weights_.end(), weights.values().begin());
      mesh.weights = std::move(weights);
    }
    Rows<std::int64_t> simplices(simplices_.size() / kVertices, kVertices);
    std::copy(simplices_.begin(), simplices_.end(), simplices.values().begin());
    mesh.simplices = std::move(simplices);
    mesh.first_index = first_index_;
    for (const Vertex v : labels_) mesh.labels.push_back(index_of_place(v, first_index_));
    return mesh;
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  struct Found {
    std::uint64_t place = 0;  // in the whole
    FacetName name = {};
    std::array<std::int64_t, kVertices> row = {};
    std::array<bool, kVertices> is_point = {};
    fast::SiteRow<kDimension> sites = {};
  };

  // One name for all facets of a simplex.
  static FacetName simplex_of_name(FacetName name) {
    return {name.rank, static_cast<std::uint32_t>(name.facet / kVertices * kVertices)};
  }

  void number(std::vector<Found> found, std::vector<NumberedPoint<kDimension>> points) {
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.place < b.place; });
    for (const Found& simplex : found) {
      for (std::size_t i = 0; i < kVertices; ++i) {
        if (!simplex.is_point[i]) continue;
        points.push_back({static_cast<std::uint64_t>(simplex.row[i]), simplex.sites[i]});
      }
    }
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.index < b.index; });
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0 && points[i].index == points[i - 1].index) continue;
      labels_.push_back(static_cast<Vertex>(points[i].index));
      const fast::Site<kDimension>& site = points[i].site;
      coordinates_.insert(coordinates_.end(), site.at.begin(), site.at.end());
      if (weighted_) weights_.push_back(site.weight);
    }
    for (std::size_t s = 0; s < found.size(); ++s) {
      names_.emplace_back(found[s].name, s);
      for (std::size_t i = 0; i < kVertices; ++i) {
        const std::int64_t v = found[s].row[i];
        simplices_.push_back(found[s].is_point[i]
                                 ? static_cast<std::int64_t>(point(static_cast<std::uint64_t>(v)))
                                 : v);
      }
    }
    std::sort(names_.begin(), names_.end());
  }

  Vertex first_index_;
  bool weighted_;
  std::vector<Vertex> labels_;  // of the points, in the whole, from 0; ascending
  std::vector<double> coordinates_;
  std::vector<double> weights_;
  std::vector<std::int64_t> simplices_;
  std::vector<std::pair<FacetName, std::size_t>> names_;
};

}  // namespace circumspect::distributed
