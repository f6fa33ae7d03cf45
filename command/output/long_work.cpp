#include "command/output/long_work.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "oracle/model/printable.hpp"
#include "platform/files.hpp"
#include "platform/terminal.hpp"

namespace circumspect::cli {
namespace {

constexpr double kLong = 2;         // seconds that nobody need hear of
constexpr int kBetweenLooks = 200;  // milliseconds
double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t width_of_terminal() {
  constexpr std::size_t kUsual = 80;
  const std::size_t width = platform::terminal_width(platform::kStandardError);
  return width > 0 ? width : kUsual;
}

}  // namespace

std::string about(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  if (seconds < 100 * 60) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 100 * 3600) return fmt::format("{:.0f} hours", seconds / 3600);
  if (seconds < 1e10) return fmt::format("{:.0f} days", seconds / 86400);
  return "longer than anybody waits";
}

LongWork::LongWork(std::string command, std::optional<double> seconds, bool shows,
                   std::function<int(const std::string& why)> last_words)
    : command_(std::move(command)),
      seconds_(seconds),
      shows_(shows && platform::is_terminal(platform::kStandardError)),
      last_words_(std::move(last_words)) {
  interruptions_.start([this] { look_on(); });
}

LongWork::~LongWork() {
  if (!interruptions_.is_running()) return;
  is_over_ = true;
  interruptions_.end();
  clear();
}

void LongWork::begin(std::string what, std::optional<double> expected) {
  const std::lock_guard lock(mutex_);
  what_ = on_one_line(what);
  expected_ = expected;
  begun_ = Clock::now();
  counted_ = nullptr;
}

Progress LongWork::progress() {
  return [this](const char* what, std::size_t done, std::size_t of) {
    done_ = done;
    of_ = of;
    counted_ = what;
  };
}

void LongWork::clear() {
  const std::lock_guard lock(mutex_);
  if (is_shown_) std::fputs("\r\x1b[K", stderr);
  is_shown_ = false;
}

void LongWork::look_on() {
  while (!is_over_) {
    int wait = shows_ ? kBetweenLooks : -1;
    if (seconds_) {
      const double left = std::ceil(std::max(0.0, *seconds_ - since(start_)) * 1000);
      if (wait < 0 || left < wait) wait = static_cast<int>(std::min(left, 1e9));
    }
    interruptions_.wait(wait);
    if (is_over_) return;
    if (interruptions_.is_interrupted()) end_with("interrupted");
    if (seconds_ && since(start_) >= *seconds_) end_with("stopped by --limit");
    if (shows_ && since(start_) >= kLong) show();
  }
}

// "segments: 1200 of 9680, 12 %"
std::string LongWork::so_far() const {
  const char* const counted = counted_;
  if (counted == nullptr) return "";
  const std::size_t done = done_, of = of_;
  if (of == 0) return fmt::format(", {}: {}", counted, done);
  return fmt::format(", {}: {} of {}, {:.0f} %", counted, done, of,
                     std::floor(100.0 * static_cast<double>(done) / static_cast<double>(of)));
}

void LongWork::show() {
  const std::lock_guard lock(mutex_);
  if (what_.empty()) return;
  std::string line = command_ + ": " + what_;
  std::string rest = fmt::format("{}, {:.0f} s", so_far(), std::floor(since(begun_)));
  if (expected_) rest += " of about " + about(*expected_);
  // Where both do not fit on a line, the name of a file, which the user knows, is cut.
  const std::size_t room = width_of_terminal() - 1;
  if (line.size() + rest.size() > room) {
    line.resize(room > rest.size() + 3 ? room - rest.size() - 3 : 0);
    line += "...";
  }
  line += rest;
  std::fputs(("\r\x1b[K" + line).c_str(), stderr);
  std::fflush(stderr);
  is_shown_ = true;
}

void LongWork::end_with(const std::string& cause) {
  clear();
  std::string why = fmt::format("{} after {:.1f} s", cause, since(start_));
  {
    const std::lock_guard lock(mutex_);
    if (!what_.empty()) why += ", while " + what_ + so_far();
  }
  std::_Exit(last_words_(why));
}

}  // namespace circumspect::cli
