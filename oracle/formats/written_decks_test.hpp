// For tests: a mesh of elements as solvers of engineers read it. Nodes have tags, elements may go
// on over lines, and what a solver is told beside the mesh stands around it.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

namespace circumspect::formats {

// Points of space by their coordinates, cells by their vertices from 0: of 2, 3 or 4.
struct WrittenMesh {
  std::vector<std::vector<double>> points;
  std::vector<std::vector<int>> cells;
};

// A double that is read as it was.
inline std::string digits_of(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

// The numbers of a cell's nodes, the first node being `first`, each behind the text between them.
inline std::string nodes_of(const std::vector<int>& cell, int first, const std::string& between) {
  std::string text;
  for (const int v : cell) text += between + std::to_string(v + first);
  return text;
}

inline std::string of_size(std::size_t vertices, std::initializer_list<const char*> words) {
  return words.begin()[vertices - 2];
}

// Text in a field of so many columns.
inline std::string in_columns(const std::string& text, std::size_t columns) {
  return text + std::string(text.size() < columns ? columns - text.size() : 1, ' ');
}

// A node in large columns, if its numbers fit there, or behind commas.
inline std::string nastran_grid(std::size_t tag, const std::vector<double>& point,
                                bool has_columns) {
  std::vector<std::string> fields = {std::to_string(tag), ""};
  for (const double x : point) fields.push_back(digits_of(x));
  const bool fit = std::all_of(fields.begin(), fields.end(),
                               [](const std::string& field) { return field.size() < 16; });
  const std::string mark = "*" + std::to_string(tag);
  std::string lines = has_columns && fit ? "GRID*   " : "GRID*";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i == 4)
      lines += has_columns && fit ? mark + "\n" + in_columns(mark, 8) : "," + mark + "\n" + mark;
    lines += has_columns && fit ? in_columns(fields[i], 16) : "," + fields[i];
  }
  return lines + "\n";
}

// Nodes from the last to the first, then elements, all behind commas; or elements in small columns,
// then nodes in large ones.
inline std::string nastran(const WrittenMesh& mesh, bool has_columns) {
  std::string nodes, elements;
  for (std::size_t i = mesh.points.size(); i > 0; --i) {
    nodes += nastran_grid(i, mesh.points[i - 1], has_columns);
  }
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& cell = mesh.cells[i];
    std::vector<std::string> fields = {of_size(cell.size(), {"CROD", "CTRIA3", "CTETRA"}),
                                       std::to_string(i + 1), "7"};
    for (const int v : cell) fields.push_back(std::to_string(v + 1));
    for (std::size_t field = 0; field < fields.size(); ++field) {
      elements +=
          has_columns ? in_columns(fields[field], 8) : (field > 0 ? "," : "") + fields[field];
    }
    elements += "\n";
  }
  const std::string begin = "SOL 101\nBEGIN BULK\n$ GRID,99 is a comment\nMAT1,7,1.,,.3\n";
  return begin + (has_columns ? elements + nodes : nodes + elements) + "ENDDATA\n";
}

// Elements in one section for each kind, or each in its own, going on behind its first node.
inline std::string abaqus(const WrittenMesh& mesh, bool goes_on) {
  std::string text = "*Heading\n a title, with a comma\n*Node, nset=all\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    text += std::to_string(i + 1);
    for (const double x : mesh.points[i]) text += ", " + digits_of(x);
    text += "\n";
  }
  std::size_t size = 0;
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& cell = mesh.cells[i];
    if (goes_on || cell.size() != size) {
      size = cell.size();
      text += "** the next ones\n*Element, type=" + of_size(size, {"T3D2", "S3", "C3D4"}) + "\n";
    }
    std::string nodes = nodes_of(cell, 1, ", ");
    if (goes_on) nodes.insert(nodes.find(',', 1) + 1, "\n");
    text += std::to_string(i + 1) + nodes + "\n";
  }
  return text + "*Material, name=steel\n*Elastic\n210000., 0.3\n";
}

// In old files the types of nodes stand elsewhere; both list orientations of edges.
inline std::string unv(const WrittenMesh& mesh, bool is_old) {
  const std::string begin = "    -1\n";
  std::string text = begin + "   164\n 1 SI: Meter 2\n 1. 1. 1.\n 0.\n" + begin;
  text += begin + (is_old ? "   781\n" : "  2411\n");
  for (std::size_t i = mesh.points.size(); i > 0; --i) {
    text += std::to_string(i) + " 1 1 11\n";
    for (const double x : mesh.points[i - 1]) text += " " + digits_of(x);
    text += "\n";
  }
  text += begin + begin + (is_old ? "   780\n" : "  2412\n");
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& cell = mesh.cells[i];
    text += std::to_string(i + 1) + " " + of_size(cell.size(), {"11", "91", "111"});
    text += (is_old ? " 1 5 1 5 7 " : " 5 1 7 ") + std::to_string(cell.size()) + "\n";
    if (cell.size() == 2) text += " 0 1 1\n";
    text += nodes_of(cell, 1, " ") + "\n";
  }
  return text + begin;
}

// Elements and points with their indices or without them, and in either order.
inline std::string su2(const WrittenMesh& mesh, bool has_indices) {
  std::string points = "NPOIN= " + std::to_string(mesh.points.size()) + "\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (const double x : mesh.points[i]) points += digits_of(x) + " ";
    points += (has_indices ? std::to_string(i) : "") + "\n";
  }
  std::string cells = "NELEM= " + std::to_string(mesh.cells.size()) + "\n";
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& cell = mesh.cells[i];
    cells += of_size(cell.size(), {"3", "5", "10"}) + nodes_of(cell, 0, " ");
    cells += (has_indices ? " " + std::to_string(i) : "") + "\n";
  }
  return "% a comment\nNDIME= 3\n" + (has_indices ? cells + points : points + cells) + "NMARK= 0\n";
}

inline std::string ucd(const WrittenMesh& mesh) {
  std::string text =
      std::to_string(mesh.points.size()) + " " + std::to_string(mesh.cells.size()) + " 0 0 0\n";
  for (std::size_t i = mesh.points.size(); i > 0; --i) {
    text += std::to_string(i);
    for (const double x : mesh.points[i - 1]) text += " " + digits_of(x);
    text += "\n";
  }
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& cell = mesh.cells[i];
    text += std::to_string(i + 1) + " 7 " + of_size(cell.size(), {"line", "tri", "tet"}) +
            nodes_of(cell, 1, " ") + "\n";
  }
  return text;
}

inline std::string xdmf(const WrittenMesh& mesh) {
  std::string points, cells;
  for (const auto& point : mesh.points) {
    for (const double x : point) points += digits_of(x) + " ";
    points += "\n";
  }
  std::size_t numbers = 0;
  for (const auto& cell : mesh.cells) {
    cells += of_size(cell.size(), {"2 2", "4", "6"}) + nodes_of(cell, 0, " ") + "\n";
    numbers += cell.size() + (cell.size() == 2 ? 2 : 1);
  }
  return "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\"><Domain><Grid>\n<Geometry>"
         "<DataItem Dimensions=\"" +
         std::to_string(mesh.points.size()) + " 3\" Precision=\"8\">\n" + points +
         "</DataItem></Geometry>\n<Topology TopologyType=\"Mixed\"><DataItem Dimensions=\"" +
         std::to_string(numbers) + "\" NumberType=\"Int\">\n" + cells +
         "</DataItem></Topology></Grid></Domain></Xdmf>\n";
}

}  // namespace circumspect::formats
