// The code that all adapters in C and C++ share: it answers the cases of `circumspect campaign
// --worker` (docs/workers.md).
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

using Triangulate = std::function<Simplices(const Points&, const Segments&)>;

// One answer after the other. What `triangulate` throws beside Refused ends the process with exit
// code 1.
inline int answer_all(const Triangulate& triangulate, bool is_of_domains) {
  std::FILE* out = fdopen(dup(1), "w");
  dup2(2, 1);  // libraries print what they like
  char header[256];
  while (std::fgets(header, sizeof header, stdin) != nullptr) {
    std::size_t count = 0;
    std::size_t dimension = 0;
    std::size_t constraints = 0;
    if (std::sscanf(header, "%zu %zu %*d %zu", &count, &dimension, &constraints) < 3) continue;
    Segments segments(constraints);
    Points points(count, std::vector<double>(dimension));
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
      if (is_of_domains) {
        std::fprintf(out, "nOFF 2\n%zu %zu 0\n", count, made.size());
        for (const auto& p : points) std::fprintf(out, "%.17g %.17g\n", p[0], p[1]);
      } else {
        std::fprintf(out, "%zu\n", made.size());
      }
      for (const auto& simplex : made) {
        if (is_of_domains) std::fputs("3 ", out);
        for (const long v : simplex)
          std::fprintf(out, "%zu ", v < 0 ? count : static_cast<std::size_t>(v));
        std::fputc('\n', out);
      }
    } catch (const Refused& refusal) {
      std::fprintf(out, "error %s\n", refusal.why.c_str());
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      return 1;
    }
    std::fflush(out);
  }
  return 0;
}

// `triangulate` is given the points of the plane, and the segments that are to be edges: a worker
// answers domains with an .off file.
inline int serve_domains(const Triangulate& triangulate) { return answer_all(triangulate, true); }

inline int serve(const std::function<Simplices(const Points&)>& triangulate) {
  return answer_all([&](const Points& points, const Segments&) { return triangulate(points); },
                    false);
}

}  // namespace lines
