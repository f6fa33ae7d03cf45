#include "oracle/formats/gmsh.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/gmsh_types.hpp"
#include "oracle/formats/node_tags.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {
namespace {

class GmshReader {
 public:
  GmshReader(const Source& source, NumberReading reading) : text_(source, reading) {}

  Result<ElementFile> read();

 private:
  Status expect_word(std::string_view word);
  Status read_header();
  Status read_section(std::string_view keyword);
  Status read_section_1(std::string_view keyword);
  Status read_nodes_2();
  Status read_nodes_4();
  Status read_node_block(std::size_t& read);
  // Each point behind its tag, or all tags before all points, as in version 4.1. Parameters of each
  // point follow it.
  Status read_tagged_points(std::size_t count, std::size_t parameters);
  Status read_tags_and_points(std::size_t count, std::size_t parameters);
  Status read_coordinates(std::size_t more, const Item& item);
  Status read_elements_1();
  Status read_elements_2();
  Status read_elements_4();
  Status read_element_block(std::size_t& read);
  Result<const ElementType*> read_type();
  Status read_vertices(const ElementType& type, NumberType of_tags, Vertex label);
  std::size_t read_stored_elements(const ElementType& type, NumberType of_tags, Vertex label,
                                   std::size_t count);
  Status read_entities();
  Status read_entity(std::size_t dimension);
  // Goes to the numbers of a section; in binary files they begin on the next line.
  void go_to_numbers() {
    if (text_.is_binary()) text_.rest_of_line();
  }
  // The rest of a line that is in no section. Requires: `first_word` has just been read.
  void skip_line(std::string_view first_word);

