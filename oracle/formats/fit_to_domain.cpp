#include <algorithm>
#include <iterator>
#include <set>

#include "kernel/exact/each_once.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {
namespace {

// A message stops listing labels after so many bytes.
constexpr std::size_t kLongestListOfLabels = 60;

// Which of some listed faces are faces of cells that are kept, and of cells that are not.
class ListedFaces {
 public:
  ListedFaces(const std::vector<Simplex>& listed, std::size_t points) : is_listed_at_(points) {
    for (const Simplex& face : listed) {
      faces_.push_back(sorted(face));
      for (const Vertex v : face) {
        if (names(v)) is_listed_at_[static_cast<std::size_t>(v)] = true;
      }
    }
    keep_each_once(faces_);
    of_kept_.resize(faces_.size());
    of_left_.resize(faces_.size());
  }

  // Requires: at most four vertices.
  void see(const Simplex& cell, bool is_kept) {
    // Most cells have no listed face, which their vertices tell.
    Simplex vertices;
    for (const Vertex v : cell) {
      if (!names(v) || is_listed_at_[static_cast<std::size_t>(v)]) vertices.push_back(v);
    }
    std::sort(vertices.begin(), vertices.end());
    std::vector<bool>& seen = is_kept ? of_kept_ : of_left_;
    Simplex face;
    for (unsigned bits = 1; bits < 1U << vertices.size(); ++bits) {
      face.clear();
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        if ((bits >> i & 1U) != 0) face.push_back(vertices[i]);
      }
      if (face.size() < 2 || face.size() == cell.size()) continue;
      const auto at = std::lower_bound(faces_.begin(), faces_.end(), face);
      if (at != faces_.end() && *at == face) {
        seen[static_cast<std::size_t>(at - faces_.begin())] = true;
      }
    }
  }

  // It is a face of no cell that is kept, and of one that is not.
  bool is_lost(const Simplex& face) const {
    const auto at = std::lower_bound(faces_.begin(), faces_.end(), sorted(face));
    const auto place = static_cast<std::size_t>(at - faces_.begin());
    return of_left_[place] && !of_kept_[place];
  }

 private:
  bool names(Vertex v) const { return v >= 0 && v < static_cast<Vertex>(is_listed_at_.size()); }

  std::vector<Simplex> faces_;  // each ascending, all ascending
  std::vector<bool> of_kept_, of_left_;
  std::vector<bool> is_listed_at_;  // by vertex: has a listed face
};

template <class Value>
Rows<Value> some_rows(const Rows<Value>& rows, const std::vector<Vertex>& places) {
  Rows<Value> some(places.size(), rows.columns());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto row = rows.row(static_cast<std::size_t>(places[i]));
    std::copy(row.begin(), row.end(), some.row(i).begin());
  }
  return some;
}

// Points that are left out keep their numbers: those that stay have labels of their own.
template <class IsLeftOut>
void leave_out_points(Mesh& mesh, const IsLeftOut& is_left_out) {
  std::vector<Vertex> places;
  std::vector<Vertex> number(mesh.points(), 0);
  std::vector<Vertex> own;
  for (Vertex v = 0; mesh.names(v); ++v) {
    if (is_left_out(v)) continue;
    number[static_cast<std::size_t>(v)] = static_cast<Vertex>(places.size());
    places.push_back(v);
    own.push_back(mesh.label(v));
  }
  if (places.size() == mesh.points()) return;
  const auto renumber = [&](std::vector<Simplex> simplices) {
    for (Simplex& simplex : simplices) {
      for (Vertex& v : simplex) {
        // An index that names no point still names none.
        v = mesh.names(v) ? number[static_cast<std::size_t>(v)] : v;
      }
    }
    return simplices;
  };
  const auto some = [&](const Numbers& numbers) {
    return std::visit([&](const auto& rows) -> Numbers { return some_rows(rows, places); },
                      numbers);
  };
  mesh.simplices = IndexLists(renumber(mesh.simplices.lists()));
  mesh.faces = renumber(std::move(mesh.faces));
  mesh.coordinates = some(mesh.coordinates);
  mesh.labels = std::move(own);
}

}  // namespace

