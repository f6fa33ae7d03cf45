#include "oracle/distributed/shared_file.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include <sys/stat.h>

#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::distributed {
namespace {

// Which of the copies of a file a rank sees. Two ranks see one and the same if they run under one
// kernel, on one device of which the file has one number.
struct Copy {
  std::uint64_t kernel = 0;
  std::uint64_t device = 0;
  std::uint64_t inode = 0;

  bool operator==(const Copy&) const = default;
};

// Words, in their order, added to a digest. A change of one word always changes it, because each
// step is one-to-one in the word and in the digest before.
std::uint64_t digest_of(std::uint64_t digest, std::span<const char> bytes) {
  for (std::uint64_t word = 0; !bytes.empty();
       bytes = bytes.subspan(std::min(bytes.size(), sizeof word))) {
    word = 0;
    std::memcpy(&word, bytes.data(), std::min(bytes.size(), sizeof word));
    digest = fast::mixed_vertex(digest ^ word);
  }
  return digest;
}

// Linux draws a number whenever it boots. A rank that may not read it is taken to be alone.
std::uint64_t own_kernel(const Ranks& ranks) {
  const auto boot = formats::load("/proc/sys/kernel/random/boot_id");
  return boot ? digest_of(0, boot->text) : ranks.rank() + 1;
}

// A file as one rank sees it.
struct Seen {
  Counted counted;
  std::uint64_t size = 0;
  Copy copy;

  std::string to_string() const {
    return std::to_string(counted.rows) + " rows of " + std::to_string(counted.columns) + " in " +
           std::to_string(size) + " bytes";
  }
};

Seen seen_of(const Ranks& ranks, const std::string& path, const Counted& counted) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return {counted, 0, {own_kernel(ranks), 0, 0}};
  return {counted,
          static_cast<std::uint64_t>(status.st_size),
          {own_kernel(ranks), status.st_dev, status.st_ino}};
}

// A digest of a part of a file's blocks. The sum over all parts depends on the bytes alone, and not
// on the number of parts. A block that can no longer be read adds nothing.
std::uint64_t digest_of(const std::string& path, PartOf part) {
  const auto file = formats::RandomAccess::open(path);
  if (!file) return 0;
  constexpr std::size_t kBlock = 4096;
  std::vector<char> bytes(kBlock);
  const Slice blocks = part.slice((file->size() + kBlock - 1) / kBlock);
  std::uint64_t sum = 0;
  for (std::uint64_t block = blocks.begin; block < blocks.end; ++block) {
    bytes.resize(std::min<std::size_t>(kBlock, file->size() - block * kBlock));
    if (file->read(block * kBlock, bytes.size(), bytes.data())) sum += digest_of(block, bytes);
  }
  return sum;
}

// A digest of the whole copy that this rank sees. All ranks that see it read a part of it.
std::uint64_t digest_of_copy(Ranks& ranks, const std::string& path,
                             const std::vector<Copy>& copies) {
  const Copy& own = copies[ranks.rank()];
  const auto here = copies.begin() + static_cast<std::ptrdiff_t>(ranks.rank());
  const PartOf part{static_cast<std::size_t>(std::count(copies.begin(), here, own)),
                    static_cast<std::size_t>(std::count(copies.begin(), copies.end(), own))};
  const std::vector<std::uint64_t> digests = ranks.of_each(digest_of(path, part));
  std::uint64_t sum = 0;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
    if (copies[rank] == own) sum += digests[rank];
  }
  return sum;
}

}  // namespace

formats::Status check_shared(Ranks& ranks, const std::string& path, const Counted& counted) {
  const Seen own = seen_of(ranks, path, counted);
  const Seen expected = ranks.of_rank(0, own);
  const auto fault = [&](std::size_t other, const std::string& found) {
    return tl::unexpected(formats::FormatError{
        path, 0, "the same file at all ranks, as rank 0 has it (" + expected.to_string() + ")",
        "another one at rank " + std::to_string(other) + " (" + found + ")"});
  };
  const bool as_large = own.counted == expected.counted && own.size == expected.size;
  if (const std::size_t other = ranks.first_with(!as_large); other != ranks.size()) {
    return fault(other, ranks.of_rank(other, own).to_string());
  }
  if (!ranks.any(own.copy != expected.copy)) return {};
  const std::uint64_t digest = digest_of_copy(ranks, path, ranks.of_each(own.copy));
  const std::size_t other = ranks.first_with(digest != ranks.of_rank(0, digest));
  if (other == ranks.size()) return {};
  return fault(other, "as large, with other bytes");
}

}  // namespace circumspect::distributed
