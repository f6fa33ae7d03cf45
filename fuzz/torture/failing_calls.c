// Makes one system call of the program fail, or all from one on: for LD_PRELOAD, on Linux on x86-64.
//
//   FAILING_CALL   "GROUP FIRST LAST ERRNO": of the calls of this group, in all processes that the program forks,
//                  those from FIRST to LAST fail. The group is one of those in kGroups, or "memory". Where ERRNO is 0, the
//                  calls of the first process alone are counted, and it is killed at such a call, after half of a write.
//   FAILING_COUNT  a file of 8 bytes, in which the calls are counted
//
// The kernel hands each call that libc makes to `on_call` (seccomp), so no call is missed that libc makes of itself.
// Calls are counted from main on, and those of programs that the program becomes or starts are their own.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#define MOST 12

static const struct {
  const char* name;
  int calls[MOST];  // -1 after the last
} kGroups[] = {
    {"open", {SYS_open, SYS_openat, -1}},
    {"read", {SYS_read, SYS_readv, SYS_pread64, -1}},
    {"write", {SYS_write, SYS_writev, SYS_pwrite64, SYS_copy_file_range, -1}},
    {"stat", {SYS_stat, SYS_fstat, SYS_lstat, SYS_newfstatat, SYS_statx, SYS_access, SYS_faccessat, -1}},
    {"seek", {SYS_lseek, SYS_ftruncate, SYS_fcntl, SYS_flock, -1}},
    {"sync", {SYS_fsync, SYS_fdatasync, -1}},
    {"name", {SYS_rename, SYS_renameat, SYS_renameat2, SYS_link, SYS_linkat, -1}},
    {"remove", {SYS_unlink, SYS_unlinkat, SYS_rmdir, -1}},
    {"folder", {SYS_mkdir, SYS_mkdirat, SYS_getdents64, SYS_getcwd, SYS_chdir, -1}},
    {"close", {SYS_close, -1}},
    {"map", {SYS_mmap, SYS_mremap, -1}},
    {"pipe", {SYS_pipe, SYS_pipe2, SYS_socketpair, SYS_sendto, SYS_recvfrom, SYS_dup2, -1}},
    {"process", {-1}},  // fork, clone and threads: the functions below
    {"memory", {-1}},   // malloc and what is like it
};

static long first, last;
static int error;
static const char* group = "";
static uint64_t none;
static uint64_t* count = &none;
static int counting;  // from main on
static pid_t first_process;

static int to_fail(void) {
  if (!counting || (error == 0 && getpid() != first_process)) return 0;
  const long n = (long)__atomic_add_fetch(count, 1, __ATOMIC_RELAXED);
  return first <= n && n <= last;
}

static long call(long number, long a, long b, long c, long d, long e, long f) {
  register long r10 __asm__("r10") = d;
  register long r8 __asm__("r8") = e;
  register long r9 __asm__("r9") = f;
  long result;
  __asm__ volatile("syscall"
                   : "=a"(result)
                   : "a"(number), "D"(a), "S"(b), "d"(c), "r"(r10), "r"(r8), "r"(r9)
                   : "rcx", "r11", "memory");
  return result;
}

static void on_call(int number, siginfo_t* info, void* context) {
  (void)number;
  greg_t* const r = ((ucontext_t*)context)->uc_mcontext.gregs;
  // Where a disk is full, an error can still be told.
  const int told = info->si_syscall == SYS_write && r[REG_RDI] == STDERR_FILENO && last != first;
  const int fails = !told && to_fail();
  if (fails && error == 0) {
    if (info->si_syscall == SYS_write) call(SYS_write, r[REG_RDI], r[REG_RSI], r[REG_RDX] / 2, 0, 0, 0);
    call(SYS_kill, first_process, SIGKILL, 0, 0, 0, 0);
  }
  // A file that could not be closed is closed, as Linux has it.
  if (!fails || info->si_syscall == SYS_close) {
    const long result =
        call(info->si_syscall, r[REG_RDI], r[REG_RSI], r[REG_RDX], r[REG_R10], r[REG_R8], r[REG_R9]);
    r[REG_RAX] = result;
    if (result < 0) return;
  }
  if (fails) r[REG_RAX] = -error;
}

static int text_of_libc(struct dl_phdr_info* info, size_t size, void* range) {
  (void)size;
  if (strstr(info->dlpi_name, "/libc.so") == NULL) return 0;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    if (info->dlpi_phdr[i].p_type != PT_LOAD || (info->dlpi_phdr[i].p_flags & PF_X) == 0) continue;
    ((uint64_t*)range)[0] = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
    ((uint64_t*)range)[1] = ((uint64_t*)range)[0] + info->dlpi_phdr[i].p_memsz;
  }
  return 1;
}

static void end(const char* why) {
  fprintf(stderr, "failing_calls: %s\n", why);
  _exit(99);
}

// Calls from elsewhere stay as they are: those of this file, and those of programs that this one becomes, whose libc
// lies at another address.
static void trap(const int* calls, char** argv) {
  uint64_t range[2] = {0, 0};
  dl_iterate_phdr(text_of_libc, range);
  if (range[0] == 0) end("found no libc");
  if (range[0] >> 32 != range[1] >> 32) execv("/proc/self/exe", argv);  // the next address is a better one
  struct sock_filter filter[MOST + 16];
  unsigned short n = 0;
  int many = 0;
  while (calls[many] >= 0) ++many;
#define LOAD(field) \
  (struct sock_filter) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, (uint32_t)(field))
