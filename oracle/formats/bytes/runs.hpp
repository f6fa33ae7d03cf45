// A list of integers that mostly go up by one or stay the same, such as the lines of a file's
// elements or their labels, in memory for each change alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <vector>

#include "kernel/predicates/configuration.hpp"

namespace circumspect::formats {

template <class Value>
class Runs {
 public:
  Runs() = default;
  Runs(std::initializer_list<Value> values) {
    for (const Value value : values) push_back(value);
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  void push_back(Value value) {
    if (runs_.empty() || (size_ - runs_.back().begin > 1 && value != due(runs_.back(), size_))) {
      runs_.push_back({size_, value, 0});
    } else if (size_ - runs_.back().begin == 1) {
      // The second of a run says how it goes on.
      const auto step = static_cast<Bits>(value) - static_cast<Bits>(runs_.back().first);
      if (step > 1) {
        runs_.push_back({size_, value, 0});
      } else {
        runs_.back().step = step;
      }
    }
    ++size_;
  }

  // Requires: i < size().
  Value operator[](std::size_t i) const {
    const auto after =
        std::upper_bound(runs_.begin(), runs_.end(), i,
                         [](std::size_t at, const Run& run) { return at < run.begin; });
    return due(*(after - 1), i);
  }
  Value front() const { return runs_.front().first; }
  Value back() const { return due(runs_.back(), size_ - 1); }

  void clear() {
    runs_.clear();
    size_ = 0;
  }

  std::vector<Value> values() const {
    std::vector<Value> all;
    all.reserve(size_);
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      const std::size_t end = r + 1 < runs_.size() ? runs_[r + 1].begin : size_;
      for (std::size_t i = runs_[r].begin; i < end; ++i) all.push_back(due(runs_[r], i));
    }
    return all;
  }

  friend bool operator==(const Runs& a, const Runs& b) { return a.values() == b.values(); }
  friend bool operator==(const Runs& a, const std::vector<Value>& b) { return a.values() == b; }

 private:
  using Bits = std::make_unsigned_t<Value>;  // sums of these wrap around, which is defined
  struct Run {
    std::size_t begin;
    Value first;
    Bits step;
  };
  static Value due(const Run& run, std::size_t i) {
    return static_cast<Value>(static_cast<Bits>(run.first) +
                              run.step * static_cast<Bits>(i - run.begin));
  }

  std::vector<Run> runs_;
  std::size_t size_ = 0;
};

}  // namespace circumspect::formats