  MixedText text_;
  std::size_t version_ = 0;  // 1, 2 or 4
  bool is_4_0_ = false;      // of version 4
  bool has_nodes_ = false;
  bool has_elements_ = false;
  bool has_skipped_line_ = false;
  ElementFile file_;
  Simplex vertices_;                                    // of one element
  std::vector<Vertex> tags_;                            // of the points
  std::map<std::pair<Vertex, Vertex>, Vertex> groups_;  // the first physical group of an entity
};

Status GmshReader::expect_word(std::string_view word) {
  if (text_.word() == word) return {};
  return text_.fail_at_word("\"" + std::string(word) + "\"");
}

Status GmshReader::read_header() {
  Status status = expect_word("$MeshFormat");
  if (!status) return status;
  text_.begin_section();
  const std::string_view version = text_.word();
  is_4_0_ = version == "4" || version == "4.0";
  version_ = is_4_0_ || version == "4.1" ? 4 : version == "2" || version.starts_with("2.") ? 2 : 0;
  if (version_ == 0) {
    return text_.fail_at_word(
        "version 2, 4.0 or 4.1 of the format (gmsh writes it with -format msh41)");
  }
  const Result<std::size_t> type = text_.count_in_text("0 (text) or 1 (binary)");
  if (!type) return tl::unexpected(type.error());
  if (*type > 1) return text_.fail_at_word("0 (text) or 1 (binary)");
  const Result<std::size_t> size = text_.count_in_text("8, the size of a number");
  if (!size) return tl::unexpected(size.error());
  if (*size != 8) return text_.fail_at_word("8, the size of a number");
  if (*type == 1) {
    text_.rest_of_line();
    text_.set_binary(ByteOrder::kLittleEndian);
    const Result<Vertex> one = text_.integer(kInt32, "the number 1");
    if (!one) return tl::unexpected(one.error());
    constexpr Vertex kOneOfOtherOrder = 1 << 24;
    if (*one != 1 && *one != kOneOfOtherOrder) {
      return text_.fail("the number 1, in either byte order", std::to_string(*one));
    }
    if (*one != 1) text_.set_binary(ByteOrder::kBigEndian);
  }
  return expect_word("$EndMeshFormat");
}

// Of one point; then its parameters, which are skipped.
Status GmshReader::read_coordinates(std::size_t more, const Item& item) {
  Status status = text_.points(kFloat64, 1, item, file_.points.points);
  if (!status || more == 0) return status;
  return text_.skip_numbers(kFloat64, more, {"a parameter of ", item.noun, item.place, item.count});
}

Status GmshReader::read_nodes_2() {
  const Result<std::size_t> count = text_.count_in_text("the number of nodes");
  if (!count) return tl::unexpected(count.error());
  go_to_numbers();
  return read_tagged_points(*count, 0);
}

Status GmshReader::read_node_block(std::size_t& read) {
  Status entity;
  if (is_4_0_) entity = text_.skip_numbers(kInt32, 1, "the tag of an entity");
  if (!entity) return entity;
  const Result<std::size_t> dimension = text_.count(kInt32, "the dimension of an entity");
  if (!dimension) return tl::unexpected(dimension.error());
  if (*dimension > 3) {
    return text_.fail("the dimension of an entity, 3 at most", std::to_string(*dimension));
  }
  if (!is_4_0_) entity = text_.skip_numbers(kInt32, 1, "the tag of an entity");
  if (!entity) return entity;
  const Result<std::size_t> parametric = text_.count(kInt32, "whether there are parameters");
  if (!parametric) return tl::unexpected(parametric.error());
  const Result<std::size_t> count = text_.count(kUint64, "the number of nodes of a block");
  if (!count) return tl::unexpected(count.error());
  read += *count;
  const std::size_t parameters = *parametric == 0 ? 0 : *dimension;
  return is_4_0_ ? read_tagged_points(*count, parameters)
                 : read_tags_and_points(*count, parameters);
}

Status GmshReader::read_tagged_points(std::size_t count, std::size_t parameters) {
  for (std::size_t i = 0; i < count; ++i) {
    tags_.push_back(text_.take(kInt32, Item("", "node", i, count)));
    if (text_.has_failed()) return text_.failure();
    const Item item("a coordinate of ", "node", i, count);
    if (Status point = read_coordinates(parameters, item); !point) return point;
  }
  return {};
}

Status GmshReader::read_tags_and_points(std::size_t count, std::size_t parameters) {
  for (std::size_t i = 0; i < count; ++i) {
    tags_.push_back(text_.take(kUint64, Item("", "node", i, count)));
    if (text_.has_failed()) return text_.failure();
  }
  const Item first("a coordinate of ", "node", 0, count);
  if (parameters == 0) return text_.points(kFloat64, count, first, file_.points.points);
  Status points;
  for (std::size_t i = 0; points && i < count; ++i) {
    points = read_coordinates(parameters, Item("a coordinate of ", "node", i, count));
  }
  return points;
}

// The counts with which $Nodes and $Elements begin in version 4, then the blocks.
Status GmshReader::read_nodes_4() {
  go_to_numbers();
  const Result<std::size_t> blocks = text_.count(kUint64, "the number of blocks of nodes");
  if (!blocks) return tl::unexpected(blocks.error());
  const Result<std::size_t> count = text_.count(kUint64, "the number of nodes");
  if (!count) return tl::unexpected(count.error());
  Status status;
  if (!is_4_0_) {
    status = text_.skip_numbers(kUint64, 2, "the lowest and the highest tag of nodes");
  }
  std::size_t read = 0;
  for (std::size_t i = 0; status && i < *blocks; ++i) status = read_node_block(read);
  if (!status || read == *count) return status;
  return text_.fail(std::to_string(*count) + " nodes in all blocks", std::to_string(read));
}

Result<const ElementType*> GmshReader::read_type() {
  const Vertex code = text_.take(kInt32, "the type of an element");
  if (text_.has_failed()) return text_.failure();
  const auto* const type = std::find_if(kGmshTypes.begin(), kGmshTypes.end(),
                                        [&](const ElementType& one) { return one.code == code; });
  if (type != kGmshTypes.end()) return type;
  if (code < 1 || code > kLastGmshType) {
    return text_.fail("a type of elements from 1 to " + std::to_string(kLastGmshType),
                      std::to_string(code));
  }
  return text_.fail("edges, triangles and tetrahedra",
                    "an element of Gmsh's type " + std::to_string(code));
}

// In version 4 the physical groups of elements are those of the entity to which they belong.
Status GmshReader::read_entity(std::size_t dimension) {
  const Result<Vertex> tag = text_.integer(kInt32, "the tag of an entity");
  if (!tag) return tl::unexpected(tag.error());
  const std::size_t bounds = dimension == 0 && !is_4_0_ ? 3 : 6;
  Status status = text_.skip_numbers(kFloat64, bounds, "a bound of an entity");
  if (!status) return status;
  const Result<std::size_t> groups = text_.count(kUint64, "the number of physical groups");
  if (!groups) return tl::unexpected(groups.error());
  for (std::size_t i = 0; i < *groups; ++i) {
    const Result<Vertex> group = text_.integer(kInt32, "a physical group of an entity");
    if (!group) return tl::unexpected(group.error());
    groups_.try_emplace({static_cast<Vertex>(dimension), *tag}, *group);
  }
  if (dimension == 0) return {};
  const Result<std::size_t> boundary = text_.count(kUint64, "the number of bounding entities");
  if (!boundary) return tl::unexpected(boundary.error());
  return text_.skip_numbers(kInt32, *boundary, "the tag of a bounding entity");
}

Status GmshReader::read_entities() {
  go_to_numbers();
  std::array<std::size_t, 4> counts = {};
  for (std::size_t& count : counts) {
    const Result<std::size_t> entities = text_.count(kUint64, "the number of entities");
    if (!entities) return tl::unexpected(entities.error());
    count = *entities;
  }
  for (std::size_t dimension = 0; dimension < counts.size(); ++dimension) {
    for (std::size_t i = 0; i < counts[dimension]; ++i) {
      if (Status entity = read_entity(dimension); !entity) return entity;
    }
  }
  return {};
}

Status GmshReader::read_vertices(const ElementType& type, NumberType of_tags, Vertex label) {
  const std::size_t line = text_.line();
  vertices_.resize(type.vertices);
  for (Vertex& vertex : vertices_) vertex = text_.take(of_tags, {"a node of ", type.name});
  if (text_.has_failed()) return text_.failure();
  add_element(file_, type.shape, vertices_, type.name, line, label);
  return {};
}

// Some binary elements, each behind its tag, at once; returns how many: 0 if something is wrong.
std::size_t GmshReader::read_stored_elements(const ElementType& type, NumberType of_tags,
                                             Vertex label, std::size_t count) {
  constexpr std::size_t kAtOnce = 1 << 12;
  const std::size_t each = 1 + type.vertices;
  count = std::min(count, kAtOnce);
  if (!text_.is_binary() || count * each > text_.bytes_left() / of_tags.size) return 0;
  Indices numbers;
  MixedText text = text_;
  if (!text.integers(of_tags, count * each, "", numbers)) return 0;
  vertices_.resize(type.vertices);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 1; j < each; ++j) vertices_[j - 1] = numbers[i * each + j];
    add_element(file_, type.shape, vertices_, type.name, 0, label);
  }
  text_ = std::move(text);
  return count;
}

