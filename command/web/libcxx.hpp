// The parts of C++20 that the sources use and that libc++ 14 of Debian's Emscripten (without
// threads) lacks. The build for the browser includes it before every file; no other build sees it.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <compare>
#include <cstddef>
#include <memory>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace std {

// Defined in libcxx.cpp.
to_chars_result to_chars(char* first, char* last, double value);
from_chars_result from_chars(const char* first, const char* last, double& value);

// Here no thread can be started: who tries hears of it as on a system that gives no more.
class jthread {
 public:
  jthread() = default;
  template <typename Work, typename... Arguments>
  explicit jthread(Work&& work, Arguments&&... arguments)
      : thread_(std::forward<Work>(work), std::forward<Arguments>(arguments)...) {}
  jthread(jthread&&) = default;
  jthread& operator=(jthread&&) = default;
  ~jthread() {
    if (thread_.joinable()) thread_.join();
  }

 private:
  thread thread_;
};

template <typename A, typename B>
constexpr strong_ordering lexicographical_compare_three_way(A a, A a_end, B b, B b_end) {
  for (; a != a_end && b != b_end; ++a, ++b) {
    if (*a < *b) return strong_ordering::less;
    if (*b < *a) return strong_ordering::greater;
  }
  return (a != a_end) <=> (b != b_end);
}

template <typename T, typename A>
constexpr strong_ordering operator<=>(const vector<T, A>& a, const vector<T, A>& b) {
  return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
}

template <typename T, size_t kSize>
constexpr strong_ordering operator<=>(const array<T, kSize>& a, const array<T, kSize>& b) {
  return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
}

template <typename To, typename From>
constexpr To bit_cast(const From& value) {
  return __builtin_bit_cast(To, value);
}

template <typename T>
unique_ptr<T> make_unique_for_overwrite(size_t count) {
  return unique_ptr<T>(new remove_extent_t<T>[count]);
}

}  // namespace std
