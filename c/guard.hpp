// What keeps exceptions and C++ types on this side of <circumspect/circumspect.h>.
#pragma once

#include <string>

#include <circumspect/circumspect.h>

namespace circumspect::c {

// Why a call is refused, with the status that comes back.
struct Refusal {
  circumspect_status status;
  std::string message;
};

[[noreturn]] void refuse_call(const std::string& message);   // CIRCUMSPECT_INVALID_ARGUMENT
[[noreturn]] void refuse_input(const std::string& message);  // CIRCUMSPECT_INPUT_FAULT

// Throws std::bad_alloc unless there is memory left for a document: nlohmann's destructors allocate, and so
// end the process if there is none.
void require_memory_for_json();

// After a catch: the status of what was thrown, its text kept for circumspect_last_error().
circumspect_status status_of_exception() noexcept;
// Nothing has failed yet.
void forget_last_error() noexcept;

template <class Action>
circumspect_status guarded(const Action& action) noexcept {
  forget_last_error();
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

}  // namespace circumspect::c
