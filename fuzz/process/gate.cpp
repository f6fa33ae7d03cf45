#include "fuzz/process/gate.hpp"

#include <cerrno>
#include <climits>
#include <memory>
#include <system_error>

#include <linux/futex.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

namespace circumspect::campaign {
namespace {

bool is_cut(int lifeline) {
  pollfd file = {lifeline, POLLRDHUP, 0};
  return poll(&file, 1, 0) > 0 && (file.revents & (POLLRDHUP | POLLHUP)) != 0;
}

}  // namespace

Gate::Gate(std::size_t places) : count_(places + 1) {
  void* const memory = mmap(nullptr, count_ * sizeof(Cell), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  cells_ = static_cast<Cell*>(memory);
  std::uninitialized_value_construct_n(cells_, count_);
}

Gate::~Gate() { munmap(cells_, count_ * sizeof(Cell)); }

bool Turn::take(int lifeline) const {
  if (gate_ == nullptr) return true;
  Gate::Cell* const cells = gate_->cells_;
  while (true) {
    const int given_back = cells[0];
    for (std::size_t i = 1; i < gate_->count_; ++i) {
      int nobody = 0;
      if (cells[i].compare_exchange_strong(nobody, holder_)) return true;
    }
    if (is_cut(lifeline)) return false;
    // Nobody says that the lifeline is cut: it is looked at again. In between only what is given back
    // wakes it, if that has not happened since the places were looked at.
    const timespec tick = {0, 20'000'000};
    syscall(SYS_futex, cells, FUTEX_WAIT, given_back, &tick, nullptr, 0);
  }
}

void Turn::give_back() const {
  if (gate_ == nullptr) return;
  Gate::Cell* const cells = gate_->cells_;
  for (std::size_t i = 1; i < gate_->count_; ++i) {
    int holder = holder_;
    cells[i].compare_exchange_strong(holder, 0);
  }
  // All, for of those that wait one may have been killed.
  ++cells[0];
  syscall(SYS_futex, cells, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

}  // namespace circumspect::campaign
