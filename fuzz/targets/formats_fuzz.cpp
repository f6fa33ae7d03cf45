// No bytes crash a reader, and every error is one line that names the file.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "oracle/formats/format.hpp"
#include "oracle/formats/plain_files.hpp"
#include "oracle/formats/poly.hpp"
#include "oracle/formats/tetgen.hpp"

namespace circumspect::fuzz {
namespace {

using formats::Result;
using formats::Source;

template <class T>
bool expect_value_or_line(const Result<T>& result) {
  if (result) return true;
  const std::string message = result.error().to_string();
  const bool names_file = message.starts_with("f:") || message.starts_with("f.node:");
  if (names_file && message.find('\n') == std::string::npos) return false;
  std::fprintf(stderr, "expected one line that begins with the file, found\n%s\n", message.c_str());
  std::abort();
}

Result<formats::PointFile> three_points() {
  return formats::PointFile{3, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, 1};
}

// Where the readers of plain files have an answer, the others have one too.
void expect_agreement(const Source& source) {
  const formats::RandomAccess file{std::string_view(source.text)};
  const formats::PlainReading reading{1, 64};
  const auto node = formats::read_plain_node(file, reading);
  const auto ele = formats::read_plain_ele(file, 0, reading);
  const auto neigh = formats::read_plain_neigh(file, reading);
  const auto points = formats::read_node(source, NumberReading::kDouble);
  if ((node && (!points || node->coordinates.rows() != points->points.size())) ||
      (ele && !formats::read_ele(source)) || (neigh && !formats::read_neigh(source))) {
    std::fputs("a plain file that the other reader refuses\n", stderr);
    std::abort();
  }
  for (std::size_t i = 0; node && i < node->coordinates.rows(); ++i) {
    for (std::size_t j = 0; j < node->coordinates.columns(); ++j) {
      if (exact_value(node->coordinates.row(i)[j]) == points->points[i][j]) continue;
      std::fputs("two readers, two coordinates\n", stderr);
      std::abort();
    }
  }
}

// Everything that a file of this format may hold.
void read(const formats::Format& format, NumberReading reading, const Source& source) {
  if (format.has_points()) expect_value_or_line(format.read_points(source, reading));
  if (format.has_mesh()) expect_value_or_line(format.read_mesh(source, reading));
  if (format.has_domain()) expect_value_or_line(format.read_domain(source, reading));
}

// What no row of the table reads: files beside others, and points that are elsewhere.
void read_beside(char letter, NumberReading reading, const Source& source) {
  switch ((static_cast<unsigned char>(letter) - 'a') & 7) {
    case 0:
      expect_value_or_line(formats::read_neigh(source));
      return;
    case 1:
      expect_value_or_line(formats::read_face(source, 3));
      return;
    case 2:
      expect_value_or_line(formats::read_face(source, 2));
      return;
    case 3:
      expect_value_or_line(read_poly(source, reading, three_points));
      return;
    case 4:
      expect_value_or_line(read_smesh(source, reading, three_points));
      return;
    default:
      expect_agreement(source);
  }
}

}  // namespace
}  // namespace circumspect::fuzz

// The first line is the ending of a format, ".msh", or a letter from 'a' to 'f' (read_beside). Then
// comes a byte that says how numbers are read, and the text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using circumspect::NumberReading;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = bytes.find('\n');
  if (end == 0 || end == std::string_view::npos || end + 1 == size) return 0;
  const auto reading = bytes[end + 1] % 2 == 0 ? NumberReading::kDouble : NumberReading::kDecimal;
  const circumspect::formats::Source source{"f", std::string(bytes.substr(end + 2))};
  const auto* const format = circumspect::formats::format_of(bytes.substr(0, end));
  if (format != nullptr) {
    circumspect::fuzz::read(*format, reading, source);
  } else {
    circumspect::fuzz::read_beside(bytes[0], reading, source);
  }
  return 0;
}
