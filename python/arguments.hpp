// Meshes and domains as the package passes them, and as the C interface takes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <circumspect/circumspect.h>

#include "python/arrays.hpp"
#include "python/values.hpp"

namespace circumspect::python {

// A list of numbers, doubles or texts, that lives as long as the call.
class NumberList {
 public:
  explicit NumberList(PyObject* numbers) {
    if (numbers == Py_None) return;
    if (PyList_Check(numbers) == 0) {
      doubles_.emplace(numbers);
      return;
    }
    texts_ = value_of<std::vector<std::string>>(numbers);
    for (const std::string& text : texts_) pointers_.push_back(text.c_str());
    pointers_.push_back(nullptr);  // so that there is an array, even if it is empty
  }
  const double* doubles() const { return doubles_ ? doubles_->data() : nullptr; }
  const char* const* texts() const { return pointers_.empty() ? nullptr : pointers_.data(); }
  std::int64_t size() const {
    return static_cast<std::int64_t>(doubles_ ? doubles_->size() : texts_.size());
  }

 private:
  std::optional<Doubles> doubles_ = {};
  std::vector<std::string> texts_ = {};
  std::vector<const char*> pointers_ = {};
};

// A tuple of the package, part by part.
class Parts {
 public:
  explicit Parts(PyObject* tuple) : tuple_(tuple) {}
  // Requires: it lives as long as the tuple.
  PyObject* operator[](Py_ssize_t place) const {
    PyObject* const part = PyTuple_GetItem(tuple_, place);
    require(part != nullptr);
    return part;
  }
  std::int64_t number(Py_ssize_t place) const { return value_of<std::int64_t>((*this)[place]); }

 private:
  PyObject* tuple_;
};

// A mesh as the package passes it: (dimension, coordinates, weights, simplices, neighbors,
// triangles, edges), each but the first two may be None; coordinates are flat.
class MeshArgument {
 public:
  explicit MeshArgument(PyObject* tuple)
      : parts_(tuple),
        coordinates_(parts_[1]),
        weights_(parts_[2]),
        simplices_(value_of<std::optional<Array>>(parts_[3])),
        neighbors_(value_of<std::optional<Array>>(parts_[4])),
        triangles_(value_of<std::optional<Indices>>(parts_[5])),
        edges_(value_of<std::optional<Indices>>(parts_[6])) {
    mesh_.dimension = parts_.number(0);
    mesh_.point_count = mesh_.dimension > 0 ? coordinates_.size() / mesh_.dimension : 0;
    mesh_.coordinates = coordinates_.doubles();
    mesh_.exact_coordinates = coordinates_.texts();
    mesh_.weights = weights_.doubles();
    mesh_.exact_weights = weights_.texts();
    if (simplices_) {
      require_indices();
      mesh_.simplex_count = simplices_->length(0);
      mesh_.vertices_of_simplex = simplices_->length(1);
      mesh_.index_bytes = static_cast<std::int64_t>(simplices_->bytes_of_one());
      mesh_.simplices = simplices_->data();
      if (neighbors_) mesh_.neighbors = neighbors_->data();
    }
    if (triangles_) {
      mesh_.triangle_count = triangles_->length(0);
      mesh_.triangles = triangles_->data();
    }
    if (edges_) {
      mesh_.edge_count = edges_->length(0);
      mesh_.edges = edges_->data();
    }
  }
  const circumspect_mesh* get() const { return &mesh_; }

 private:
  void require_indices() const {
    const bool are_rows = simplices_->axes() == 2 && !simplices_->holds_doubles();
    const bool fit = !neighbors_ || (neighbors_->size() == simplices_->size() &&
                                     neighbors_->bytes_of_one() == simplices_->bytes_of_one() &&
                                     !neighbors_->holds_doubles());
    if (!are_rows || !fit) {
      throw Failure{PyExc_TypeError, "expected rows of indices, and neighbors of their shape"};
    }
  }

  circumspect_mesh mesh_ = CIRCUMSPECT_MESH;
  Parts parts_;
  NumberList coordinates_;
  NumberList weights_;
  std::optional<Array> simplices_, neighbors_;
  std::optional<Indices> triangles_, edges_;
};

// (dimension, coordinates, segments, polygon_starts, line_starts, corners, hole_seeds, kind,
// polygons_of_holes, polygon_hole_seeds, region_seeds, merge_coplanar, resolve)
class DomainArgument {
 public:
  explicit DomainArgument(PyObject* tuple) : DomainArgument(Parts(tuple)) {}
  const circumspect_domain* get() const { return &domain_; }

 private:
  explicit DomainArgument(const Parts& parts)
      : coordinates_(parts[1]),
        segments_(parts[2]),
        polygons_(parts[3]),
        lines_(parts[4]),
        corners_(parts[5]),
        holes_(parts[6]),
        polygons_of_holes_(parts[8]),
        polygon_holes_(parts[9]),
        regions_(parts[10]) {
    domain_.dimension = parts.number(0);
    domain_.point_count = domain_.dimension > 0 ? coordinates_.size() / domain_.dimension : 0;
    domain_.coordinates = coordinates_.doubles();
    domain_.exact_coordinates = coordinates_.texts();
    domain_.segment_count = static_cast<std::int64_t>(segments_.size()) / 2;
    domain_.segments = segments_.data();
    domain_.polygon_count = static_cast<std::int64_t>(polygons_.size()) - 1;
    domain_.polygon_starts = polygons_.data();
    domain_.line_starts = lines_.data();
    domain_.corners = corners_.data();
    domain_.hole_count = domain_.dimension > 0 ? holes_.size() / domain_.dimension : 0;
    domain_.hole_seeds = holes_.doubles();
    domain_.exact_hole_seeds = holes_.texts();
    domain_.kind = value_of<std::int32_t>(parts[7]);
    domain_.polygon_hole_count = static_cast<std::int64_t>(polygons_of_holes_.size());
    domain_.polygons_of_holes = polygons_of_holes_.data();
    domain_.polygon_hole_seeds = polygon_holes_.doubles();
    domain_.exact_polygon_hole_seeds = polygon_holes_.texts();
    domain_.region_count = domain_.dimension > 0 ? regions_.size() / domain_.dimension : 0;
    domain_.region_seeds = regions_.doubles();
    domain_.exact_region_seeds = regions_.texts();
    domain_.merge_coplanar = value_of<bool>(parts[11]) ? 1 : 0;
    domain_.resolve = value_of<bool>(parts[12]) ? 1 : 0;
  }

  circumspect_domain domain_ = CIRCUMSPECT_DOMAIN;
  NumberList coordinates_;
  Indices segments_, polygons_, lines_, corners_;
  NumberList holes_;
  Indices polygons_of_holes_;
  NumberList polygon_holes_;
  NumberList regions_;
};

}  // namespace circumspect::python
