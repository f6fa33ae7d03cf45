// What every adapter in C and C++ does: reads points from the standard input, writes simplices to the standard output.
#pragma once

#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <unistd.h>

namespace lines {

using Points = std::vector<std::vector<double>>;
using Simplices = std::vector<std::vector<long>>;

// The library says that it does not take this input, as its documents tell.
struct Refused {
  std::string why;
};

// From a point that a library returns back to its index; it has to be the same doubles.
struct Indices {
  explicit Indices(const Points& points) {
    for (std::size_t i = 0; i < points.size(); ++i) known[points[i]] = static_cast<long>(i);
  }
  long operator()(const std::vector<double>& point) const {
    const auto found = known.find(point);
    return found == known.end() ? -1 : found->second;
  }
  std::map<std::vector<double>, long> known;
};

using Segments = std::vector<std::pair<long, long>>;

// `triangulate` is given the points, and the segments that are to be edges.
inline int serve_domains(
    const std::function<Simplices(const Points&, const Segments&)>& triangulate) {
  std::FILE* out = fdopen(dup(1), "w");
  dup2(2, 1);  // libraries print what they like
  long count = 0;
  long dimension = 0;
  char header[256];
  while (std::fgets(header, sizeof header, stdin) != nullptr) {
    long constraints = 0;
    if (std::sscanf(header, "%ld %ld %ld", &count, &dimension, &constraints) < 2) continue;
    Segments segments(static_cast<std::size_t>(constraints));
    Points points(static_cast<std::size_t>(count),
                  std::vector<double>(static_cast<std::size_t>(dimension)));
    for (auto& point : points) {
      for (double& x : point) {
        if (std::scanf("%lf", &x) != 1) return 1;
      }
    }
    for (auto& [from, to] : segments) {
      if (std::scanf("%ld %ld", &from, &to) != 2) return 1;
    }
    try {
      const Simplices made = triangulate(points, segments);
      std::fprintf(out, "%zu %ld\n", made.size(), dimension + 1);
      for (const auto& simplex : made) {
        for (const long vertex : simplex) std::fprintf(out, "%ld ", vertex);
        std::fputc('\n', out);
      }
    } catch (const Refused& refusal) {
      std::fprintf(out, "refused %s\n", refusal.why.c_str());
    } catch (const std::exception& error) {
      const std::string text = error.what();
      std::fprintf(out, "raised %s\n", text.substr(0, text.find('\n')).c_str());
    }
    std::fflush(out);
  }
  return 0;
}

inline int serve(const std::function<Simplices(const Points&)>& triangulate) {
  return serve_domains([&](const Points& points, const Segments&) { return triangulate(points); });
}

}  // namespace lines
