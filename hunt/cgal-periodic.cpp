// CGAL's periodic Delaunay triangulations, as `circumspect check --claim periodic-delaunay` reads
// them.
//
//     cgal-periodic 3 4 < x.node > x.ele        of points in the box from 0 to 4, which is repeated
//     circumspect check x.ele --claim periodic-delaunay --box 0,0,0,4,4,4
//
// If CGAL needs several sheets, they are folded into one: a cell of each is the same, moved. The
// points are counted from 0.
#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plane = CGAL::Periodic_2_Delaunay_triangulation_2<
    CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>>;
using Space = CGAL::Periodic_3_Delaunay_triangulation_3<
    CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>>;
using Corner = std::pair<std::size_t, std::vector<int>>;  // a point, and how it is moved
using Cell = std::vector<Corner>;

template <class Point>
std::vector<Point> read(std::size_t d) {
  std::size_t count = 0;
  std::string rest;
  std::cin >> count;
  std::getline(std::cin, rest);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    double x = 0, y = 0, z = 0;
    std::cin >> rest >> x >> y;
    if (d == 3) std::cin >> z;
    std::getline(std::cin, rest);
    if constexpr (std::is_same_v<Point, Plane::Point>)
      points.emplace_back(x, y);
    else
      points.emplace_back(x, y, z);
  }
  return points;
}

// Moved so that the least corner is where it was listed: each orbit of cells once.
void add(std::set<Cell>& cells, Cell cell) {
  std::sort(cell.begin(), cell.end());
  const std::vector<int> way = cell.front().second;
  for (Corner& corner : cell) {
    for (std::size_t axis = 0; axis < way.size(); ++axis) corner.second[axis] -= way[axis];
  }
  cells.insert(std::move(cell));
}

template <class Triangulation, class CellIterator>
void collect(const Triangulation& all, CellIterator first, CellIterator last,
             const std::vector<typename Triangulation::Point>& points, std::set<Cell>& cells) {
  std::map<typename Triangulation::Point, std::size_t> index;
  for (std::size_t i = 0; i < points.size(); ++i) index.emplace(points[i], i);
  constexpr int kCorners = std::is_same_v<Triangulation, Plane> ? 3 : 4;
  for (CellIterator cell = first; cell != last; ++cell) {
    Cell own;
    for (int i = 0; i < kCorners; ++i) {
      const auto place = all.periodic_point(cell, i);
      std::vector<int> offset;
      for (int axis = 0; axis + 1 < kCorners; ++axis) offset.push_back(place.second[axis]);
      own.emplace_back(index.at(place.first), offset);
    }
    add(cells, std::move(own));
  }
}

int main(int, char** arguments) {
  const std::size_t d = std::stoul(arguments[1]);
  const double side = std::stod(arguments[2]);
  std::set<Cell> cells;
  if (d == 2) {
    const auto points = read<Plane::Point>(d);
    const Plane all(points.begin(), points.end(), Plane::Iso_rectangle(0, 0, side, side));
    collect(all, all.faces_begin(), all.faces_end(), points, cells);
  } else {
    const auto points = read<Space::Point>(d);
    const Space all(points.begin(), points.end(), Space::Iso_cuboid(0, 0, 0, side, side, side));
    collect(all, all.cells_begin(), all.cells_end(), points, cells);
  }
  std::cout << cells.size() << ' ' << d + 1 << ' ' << d * (d + 1) << '\n';
  std::size_t i = 0;
  for (const Cell& cell : cells) {
    std::cout << i++;
    for (const auto& [point, offset] : cell) std::cout << ' ' << point;
    for (const auto& [point, offset] : cell) {
      for (const int x : offset) std::cout << ' ' << x;
    }
    std::cout << '\n';
  }
}
