// The ranks of an MPI program, one for each process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <mpi.h>

#include "oracle/distributed/ranks.hpp"

namespace circumspect::distributed {

class MpiCommunicator : public Communicator {
 public:
  // Requires: MPI is initialized, and `communicator` outlives this object.
  explicit MpiCommunicator(MPI_Comm communicator) : communicator_(communicator) {
    MPI_Comm_rank(communicator_, &rank_);
    MPI_Comm_size(communicator_, &size_);
  }

  std::size_t rank() const override { return static_cast<std::size_t>(rank_); }
  std::size_t size() const override { return static_cast<std::size_t>(size_); }

  std::uint64_t reduced(std::uint64_t own, Reduction how) override {
    const MPI_Op operation = how == Reduction::kSum    ? MPI_SUM
                             : how == Reduction::kMost ? MPI_MAX
                                                       : MPI_MIN;
    std::uint64_t all = 0;
    MPI_Allreduce(&own, &all, 1, MPI_UINT64_T, operation, communicator_);
    return all;
  }
  void broadcast(std::byte* bytes, std::size_t count, std::size_t root) override {
    MPI_Bcast(bytes, static_cast<int>(count), MPI_BYTE, static_cast<int>(root), communicator_);
  }
  void gather(const std::byte* own, std::size_t count, std::byte* all) override {
    const int bytes = static_cast<int>(count);
    MPI_Allgather(own, bytes, MPI_BYTE, all, bytes, MPI_BYTE, communicator_);
  }
  std::vector<std::uint64_t> turned(const std::vector<std::uint64_t>& own) override {
    std::vector<std::uint64_t> all(size());
    MPI_Alltoall(own.data(), 1, MPI_UINT64_T, all.data(), 1, MPI_UINT64_T, communicator_);
    return all;
  }
  void exchange(std::size_t bytes_each, const std::byte* sent,
                const std::vector<std::uint64_t>& counts, std::byte* received,
                const std::vector<std::uint64_t>& from_counts) override {
    MPI_Datatype item = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(static_cast<int>(bytes_each), MPI_BYTE, &item);
    MPI_Type_commit(&item);
    const Places to(counts), from(from_counts);
    MPI_Alltoallv(sent, to.counts.data(), to.begins.data(), item, received, from.counts.data(),
                  from.begins.data(), item, communicator_);
    MPI_Type_free(&item);
  }

 private:
  // In the types that MPI requires.
  struct Places {
    explicit Places(const std::vector<std::uint64_t>& all)
        : counts(all.begin(), all.end()), begins(all.size()) {
      std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
    }
    std::vector<int> counts, begins;
  };

  MPI_Comm communicator_;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace circumspect::distributed
