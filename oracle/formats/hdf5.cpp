#include "oracle/formats/hdf5.hpp"

#include <algorithm>
#include <utility>

#include <zlib.h>

#include "oracle/formats/hdf5_objects.hpp"

namespace circumspect::formats {
namespace {

constexpr std::size_t kSmallArray = 1'000'000;
constexpr std::size_t kLargestGrowth = 200;
constexpr std::size_t kMostDimensions = 8;
constexpr std::uint64_t kDeflate = 1;
constexpr std::uint64_t kShuffle = 2;
constexpr std::uint64_t kChecksum = 3;

std::size_t most_bytes(const Hdf5File& file) {
  return std::max(kSmallArray, file.bytes().size() * kLargestGrowth);
}

// Fletcher's sums of pairs of bytes, which stand behind these and are taken off; false if they are
// others. Modulo 65535, for which libhdf5 writes 0 or 65535.
bool take_checksum(std::string& bytes) {
  constexpr std::size_t kSize = 4;
  if (bytes.size() < kSize) return false;
  Hdf5Cursor sums(bytes, bytes.size() - kSize);
  const std::uint64_t first = sums.number(2);
  const std::uint64_t second = sums.number(2);
  bytes.resize(bytes.size() - kSize);
  std::uint64_t sum = 0;
  std::uint64_t sum_of_sums = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const unsigned low = i + 1 < bytes.size() ? static_cast<unsigned char>(bytes[i + 1]) : 0;
    sum = (sum + (static_cast<unsigned char>(bytes[i]) << 8U | low)) % 65535;
    sum_of_sums = (sum_of_sums + sum) % 65535;
  }
  return first % 65535 == sum && second % 65535 == sum_of_sums;
}

class DataSet {
 public:
  DataSet(const Hdf5File& file, std::string_view path) : file_(file), path_(path) {}

  Result<Hdf5Array> read();

 private:
  // The message of a type, which must be there.
  Result<std::string_view> message(Hdf5Message::Type type, std::string_view what) const;
  Status read_dataspace(Hdf5Cursor at);
  Status read_type(Hdf5Cursor at);
  Status read_filters(Hdf5Cursor at);
  Status read_layout(Hdf5Cursor at);
  Status read_chunks(std::uint64_t tree, const std::vector<std::size_t>& sizes);
  Status read_chunk(Hdf5Cursor& key, std::uint64_t mask, std::uint64_t stored, std::uint64_t at,
                    const std::vector<std::size_t>& sizes);
  // The bytes of a chunk, `size` of them.
  Result<std::string> unpacked(std::string_view stored, std::uint64_t mask, std::size_t size) const;
  void copy_chunk(const std::string& chunk, const std::vector<std::size_t>& begin,
                  const std::vector<std::size_t>& sizes);
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return file_.fail(std::move(expected) + " of the data set " + quote(path_), std::move(found));
  }

  const Hdf5File& file_;
  std::string_view path_;
  std::vector<Hdf5Message> messages_;
  std::vector<std::uint64_t> filters_;
  std::size_t size_ = 0;  // in bytes, of all numbers
  std::size_t copied_ = 0;
  std::size_t unpacked_ = 0;  // of all chunks
  Hdf5Array array_;
};

Result<std::string_view> DataSet::message(Hdf5Message::Type type, std::string_view what) const {
  const auto found = std::find_if(messages_.begin(), messages_.end(),
                                  [type](const auto& message) { return message.type == type; });
  if (found == messages_.end()) return fail(std::string(what), "none (a group, or another object)");
  if (found->is_shared) return fail(std::string(what), "one that another object has");
  return found->data;
}

Status DataSet::read_dataspace(Hdf5Cursor at) {
  const std::uint64_t version = at.number(1);
  const std::uint64_t rank = at.number(1);
  at.bytes(version == 1 ? 6 : 2);
  if (version != 1 && version != 2)
    return fail("dimensions of version 1 or 2", std::to_string(version));
  if (rank == 0 || rank > kMostDimensions) {
    return fail("1 to 8 dimensions", std::to_string(rank));
  }
  // The packed data may hold more than the file, but only so much more.
  const std::size_t most = most_bytes(file_);
  size_ = array_.type.size;
  for (std::uint64_t i = 0; i < rank; ++i) {
    const std::uint64_t length = at.number(file_.length_size());
    array_.dimensions.push_back(length);
    if (length != 0 && size_ > most / length) {
      return fail("at most " + std::to_string(most) + " bytes", "more");
    }
    size_ *= length;
  }
  return at.has_failed() ? Status(fail("dimensions", "the end of their message")) : Status();
}