// In text each element has its type and tags; in binary they come in blocks of one type.
Status GmshReader::read_elements_2() {
  const Result<std::size_t> count = text_.count_in_text("the number of elements");
  if (!count) return tl::unexpected(count.error());
  go_to_numbers();
  for (std::size_t read = 0; read < *count;) {
    const Item of_one("a tag of ", "element", read, *count);
    if (!text_.is_binary()) {
      text_.take(kInt32, Item("", "element", read, *count));
      if (text_.has_failed()) return text_.failure();
    }
    const Result<const ElementType*> type = read_type();
    if (!type) return tl::unexpected(type.error());
    Result<std::size_t> in_block = 1;
    if (text_.is_binary()) in_block = text_.count(kInt32, "the number of elements of a block");
    if (!in_block) return tl::unexpected(in_block.error());
    const Item of_tags("the number of tags of ", "element", read, *count);
    const Vertex tags = text_.take(kInt32, of_tags);
    if (text_.has_failed()) return text_.failure();
    if (tags < 0) return text_.fail(of_tags.words() + ", 0 or more", std::to_string(tags));
    for (std::size_t i = 0; i < *in_block; ++i) {
      if (text_.is_binary()) text_.take(kInt32, of_one);
      const Vertex group = tags > 0 ? text_.take(kInt32, of_one) : 0;
      if (text_.has_failed()) return text_.failure();
      Status status;
      if (tags > 1) status = text_.skip_numbers(kInt32, count_of(tags) - 1, of_one);
      if (status) status = read_vertices(**type, kInt32, group);
      if (!status) return status;
    }
    read += *in_block;
    if (read > *count) {
      return text_.fail(std::to_string(*count) + " elements", std::to_string(read) + " in blocks");
    }
  }
  return {};
}

