// Arrays of numbers in VTK's XML files: as text, or as bytes in the element or appended to the
// document, raw or in base 64, compressed by zlib, by LZ4, by LZMA or not.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/xml_skeleton.hpp"

namespace circumspect::formats {

// The line on which this place of a text is, from 1.
std::size_t line_at(std::string_view text, std::size_t offset);

// The document, and the bytes after it.
class VtuDocument {
 public:
  // Errors: the file is not XML; the attributes of the element VTKFile name a variant that is not
  // read. Requires: the source outlives this object.
  static Result<std::unique_ptr<VtuDocument>> parse(const Source& source, NumberReading reading);

  pugi::xml_node root() const { return document_.child("VTKFile"); }
  const std::string& name() const { return source_.name; }
  // The line on which an element begins.
  std::size_t line_of(pugi::xml_node node) const;
  // An error about an element.
  tl::unexpected<FormatError> fail(pugi::xml_node node, std::string expected,
                                   std::string found) const;
  // An attribute that is a count; it may have blanks around it, as VTK allows.
  Result<std::size_t> count(pugi::xml_node node, const char* attribute) const;

  // The numbers of a DataArray. They are read by `text`.
  struct Array {
    NumberType type;
    std::unique_ptr<std::string> own;  // what `text` reads, unless that is a part of the file
    MixedText text;
  };
  // Errors include more numbers, in all arrays that were asked for, than a file of this size can
  // have.
  Result<Array> array(pugi::xml_node node);

 private:
  VtuDocument(const Source& source, NumberReading reading) : source_(source), reading_(reading) {}

  Status read_attributes();
  // Takes so many bytes of numbers out of what is left for all arrays.
  Status take_numbers(pugi::xml_node node, std::size_t bytes, std::size_t bytes_each);
  // Bytes of the file, or of their own.
  struct Stored {
    std::unique_ptr<std::string> own = {};
    std::string_view bytes = {};
  };
  static std::optional<Stored> first_bytes(std::string_view stored, bool is_base64,
                                           std::size_t count);
  Result<Stored> decode(pugi::xml_node node, std::string_view stored, bool is_base64,
                        std::size_t bytes_each);
  Result<Stored> inflate(pugi::xml_node node, std::string_view stored, bool is_base64,
                         std::size_t bytes_each);

  const Source& source_;
  NumberReading reading_;
  XmlSkeleton skeleton_;
  pugi::xml_document document_;
  std::string_view appended_ = {};  // after the '_' of AppendedData
  bool is_appended_base64_ = false;
  ByteOrder order_ = ByteOrder::kLittleEndian;
  std::size_t size_of_lengths_ = 4;  // of those in front of bytes
  // Unpacks one block into exactly the bytes for which there is room; null if none is packed.
  bool (*unpack_)(std::string_view block, std::span<char> to) = nullptr;
  std::size_t most_numbers_ = 0;  // in all arrays that are not text
  std::size_t numbers_ = 0;       // so far
};

}  // namespace circumspect::formats
