#include "oracle/formats/format.hpp"

#include <algorithm>

#include "oracle/formats/curved_elements.hpp"
#include "oracle/formats/element_domain.hpp"
#include "oracle/formats/plane.hpp"

namespace circumspect::formats {

namespace {

// The simplices of the highest dimension; those of lower dimensions are listed beside them.
Result<Contents> mesh_of(ElementFile file, const std::string& name) {
  const Status simplices = check_simplices(file, name);
  if (!simplices) return tl::unexpected(simplices.error());
  Contents contents;
  contents.notes = std::move(file.notes);
  if (auto note = note_of_curved(file, name)) contents.notes.push_back(std::move(*note));
  contents.nodes_between = nodes_between_corners(file);
  TopElements top = top_elements(file);
  contents.simplices = std::move(top.simplices);
  contents.faces = std::move(top.faces);
  contents.points = RawPoints{std::move(file.points), {}, name};
  return contents;
}

bool has_ending(const Format& format, std::string_view ending) {
  return std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end();
}

std::string listed_endings(Has content, bool in_help) {
  std::string text;
  for (const Format& format : formats()) {
    if (!(format.*content)()) continue;
    for (const std::string_view ending : format.endings) {
      if (ending.empty() || format_of(ending) != &format) continue;
      text += (text.empty() ? "" : ", ") + std::string(ending);
      if (in_help && !format.aside.empty()) text += " (" + std::string(format.aside) + ")";
    }
  }
  return text;
}

// Lines of several files are none of the one that messages name.
void forget_lines(DomainFile& file) {
  std::fill(file.segment_lines.begin(), file.segment_lines.end(), 0);
  std::fill(file.polygon_lines.begin(), file.polygon_lines.end(), 0);
}

// What `read` makes of a text and of all that it includes.
template <class Read>
auto read_with_included(InclusionAt includes, const Source& source, const Read& read) {
  using Answer = decltype(read(source, false));
  if (includes == nullptr) return read(source, false);
  const Deck deck(source, includes);
  Answer answer = read(deck.source(), deck.has_included());
  if (answer) return answer;
  return Answer(tl::unexpected(deck.at_its_place(std::move(answer.error()))));
}

}  // namespace

Result<RawPoints> Format::read_points(const Source& source, NumberReading reading) const {
  if (points != nullptr) return points(source, reading);
  const auto read = [&](const Source& text, bool) -> Result<RawPoints> {
    Result<ElementFile> file = elements(text, reading);
    if (!file) return tl::unexpected(file.error());
    return RawPoints{std::move(file->points), {}, source.name};
  };
  return read_with_included(includes, source, read);
}

Result<Contents> Format::read_mesh(const Source& source, NumberReading reading) const {
  if (mesh != nullptr) return mesh(source, reading);
  const auto read = [&](const Source& text, bool) -> Result<Contents> {
    Result<ElementFile> file = elements(text, reading);
    if (!file) return tl::unexpected(file.error());
    return mesh_of(std::move(*file), source.name);
  };
  return read_with_included(includes, source, read);
}

Result<DomainFile> Format::read_domain(const Source& source, NumberReading reading) const {
  if (domain != nullptr) {
    Result<DomainFile> file = domain(source, reading);
    return file ? taken_for_plane(std::move(*file)) : std::move(file);
  }
  const auto read = [&](const Source& text, bool has_included) -> Result<DomainFile> {
    const Result<ElementFile> file = elements(text, reading);
    if (!file) return tl::unexpected(file.error());
    Result<DomainFile> whole = plane_or_space_of(*file, source.name);
    if (whole && has_included) forget_lines(*whole);
    return whole;
  };
  return read_with_included(includes, source, read);
}

const Format* format_of(std::string_view ending) {
  if (ending.empty()) return nullptr;
  const auto rows = formats();
  const auto found = std::find_if(rows.begin(), rows.end(), [ending](const Format& format) {
    return has_ending(format, ending);
  });
  return found == rows.end() ? nullptr : &*found;
}

const Format* format_of(std::string_view ending, const Source& source) {
  if (ending.empty()) return nullptr;
  for (const Format& format : formats()) {
    if (format.is_meant == nullptr || !has_ending(format, ending)) continue;
    if (format.is_meant(Beginning(source))) return &format;
  }
  return format_of(ending);
}

const Format* told_format(const Source& source, Has content, bool has_points) {
  Beginning beginning(source);
  beginning.has_points = has_points;
  for (const auto is : {&Format::is_told, &Format::is_taken_for}) {
    for (const Format& format : formats()) {
      if (!(format.*content)() || format.*is == nullptr) continue;
      if ((format.*is)(beginning)) return &format;
    }
  }
  return nullptr;
}

std::string endings_of(Has content) { return listed_endings(content, false); }
std::string endings_in_help(Has content) { return listed_endings(content, true); }

ElementWriter writer_of(std::string_view ending) {
  const Format* const format = format_of(ending);
  return format == nullptr ? nullptr : format->write;
}

std::vector<std::string_view> written_endings() {
  std::vector<std::string_view> endings;
  for (const Format& format : formats()) {
    if (format.write != nullptr) endings.push_back(format.endings.front());
  }
  return endings;
}

}  // namespace circumspect::formats
