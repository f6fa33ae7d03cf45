#include "oracle/distributed/shared_file.hpp"

#include <algorithm>
#include <array>

namespace circumspect::distributed {
namespace {

// A file as one rank sees it. The digest is 0 if the file can no longer be read.
struct Seen {
  Counted counted;
  std::uint64_t size = 0;
  std::uint64_t digest = 0;

  bool operator==(const Seen&) const = default;
  std::string to_string() const {
    return std::to_string(counted.rows) + " rows of " + std::to_string(counted.columns) + " in " +
           std::to_string(size) + " bytes";
  }
};

// FNV-1a of a kilobyte at each end.
std::uint64_t digest_of_ends(const formats::RandomAccess& file) {
  constexpr std::size_t kEnd = 1024;
  std::array<char, kEnd> bytes = {};
  const std::size_t count = std::min(kEnd, file.size());
  std::uint64_t digest = 0xcbf29ce484222325;
  for (const std::size_t offset : {std::size_t{0}, file.size() - count}) {
    if (!file.read(offset, count, bytes.data())) return 0;
    for (std::size_t i = 0; i < count; ++i) {
      digest = (digest ^ static_cast<unsigned char>(bytes[i])) * 0x100000001b3;
    }
  }
  return digest;
}

Seen seen_of(const std::string& path, const Counted& counted) {
  const auto file = formats::RandomAccess::open(path);
  return file ? Seen{counted, file->size(), digest_of_ends(*file)} : Seen{counted};
}

}  // namespace

formats::Status check_shared(Ranks& ranks, const std::string& path, const Counted& counted) {
  const Seen own = seen_of(path, counted);
  const Seen expected = ranks.of_rank(0, own);
  const std::size_t other = ranks.first_with(own != expected);
  if (other == ranks.size()) return {};
  const Seen found = ranks.of_rank(other, own);
  return tl::unexpected(formats::FormatError{
      path, 0, "the same file at all ranks, as rank 0 has it (" + expected.to_string() + ")",
      "another one at rank " + std::to_string(other) + " (" + found.to_string() + ")"});
}

}  // namespace circumspect::distributed
