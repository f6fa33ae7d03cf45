#include "oracle/formats/hdf5_objects.hpp"

#include <algorithm>
#include <limits>

namespace circumspect::formats {
namespace {

constexpr std::string_view kSignature("\x89HDF\r\n\x1a\n", 8);
constexpr std::uint64_t kNowhere = std::numeric_limits<std::uint64_t>::max();

// The part of a path in front, which is taken away.
std::string_view next_name(std::string_view& path) {
  while (path.starts_with('/')) path.remove_prefix(1);
  const std::string_view name = path.substr(0, path.find('/'));
  path.remove_prefix(name.size());
  return name;
}

}  // namespace

std::uint64_t Hdf5Cursor::number(std::size_t size) {
  std::uint64_t value = 0;
  const std::string_view digits = bytes(size);
  for (std::size_t i = digits.size(); i > 0; --i) {
    value = value << 8U | static_cast<unsigned char>(digits[i - 1]);
  }
  return value;
}

std::string_view Hdf5Cursor::bytes(std::uint64_t count) {
  failed_ = failed_ || count > rest_.size();
  if (failed_) return {};
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

bool Hdf5File::is_undefined(std::uint64_t address) const {
  return address == kNowhere >> (64 - 8 * offset_size_);
}

// The signature may stand behind bytes of others, at 512, 1024 and so on.
Result<Hdf5File> Hdf5File::open(const Source& source) {
  Hdf5File file;
  file.name_ = source.name;
  const std::string_view text = source.text;
  for (std::size_t at = 0; at < text.size(); at = at == 0 ? 512 : 2 * at) {
    if (!text.substr(at).starts_with(kSignature)) continue;
    file.bytes_ = text.substr(at);
    if (Status read = file.read_superblock(Hdf5Cursor(file.bytes_, kSignature.size())); !read) {
      return tl::unexpected(read.error());
    }
    return file;
  }
  return file.fail("a file of HDF5",
                   text.empty() ? "nothing" : quote(text.substr(0, kSignature.size())));
}

Status Hdf5File::read_superblock(Hdf5Cursor at) {
  const std::uint64_t version = at.number(1);
  if (version > 3) return fail("a superblock of version 0 to 3", std::to_string(version));
  if (version < 2) at.bytes(4);
  offset_size_ = at.number(1);
  length_size_ = at.number(1);
  for (const std::size_t size : {offset_size_, length_size_}) {
    if (size != 4 && size != 8) return fail("addresses of 4 or 8 bytes", std::to_string(size));
  }
  at.bytes(version >= 2 ? 1 : version == 1 ? 13 : 9);
  at.bytes(2 * offset_size_);  // the base, which is where this is; free space, or an extension
  const std::uint64_t end = at.number(offset_size_);
  if (version < 2) at.bytes(2 * offset_size_);  // a driver, and the name of the root
  root_ = at.number(offset_size_);
  if (!at.has_failed() && end > bytes_.size()) {
    return fail(std::to_string(end) + " bytes, as the superblock says",
                std::to_string(bytes_.size()) + ": the file was cut off, or is still written");
  }
  if (!at.has_failed()) return {};
  return fail("a superblock", "the end of the file at byte " + std::to_string(bytes_.size()));
}

Status Hdf5File::add_messages(Block block, unsigned version, bool has_order,
                              std::vector<Hdf5Message>& messages,
                              std::vector<Block>& behind) const {
  Hdf5Cursor whole(bytes_, block.begin);
  Hdf5Cursor at(whole.bytes(block.length), 0);
  if (whole.has_failed()) return fail_at("a header of an object", block.begin);
  const std::size_t head = version == 1 ? 8 : has_order ? 6 : 4;
  while (at.left() >= head) {
    Hdf5Message message;
    message.type = static_cast<unsigned>(at.number(version == 1 ? 2 : 1));
    const std::uint64_t size = at.number(2);
    message.is_shared = (at.number(1) & 2U) != 0;
    at.bytes(head - (version == 1 ? 5 : 4));
    message.data = at.bytes(size);
    if (at.has_failed()) return fail_at("a message in the header of an object", block.begin);
    if (message.type == Hdf5Message::kContinuation) {
      Hdf5Cursor next(message.data, 0);
      const std::uint64_t begin = next.number(offset_size_);
      behind.push_back({begin, next.number(length_size_)});
      if (next.has_failed()) return fail_at("where a header goes on", block.begin);
    }
    messages.push_back(message);
  }
  return {};
}

Result<std::vector<Hdf5Message>> Hdf5File::messages(std::uint64_t address) const {
  Hdf5Cursor at(bytes_, address);
  std::vector<Block> blocks;
  unsigned version = 1;
  bool has_order = false;
  Hdf5Cursor signature = at;
  if (signature.begins_with("OHDR")) {
    at = signature;
    version = static_cast<unsigned>(at.number(1));
    const std::uint64_t flags = at.number(1);
    has_order = (flags & 4U) != 0;
    at.bytes(((flags & 0x20U) != 0 ? 16 : 0) + ((flags & 0x10U) != 0 ? 4 : 0));
    const std::uint64_t length = at.number(std::size_t{1} << (flags & 3U));
    blocks.push_back({bytes_.size() - at.left(), length});
    if (version != 2) return fail_at("a header of an object of version 2", address);
  } else {
    if (at.number(1) != 1) return fail_at("a header of an object", address);
    at.bytes(7);
    const std::uint64_t length = at.number(4);
    at.bytes(4);
    blocks.push_back({bytes_.size() - at.left(), length});
  }
  if (at.has_failed()) return fail_at("a header of an object", address);
  std::vector<Hdf5Message> found;
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    Block block = blocks[i];
    if (block.length > bytes_.size() - seen) return fail_at("a header that ends", address);
    seen += block.length;
    if (i > 0 && version == 2) {  // a signature in front, a checksum behind
      if (block.length < 8 || !Hdf5Cursor(bytes_, block.begin).begins_with("OCHK")) {
        return fail_at("where a header goes on", block.begin);
      }
      block = {block.begin + 4, block.length - 8};
    }
    if (Status added = add_messages(block, version, has_order, found, blocks); !added) {
      return tl::unexpected(added.error());
    }
  }
  return found;
}

std::uint64_t Hdf5File::in_symbol_node(std::uint64_t node, std::string_view names,
                                       std::string_view name) const {
  Hdf5Cursor at(bytes_, node);
  if (!at.begins_with("SNOD")) return kNowhere;
  at.bytes(2);
  for (std::uint64_t count = at.number(2); count > 0; --count) {
    Hdf5Cursor entry(names, at.number(offset_size_));
    const std::uint64_t object = at.number(offset_size_);
    at.bytes(24);
    if (at.has_failed()) return kNowhere;
    const std::string_view found =
        entry.bytes(std::min<std::size_t>(name.size() + 1, entry.left()));
    if (found.size() == name.size() + 1 && found.starts_with(name) && found.back() == '\0') {
      return object;
    }
  }
  return kNowhere;
}

// The nodes of the tree of names; each is looked at once.
Result<std::uint64_t> Hdf5File::in_symbol_table(std::string_view table,
                                                std::string_view name) const {
  Hdf5Cursor addresses(table, 0);
  std::vector<std::uint64_t> nodes = {addresses.number(offset_size_)};
  const std::uint64_t heap_at = addresses.number(offset_size_);
  Hdf5Cursor heap(bytes_, heap_at);
  const bool is_heap = heap.begins_with("HEAP");
  heap.bytes(4);
  const std::uint64_t size = heap.number(length_size_);
  heap.bytes(length_size_);
  Hdf5Cursor data(bytes_, heap.number(offset_size_));
  const std::string_view names = data.bytes(size);
  if (!is_heap || heap.has_failed() || data.has_failed()) {
    return fail_at("the names of a group", heap_at);
  }
  const std::size_t most = bytes_.size() / 8;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Hdf5Cursor at(bytes_, nodes[i]);
    const bool is_node = at.begins_with("TREE") && at.number(1) == 0;
    const std::uint64_t level = at.number(1);
    std::uint64_t count = at.number(2);
    at.bytes(2 * offset_size_);
    if (!is_node || nodes.size() > most) return fail_at("a tree of names", nodes[i]);
    for (; count > 0 && !at.has_failed(); --count) {
      at.bytes(length_size_);
      const std::uint64_t child = at.number(offset_size_);
      if (level > 0) {
        nodes.push_back(child);
        continue;
      }
      const std::uint64_t found = in_symbol_node(child, names, name);
      if (found != kNowhere) return found;
    }
    if (at.has_failed()) return fail_at("a tree of names", nodes[i]);
  }
  return kNowhere;
}