Status GmshReader::read_element_block(std::size_t& read) {
  const std::string which = "the dimension and the tag of an entity";
  Result<Vertex> dimension = text_.integer(kInt32, which);
  if (!dimension) return tl::unexpected(dimension.error());
  Result<Vertex> entity = text_.integer(kInt32, which);
  if (!entity) return tl::unexpected(entity.error());
  if (is_4_0_) std::swap(dimension, entity);
  const auto group = groups_.find({*dimension, *entity});
  const Vertex label = group == groups_.end() ? 0 : group->second;
  const Result<const ElementType*> type = read_type();
  if (!type) return tl::unexpected(type.error());
  const Result<std::size_t> count = text_.count(kUint64, "the number of elements of a block");
  if (!count) return tl::unexpected(count.error());
  const NumberType of_tags = is_4_0_ ? kInt32 : kUint64;
  for (std::size_t i = 0; i < *count; ++i) {
    i += read_stored_elements(**type, of_tags, label, *count - i);
    if (i == *count) break;
    text_.take(of_tags, Item("", "element", i, *count));
    if (text_.has_failed()) return text_.failure();
    if (Status vertices = read_vertices(**type, of_tags, label); !vertices) return vertices;
  }
  read += *count;
  return {};
}

Status GmshReader::read_elements_4() {
  go_to_numbers();
  const Result<std::size_t> blocks = text_.count(kUint64, "the number of blocks of elements");
  if (!blocks) return tl::unexpected(blocks.error());
  const Result<std::size_t> count = text_.count(kUint64, "the number of elements");
  if (!count) return tl::unexpected(count.error());
  Status status;
  if (!is_4_0_) {
    status = text_.skip_numbers(kUint64, 2, "the lowest and the highest tag of elements");
  }
  std::size_t read = 0;
  for (std::size_t i = 0; status && i < *blocks; ++i) status = read_element_block(read);
  if (!status || read == *count) return status;
  return text_.fail(std::to_string(*count) + " elements in all blocks", std::to_string(read));
}

// In version 1: a tag, the type, the physical group, the entity, the number of nodes, and these.
Status GmshReader::read_elements_1() {
  const Result<std::size_t> count = text_.count_in_text("the number of elements");
  if (!count) return tl::unexpected(count.error());
  for (std::size_t i = 0; i < *count; ++i) {
    Status skipped = text_.skip_numbers(kInt32, 1, Item("the tag of ", "element", i, *count));
    if (!skipped) return skipped;
    const Result<const ElementType*> type = read_type();
    if (!type) return tl::unexpected(type.error());
    const Vertex group = text_.take(kInt32, "the physical group of an element");
    text_.take(kInt32, "the entity of an element");
    const Vertex nodes = text_.take(kInt32, "the number of nodes of an element");
    if (text_.has_failed()) return text_.failure();
    if (nodes != static_cast<Vertex>((*type)->vertices)) {
      return text_.fail(
          std::to_string((*type)->vertices) + " nodes of " + std::string((*type)->name),
          std::to_string(nodes));
    }
    if (Status vertices = read_vertices(**type, kInt32, group); !vertices) return vertices;
  }
  return {};
}

