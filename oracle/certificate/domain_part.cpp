#include "oracle/certificate/domain_part.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "kernel/exact/linear_algebra.hpp"
#include "oracle/certificate/scaled_points.hpp"

namespace circumspect::certificate {
namespace {

std::span<const Vertex> vertices_of(const Certificate& mesh, std::size_t simplex) {
  return std::span<const Vertex>(mesh.simplices[simplex].vertices).first(mesh.points.dimension + 1);
}

Simplex facet_of(const Certificate& mesh, std::size_t simplex, std::size_t place) {
  Simplex facet;
  const auto vertices = vertices_of(mesh, simplex);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i != place) facet.push_back(vertices[i]);
  }
  return sorted(facet);
}

void find_roles(const PartInput& input, DomainPart& part) {
  part.roles.resize(input.is_corner.size());
  for (std::size_t s = 0; s < input.mesh.simplices.size(); ++s) {
    for (const Vertex v : vertices_of(input.mesh, s)) {
      const auto place = static_cast<std::size_t>(v);
      if (input.is_corner[place] && !part.roles[place].corner_of) {
        part.roles[place].corner_of = static_cast<std::uint32_t>(s);
        part.dangles = part.dangles || s >= input.kept;
      }
    }
  }
  for (std::size_t v = 0; v < input.weights.size(); ++v) part.roles[v].weights = input.weights[v];
}

// For each edge of the chains a simplex, a kept one if there is one; and the place of a vertex that
// the edge leaves out.
std::map<Simplex, std::pair<std::uint32_t, std::size_t>> simplices_at_links(
    const PartInput& input) {
  std::map<Simplex, std::pair<std::uint32_t, std::size_t>> found;
  std::vector<bool> touched(input.is_corner.size(), false);
  for (const std::vector<Vertex>& chain : input.chains) {
    for (const Vertex v : chain) touched[static_cast<std::size_t>(v)] = true;
  }
  for (std::size_t s = 0; s < input.mesh.simplices.size(); ++s) {
    const auto vertices = vertices_of(input.mesh, s);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (!touched[static_cast<std::size_t>(vertices[i])]) continue;
      for (std::size_t j = i + 1; j < vertices.size(); ++j) {
        if (!touched[static_cast<std::size_t>(vertices[j])]) continue;
        std::size_t other = 0;
        while (other == i || other == j) ++other;
        found.emplace(sorted({vertices[i], vertices[j]}),
                      std::pair(static_cast<std::uint32_t>(s), other));
      }
    }
  }
  return found;
}

bool find_steps(const PartInput& input, DomainPart& part) {
  const auto simplices = simplices_at_links(input);
  for (const std::vector<Vertex>& chain : input.chains) {
    SegmentSteps& segment = part.segments.emplace_back(SegmentSteps{chain.front()});
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const auto found = simplices.find(sorted({chain[i - 1], chain[i]}));
      if (found == simplices.end()) return false;
      segment.steps.push_back({chain[i], found->second.first, found->second.second});
      part.dangles = part.dangles || found->second.first >= input.kept;
    }
  }
  return true;
}

// From the holes and the outside through facets that are in no wall, in as few steps as possible.
bool find_ways_out(const PartInput& input, DomainPart& part) {
  std::deque<std::uint32_t> reached;
  for (std::size_t h = 0; h < part.holes.size(); ++h) {
    Mark& mark = part.marks[part.holes[h].simplex];
    if (mark.rank != 0) continue;
    mark.hole = h;
    mark.rank = 1;
    reached.push_back(part.holes[h].simplex);
  }
  const std::size_t size = input.mesh.points.dimension + 1;
  for (std::size_t s = input.kept; s < part.marks.size(); ++s) {
    Mark& mark = part.marks[s];
    for (std::size_t place = 0; mark.rank == 0 && place < size; ++place) {
      if (mark.flags[place] || input.mesh.simplices[s].across[place].place != Across::kHull)
        continue;
      mark.place = place;
      mark.rank = 1;
      reached.push_back(static_cast<std::uint32_t>(s));
    }
  }
  while (!reached.empty()) {
    const std::uint32_t s = reached.front();
    reached.pop_front();
    for (std::size_t place = 0; place < size; ++place) {
      const Across& across = input.mesh.simplices[s].across[place];
      if (part.marks[s].flags[place] || across.place == Across::kHull || across.cell < input.kept)
        continue;
      Mark& mark = part.marks[across.cell];
      if (mark.rank != 0) continue;
      mark.place = static_cast<std::size_t>(across.place);
      mark.rank = part.marks[s].rank + 1;
      reached.push_back(across.cell);
    }
  }
  return std::all_of(part.marks.begin() + static_cast<std::ptrdiff_t>(input.kept), part.marks.end(),
                     [](const Mark& mark) { return mark.rank != 0; });
}