Status DataSet::read_type(Hdf5Cursor at) {
  const std::uint64_t kind = at.number(1) & 0xfU;
  const std::uint64_t bits = at.number(1);
  at.bytes(2);
  const std::size_t size = at.number(4);
  const std::uint64_t offset = at.number(2);
  const std::uint64_t precision = at.number(2);
  const std::uint64_t exponent = at.number(4);  // where it is, its size, the same of the mantissa
  const std::uint64_t bias = at.number(4);
  const bool is_whole = offset == 0 && precision == 8 * size;
  if ((bits & 1U) != 0) array_.order = ByteOrder::kBigEndian;
  const bool is_integer_size = size == 1 || size == 2 || size == 4 || size == 8;
  if (kind == 0 && is_integer_size && is_whole) {
    const bool is_signed = (bits & 8U) != 0;
    array_.type = {is_signed ? NumberType::Kind::kSigned : NumberType::Kind::kUnsigned, size};
    return {};
  }
  const bool is_single = size == 4 && exponent == 0x17000817 && bias == 127;
  const bool is_double = size == 8 && exponent == 0x34000b34 && bias == 1023;
  if (kind == 1 && is_whole && (bits & 0x40U) == 0 && (is_single || is_double) &&
      !at.has_failed()) {
    array_.type = {NumberType::Kind::kFloating, size};
    return {};
  }
  return fail(
      "integers, or IEEE numbers of 4 or 8 bytes,",
      "numbers of class " + std::to_string(kind) + " of " + std::to_string(size) + " bytes");
}

Status DataSet::read_filters(Hdf5Cursor at) {
  const std::uint64_t version = at.number(1);
  const std::uint64_t count = at.number(1);
  at.bytes(version == 1 ? 6 : 0);
  for (std::uint64_t i = 0; i < count && !at.has_failed(); ++i) {
    const std::uint64_t filter = at.number(2);
    const bool has_name = version == 1 || filter >= 256;
    const std::uint64_t name = has_name ? at.number(2) : 0;
    at.bytes(2);
    const std::uint64_t values = at.number(2);
    at.bytes(name + 4 * values + (version == 1 && values % 2 == 1 ? 4 : 0));
    filters_.push_back(filter);
    if (filter == kDeflate || filter == kShuffle || filter == kChecksum) continue;
    return fail("no filter but deflate, shuffle and fletcher32",
                "filter " + std::to_string(filter) + " (h5repack -f GZIP=4 IN.h5 OUT.h5)");
  }
  return at.has_failed() ? Status(fail("filters", "the end of their message")) : Status();
}

Status DataSet::read_layout(Hdf5Cursor at) {
  const std::uint64_t version = at.number(1);
  const std::uint64_t kind = at.number(1);
  if (version != 3 && !(version == 4 && kind < 2)) {
    return fail("a layout of version 3",
                "version " + std::to_string(version) + " (h5repack --high=1 IN.h5 OUT.h5)");
  }
  if (kind == 0) {
    array_.bytes = at.bytes(at.number(2));
  } else if (kind == 1) {
    const std::uint64_t address = at.number(file_.offset_size());
    const std::uint64_t stored = at.number(file_.length_size());
    if (file_.is_undefined(address)) return fail("data", "none that were written");
    if (stored < size_) return fail(std::to_string(size_) + " bytes", std::to_string(stored));
    Hdf5Cursor data(file_.bytes(), address);
    array_.bytes = data.bytes(size_);
  } else if (kind == 2) {
    const std::uint64_t rank = at.number(1);
    const std::uint64_t tree = at.number(file_.offset_size());
    std::vector<std::size_t> sizes;
    for (std::uint64_t i = 0; i < rank; ++i) sizes.push_back(at.number(4));
    const bool is_sound = rank == array_.dimensions.size() + 1 && !at.has_failed() &&
                          sizes.back() == array_.type.size &&
                          std::find(sizes.begin(), sizes.end(), std::size_t{0}) == sizes.end();
    if (!is_sound) return fail("sizes of chunks", "others than the numbers have");
    return read_chunks(tree, sizes);
  }
  if (array_.bytes.size() == size_ && !at.has_failed()) return {};
  return fail(std::to_string(size_) + " bytes", "the end of the file");
}

// The tree of chunks; each of its nodes is looked at once.
Status DataSet::read_chunks(std::uint64_t tree, const std::vector<std::size_t>& sizes) {
  array_.bytes.resize(size_);
  std::vector<std::uint64_t> nodes = {tree};
  if (size_ == 0) return {};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (file_.is_undefined(nodes[i])) return fail("data", "none that were written");
    Hdf5Cursor at(file_.bytes(), nodes[i]);
    const bool is_node = at.begins_with("TREE") && at.number(1) == 1;
    const std::uint64_t level = at.number(1);
    const std::uint64_t count = at.number(2);
    at.bytes(2 * file_.offset_size());
    if (!is_node || at.has_failed() || nodes.size() > file_.bytes().size() / 8) {
      return file_.fail_at("a tree of chunks", nodes[i]);
    }
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t stored = at.number(4);
      const std::uint64_t mask = at.number(4);
      Hdf5Cursor key(at.bytes(8 * sizes.size()), 0);
      const std::uint64_t child = at.number(file_.offset_size());
      if (at.has_failed()) return file_.fail_at("a tree of chunks", nodes[i]);
      if (level > 0) {
        nodes.push_back(child);
      } else if (Status read = read_chunk(key, mask, stored, child, sizes); !read) {
        return read;
      }
    }
  }
  // What no chunk has would silently be zero.
  if (copied_ == size_) return {};
  return fail(std::to_string(size_) + " bytes in chunks", std::to_string(copied_));
}