void take_for_faces(MeshFile& file) {
  Mesh& mesh = file.mesh;
  const std::size_t size = mesh.simplices.columns();
  const std::size_t dimension = mesh.dimension();
  if (size < 2 || size > dimension || dimension > 3) return;
  const std::string kind = size == 3 ? "triangle" : "edge";
  const std::size_t count = mesh.simplices.size();
  file.notes.push_back(
      file.mesh_name + ": no " + (dimension == 3 ? "tetrahedra" : "triangles") + "; the " +
      std::to_string(count) + " " + kind +
      (count == 1 ? " is judged as a dangling one" : "s are judged as dangling ones"));
  std::vector<Simplex> faces = mesh.simplices.lists();
  mesh.faces.insert(mesh.faces.end(), std::make_move_iterator(faces.begin()),
                    std::make_move_iterator(faces.end()));
  mesh.simplices = {};
}

void leave_out_nodes_between(const std::vector<Vertex>& indices, Mesh& mesh) {
  if (indices.empty()) return;
  std::vector<bool> is_between(mesh.points(), false);
  for (const Vertex index : indices) {
    const Vertex v = place_of_index(index, mesh.first_index);
    if (mesh.names(v)) is_between[static_cast<std::size_t>(v)] = true;
  }
  leave_out_points(mesh, [&](Vertex v) { return is_between[static_cast<std::size_t>(v)]; });
}

Status keep_labelled(const std::vector<Vertex>& kept, const std::vector<Vertex>& labels,
                     MeshFile& file) {
  Mesh& mesh = file.mesh;
  if (labels.empty() || labels.size() != mesh.simplices.size()) {
    return tl::unexpected(FormatError{
        file.mesh_name, 0,
        "cells with labels: references in .mesh, physical groups in .msh, attributes in .ele",
        "cells without"});
  }
  const auto is_kept = [&](std::size_t i) {
    return std::find(kept.begin(), kept.end(), labels[i]) != kept.end();
  };
  const std::size_t count = mesh.simplices.size();
  std::vector<Simplex> simplices;
  // By vertex: does it belong to something that is kept, and to something that is not? Indices that
  // name no point are not left out.
  std::vector<bool> used(mesh.points(), false), left(mesh.points(), false);
  const auto mark = [&](const Simplex& simplex, std::vector<bool>& vertices) {
    for (const Vertex v : simplex) {
      if (mesh.names(v)) vertices[static_cast<std::size_t>(v)] = true;
    }
  };
  ListedFaces faces(mesh.faces, mesh.points());
  for (std::size_t i = 0; i < count; ++i) {
    Simplex cell = mesh.simplices[i];
    const bool keep = is_kept(i);
    mark(cell, keep ? used : left);
    if (!mesh.faces.empty()) faces.see(cell, keep);
    if (keep) simplices.push_back(std::move(cell));
  }
  if (simplices.empty()) {
    const std::set<Vertex> known(labels.begin(), labels.end());
    std::string text;
    for (const Vertex label : known) {
      if (text.size() > kLongestListOfLabels) {
        text += ", …";
        break;
      }
      text += (text.empty() ? "" : ", ") + std::to_string(label);
    }
    return tl::unexpected(FormatError{file.mesh_name, 0, "a cell with a label of --keep-label",
                                      "the labels " + text});
  }
  std::erase_if(mesh.faces, [&](const Simplex& face) { return faces.is_lost(face); });
  for (const Simplex& face : mesh.faces) mark(face, used);
  file.notes.push_back(file.mesh_name + ": " + std::to_string(simplices.size()) + " of " +
                       std::to_string(count) + " cells have a label that is kept");
  mesh.simplices = IndexLists(std::move(simplices));
  leave_out_points(mesh, [&](Vertex v) {
    return left[static_cast<std::size_t>(v)] && !used[static_cast<std::size_t>(v)];
  });
  file.face_markers.clear();  // for points that have other places now
  return {};
}

}  // namespace circumspect::formats
