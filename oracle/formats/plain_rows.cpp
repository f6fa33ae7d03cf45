#include "oracle/formats/plain_rows.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <new>
#include <span>
#include <string_view>
#include <system_error>
#include <thread>

#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {

namespace {

// How far to search for the first line and the first row, and for the first row of a further block.
constexpr std::size_t kBeginning = std::size_t{1} << 16U;
constexpr std::size_t kBlockBeginning = std::size_t{1} << 12U;

// Lines copied out of a file, as PlainTokens requires them.
class LinesOfFile {
 public:
  // Makes room for so many bytes.
  explicit LinesOfFile(std::size_t most) : bytes_(most + 1) {}

  // Copies the bytes from `begin` up to `end`; the last line gets an end if it has none. False if
  // the file no longer has them. Requires: there is room.
  bool copy(const RandomAccess& file, std::size_t begin, std::size_t end) {
    size_ = end - begin;
    if (!file.read(begin, size_, bytes_.data())) return false;
    if (size_ > 0 && bytes_[size_ - 1] != '\n') bytes_[size_++] = '\n';
    return true;
  }

  // The same with up to `most` bytes, without the incomplete line at their end.
  bool copy_some(const RandomAccess& file, std::size_t begin, std::size_t most) {
    const std::size_t end = begin + std::min(most, file.size() - begin);
    if (!file.read(begin, end - begin, bytes_.data())) return false;
    if (end == file.size()) return copy(file, begin, end);
    const std::size_t last = std::string_view(bytes_.data(), end - begin).rfind('\n');
    size_ = last == std::string_view::npos ? 0 : last + 1;
    return true;
  }

  std::string_view text() const { return {bytes_.data(), size_}; }
  PlainTokens tokens(std::size_t from = 0) const {
    return {bytes_.data() + from, bytes_.data() + size_};
  }
  // Where the line after the first one begins; size() if there is none.
  std::size_t second_line() const {
    const std::size_t end = text().find('\n');
    return end == std::string_view::npos ? size_ : end + 1;
  }

 private:
  std::vector<char> bytes_;
  std::size_t size_ = 0;
};

bool skip_empty_lines(PlainTokens& tokens) {
  while (!tokens.at_end()) {
    if (!tokens.skip_line_end()) return true;
  }
  return false;
}

// The first index of these lines; nothing if no line has a token, or if the token is not an
// integer.
std::optional<std::int64_t> first_index(PlainTokens tokens) {
  std::int64_t index = 0;
  if (!skip_empty_lines(tokens) || !tokens.integer(index)) return std::nullopt;
  return index;
}

// Where a block near `target` may begin, and its first row; nothing if the lines there do not tell.
std::optional<PlainBlock> cut_near(const RandomAccess& file, std::size_t target, Vertex first,
                                   LinesOfFile& lines) {
  if (!lines.copy_some(file, target, kBlockBeginning)) return std::nullopt;
  const std::size_t line = lines.second_line();
  const std::optional<std::int64_t> index = first_index(lines.tokens(line));
  if (!index || *index <= first) return std::nullopt;
  return PlainBlock{target + line, 0, count_of(*index - first), 0};
}

// The blocks are consecutive, and all hold some rows.
bool is_in_order(const PlainRows& rows) {
  return std::all_of(rows.blocks.begin(), rows.blocks.end(), [&rows](const PlainBlock& block) {
    return block.first < block.last || rows.blocks.size() == 1;
  });
}

}  // namespace

std::optional<Source> beginning_of(const RandomAccess& file) {
  LinesOfFile lines(std::min(kBeginning, file.size()));
  if (!lines.copy_some(file, 0, kBeginning)) return std::nullopt;
  return Source{"", std::string(lines.text().substr(0, file.size()))};
}

std::optional<PlainRows> plan_rows(const RandomAccess& file, std::size_t begin, std::size_t rows,
                                   std::size_t columns, std::size_t block_size) {
  const std::size_t bytes = file.size() - begin;
  // A column takes at least one character and a separator.
  if (columns > kMostPlainColumns || rows > bytes / (2 * columns) + 1) return std::nullopt;
  LinesOfFile lines(std::min(kBeginning, bytes));
  if (!lines.copy_some(file, begin, kBeginning)) return std::nullopt;
  PlainRows plan;
  if (rows > 0) {
    const std::optional<std::int64_t> first = first_index(lines.tokens());
    if (!first) return std::nullopt;
    plan.first_index = *first;
  }
  plan.blocks.push_back({begin, file.size(), 0, rows});
  if (rows == 0) return plan;
  for (std::size_t target = begin; file.size() - target > block_size;) {
    target += block_size;
    const auto cut = cut_near(file, target, plan.first_index, lines);
    if (!cut || cut->begin <= plan.blocks.back().begin) continue;
    plan.blocks.back().end = cut->begin;
    plan.blocks.back().last = cut->first;
    plan.blocks.push_back({cut->begin, file.size(), cut->first, rows});
  }
  return is_in_order(plan) ? std::optional(std::move(plan)) : std::nullopt;
}

bool for_each_block(const RandomAccess& file, const PlainRows& rows, unsigned threads,
                    const std::function<bool(PlainTokens&, const PlainBlock&)>& read_block) {
  if (rows.blocks.empty()) return true;  // a part without rows
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t workers = std::min<std::size_t>(threads, rows.blocks.size());
  std::size_t largest = 0;
  for (const PlainBlock& block : rows.blocks) largest = std::max(largest, block.end - block.begin);
  std::vector<LinesOfFile> lines(workers, LinesOfFile(largest));
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> plain = true;
  const auto work = [&](LinesOfFile& own) {
    while (plain) {
      const std::size_t i = next++;
      if (i >= rows.blocks.size()) return;
      const PlainBlock& block = rows.blocks[i];
      if (!own.copy(file, block.begin, block.end)) plain = false;
      PlainTokens tokens = own.tokens();
      if (plain && !read_block(tokens, block)) plain = false;
    }
  };
  std::vector<std::jthread> others;
  try {
    for (std::size_t i = 1; i < workers; ++i) others.emplace_back(work, std::ref(lines[i]));
  } catch (const std::system_error&) {
    // The system allows no more threads, so the existing ones do the work.
  }
  work(lines[0]);
  others.clear();
  return plain;
}

}  // namespace circumspect::formats
