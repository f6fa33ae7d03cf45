// The objects of a file of HDF5, by their paths, as the HDF5 File Format
// Specification 3.0 lays them out. What comes from the file is never believed
// before its bytes have been seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// Reads little-endian numbers one behind the other. After the first that is not
// there all are 0.
class Hdf5Cursor {
 public:
  Hdf5Cursor(std::string_view text, std::uint64_t at)
      : rest_(at <= text.size() ? text.substr(at) : std::string_view()),
        failed_(at > text.size()) {}

  // Requires: at most 8 bytes.
  std::uint64_t number(std::size_t size);
  std::string_view bytes(std::uint64_t count);
  bool begins_with(std::string_view signature) { return bytes(signature.size()) == signature; }
  std::size_t left() const { return rest_.size(); }
  bool has_failed() const { return failed_; }

 private:
  std::string_view rest_;
  bool failed_ = false;
};

// A message of an object's header.
struct Hdf5Message {
  enum Type : unsigned {
    kDataspace = 0x01,
    kLinkInfo = 0x02,
    kDatatype = 0x03,
    kLink = 0x06,
    kLayout = 0x08,
    kFilters = 0x0b,
    kContinuation = 0x10,
    kSymbolTable = 0x11,
  };
  unsigned type = 0;
  bool is_shared = false;  // `data` says where it is
  std::string_view data = {};
};

class Hdf5File {
 public:
  // Requires: the source outlives this object.
  static Result<Hdf5File> open(const Source& source);

  // The messages of the object at a path, as "/Mesh/mesh/topology".
  Result<std::vector<Hdf5Message>> object(std::string_view path) const;

  std::size_t offset_size() const { return offset_size_; }
  std::size_t length_size() const { return length_size_; }
  // From the beginning of the file on, at which addresses count.
  std::string_view bytes() const { return bytes_; }
  // An address that stands for none.
  bool is_undefined(std::uint64_t address) const;
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return tl::unexpected(FormatError{name_, 0, std::move(expected), std::move(found)});
  }
  tl::unexpected<FormatError> fail_at(std::string expected, std::uint64_t address) const {
    return fail(std::move(expected), "other bytes at byte " + std::to_string(address));
  }

 private:
  struct Block {
    std::uint64_t begin = 0;
    std::uint64_t length = 0;
  };

  Status read_superblock(Hdf5Cursor at);
  Result<std::vector<Hdf5Message>> messages(std::uint64_t address) const;
  // Of a block of a header; `behind`: what continues it.
  Status add_messages(Block block, unsigned version, bool has_order,
                      std::vector<Hdf5Message>& messages, std::vector<Block>& behind) const;
  // The address of the member of that name.
  Result<std::uint64_t> member(const std::vector<Hdf5Message>& group, std::string_view name) const;
  Result<std::uint64_t> in_symbol_table(std::string_view table, std::string_view name) const;
  std::uint64_t in_symbol_node(std::uint64_t node, std::string_view names,
                               std::string_view name) const;

  std::string name_;
  std::string_view bytes_;
  std::size_t offset_size_ = 8;
  std::size_t length_size_ = 8;
  std::uint64_t root_ = 0;
};

}  // namespace circumspect::formats
