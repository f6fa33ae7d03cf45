#include "c/guard.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "oracle/model/printable.hpp"

namespace circumspect::c {
namespace {

// The arguments of circumspect_end_calls_after().
thread_local std::chrono::duration<double> most_seconds{0};
thread_local const std::int32_t* stop_of_calls = nullptr;

// Its size is fixed, so that it exists even when no memory is left.
constexpr std::size_t kLongestMessage = 2000;
thread_local char last_error[kLongestMessage + 1] = "";
thread_local char last_fault[kLongestMessage + 1] = "";
thread_local const char* last_option = "";

void keep(std::string_view message, char* kept) noexcept {
  std::size_t length = std::min(message.size(), kLongestMessage);
  if (length < message.size()) {  // never cuts a multibyte character in two
    while (length > 0 && (static_cast<unsigned char>(message[length]) & 0xC0U) == 0x80U) --length;
  }
  std::memcpy(kept, message.data(), length);
  kept[length] = '\0';
}

void keep(std::string_view fault) noexcept {
  keep(fault, last_fault);
  keep(fault, last_error);
  last_option = "";
}

constexpr std::string_view kNoMemory = "expected more memory than there is";

// The message may quote text of the caller, which may hold any bytes.
circumspect_status failed(circumspect_status status, std::string_view message,
                          const Option& option = {}) noexcept {
  try {
    const std::string fault = on_one_line(message);
    keep(fault);
    if (*option.name != '\0') {
      keep(fmt::format("{}; to {}, set {}", fault, option.purpose, option.name), last_error);
      last_option = option.name;
    }
    return status;
  } catch (const std::bad_alloc&) {
    keep(kNoMemory);
    return CIRCUMSPECT_OUT_OF_MEMORY;
  }
}

}  // namespace

void refuse_call(const std::string& message) {
  throw Refusal{CIRCUMSPECT_INVALID_ARGUMENT, message};
}

void refuse_input(const std::string& message, const Option& option) {
  throw Refusal{CIRCUMSPECT_INPUT_FAULT, message, option};
}

void require_memory_for_json() {
  constexpr std::size_t kEnough = std::size_t{1} << 20;
  ::operator delete(::operator new(kEnough));
}

void forget_last_error() noexcept { keep(""); }

Interruption interruption_of_call() noexcept {
  using Clock = std::chrono::steady_clock;
  Interruption interruption{stop_of_calls};
  // Beyond a year, the sum with the clock's time may overflow.
  constexpr std::chrono::duration<double> kYear = std::chrono::hours(24 * 365);
  if (most_seconds.count() > 0) {
    interruption.deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::min(most_seconds, kYear));
  }
  return interruption;
}

circumspect_status status_of_exception() noexcept {
  try {
    throw;
  } catch (const Refusal& refusal) {
    return failed(refusal.status, refusal.message, refusal.option);
  } catch (const Interrupted& interrupted) {
    return failed(CIRCUMSPECT_UNDECIDED,
                  interrupted.is_late ? "expected an answer within the time limit, found none"
                                      : "expected an answer, found that the call was stopped");
  } catch (const std::bad_alloc&) {
    keep(kNoMemory);
    return CIRCUMSPECT_OUT_OF_MEMORY;
  } catch (const std::length_error&) {  // of a container that is to hold more than can be
    keep("expected more memory than can be");
    return CIRCUMSPECT_OUT_OF_MEMORY;
  } catch (const std::invalid_argument& error) {
    return failed(CIRCUMSPECT_INVALID_ARGUMENT, error.what());
  } catch (const std::exception& error) {
    return failed(CIRCUMSPECT_INTERNAL_ERROR, error.what());
  } catch (...) {
    return failed(CIRCUMSPECT_INTERNAL_ERROR, "something was thrown that is not a std::exception");
  }
}

}  // namespace circumspect::c

const char* circumspect_version(void) { return CIRCUMSPECT_VERSION; }

const char* circumspect_last_error(void) { return circumspect::c::last_error; }
const char* circumspect_last_fault(void) { return circumspect::c::last_fault; }
const char* circumspect_last_option(void) { return circumspect::c::last_option; }

void circumspect_end_calls_after(double seconds, const int32_t* stop) {
  // NaN sets no limit either.
  circumspect::c::most_seconds = std::chrono::duration<double>(seconds > 0 ? seconds : 0);
  circumspect::c::stop_of_calls = stop;
}
