// An XML file of VTK without the bytes that are large and no XML: the contents of its arrays, and
// what is appended to the document. A parser of XML would copy them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace circumspect::formats {

class XmlSkeleton {
 public:
  XmlSkeleton() = default;
  // Requires: the file outlives this object.
  explicit XmlSkeleton(std::string_view file);

  const std::string& text() const { return text_; }
  // The bytes after the '_' of AppendedData; empty if there are none.
  std::string_view appended() const { return appended_; }
  // Where in the file this place of the text is.
  std::size_t in_file(std::size_t place) const;
  // What was left out of the element whose name stands at this place of the text; nothing if its
  // content is in the text.
  std::optional<std::string_view> content_of(std::size_t place) const;

 private:
  struct Cut {
    std::size_t element = 0;  // where its name is in the text
    std::size_t at = 0;       // where in the text something is left out
    std::size_t end = 0;      // where the file goes on
    std::string_view content = {};
  };

  std::string text_;
  std::string_view appended_;
  std::vector<Cut> cuts_;  // in their order
};

}  // namespace circumspect::formats
