// Finds the word that a user who mistyped one probably meant.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace circumspect::cli {

// How many letters have to be put in, left out or replaced, or neighbours exchanged, to make one
// word of the other (the distance of Damerau and Levenshtein in which no part is edited twice).
// Case counts.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Rows of the table of distances between the beginnings: the one before the last, the last, and
  // this.
  std::vector<std::size_t> before;
  std::vector<std::size_t> last(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = std::move(last);
    last = std::move(row);
  }
  return last[b.size()];
}

// The word of a list that is nearest to this one, whatever the case of its letters, the first of
// several; "" if none is near: at most a third of its letters may be wrong, or it begins the word.
inline std::string nearest_word(std::string_view found, const std::vector<std::string>& words) {
  const auto bare = [](std::string_view word) {
    std::string letters;
    for (const char c : word.substr(std::min(word.find_first_not_of('-'), word.size()))) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return letters;
  };
  const std::string mistyped = bare(found);
  if (mistyped.size() < 3) return "";
  std::string nearest;
  std::size_t least = mistyped.size() / 3 + 1;
  for (const std::string& word : words) {
    const std::size_t distance = edit_distance(mistyped, bare(word));
    if (distance >= least) continue;
    nearest = word;
    least = distance;
  }
  if (!nearest.empty()) return nearest;
  const auto begun = std::find_if(words.begin(), words.end(), [&](const std::string& word) {
    return bare(word).compare(0, mistyped.size(), mistyped) == 0;
  });
  return begun == words.end() ? "" : *begun;
}

// "; the nearest is WORD", or "" if none is near: the end of a sentence about a word that is none.
inline std::string nearest_text(std::string_view found, const std::vector<std::string>& words) {
  const std::string nearest = nearest_word(found, words);
  return nearest.empty() ? "" : "; the nearest is " + nearest;
}

}  // namespace circumspect::cli
