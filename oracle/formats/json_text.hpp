// A text of JSON as the events of a parser (object begins, key, number …), and the line of each.
#pragma once

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

class JsonText {
 public:
  // Requires: the source outlives this object.
  explicit JsonText(const Source& source)
      : source_(source), position_(source.text.data()), counted_(source.text.data()) {}

  // Calls the handler's functions, whose names nlohmann::json::sax_parse knows, until one of them
  // returns false.
  template <class Handler>
  void parse(Handler& handler) {
    const char* const begin = source_.text.data();
    nlohmann::json::sax_parse(Iterator(begin, position_),
                              Iterator(begin + source_.text.size(), position_), &handler);
  }

  const std::string& file() const { return source_.name; }
  // Of the event whose function is being called.
  std::size_t line();
  // What the event parse_error means. `beyond` says what to write for a number beyond double.
  FormatError fault(const std::string& last_token, const nlohmann::json::exception& error,
                    std::string_view beyond = "");

 private:
  // Feeds the text to the parser and records how far it has read, which its events do not say.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    Iterator(const char* at, const char*& position) : at_(at), position_(&position) {}
    reference operator*() const { return *at_; }
    Iterator& operator++() {
      *position_ = ++at_;
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    const char* at_;
    const char** position_;
  };

  // The last characters of the line that the parser took, for messages.
  std::string_view end_of_what_was_read() const;

  const Source& source_;
  const char* position_;  // behind the last character that the parser has taken
  // Lines are counted on the way: the text before `counted_` ends on line `line_`.
  const char* counted_;
  std::size_t line_ = 1;
};

// The text of a number that the parser took for a double: it puts the locale's decimal point in
// place of the one that was written.
std::string as_written(std::string number);

}  // namespace circumspect::formats