Result<std::uint64_t> Hdf5File::member(const std::vector<Hdf5Message>& group,
                                       std::string_view name) const {
  bool has_many = false;
  for (const Hdf5Message& message : group) {
    if (message.type == Hdf5Message::kSymbolTable) return in_symbol_table(message.data, name);
    if (message.type == Hdf5Message::kLinkInfo) {
      Hdf5Cursor at(message.data, 1);
      const std::uint64_t flags = at.number(1);
      at.bytes((flags & 1U) != 0 ? 8 : 0);
      has_many = !is_undefined(at.number(offset_size_)) && !at.has_failed();
    }
    if (message.type != Hdf5Message::kLink) continue;
    Hdf5Cursor at(message.data, 1);
    const std::uint64_t flags = at.number(1);
    const std::uint64_t kind = (flags & 8U) != 0 ? at.number(1) : 0;
    at.bytes(((flags & 4U) != 0 ? 8 : 0) + ((flags & 0x10U) != 0 ? 1 : 0));
    const std::string_view found = at.bytes(at.number(std::size_t{1} << (flags & 3U)));
    const std::uint64_t object = at.number(offset_size_);
    if (!at.has_failed() && kind == 0 && found == name) return object;
  }
  if (!has_many) return kNowhere;
  return fail("a group whose links are in its header",
              "one in a heap (h5repack -L 0 makes the other)");
}

Result<std::vector<Hdf5Message>> Hdf5File::object(std::string_view path) const {
  const std::string whole(path);
  Result<std::vector<Hdf5Message>> found = messages(root_);
  for (std::string_view name = next_name(path); found && !name.empty(); name = next_name(path)) {
    const Result<std::uint64_t> address = member(*found, name);
    if (!address) return tl::unexpected(address.error());
    if (*address == kNowhere)
      return fail("a data set " + quote(whole), "no " + quote(name) + " in it");
    found = messages(*address);
  }
  return found;
}

}  // namespace circumspect::formats
