// For tests: a mesh of elements in Medit's binary form, and numbers as bytes.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "oracle/formats/bytes/binary.hpp"
#include "oracle/formats/written_decks_test.hpp"

namespace circumspect::formats {

inline std::string stored(std::uint64_t value, std::size_t size, ByteOrder order) {
  std::string text;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = order == ByteOrder::kBigEndian ? size - 1 - i : i;
    text += static_cast<char>(static_cast<unsigned char>(value >> (8 * place)));
  }
  return text;
}

// Medit's binary form: a section Corners, which is skipped, before the elements, each in a section
// of its own.
inline std::string meshb(const WrittenMesh& mesh, ByteOrder order, std::size_t version) {
  const std::size_t place = version >= 3 ? 8 : 4, integer = version >= 4 ? 8 : 4;
  std::string text = stored(1, 4, order) + stored(version, 4, order);
  const auto section = [&](std::size_t code, const std::string& content) {
    const std::size_t end = text.size() + 4 + place + content.size();
    text += stored(code, 4, order) + stored(end, place, order) + content;
  };
  section(3, stored(mesh.points.front().size(), 4, order));
  std::string points = stored(mesh.points.size(), integer, order);
  for (const auto& point : mesh.points) {
    for (const double x : point) {
      points += version == 1 ? stored(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4, order)
                             : stored(std::bit_cast<std::uint64_t>(x), 8, order);
    }
    points += stored(9, integer, order);
  }
  section(4, points);
  section(13, stored(1, integer, order) + stored(1, integer, order));
  for (const auto& cell : mesh.cells) {
    std::string content = stored(1, integer, order);
    for (const int v : cell) content += stored(static_cast<std::size_t>(v) + 1, integer, order);
    section(cell.size() == 2 ? 5 : 2 * cell.size(), content + stored(7, integer, order));
  }
  section(54, "");
  return text;
}

}  // namespace circumspect::formats