Status DataSet::read_chunk(Hdf5Cursor& key, std::uint64_t mask, std::uint64_t stored,
                           std::uint64_t at, const std::vector<std::size_t>& sizes) {
  std::vector<std::size_t> begin;
  std::size_t bytes = array_.type.size;
  const std::size_t most = most_bytes(file_);
  for (std::size_t i = 0; i < array_.dimensions.size(); ++i) {
    begin.push_back(key.number(8));
    if (begin[i] >= array_.dimensions[i] || begin[i] % sizes[i] != 0) {
      return fail("a chunk", "one outside of it");
    }
    if (bytes > most / sizes[i]) {
      return fail("chunks of at most " + std::to_string(most) + " bytes", "more");
    }
    bytes *= sizes[i];
  }
  // Chunks may be listed again and again.
  unpacked_ += bytes;
  if (unpacked_ > 2 * most || copied_ >= size_) {
    return fail("chunks for " + std::to_string(size_) + " bytes", "more");
  }
  Hdf5Cursor data(file_.bytes(), at);
  const std::string_view packed = data.bytes(stored);
  if (data.has_failed()) {
    return file_.fail_at("a chunk of " + std::to_string(stored) + " bytes", at);
  }
  const Result<std::string> chunk = unpacked(packed, mask, bytes);
  if (!chunk) return tl::unexpected(chunk.error());
  copy_chunk(*chunk, begin, sizes);
  return {};
}

Result<std::string> DataSet::unpacked(std::string_view stored, std::uint64_t mask,
                                      std::size_t size) const {
  std::string bytes(stored);
  for (std::size_t i = filters_.size(); i > 0; --i) {
    if ((mask >> (i - 1) & 1U) != 0) continue;
    if (filters_[i - 1] == kChecksum) {
      if (!take_checksum(bytes)) return fail("chunks with their checksum", "another");
    } else if (filters_[i - 1] == kDeflate) {
      std::string made(size + 4, '\0');  // a checksum may have been packed, too
      uLongf count = made.size();
      if (::uncompress(reinterpret_cast<Bytef*>(made.data()), &count,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK) {
        return fail("chunks that deflate packed", "other data");
      }
      made.resize(count);
      bytes = std::move(made);
    } else {
      const std::size_t each = array_.type.size;
      const std::size_t numbers = bytes.size() / each;
      std::string in_order = bytes;
      for (std::size_t n = 0; n < numbers; ++n) {
        for (std::size_t b = 0; b < each; ++b) in_order[n * each + b] = bytes[b * numbers + n];
      }
      bytes = std::move(in_order);
    }
  }
  if (bytes.size() == size) return bytes;
  return fail("chunks of " + std::to_string(size) + " bytes", std::to_string(bytes.size()));
}

// Row by row of the last dimension; what reaches beyond the array is padding.
void DataSet::copy_chunk(const std::string& chunk, const std::vector<std::size_t>& begin,
                         const std::vector<std::size_t>& sizes) {
  const std::vector<std::size_t>& all = array_.dimensions;
  const std::size_t last = all.size() - 1;
  const std::size_t row = std::min(sizes[last], all[last] - begin[last]) * array_.type.size;
  std::vector<std::size_t> at(all.size(), 0);
  while (true) {
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t i = 0; i <= last; ++i) {
      from = from * sizes[i] + at[i];
      to = to * all[i] + begin[i] + at[i];
    }
    std::copy_n(chunk.data() + from * array_.type.size, row,
                array_.bytes.data() + to * array_.type.size);
    copied_ += row;
    std::size_t i = last;
    while (i > 0) {
      --i;
      if (++at[i] < std::min(sizes[i], all[i] - begin[i])) break;
      at[i] = 0;
      if (i == 0) return;
    }
    if (last == 0) return;
  }
}

Result<Hdf5Array> DataSet::read() {
  Result<std::vector<Hdf5Message>> messages = file_.object(path_);
  if (!messages) return tl::unexpected(messages.error());
  messages_ = std::move(*messages);
  const auto type = message(Hdf5Message::kDatatype, "a type");
  const auto space = message(Hdf5Message::kDataspace, "dimensions");
  const auto layout = message(Hdf5Message::kLayout, "a layout");
  for (const auto* const part : {&type, &space, &layout}) {
    if (!*part) return tl::unexpected(part->error());
  }
  Status status = read_type(Hdf5Cursor(*type, 0));
  if (status) status = read_dataspace(Hdf5Cursor(*space, 0));
  for (const Hdf5Message& other : messages_) {
    if (status && other.type == Hdf5Message::kFilters) status = read_filters({other.data, 0});
  }
  if (status) status = read_layout(Hdf5Cursor(*layout, 0));
  if (!status) return tl::unexpected(status.error());
  return std::move(array_);
}

}  // namespace

Result<Hdf5Array> read_hdf5(const Source& source, std::string_view path) {
  const Result<Hdf5File> file = Hdf5File::open(source);
  if (!file) return tl::unexpected(file.error());
  return DataSet(*file, path).read();
}

}  // namespace circumspect::formats
