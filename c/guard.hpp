// Keeps exceptions and C++ types on this side of <circumspect/circumspect.h>.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <string>

#include <circumspect/circumspect.h>

#include "kernel/exact/interruption.hpp"

// Behind the handle.
struct circumspect_document {
  std::string text;
};

namespace circumspect::c {

// The member of the options with which a call would not be refused, and what it is set for. The
// texts are literals.
struct Option {
  const char* name = "";
  const char* purpose = "";
};
inline constexpr Option kMergeEqualPoints{"merge_equal_points", "take equal points for one"};
inline constexpr Option kAllowEmpty{"allow_empty", "judge an empty mesh"};

// Why a call is refused, with the status that it returns.
struct Refusal {
  circumspect_status status;
  std::string message;
  Option option = {};
};

[[noreturn]] void refuse_call(const std::string& message);  // CIRCUMSPECT_INVALID_ARGUMENT
// CIRCUMSPECT_INPUT_FAULT
[[noreturn]] void refuse_input(const std::string& message, const Option& option = {});

// Throws std::bad_alloc unless there is memory left for a document: nlohmann's destructors
// allocate, and so end the process if there is none.
void require_memory_for_json();

// After a catch: the status of what was thrown, its text kept for circumspect_last_error().
circumspect_status status_of_exception() noexcept;
// Nothing has failed yet.
void forget_last_error() noexcept;
// The limit for a call that this thread begins now.
Interruption interruption_of_call() noexcept;

template <class Action>
circumspect_status guarded(const Action& action) noexcept {
  forget_last_error();
  const Interruption interruption = interruption_of_call();
  const Interruptible interruptible(&interruption);
  try {
    action();
    return CIRCUMSPECT_OK;
  } catch (...) {
    return status_of_exception();
  }
}

template <class Pointer>
Pointer* required(Pointer* pointer, const char* what) {
  if (pointer == nullptr) refuse_call(std::string("expected ") + what + ", found NULL");
  return pointer;
}

// A copy of a struct of the header; `begun` is what its macro makes. Programs that were compiled
// when the struct had fewer members pass fewer bytes; `earlier` lists the sizes that it has had.
template <class Struct>
Struct of_any_version(const Struct& given, Struct begun, std::initializer_list<std::size_t> earlier,
                      const char* macro) {
  const std::size_t size = given.struct_size;
  if (size != sizeof(Struct) && std::find(earlier.begin(), earlier.end(), size) == earlier.end()) {
    refuse_call(std::string("expected a struct that began as ") + macro +
                ", found another struct_size");
  }
  std::memcpy(&begun, &given, size);
  return begun;
}

}  // namespace circumspect::c
