#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/picture/picture.hpp"

namespace circumspect::picture {
namespace {

enum Role { kSimplex, kFace, kVertex, kBall, kDomainCell, kPoint };

int number_of(Rule rule) { return static_cast<int>(rule); }

struct Cell {
  std::vector<std::size_t> corners;  // places among the points, from 0
  Rule rule;
  std::size_t violation;
  Role role;
};

struct CellPoint {
  std::string coordinates;  // three numbers
  Vertex index;
  std::string radius;
};

// All that is written, format or no format.
class Cells {
 public:
  Cells(const Verdict& verdict, const Mesh& mesh, const Domain* domain)
      : mesh_(mesh), domain_(domain) {
    for (const Violation& violation : verdict.violations()) {
      ++violation_;
      add(violation);
    }
  }

  const std::vector<Cell>& cells() const { return cells_; }
  const std::vector<CellPoint>& points() const { return points_; }

 private:
  void add(const Violation& violation) {
    const Witness& witness = violation.witness;
    const auto add_cell = [&](std::vector<std::size_t> corners, Role role) {
      if (corners.empty() || corners.size() > 4) return;
      cells_.push_back({std::move(corners), violation.rule, violation_, role});
    };
    for (const Simplex& simplex : witness.simplices) add_cell(corners(simplex), kSimplex);
    if (witness.face) add_cell(corners(*witness.face), kFace);
    for (const Vertex v : witness.vertices) add_cell(corners({v}), kVertex);
    if (witness.point) add_cell({add_point(*witness.point)}, kPoint);
    if (witness.ball && sign(witness.ball->squared_radius) >= 0) {
      add_cell(
          {add_point(witness.ball->centre, square_root_to_decimal(witness.ball->squared_radius))},
          kBall);
    }
    if (domain_ == nullptr) return;
    const PointSet& points = domain_->complex.points;
    const auto of_domain = [&](const Simplex& simplex) {
      std::vector<std::size_t> found;
      for (const Vertex v : simplex) found.push_back(add_point(points[v]));
      add_cell(std::move(found), kDomainCell);
    };
    if (witness.domain_cell) of_domain(*witness.domain_cell);
    if (!witness.polygon) return;
    for (const Simplex& triangle : domain_->complex.polygons[*witness.polygon].triangles) {
      of_domain(triangle);
    }
  }

  // Those of its vertices that are points, each once: a repeated one makes a cell of lower
  // dimension.
  std::vector<std::size_t> corners(const Simplex& simplex) {
    std::vector<std::size_t> found;
    for (const Vertex v : simplex) {
      if (!mesh_.names(v)) continue;
      const auto [at, is_new] = place_of_.emplace(v, points_.size());
      if (is_new) add_point(mesh_.point(v), "0", mesh_.label(v));
      if (std::find(found.begin(), found.end(), at->second) == found.end()) {
        found.push_back(at->second);
      }
    }
    return found;
  }

  std::size_t add_point(const Point& point, std::string radius = "0", Vertex index = -1) {
    std::string coordinates;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      coordinates += (axis == 0 ? "" : " ");
      coordinates += axis < point.size() ? to_decimal(point[axis]) : "0";
    }
    points_.push_back({std::move(coordinates), index, std::move(radius)});
    return points_.size() - 1;
  }

  const Mesh& mesh_;
  const Domain* domain_;
  std::map<Vertex, std::size_t> place_of_;
  std::vector<CellPoint> points_;
  std::vector<Cell> cells_;
  std::size_t violation_ = 0;
};

// One array of a .vtu: a value a line.
template <class List, class Value>
void write_array(std::ostream& out, std::string_view type, std::string_view name, const List& list,
                 const Value& value) {
  out << fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">\n", type, name);
  for (const auto& one : list) out << value(one) << '\n';
  out << "</DataArray>\n";
}

