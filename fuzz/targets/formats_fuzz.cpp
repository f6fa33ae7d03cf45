// No bytes crash a reader, and every error is one line that names the file. Input: a byte that
// picks the format, one for how numbers are read, then the text.
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "oracle/formats/element_formats.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/plain_files.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/ply.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/surface_formats.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/formats/vtk.hpp"

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

// The elements, the mesh that they are and the domain.
void read_elements(Result<formats::ElementFile> elements) {
  if (!expect_value_or_line(elements)) return;
  const Result<formats::DomainFile> domain = domain_of(*elements, "f");
  if (expect_value_or_line(domain)) formats::taken_for_plane(*domain);
  if (expect_value_or_line(check_simplices(*elements, "f"))) top_elements(*elements);
}

void read(std::uint8_t format, NumberReading reading, const Source& source) {
  // The letters 'a' to 'w', so that seeds can be written by hand.
  switch ((format - 'a') & 31) {
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
    case 14:
      expect_value_or_line(formats::read_npy_points(source));
      expect_value_or_line(formats::read_npy_simplices(source));
      if (const auto array = formats::array_of_npz(source, "points"))
        formats::read_npy_points(*array);
      return;
    case 15:
      expect_agreement(source);
      return;
    case 16:
      read_elements(formats::read_gmsh(source, reading));
      return;
    case 17:
      read_elements(formats::read_vtk(source, reading));
      return;
    case 18:
      read_elements(formats::read_vtu(source, reading));
      return;
    case 19:
      read_elements(formats::read_obj(source, reading));
      return;
    case 20:
      read_elements(formats::read_tet(source, reading));
      return;
    case 21:
      expect_value_or_line(formats::read_xyz(source, reading));
      expect_value_or_line(formats::read_csv(source, reading));
      return;
    case 22:
      read_elements(formats::read_ply_elements(source, reading));
      return;
    default:
      read_elements(formats::read_medit(source, reading));
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
