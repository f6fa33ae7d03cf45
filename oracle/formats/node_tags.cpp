#include "oracle/formats/node_tags.hpp"

#include <algorithm>
#include <limits>

namespace circumspect::formats {
namespace {

// Do tags go up by one from one to the next? The difference of two tags is not computed, because it
// may not fit.
bool are_consecutive(const std::vector<Vertex>& tags) {
  for (std::size_t i = 1; i < tags.size(); ++i) {
    const bool is_last = tags[i - 1] == std::numeric_limits<Vertex>::max();
    if (is_last || tags[i] != tags[i - 1] + 1) return false;
  }
  return true;
}

// Sorts points and tags by tags.
Status sort_by_tags(PointRows& points, std::vector<Vertex>& tags, const std::string& name) {
  std::vector<std::size_t> order(tags.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return tags[a] < tags[b]; });
  std::sort(tags.begin(), tags.end());
  const auto twice = std::adjacent_find(tags.begin(), tags.end());
  if (twice != tags.end()) {
    return tl::unexpected(FormatError{name, 0, "a tag of its own for each node",
                                      "tag " + std::to_string(*twice) + " twice"});
  }
  points = points.in_order(order);
  return {};
}

}  // namespace

Status index_by_tags(ElementFile& file, std::vector<Vertex> tags, const std::string& name,
                     std::string_view where) {
  file.points.first_index = 1;
  if (!are_consecutive(tags)) {
    if (Status sorted = sort_by_tags(file.points.points, tags, name); !sorted) return sorted;
  }
  if (are_consecutive(tags)) {
    if (!tags.empty()) file.points.first_index = tags.front();
    return {};
  }
  file.notes.push_back(name +
                       ": the tags of nodes leave gaps; nodes are counted from 1 in their order");
  const auto place_of = [&tags](Vertex tag) -> Vertex {
    const auto found = std::lower_bound(tags.begin(), tags.end(), tag);
    return found == tags.end() || *found != tag ? 0 : 1 + (found - tags.begin());
  };
  for (SimplexFile* const list : file.lists()) {
    for (std::size_t i = 0; i < list->simplices.size(); ++i) {
      for (const Vertex tag : list->simplices[i]) {
        if (place_of(tag) != 0) continue;
        return tl::unexpected(FormatError{
            name, list->lines[i], "the tag of a node " + std::string(where), std::to_string(tag)});
      }
    }
    list->simplices.replace_each(place_of);
  }
  return {};
}

}  // namespace circumspect::formats
