#include "platform/interruption_watch.hpp"

#include <atomic>
#include <system_error>
#include <thread>
#include <utility>

#include <windows.h>

namespace circumspect::platform {
namespace {

std::atomic<bool> received = false;
std::atomic<HANDLE> wake_up = nullptr;  // an event that the thread waits for

// The system calls it in a thread of its own. The second time it is left to the system, which ends
// the process.
BOOL WINAPI receive(DWORD what) {
  if (what != CTRL_C_EVENT && what != CTRL_BREAK_EVENT) return FALSE;
  if (received.exchange(true)) return FALSE;
  const HANDLE event = wake_up;
  if (event != nullptr) SetEvent(event);
  return TRUE;
}

}  // namespace

struct InterruptionWatch::System {
  HANDLE event = nullptr;
  std::thread thread;
};

InterruptionWatch::InterruptionWatch() : system_(std::make_unique<System>()) {}

InterruptionWatch::~InterruptionWatch() { end(); }

bool InterruptionWatch::start(std::function<void()> look_on) {
  system_->event = CreateEventW(nullptr, FALSE, FALSE, nullptr);
  if (system_->event == nullptr) return false;
  received = false;
  wake_up = system_->event;
  try {
    system_->thread = std::thread(std::move(look_on));
  } catch (const std::system_error&) {
    wake_up = nullptr;
    CloseHandle(system_->event);
    return false;
  }
  SetConsoleCtrlHandler(receive, TRUE);
  return true;
}

bool InterruptionWatch::is_running() const { return system_->thread.joinable(); }

void InterruptionWatch::end() {
  if (!is_running()) return;
  SetConsoleCtrlHandler(receive, FALSE);
  wake_up = nullptr;
  SetEvent(system_->event);
  system_->thread.join();
  CloseHandle(system_->event);
}

void InterruptionWatch::wait(int milliseconds) {
  WaitForSingleObject(system_->event,
                      milliseconds < 0 ? INFINITE : static_cast<DWORD>(milliseconds));
}

bool InterruptionWatch::is_interrupted() const { return received; }

}  // namespace circumspect::platform
