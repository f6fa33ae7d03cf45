// No bytes crash a reader, and every error is one line that names the file. Input: a byte that picks
// the format, one for how numbers are read, then the text.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "oracle/formats/ele.hpp"
#include "oracle/formats/face.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/medit.hpp"
#include "oracle/formats/neigh.hpp"
#include "oracle/formats/node.hpp"
#include "oracle/formats/off.hpp"
#include "oracle/formats/ply.hpp"
#include "oracle/formats/poly.hpp"
#include "oracle/formats/qhull.hpp"
#include "oracle/formats/stl.hpp"

namespace circumspect::fuzz {
namespace {

using formats::Result;
using formats::Source;

template <class T>
bool expect_value_or_line(const Result<T>& result) {
  if (result) return true;
  const std::string message = result.error().to_string();
  if (message.rfind("f:", 0) == 0 && message.find('\n') == std::string::npos) return false;
  std::fprintf(stderr, "expected one line that begins with the file, found\n%s\n", message.c_str());
  std::abort();
}

Result<formats::PointFile> three_points() {
  return formats::PointFile{3, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, 1};
}

void read(std::uint8_t format, NumberReading reading, const Source& source) {
  // The letters 'a' to 'n', so that seeds can be written by hand.
  switch ((format - 'a') & 15) {
    case 0:
      expect_value_or_line(read_node(source, reading));
      return;
    case 1:
      expect_value_or_line(formats::read_ele(source));
      return;
    case 2:
      expect_value_or_line(formats::read_neigh(source));
      return;
    case 3:
      expect_value_or_line(formats::read_face(source, 3));
      return;
    case 4:
      expect_value_or_line(formats::read_face(source, 2));
      return;
    case 5:
      expect_value_or_line(read_off(source, reading));
      return;
    case 6:
      expect_value_or_line(read_qhull_points(source, reading));
      return;
    case 7:
      expect_value_or_line(formats::read_qhull_simplices(source));
      return;
    case 8:
      expect_value_or_line(read_json(source, reading));
      return;
    case 9:
      expect_value_or_line(read_poly(source, reading, three_points));
      return;
    case 10:
      expect_value_or_line(read_smesh(source, reading, three_points));
      return;
    case 11:
      expect_value_or_line(read_stl(source, reading));
      return;
    case 12:
      expect_value_or_line(read_ply(source, reading));
      return;
    default: {
      const auto medit = read_medit(source, reading);
      if (expect_value_or_line(medit)) expect_value_or_line(domain_of(*medit, "f"));
    }
  }
}

}  // namespace
}  // namespace circumspect::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using circumspect::NumberReading;
  if (size < 2) return 0;
  const auto reading = data[1] % 2 == 0 ? NumberReading::kDouble : NumberReading::kDecimal;
  circumspect::fuzz::read(data[0], reading,
                          {"f", std::string(reinterpret_cast<const char*>(data) + 2, size - 2)});
  return 0;
}
