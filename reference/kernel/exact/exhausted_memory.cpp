#include "reference/kernel/exact/exhausted_memory.hpp"

#include <cstddef>
#include <cstdlib>

#include <gmp.h>

namespace circumspect {
namespace {

void (*end_without_memory)() = std::abort;

void* or_end(void* block) {
  if (block == nullptr) end_without_memory();
  return block;
}

void* allocated(std::size_t size) { return or_end(std::malloc(size)); }
void* reallocated(void* block, std::size_t, std::size_t size) {
  return or_end(std::realloc(block, size));
}

}  // namespace

void end_where_numbers_exhaust_memory(void (*end)()) {
  end_without_memory = end;
  mp_set_memory_functions(allocated, reallocated, nullptr);
}

}  // namespace circumspect
