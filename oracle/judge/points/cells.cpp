#include "oracle/judge/points/cells.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "kernel/exact/interruption.hpp"

namespace circumspect::check {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

using Key = std::span<const Vertex>;

bool is_less(Key a, Key b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

bool is_equal(Key a, Key b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

CellList sorted_keys(const CellList& cells) {
  CellList keys;
  Simplex key;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    end_if_interrupted();
    key.assign(cells[i].begin(), cells[i].end());
    std::sort(key.begin(), key.end());
    keys.add(key);
  }
  return keys;
}

// Finds the cells that have the same vertices as a given one. They are in buckets by their least
// vertices; in a mesh each bucket is small, and it is sorted in any case.
class Index {
 public:
  Index(const CellList& cells, std::size_t points)
      : keys_(sorted_keys(cells)), starts_(points + 2) {
    for (std::size_t i = 0; i < size(); ++i) ++starts_[bucket(keys_[i]) + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    order_.resize(size());
    for (std::size_t i = 0; i < size(); ++i) order_[next[bucket(keys_[i])]++] = i;
    for (std::size_t k = 0; k + 1 < starts_.size(); ++k) {
      end_if_interrupted();
      // Cells with equal keys stay as listed, because the buckets were filled in that order.
      std::stable_sort(at(starts_[k]), at(starts_[k + 1]), [this](std::size_t i, std::size_t j) {
        return is_less(keys_[i], keys_[j]);
      });
    }
    first_of_.resize(size());
    for (std::size_t place = 0; place < size(); ++place) {
      const std::size_t i = order_[place];
      const bool repeats = place > 0 && is_equal(keys_[order_[place - 1]], keys_[i]);
      first_of_[i] = repeats ? first_of_[order_[place - 1]] : place;
    }
  }

  std::size_t size() const { return keys_.size(); }
  // The sorted vertices of a cell.
  Key key(std::size_t i) const { return keys_[i]; }
  // All cells, equal ones side by side, as listed.
  std::size_t cell_at(std::size_t place) const { return order_[place]; }
  // The place of the first cell that equals cell i.
  std::size_t first_place(std::size_t i) const { return first_of_[i]; }
  // The same for these sorted vertices; kNone if there is no such cell.
  std::size_t find(Key key) const {
    const std::size_t k = bucket(key);
    const auto last = order_.begin() + static_cast<std::ptrdiff_t>(starts_[k + 1]);
    const auto found =
        std::lower_bound(order_.begin() + static_cast<std::ptrdiff_t>(starts_[k]), last, key,
                         [this](std::size_t i, Key sought) { return is_less(keys_[i], sought); });
    if (found == last || !is_equal(keys_[*found], key)) return kNone;
    return static_cast<std::size_t>(found - order_.begin());
  }

 private:
  // Vertices that name no point are in the first bucket or in the last.
  std::size_t bucket(Key key) const {
    if (key.empty() || key.front() < 0) return 0;
    return std::min(static_cast<std::size_t>(key.front()), starts_.size() - 2);
  }
  std::vector<std::size_t>::iterator at(std::size_t place) {
    return order_.begin() + static_cast<std::ptrdiff_t>(place);
  }

  CellList keys_;
  std::vector<std::size_t> starts_;    // of each bucket, in order_
  std::vector<std::size_t> order_;     // cells
  std::vector<std::size_t> first_of_;  // for each cell a place in order_
};

// Calls `visit` with every face of `size` vertices, sorted as the cell is.
template <class Visit>
void for_each_face(Key cell, std::size_t size, Simplex& face, const Visit& visit) {
  if (size == 0) return visit(Key(face));
  for (std::size_t i = 0; i + size <= cell.size(); ++i) {
    face.push_back(cell[i]);
    for_each_face(cell.subspan(i + 1), size - 1, face, visit);
    face.pop_back();
  }
}

// Listed faces, and which of them are known to be faces of a larger cell.
class Faces {
 public:
  Faces(const CellList& faces, std::size_t points)
      : index_(faces, points), covered_(faces.size()), has_face_(points, false) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      sizes_.insert(faces[i].size());
      for (const Vertex v : faces[i]) {
        if (is_point(v)) has_face_[static_cast<std::size_t>(v)] = true;
      }
    }
  }

  // All faces of the cell from its edges on, and the cell itself.
  void cover(Key cell) {
    // Most cells have few vertices that are in a face, and then few faces to be looked up.
    Simplex own, face;
    for (const Vertex v : cell) {
      if (!is_point(v) || has_face_[static_cast<std::size_t>(v)]) own.push_back(v);
    }
    std::sort(own.begin(), own.end());
    for (const std::size_t size : sizes_) {
      if (size > own.size() || (size < 2 && size != cell.size())) continue;
      for_each_face(own, size, face, [this](Key one) {
        const std::size_t place = index_.find(one);
        if (place != kNone) covered_[place] = true;
      });
    }
  }
  bool is_covered(std::size_t face) const { return covered_[index_.first_place(face)]; }
  Key key(std::size_t face) const { return index_.key(face); }

 private:
  bool is_point(Vertex v) const { return v >= 0 && static_cast<std::size_t>(v) < has_face_.size(); }

  Index index_;
  std::set<std::size_t> sizes_;
  std::vector<bool> covered_;   // by the place of the first of equal faces
  std::vector<bool> has_face_;  // of each point
};

}  // namespace

