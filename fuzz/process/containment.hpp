// How much of the system a program sees that others wrote, and with what it can be ended for certain.
#pragma once

#include <cstddef>

#include <sys/resource.h>
#include <sys/types.h>

namespace circumspect::campaign {

enum class Containment {
  // In a process namespace, whose first process is the supervisor. A program sees nothing of the processes
  // outside, so it can neither stop nor kill them. One kill ends all that it started, even a fork bomb of which
  // every process has a session of its own. The kernel counts its processes and refuses too many.
  kNamespaces,
  // As descendants of the supervisor, which looks for them and kills them. A program can see, stop and kill
  // every process of its user; it is found out, and what it started is killed.
  kSupervisor,
};

// "namespaces" or "supervisor".
const char* name(Containment containment);

// As fork. The child is the first process of a process namespace of its own, with its own /proc. −1 where the
// system does not allow that: then there is no child. Requires: this process has one thread.
pid_t fork_into_namespaces();

// How many tasks (processes and their threads) the kernel may let a program have that may have so many
// processes; called by a supervisor, once. Threads count too, so there is room for a thousand of them.
rlim_t most_tasks(Containment containment, std::size_t processes);

// In a process namespace: lets the kernel refuse more tasks, also to a superuser, if it is one that can.
void let_kernel_refuse_more_tasks(rlim_t tasks);

// A process whose number nobody else gets meanwhile, as far as this one is concerned.
class Known {
 public:
  Known() = default;
  // Requires: it is there.
  explicit Known(pid_t process);
  ~Known();
  Known(Known&& other) noexcept;
  Known& operator=(Known&& other) noexcept;

  pid_t number() const { return number_; }
  // True, too, of none.
  bool has_ended_within(int milliseconds) const;
  void send(int signal_number) const;
  // What the kernel says it does: 'R', 'S', 'T' (stopped), 't' (traced), …; 0 if it has ended.
  char state() const;

 private:
  pid_t number_ = -1;
  int file_ = -1;
};

}  // namespace circumspect::campaign
