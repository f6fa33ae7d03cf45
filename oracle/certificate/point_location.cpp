#include "oracle/certificate/point_location.hpp"

#include <array>
#include <cassert>

#include "oracle/certificate/sidedness.hpp"
#include "reference/kernel/exact/point_search.hpp"

namespace circumspect::certificate {
namespace {

// A certificate as the search for points wants it.
class Located {
 public:
  explicit Located(const Certificate& certificate)
      : certificate_(certificate), sidedness_(certificate.points) {}

  std::size_t size() const { return certificate_.simplices.size(); }
  std::size_t row_size() const { return certificate_.points.dimension + 1; }
  std::size_t points() const { return certificate_.points.size(); }
  std::size_t vertex(std::size_t s, std::size_t place) const {
    return static_cast<std::size_t>(certificate_.simplices[s].vertices[place]);
  }
  // Simplices of a certificate are positively oriented.
  int side(std::size_t s, std::size_t place, std::size_t point) const {
    std::array<Vertex, 4> moved = certificate_.simplices[s].vertices;
    moved[place] = static_cast<Vertex>(point);
    return sidedness_.orientation(std::span<const Vertex>(moved).first(row_size()));
  }
  std::size_t across(std::size_t s, std::size_t place) const {
    const Across& beyond = certificate_.simplices[s].across[place];
    return beyond.place == Across::kHull ? kNoSimplex : beyond.cell;
  }

 private:
  const Certificate& certificate_;
  mutable Sidedness sidedness_;  // keeps the memory of its numbers
};

}  // namespace

std::vector<std::uint32_t> simplices_that_contain(const Certificate& certificate,
                                                  std::span<const std::size_t> points) {
  const Located located(certificate);
  std::vector<std::uint32_t> simplices;
  simplices.reserve(points.size());
  for (const std::size_t s : PointSearch(located).simplices_with(points)) {
    assert(s != kNoSimplex);
    simplices.push_back(static_cast<std::uint32_t>(s));
  }
  return simplices;
}

}  // namespace circumspect::certificate
