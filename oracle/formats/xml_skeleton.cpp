#include "oracle/formats/xml_skeleton.hpp"

#include <algorithm>

namespace circumspect::formats {
namespace {

constexpr std::string_view kAppended = "<AppendedData";
constexpr std::string_view kArray = "<DataArray";

// What means something in XML, besides '<'.
constexpr std::string_view kMarkup = "&>\"'";

// Smaller contents stay where they are.
constexpr std::size_t kLarge = 1024;

struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// The bytes that are appended; if there are none, both are the end of the file.
Span find_appended(std::string_view file) {
  const std::size_t element = file.find(kAppended);
  const Span none{file.size(), file.size()};
  if (element == std::string_view::npos) return none;
  const std::size_t tag_end = file.find('>', element);
  const std::size_t begin = file.find('_', tag_end);
  if (tag_end == std::string_view::npos || begin == std::string_view::npos) return none;
  const std::size_t end = file.rfind("</AppendedData");
  if (end == std::string_view::npos || end < begin) return {begin + 1, file.size()};  // cut off
  return {begin + 1, end};
}

// Where a tag ends, behind its '>'; an attribute may have one between its quotes.
std::size_t end_of_tag(std::string_view xml, std::size_t at) {
  char quote = 0;
  for (; at < xml.size(); ++at) {
    const char c = xml[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at + 1;
    }
  }
  return xml.size();
}

// Each part is searched for all of them while it is in the cache.
bool has_markup(std::string_view content) {
  constexpr std::size_t kPart = 1 << 15;
  for (std::size_t at = 0; at < content.size(); at += kPart) {
    const std::string_view part = content.substr(at, kPart);
    const bool has_one = std::any_of(kMarkup.begin(), kMarkup.end(), [part](char c) {
      return part.find(c) != std::string_view::npos;
    });
    if (has_one) return true;
  }
  return false;
}

// May this content be left out? It is large, and whatever is around it, nothing in it has a meaning
// in XML.
bool is_plain_and_large(std::string_view content) {
  return content.size() >= kLarge && content.find_first_not_of(" \t\r\n") < kLarge &&
         !has_markup(content);
}

}  // namespace

XmlSkeleton::XmlSkeleton(std::string_view file) {
  const Span appended = find_appended(file);
  appended_ = file.substr(appended.begin, appended.end - appended.begin);
  const std::string_view xml = file.substr(0, appended.begin);
  std::size_t done = 0;  // so much of the file is in the text, or left out
  std::size_t at = xml.find(kArray);
  while (at != std::string_view::npos) {
    const std::size_t begin = end_of_tag(xml, at);
    const std::size_t end = std::min(xml.find('<', begin), xml.size());
    if (is_plain_and_large(xml.substr(begin, end - begin))) {
      const std::size_t element = text_.size() + (at + 1 - done);
      text_.append(xml, done, begin - done);
      cuts_.push_back({element, text_.size(), end, xml.substr(begin, end - begin)});
      done = end;
    }
    at = xml.find(kArray, end);
  }
  text_.append(xml, done, xml.size() - done);
  if (appended.begin < appended.end) {
    cuts_.push_back({std::string::npos, text_.size(), appended.end, appended_});
  }
  text_.append(file, appended.end, file.size() - appended.end);
}

std::size_t XmlSkeleton::in_file(std::size_t place) const {
  const auto after = std::upper_bound(cuts_.begin(), cuts_.end(), place,
                                      [](std::size_t p, const Cut& cut) { return p < cut.at; });
  if (after == cuts_.begin()) return place;
  const Cut& last = *(after - 1);
  return last.end + (place - last.at);
}

std::optional<std::string_view> XmlSkeleton::content_of(std::size_t place) const {
  const auto found =
      std::lower_bound(cuts_.begin(), cuts_.end(), place,
                       [](const Cut& cut, std::size_t p) { return cut.element < p; });
  if (found == cuts_.end() || found->element != place) return std::nullopt;
  return found->content;
}

}  // namespace circumspect::formats
