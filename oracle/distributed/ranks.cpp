#include "oracle/distributed/ranks.hpp"

#include <sys/resource.h>

namespace circumspect::distributed {

Ranks::Ranks(MPI_Comm communicator, std::size_t few) : communicator_(communicator), few_(few) {
  int number = 0;
  MPI_Comm_rank(communicator_, &number);
  rank_ = static_cast<std::size_t>(number);
  MPI_Comm_size(communicator_, &number);
  size_ = static_cast<std::size_t>(number);
}

std::uint64_t Ranks::reduced(std::uint64_t own, MPI_Op operation) const {
  std::uint64_t all = 0;
  MPI_Allreduce(&own, &all, 1, MPI_UINT64_T, operation, communicator_);
  return all;
}

void Ranks::end_phase(const std::string& name) {
  const auto now = std::chrono::steady_clock::now();
  now_.name = {};
  name.copy(now_.name.data(), now_.name.size() - 1);
  now_.seconds = std::chrono::duration<double>(now - begin_).count();
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  now_.memory = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  phases_.push_back(std::exchange(now_, Phase{}));
  begin_ = now;
}

}  // namespace circumspect::distributed
