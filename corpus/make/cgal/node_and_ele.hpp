// Reading .node and writing .ele for the corpus-making programs beside this file.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// The coordinates of a .node file of the given dimension, and the index of its first point.
struct Points {
  std::vector<std::vector<double>> coordinates;
  int first_index = 1;
};

inline Points read_node(const char* path, int dimension) {
  std::ifstream file(path);
  std::size_t count = 0;
  int d = 0, attributes = 0, markers = 0;
  file >> count >> d >> attributes >> markers;
  if (!file || d != dimension) {
    std::cerr << path << ": no .node file of dimension " << dimension << '\n';
    std::exit(2);
  }
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    int index = 0;
    std::string token;  // strtod, since streams refuse subnormal numbers
    file >> index;
    if (i == 0) points.first_index = index;
    std::vector<double> p;
    for (int c = 0; c < d; ++c) {
      file >> token;
      p.push_back(std::strtod(token.c_str(), nullptr));
    }
    for (int a = 0; a < attributes + markers; ++a) file >> token;
    points.coordinates.push_back(p);
  }
  return points;
}

inline void write_ele(const char* path, std::vector<std::vector<int>> simplices, int columns,
                      int first_index) {
  for (auto& s : simplices) std::rotate(s.begin(), std::min_element(s.begin(), s.end()), s.end());
  std::sort(simplices.begin(), simplices.end());  // one output, whatever the container's order
  std::ofstream file(path);
  file << simplices.size() << ' ' << columns << " 0\n";
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    file << i + first_index;
    for (const int v : simplices[i]) file << ' ' << v + first_index;
    file << '\n';
  }
}