void write_as_vtu(std::ostream& out, const Cells& all) {
  constexpr int kTypes[] = {1, 3, 5, 10};
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n";
  for (const RuleEntry& entry : rules()) {
    out << fmt::format("<!-- rule {}: {} -->\n", number_of(entry.rule), entry.identifier);
  }
  out << fmt::format(
      "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n",
      all.points().size(), all.cells().size());
  for (const CellPoint& point : all.points()) out << point.coordinates << '\n';
  out << "</DataArray>\n</Points>\n<Cells>\n";
  write_array(out, "Int64", "connectivity", all.cells(),
              [](const Cell& cell) { return fmt::format("{}", fmt::join(cell.corners, " ")); });
  std::size_t end = 0;
  write_array(out, "Int64", "offsets", all.cells(),
              [&](const Cell& cell) { return end += cell.corners.size(); });
  write_array(out, "UInt8", "types", all.cells(),
              [&](const Cell& cell) { return kTypes[cell.corners.size() - 1]; });
  out << "</Cells>\n<PointData>\n";
  write_array(out, "Int64", "index", all.points(), [](const CellPoint& p) { return p.index; });
  write_array(out, "Float64", "radius", all.points(), [](const CellPoint& p) { return p.radius; });
  out << "</PointData>\n<CellData>\n";
  write_array(out, "Int32", "rule", all.cells(),
              [](const Cell& cell) { return number_of(cell.rule); });
  write_array(out, "Int32", "violation", all.cells(),
              [](const Cell& cell) { return cell.violation; });
  write_array(out, "Int32", "role", all.cells(),
              [](const Cell& cell) { return static_cast<int>(cell.role); });
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

// Data of points or of elements in a .msh: a number each.
template <class List, class Value>
void write_data(std::ostream& out, std::string_view section, std::string_view name,
                const List& list, const Value& value) {
  out << fmt::format("${}\n1\n\"{}\"\n1\n0\n3\n0\n1\n{}\n", section, name, list.size());
  std::size_t tag = 0;
  for (const auto& one : list) out << fmt::format("{} {}\n", ++tag, value(one));
  out << fmt::format("$End{}\n", section);
}

void write_as_gmsh(std::ostream& out, const Cells& all) {
  constexpr int kTypes[] = {15, 1, 2, 4};
  std::map<std::pair<std::size_t, int>, std::string_view> groups;  // dimension, number of a rule
  for (const Cell& cell : all.cells()) {
    groups.emplace(std::pair(cell.corners.size() - 1, number_of(cell.rule)), identifier(cell.rule));
  }
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << groups.size() << '\n';
  for (const auto& [group, name] : groups) {
    out << fmt::format("{} {} \"{}\"\n", group.first, group.second, name);
  }
  out << "$EndPhysicalNames\n$Nodes\n" << all.points().size() << '\n';
  std::size_t tag = 0;
  for (const CellPoint& point : all.points()) {
    out << fmt::format("{} {}\n", ++tag, point.coordinates);
  }
  out << "$EndNodes\n$Elements\n" << all.cells().size() << '\n';
  tag = 0;
  for (const Cell& cell : all.cells()) {
    out << fmt::format("{} {} 2 {} {}", ++tag, kTypes[cell.corners.size() - 1],
                       number_of(cell.rule), cell.violation);
    for (const std::size_t corner : cell.corners) out << ' ' << corner + 1;
    out << '\n';
  }
  out << "$EndElements\n";
  write_data(out, "NodeData", "index", all.points(), [](const CellPoint& p) { return p.index; });
  write_data(out, "NodeData", "radius", all.points(), [](const CellPoint& p) { return p.radius; });
  write_data(out, "ElementData", "role", all.cells(),
             [](const Cell& cell) { return static_cast<int>(cell.role); });
  write_data(out, "ElementData", "violation", all.cells(),
             [](const Cell& cell) { return cell.violation; });
}

}  // namespace

void write_cells(std::ostream& out, CellFormat format, const Verdict& verdict, const Mesh& mesh,
                 const Domain* domain) {
  const Cells cells(verdict, mesh, domain);
  if (format == CellFormat::kVtu) {
    write_as_vtu(out, cells);
  } else {
    write_as_gmsh(out, cells);
  }
}

}  // namespace circumspect::picture
