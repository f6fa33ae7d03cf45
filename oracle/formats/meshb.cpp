#include "oracle/formats/meshb.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/formats/bytes/binary.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/medit_types.hpp"

namespace circumspect::formats {
namespace {

constexpr std::uint64_t kDimension = 3;
constexpr std::uint64_t kVertices = 4;
constexpr std::uint64_t kEnd = 54;
constexpr std::uint64_t kLastVersion = 4;

struct Header {
  ByteOrder order;
  std::uint64_t version;
};

// The first 8 bytes, in whichever byte order they are 1 and a version.
std::optional<Header> header_of(std::string_view bytes) {
  for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
    Bytes head(bytes, order);
    const auto one = head.unsigned_integer(4);
    const auto version = head.unsigned_integer(4);
    if (one == 1 && version && *version >= 1 && *version <= kLastVersion) {
      return Header{order, *version};
    }
  }
  return std::nullopt;
}

class MeshbReader {
 public:
  MeshbReader(const Source& source, Header header) : source_(source), header_(header) {}

  Result<ElementFile> read();

 private:
  std::size_t bytes_of_place() const { return header_.version >= 3 ? 8 : 4; }
  std::size_t bytes_of_integer() const { return header_.version >= 4 ? 8 : 4; }
  std::size_t bytes_of_number() const { return header_.version == 1 ? 4 : 8; }

  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return tl::unexpected(FormatError{source_.name, 0, std::move(expected), std::move(found)});
  }

  Status read_dimension(Bytes section);
  // How many entries of so many bytes the section has: they fill it.
  Result<std::size_t> count_of(Bytes& section, std::size_t bytes, std::string_view noun) const;
  Status read_vertices(Bytes section);
  Status read_elements(Bytes section, const MeditSection& of);
  Status read_section(std::uint64_t code, Bytes section);

  const Source& source_;
  Header header_;
  ElementFile file_;
  bool has_vertices_ = false;
};

Status MeshbReader::read_dimension(Bytes section) {
  if (file_.points.dimension != 0) return fail("one section Dimension", "another");
  const auto dimension = section.unsigned_integer(4);
  if (!dimension || section.left() > 0) return fail("the dimension, of 4 bytes", "another section");
  if (*dimension != 2 && *dimension != 3) {
    return fail("dimension 2 or 3", std::to_string(*dimension));
  }
  file_.points.dimension = static_cast<std::size_t>(*dimension);
  file_.points.points.set_columns(file_.points.dimension);
  return {};
}

Result<std::size_t> MeshbReader::count_of(Bytes& section, std::size_t bytes,
                                          std::string_view noun) const {
  const auto count = section.unsigned_integer(bytes_of_integer());
  const std::string what(noun);
  if (!count) return fail("the number of " + what, "the end of the section");
  if (*count != section.left() / bytes || section.left() % bytes != 0) {
    return fail(std::to_string(*count) + " " + what + " of " + std::to_string(bytes) + " bytes",
                std::to_string(section.left()) + " bytes up to the next section");
  }
  return static_cast<std::size_t>(*count);
}

Status MeshbReader::read_vertices(Bytes section) {
  const std::size_t dimension = file_.points.dimension;
  if (dimension == 0) return fail("the section Dimension before Vertices", "Vertices");
  if (has_vertices_) return fail("one section Vertices", "another");
  has_vertices_ = true;
  const std::size_t bytes = bytes_of_number();
  const auto count = count_of(section, dimension * bytes + bytes_of_integer(), "vertices");
  if (!count) return tl::unexpected(count.error());
  PointRows& points = file_.points.points;
  points.reserve(*count);
  for (std::size_t i = 0; i < *count; ++i) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      const double number = double_of_bits(*section.unsigned_integer(bytes), bytes);
      if (!std::isfinite(number)) {
        return fail("a finite number for " + Item("", "vertex", i, *count).words(),
                    std::isnan(number) ? "NaN" : "infinity");
      }
      points.add(number + 0.0);  // −0 is 0
    }
    section.skip(bytes_of_integer());
  }
  return {};
}

Status MeshbReader::read_elements(Bytes section, const MeditSection& of) {
  const std::size_t bytes = bytes_of_integer();
  const auto count = count_of(section, (of.vertices + 1) * bytes, of.keyword);
  if (!count) return tl::unexpected(count.error());
  const std::string name = std::string(of.article) + " " + std::string(of.noun);
  Simplex element(of.vertices);
  for (std::size_t i = 0; i < *count; ++i) {
    for (Vertex& vertex : element) vertex = as_signed(*section.unsigned_integer(bytes), bytes);
    const Vertex label = as_signed(*section.unsigned_integer(bytes), bytes);
    add_element(file_, of.shape, element, name, 0, label);
  }
  return {};
}

Status MeshbReader::read_section(std::uint64_t code, Bytes section) {
  if (code == kDimension) return read_dimension(section);
  if (code == kVertices) return read_vertices(section);
  for (const MeditSection& one : kMeditSections) {
    if (one.code != 0 && one.code == code) return read_elements(section, one);
  }
  return {};
}

Result<ElementFile> MeshbReader::read() {
  const std::string_view text = source_.text;
  for (std::size_t at = 8; true;) {
    Bytes here(text.substr(at), header_.order);
    const auto code = here.unsigned_integer(4);
    if (code == kEnd) break;
    const auto next = here.unsigned_integer(bytes_of_place());
    if (!next) {
      if (at < text.size()) {
        return fail("a section, or End, at byte " + std::to_string(at), "the end of the file");
      }
      file_.notes.push_back(source_.name +
                            ": no section End; if the file was cut off, it is between sections");
      break;
    }
    const std::size_t begin = text.size() - here.left();
    if (*next < begin || *next > text.size()) {
      return fail("the place of the next section, from byte " + std::to_string(begin) + " to " +
                      std::to_string(text.size()) + ", at byte " + std::to_string(at + 4),
                  std::to_string(*next));
    }
    const auto stop = static_cast<std::size_t>(*next);
    const Bytes section(text.substr(begin, stop - begin), header_.order);
    if (Status read = read_section(*code, section); !read) return tl::unexpected(read.error());
    at = stop;
  }
  if (!has_vertices_) return fail("a section Vertices", "none");
  file_.points.first_index = 1;
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_meshb(std::string_view bytes) { return header_of(bytes).has_value(); }

Result<ElementFile> read_meshb(const Source& source, NumberReading) {
  const auto header = header_of(source.text);
  if (header) return MeshbReader(source, *header).read();
  return tl::unexpected(FormatError{source.name, 0,
                                    "the integer 1 and a version from 1 to 4, of 4 bytes each",
                                    quote(std::string_view(source.text).substr(0, 8))});
}

}  // namespace circumspect::formats
