// The systems of coordinates of Nastran in which nodes may be given.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kernel/exact/number_text.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/nastran_entries.hpp"

namespace circumspect::formats {

// A rectangular system (CORD2R) on the basic one gives exact places if its axes have rational
// directions of length one, as those of every system that is parallel to the basic one. What angles
// or other square roots would round is never taken for something else.
class NastranSystems {
 public:
  // Is this the name of an entry that defines a system?
  static bool defines(const std::string& name) { return name.starts_with("CORD"); }
  // Takes over such an entry.
  Status add(const NastranEntries& entries, NumberReading reading);

  // The point in the basic system; nothing, if it has no exact place there.
  std::optional<Point> in_basic(const Point& point, Vertex system) const;
  // What the system is, for a message: "a cylindrical system (CORD2C on line 7)".
  std::string words(Vertex system) const;

 private:
  struct System {
    std::string entry = {};  // "CORD2R"
    std::size_t line = 0;
    Point origin = {};
    std::vector<Point> axes = {};  // of length one; none if they are not rational
    bool is_defined_twice = false;
  };

  void take(Vertex tag, System system);

  std::map<Vertex, System> systems_;
};

}  // namespace circumspect::formats