CellList dangling_faces(const std::vector<Simplex>& faces, const EachCell& each_cell,
                        std::size_t points) {
  CellList dangling;
  if (faces.empty()) return dangling;
  std::vector<std::size_t> largest_first(faces.size());
  std::iota(largest_first.begin(), largest_first.end(), std::size_t{0});
  std::stable_sort(
      largest_first.begin(), largest_first.end(),
      [&faces](std::size_t i, std::size_t j) { return faces[i].size() > faces[j].size(); });
  CellList listed;
  for (const std::size_t i : largest_first) listed.add(faces[i]);
  Faces known(listed, points);
  each_cell([&known](Key cell) {
    end_if_interrupted();
    known.cover(cell);
  });
  for (std::size_t i = 0; i < listed.size(); ++i) {
    if (known.is_covered(i)) continue;
    known.cover(known.key(i));
    dangling.add(listed[i]);
  }
  return dangling;
}

std::vector<std::size_t> stray_faces(const std::vector<Simplex>& faces, const EachCell& each_cell,
                                     std::size_t points) {
  std::vector<std::size_t> stray;
  if (faces.empty()) return stray;
  CellList listed;
  for (const Simplex& face : faces) listed.add(face);
  Faces known(listed, points);
  each_cell([&known](Key cell) {
    end_if_interrupted();
    known.cover(cell);
  });
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Key vertices = known.key(i);  // sorted
    const bool may_be_face = vertices.size() > 1 && vertices.front() >= 0 &&
                             vertices.back() < static_cast<Vertex>(points) &&
                             !has_repeated_vertex(faces[i]);
    if (!may_be_face || !known.is_covered(i)) stray.push_back(i);
  }
  return stray;
}

CellDifference difference_of_cells(const CellList& a, const CellList& b,
                                   const std::vector<Vertex>& place_in_b, std::size_t points_of_b) {
  CellDifference result;
  const Index index(b, points_of_b);
  // For each group of equal cells of b, by its first place: how many of a have met one.
  std::vector<std::size_t> met(b.size());
  const auto is_in_group = [&](std::size_t place, std::size_t first) {
    return place < b.size() && index.first_place(index.cell_at(place)) == first;
  };
  const auto place_of = [&](Vertex v) -> Vertex {
    const bool names = v >= 0 && static_cast<std::size_t>(v) < place_in_b.size();
    return names ? place_in_b[static_cast<std::size_t>(v)] : -1;
  };
  Simplex image;
  for (std::size_t i = 0; i < a.size(); ++i) {
    end_if_interrupted();
    image.clear();
    for (const Vertex v : a[i]) image.push_back(place_of(v));
    std::sort(image.begin(), image.end());
    const bool is_whole = image.empty() || image.front() >= 0;
    const std::size_t first = is_whole ? index.find(image) : kNone;
    if (first == kNone || !is_in_group(first + met[first], first)) {
      result.only_in_a.emplace_back(a[i].begin(), a[i].end());
      result.b_has_too.push_back(first != kNone);
    } else {
      ++met[first];  // the first of b that is still there
    }
  }
  const std::vector<std::size_t> met_by_a = met;
  // Among the remaining cells of b, equal cells are named at the place of the first one that lists
  // the vertices in that way.
  for (std::size_t i = 0; i < b.size(); ++i) {
    const std::size_t first = index.first_place(i);
    const std::size_t left = first + met[first];
    if (!is_in_group(left, first) || !is_equal(b[index.cell_at(left)], b[i])) continue;
    ++met[first];
    result.only_in_b.emplace_back(b[i].begin(), b[i].end());
    result.a_has_too.push_back(met_by_a[first] > 0);
  }
  return result;
}

namespace {

using WeightedPoint = std::pair<Point, Rational>;

std::map<WeightedPoint, Vertex> places(const PointSet& points) {
  std::map<WeightedPoint, Vertex> places;
  for (Vertex v = 0; points.names(v); ++v) {
    end_if_interrupted();
    places.emplace(WeightedPoint(points[v], points.weight(v)), v);
  }
  return places;
}

// The points of `mesh` that `others` lacks, and for each point its place in `others` (−1 if it has
// none).
std::vector<Vertex> matched(const PointSet& points, const std::map<WeightedPoint, Vertex>& others,
                            std::vector<Vertex>& only_here) {
  std::vector<Vertex> places;
  for (Vertex v = 0; points.names(v); ++v) {
    end_if_interrupted();
    const auto other = others.find({points[v], points.weight(v)});
    places.push_back(other == others.end() ? -1 : other->second);
    if (other == others.end()) only_here.push_back(v);
  }
  return places;
}

}  // namespace

CellList cells_of(const ExactMesh& mesh) {
  CellList cells;
  for (const Simplex& simplex : mesh.simplices) cells.add(simplex);
  const auto each_simplex = [&mesh](const auto& visit) {
    for (const Simplex& simplex : mesh.simplices) visit(simplex);
  };
  cells.add_all(dangling_faces(mesh.faces, each_simplex, mesh.points.size()));
  return cells;
}

Difference difference(const ExactMesh& a, const ExactMesh& b) {
  Difference result;
  const auto in_b = matched(a.points, places(b.points), result.points_only_in_a);
  matched(b.points, places(a.points), result.points_only_in_b);
  result.add(difference_of_cells(cells_of(a), cells_of(b), in_b, b.points.size()));
  return result;
}

}  // namespace circumspect::check