Status GmshReader::read_section_1(std::string_view keyword) {
  text_.begin_section();
  if (keyword == "$NOD" && !std::exchange(has_nodes_, true)) {
    const Status nodes = read_nodes_2();
    return nodes ? expect_word("$ENDNOD") : nodes;
  }
  if (keyword == "$ELM" && !std::exchange(has_elements_, true)) {
    const Status elements = read_elements_1();
    return elements ? expect_word("$ENDELM") : elements;
  }
  return text_.fail_at_word("one section $NOD and one section $ELM");
}

// Requires: `keyword` has just been read, and begins with '$'.
Status GmshReader::read_section(std::string_view keyword) {
  if (version_ == 1) return read_section_1(keyword);
  const std::string end = "$End" + std::string(keyword.substr(1));
  text_.begin_section();
  if (keyword == "$Nodes" || keyword == "$Elements") {
    bool& is_there = keyword == "$Nodes" ? has_nodes_ : has_elements_;
    if (is_there) return text_.fail_at_word("one section " + std::string(keyword));
    is_there = true;
    Status status;
    if (keyword == "$Nodes") {
      status = version_ == 2 ? read_nodes_2() : read_nodes_4();
    } else {
      status = version_ == 2 ? read_elements_2() : read_elements_4();
    }
    return status ? expect_word(end) : status;
  }
  if (keyword == "$Entities" && version_ == 4) {
    Status status = read_entities();
    return status ? expect_word(end) : status;
  }
  const std::size_t line = text_.line();
  // Some writers do not end the line after binary data. Names and comments are text in every file,
  // and may contain the end marker.
  const bool is_text = !text_.is_binary() || keyword == "$PhysicalNames" || keyword == "$Comments";
  if (text_.skip_behind(end, is_text)) return {};
  return tl::unexpected(FormatError{
      text_.name(), line, shortened(end) + " behind " + shortened(keyword), "the end of the file"});
}

// Gmsh appends options there (Show "*";), and its own reader goes to the next line with a '$'.
void GmshReader::skip_line(std::string_view first_word) {
  const std::size_t line = text_.line();
  const std::string whole = std::string(first_word) + std::string(text_.rest_of_line());
  if (has_skipped_line_) return;
  has_skipped_line_ = true;
  file_.notes.push_back(text_.name() + (line == 0 ? "" : ":" + std::to_string(line)) +
                        ": lines outside the sections were skipped; the first is " + quote(whole));
}

Result<ElementFile> GmshReader::read() {
  if (text_.peek() == "$Comments") {
    text_.word();
    if (Status comments = read_section("$Comments"); !comments) {
      return tl::unexpected(comments.error());
    }
  }
  if (text_.peek() == "$NOD") {
    version_ = 1;
  } else if (Status header = read_header(); !header) {
    return tl::unexpected(header.error());
  }
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  while (true) {
    const std::string_view keyword = text_.word();
    if (keyword.empty()) break;
    if (keyword.front() != '$') {
      skip_line(keyword);
      continue;
    }
    if (keyword.starts_with("$End")) return text_.fail_at_word("a section, as $Nodes");
    if (Status section = read_section(keyword); !section) return tl::unexpected(section.error());
  }
  if (!has_nodes_) return text_.fail_at_word("the section $Nodes");
  if (!has_elements_) return text_.fail_at_word("the section $Elements");
  Status tags = index_by_tags(file_, std::move(tags_), text_.name(), "in $Nodes");
  if (!tags) return tl::unexpected(tags.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_gmsh_keyword(std::string_view token) { return token == "$MeshFormat" || token == "$NOD"; }

Result<ElementFile> read_gmsh(const Source& source, NumberReading reading) {
  return GmshReader(source, reading).read();
}

}  // namespace circumspect::formats
