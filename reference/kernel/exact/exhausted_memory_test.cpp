#include "reference/kernel/exact/exhausted_memory.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "reference/kernel/exact/number.hpp"

namespace circumspect {

// AddressSanitizer takes more address space than any limit.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
#define HAS_LIMITS true
#else
#define HAS_LIMITS false
#endif

TEST_CASE("a number that exhausts the memory ends the process as it was told" *
          doctest::skip(!HAS_LIMITS)) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit = {rlim_t{1} << 30, rlim_t{1} << 30};
    setrlimit(RLIMIT_AS, &limit);
    end_where_numbers_exhaust_memory([] { _exit(5); });
    Integer large = 1;
    large <<= std::size_t{1} << 35;  // bits
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 5);
}

}  // namespace circumspect