#define JUMP(test, value, yes, no) \
  (struct sock_filter) BPF_JUMP(BPF_JMP | (test) | BPF_K, (uint32_t)(value), (uint8_t)(yes), (uint8_t)(no))
  filter[n++] = LOAD(offsetof(struct seccomp_data, instruction_pointer) + 4);
  filter[n++] = JUMP(BPF_JEQ, range[0] >> 32, 0, many + 4);
  filter[n++] = LOAD(offsetof(struct seccomp_data, instruction_pointer));
  filter[n++] = JUMP(BPF_JGE, range[0], 0, many + 2);
  filter[n++] = JUMP(BPF_JGE, range[1], many + 1, 0);
  filter[n++] = LOAD(offsetof(struct seccomp_data, nr));
  for (int i = 0; i < many; ++i) filter[n++] = JUMP(BPF_JEQ, calls[i], many - i, 0);
  filter[n++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  filter[n++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP);
  struct sigaction action;
  memset(&action, 0, sizeof(action));
  action.sa_sigaction = on_call;
  action.sa_flags = SA_SIGINFO | SA_NODEFER | SA_RESTART;
  call(SYS_prctl, PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0, 0);
  int (*real)(int, const struct sigaction*, struct sigaction*) = dlsym(RTLD_NEXT, "sigaction");
  const struct sock_fprog program = {n, filter};
  if (real(SIGSYS, &action, NULL) != 0 ||
      call(SYS_prctl, PR_SET_SECCOMP, SECCOMP_MODE_FILTER, (long)&program, 0, 0, 0) != 0) {
    end("this system has no seccomp");
  }
}

static void begin(char** argv) {
  const char* const what = getenv("FAILING_CALL");
  const char* const counter = getenv("FAILING_COUNT");
  static char name[32];
  if (what == NULL || counter == NULL || sscanf(what, "%31s %ld %ld %d", name, &first, &last, &error) != 4) {
    end("FAILING_CALL or FAILING_COUNT is missing");
  }
  const int file = open(counter, O_RDWR | O_CLOEXEC);
  void* const shared = mmap(NULL, 8, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (shared == MAP_FAILED) end("FAILING_COUNT is not a file of 8 bytes");
  close(file);
  count = shared;
  group = name;
  first_process = getpid();
  for (size_t i = 0; i < sizeof(kGroups) / sizeof(kGroups[0]); ++i) {
    if (strcmp(kGroups[i].name, name) != 0) continue;
    if (kGroups[i].calls[0] >= 0) trap(kGroups[i].calls, argv);
    unsetenv("LD_PRELOAD");
    unsetenv("FAILING_CALL");
    unsetenv("FAILING_COUNT");
    counting = 1;
    return;
  }
  end("no such group of calls");
}


static int (*real_main)(int, char**, char**);

static int main_that_counts(int argc, char** argv, char** environment) {
  begin(argv);
  return real_main(argc, argv, environment);
}

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void* stack_end) {
  int (*real)(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void), void (*)(void), void*) =
      dlsym(RTLD_NEXT, "__libc_start_main");
  real_main = main;
  return real(main_that_counts, argc, argv, init, fini, rtld_fini, stack_end);
}

// The handler of SIGSYS stays, and is never held up.
int sigaction(int number, const struct sigaction* action, struct sigaction* before) {
  static int (*real)(int, const struct sigaction*, struct sigaction*);
  if (real == NULL) real = dlsym(RTLD_NEXT, "sigaction");
  return real(number, number == SIGSYS ? NULL : action, before);
}

static int with_mask(const char* name, int how, const sigset_t* mask, sigset_t* before) {
  int (*real)(int, const sigset_t*, sigset_t*) = dlsym(RTLD_NEXT, name);
  sigset_t without;
  if (mask != NULL) {
    without = *mask;
    if (how != SIG_UNBLOCK) sigdelset(&without, SIGSYS);
  }
  return real(how, mask == NULL ? NULL : &without, before);
}

int pthread_sigmask(int how, const sigset_t* mask, sigset_t* before) {
  return with_mask("pthread_sigmask", how, mask, before);
}

int sigprocmask(int how, const sigset_t* mask, sigset_t* before) {
  return with_mask("sigprocmask", how, mask, before);
}

static int is(const char* name) { return counting && strcmp(group, name) == 0; }

pid_t fork(void) {
  pid_t (*real)(void) = dlsym(RTLD_NEXT, "fork");
  if (!is("process") || !to_fail()) return real();
  errno = error;
  return -1;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*run)(void*), void* with) {
  int (*real)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*) = dlsym(RTLD_NEXT, "pthread_create");
  return is("process") && to_fail() ? EAGAIN : real(thread, how, run, with);
}

long syscall(long number, ...) {
  va_list list;
  va_start(list, number);
  long a[6];
  for (int i = 0; i < 6; ++i) a[i] = va_arg(list, long);
  va_end(list);
  const int fails = number == SYS_clone && is("process") && to_fail();
  const long result = fails ? -error : call(number, a[0], a[1], a[2], a[3], a[4], a[5]);
  if (result >= 0 || result < -4095) return result;
  errno = (int)-result;
  return -1;
}

extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t n, size_t size);
extern void* __libc_realloc(void* block, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);

static int no_memory(void) {
  if (!is("memory") || !to_fail()) return 0;
  errno = ENOMEM;
  return 1;
}

void* malloc(size_t size) { return no_memory() ? NULL : __libc_malloc(size); }
void* calloc(size_t n, size_t size) { return no_memory() ? NULL : __libc_calloc(n, size); }
void* realloc(void* block, size_t size) { return no_memory() ? NULL : __libc_realloc(block, size); }
void* aligned_alloc(size_t alignment, size_t size) {
  return no_memory() ? NULL : __libc_memalign(alignment, size);
}
