// Parts of texts.
#pragma once

#include <string>

namespace circumspect::campaign {

// Puts `by` in place of every `part` of the text, from left to right; what was put there is not looked at again.
// Requires: `part` is not empty.
inline void replace_all(std::string& text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + by.size())) {
    text.replace(at, part.size(), by);
  }
}

}  // namespace circumspect::campaign
