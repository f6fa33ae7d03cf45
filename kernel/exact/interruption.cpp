#include "kernel/exact/interruption.hpp"

namespace circumspect {

const char* Interrupted::what() const noexcept {
  return is_late ? "the time limit is over" : "somebody asked for the end";
}

void Interruption::end_if_asked() const {
  if (stop != nullptr && __atomic_load_n(stop, __ATOMIC_RELAXED) != 0) throw Interrupted(false);
  // The clock takes as long as a small determinant.
  constexpr unsigned kSeldom = 32;
  thread_local unsigned asked = 0;
  if (deadline && ++asked % kSeldom == 0 && std::chrono::steady_clock::now() > *deadline) {
    throw Interrupted(true);
  }
}

}  // namespace circumspect
