// Makes a libFuzzer target of a program that makes Delaunay triangulations: one that finds wrong
// answers, not only crashes. In a file of its own, compiled with -fsanitize=fuzzer:
//
//   #include <circumspect/fuzz.hpp>
//   CIRCUMSPECT_FUZZ_DELAUNAY(3, my_triangulate)
//
// The bytes are not coordinates but a way to make points (fuzz/harness/fuzz_input.cpp has the
// grammar): small integers, exactly cospherical points, copies moved by one unit in the last place;
// and the mutator changes these steps, so that degeneracies turn up within seconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <circumspect/judgement.hpp>
#include <circumspect/subject.hpp>

namespace circumspect {

// The points that some bytes stand for: distinct, finite, at most 64, of the dimension; with a
// weight each if asked for. Any bytes are valid. Requires: dimension is 2 or 3.
PointArray points_from_bytes(const std::uint8_t* data, std::size_t size, std::size_t dimension,
                             bool weighted = false);

// Changes one or two steps in place; returns the new size, at most `max_size`. For
// LLVMFuzzerCustomMutator.
std::size_t mutate_bytes(std::uint8_t* data, std::size_t size, std::size_t max_size,
                         unsigned int seed);

struct FuzzOptions {
  std::string claim = "delaunay";  // or "triangulation", "weighted-delaunay"
  std::size_t dimension = 3;       // 2 or 3
  std::size_t min_points = 1;
  bool flat_sets = true;  // also points that span only a flat, as in PropertyOptions
};

// Runs the program on the points that the bytes stand for and judges what it returns. If it is
// wrong, prints the rule, the points as a .node file and the witness, and aborts. Returns 0.
int fuzz_once(const Triangulator& subject, const FuzzOptions& options, const std::uint8_t* data,
              std::size_t size);

}  // namespace circumspect

// CIRCUMSPECT_FUZZ(my_triangulate, {.dimension = 2, .flat_sets = false})
#define CIRCUMSPECT_FUZZ(subject, ...)                                                            \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {             \
    return ::circumspect::fuzz_once(subject, ::circumspect::FuzzOptions __VA_ARGS__, data, size); \
  }                                                                                               \
  extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,            \
                                                 std::size_t max_size, unsigned int seed) {       \
    return ::circumspect::mutate_bytes(data, size, max_size, seed);                               \
  }
#define CIRCUMSPECT_FUZZ_DELAUNAY(its_dimension, subject) \
  CIRCUMSPECT_FUZZ(subject, {.dimension = its_dimension})
