// The arrays of an XDMF file, which are text in it or lie in other files.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

struct XdmfArray {
  std::vector<std::size_t> dimensions;
  NumberType type;
  std::unique_ptr<std::string> own;  // what `text` reads, unless that is a part of the document
  MixedText text;

  std::size_t numbers() const;
  Status expect_end(const std::string& what);
};

class XdmfDocument {
 public:
  // Errors: no XML, or XML of something else. Requires: the source outlives this object.
  static Result<std::unique_ptr<XdmfDocument>> parse(const Source& source, NumberReading reading);

  pugi::xml_node root() const { return document_.child("Xdmf"); }
  const std::string& name() const { return source_.name; }
  // All grids, in their order; of those within one another the outer first.
  std::vector<pugi::xml_node> grids() const;
  tl::unexpected<FormatError> fail(pugi::xml_node node, std::string expected,
                                   std::string found) const;

  // The numbers of a DataItem; `of`: the element that should have it.
  Result<XdmfArray> array(pugi::xml_node item, pugi::xml_node of);

 private:
  XdmfDocument(const Source& source, NumberReading reading) : source_(source), reading_(reading) {}

  std::size_t line_of(pugi::xml_node node) const;
  Result<std::vector<std::size_t>> dimensions(pugi::xml_node item) const;
  Result<NumberType> type_of(pugi::xml_node item) const;
  // The other file that a DataItem names, which is read once.
  Result<const Source*> other_file(pugi::xml_node item, std::string_view path);
  Result<XdmfArray> from_hdf5(pugi::xml_node item, std::string_view text,
                              const std::vector<std::size_t>& dimensions);
  Result<XdmfArray> from_bytes(pugi::xml_node item, std::string_view path, XdmfArray array);

  const Source& source_;
  NumberReading reading_;
  pugi::xml_document document_;
  std::vector<std::unique_ptr<Source>> others_;
};

}  // namespace circumspect::formats