// Said of what dangles, if the mesh of the hull does not have it.
constexpr std::string_view kNotInHull = "what dangles is in no mesh of the hull that was found";

}  // namespace

std::vector<Simplex> dangling_faces(const ExactMesh& mesh) {
  std::set<Simplex> listed;
  for (const Simplex& face : mesh.faces) listed.insert(sorted(face));
  const auto remove_faces = [&](const Simplex& simplex, std::size_t most) {
    for (unsigned subset = 1; subset < 1U << simplex.size() && !listed.empty(); ++subset) {
      Simplex face;
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        if ((subset >> i & 1U) != 0) face.push_back(simplex[i]);
      }
      if (face.size() <= most) listed.erase(sorted(face));
    }
  };
  for (const Simplex& simplex : mesh.simplices) {
    if (simplex.size() <= 4) remove_faces(simplex, simplex.size());
  }
  const std::set<Simplex> all = listed;
  for (const Simplex& face : all) remove_faces(face, face.size() - 1);
  return {listed.begin(), listed.end()};
}

tl::expected<DomainPart, std::string> domain_part(const PartInput& input) {
  DomainPart part;
  find_roles(input, part);
  for (std::size_t v = 0; v < part.roles.size(); ++v) {
    if (input.is_corner[v] && !part.roles[v].corner_of)
      return tl::unexpected(std::string(kNotInHull));
  }
  if (!find_steps(input, part)) return tl::unexpected(std::string(kNotInHull));
  const std::size_t size = input.mesh.points.dimension + 1;
  part.marks.resize(input.mesh.simplices.size());
  for (std::size_t s = 0; s < part.marks.size(); ++s) {
    for (std::size_t place = 0; !input.walls.empty() && place < size; ++place) {
      const auto wall = input.walls.find(facet_of(input.mesh, s, place));
      if (wall != input.walls.end()) part.marks[s].flags[place] = wall->second;
    }
  }
  for (const HomogeneousPoint& seed : input.seeds) {
    part.holes.push_back({seed, *simplex_around(input, seed)});
  }
  if (!find_ways_out(input, part)) return tl::unexpected(std::string(kNotInHull));
  return part;
}

std::vector<std::pair<Integer, Vertex>> combination(const ScaledPoints& points,
                                                    const std::vector<Simplex>& simplices,
                                                    Vertex v) {
  const std::size_t d = points.dimension;
  for (const Simplex& simplex : simplices) {
    std::vector<Integer> weights;
    for (std::size_t place = 0; place <= d; ++place) {
      SquareMatrix rows(d + 1);
      for (std::size_t row = 0; row <= d; ++row) {
        const Vertex vertex = row == place ? v : simplex[row];
        for (std::size_t axis = 0; axis < d; ++axis)
          rows(row, axis) = points.coordinate(vertex, axis);
        rows(row, d) = 1;
      }
      weights.push_back(determinant(std::move(rows)));
    }
    const auto has_sign = [&](int sign) {
      return std::any_of(weights.begin(), weights.end(),
                         [&](const Integer& weight) { return sgn(weight) == sign; });
    };
    if (has_sign(1) && has_sign(-1)) continue;
    std::vector<std::pair<Integer, Vertex>> found;
    for (std::size_t place = 0; place <= d; ++place) {
      if (weights[place] != 0) found.emplace_back(abs(weights[place]), simplex[place]);
    }
    return found;
  }
  return {};
}

std::optional<std::uint32_t> simplex_around(const PartInput& input, const HomogeneousPoint& seed) {
  Sidedness sidedness(input.mesh.points);
  std::optional<std::uint32_t> found;
  for (std::size_t s = input.kept; s < input.mesh.simplices.size(); ++s) {
    const auto vertices = vertices_of(input.mesh, s);
    int least = 1;
    for (std::size_t place = 0; least >= 0 && place < vertices.size(); ++place) {
      least = std::min(least, sidedness.orientation_with(vertices, place, seed));
    }
    if (least >= 0) found = static_cast<std::uint32_t>(s);
    if (least > 0) break;
  }
  return found;
}

}  // namespace circumspect::certificate
