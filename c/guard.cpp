#include "c/guard.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

namespace circumspect::c {
namespace {

// Of a fixed size, so that there is one where no memory is left.
constexpr std::size_t kLongestMessage = 2000;
thread_local char last_error[kLongestMessage + 1] = "";

circumspect_status failed(circumspect_status status, std::string_view message) noexcept {
  const std::size_t length = std::min(message.size(), kLongestMessage);
  std::memcpy(last_error, message.data(), length);
  last_error[length] = '\0';
  return status;
}

}  // namespace

void refuse_call(const std::string& message) {
  throw Refusal{CIRCUMSPECT_INVALID_ARGUMENT, message};
}

void refuse_input(const std::string& message) { throw Refusal{CIRCUMSPECT_INPUT_FAULT, message}; }

void require_memory_for_json() {
  constexpr std::size_t kEnough = std::size_t{1} << 20;
  ::operator delete(::operator new(kEnough));
}

void forget_last_error() noexcept { last_error[0] = '\0'; }

circumspect_status status_of_exception() noexcept {
  try {
    throw;
  } catch (const Refusal& refusal) {
    return failed(refusal.status, refusal.message);
  } catch (const std::bad_alloc&) {
    return failed(CIRCUMSPECT_OUT_OF_MEMORY, "expected more memory than there is");
  } catch (const std::length_error&) {  // of a container that is to hold more than can be
    return failed(CIRCUMSPECT_OUT_OF_MEMORY, "expected more memory than can be");
  } catch (const std::invalid_argument& error) {
    return failed(CIRCUMSPECT_INVALID_ARGUMENT, error.what());
  } catch (const std::exception& error) {
    return failed(CIRCUMSPECT_INTERNAL_ERROR, error.what());
  } catch (...) {
    return failed(CIRCUMSPECT_INTERNAL_ERROR, "something was thrown that is no std::exception");
  }
}

}  // namespace circumspect::c

const char* circumspect_last_error(void) { return circumspect::c::last_error; }
