#include "fuzz/process/worker.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace circumspect::campaign {

namespace {

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos;
}

// Removes and returns the first word of a line; empty at its end.
std::string_view next_word(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t\r\v\f"), line.size());
  const std::size_t end = std::min(line.find_first_of(" \t\r\v\f", begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

}  // namespace

void Answer::add(const char* bytes, std::size_t count) {
  text_.append(bytes, count);
  while (!is_complete_) {
    const std::size_t end = text_.find('\n', searched_);
    searched_ = end == std::string::npos ? text_.size() : end + 1;
    if (end == std::string::npos) return;
    add_line(std::string_view(text_).substr(end_, end - end_));
    end_ = end + 1;
  }
}

std::size_t Answer::numbers_behind(std::string_view& line) const {
  if (form_ == Talk::Form::kSimplices) return 1;
  if (form_ == Talk::Form::kTet) return 2;
  const std::string_view word = next_word(line);
  return word == "OFF" ? 2 : word == "nOFF" ? 3 : 0;
}

void Answer::add_line(std::string_view line) {
  if (is_blank(line)) return;
  if (expected_) {
    is_complete_ = ++lines_ == *expected_;
    return;
  }
  if (numbers_wanted_ == 0) {
    std::string_view rest = line;
    is_complete_ = next_word(rest) == "error";
    if (is_complete_) return;
    numbers_wanted_ = numbers_behind(line);
    is_garbage_ = numbers_wanted_ == 0;
  }
  while (!is_garbage_ && numbers_.size() < numbers_wanted_ && !is_blank(line)) {
    const std::string_view word = next_word(line);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    // A line has two bytes or more.
    is_garbage_ = error != std::errc() || end != word.data() + word.size() || number > most_ / 2;
    numbers_.push_back(number);
    if (form_ == Talk::Form::kTet) break;  // What is counted follows.
  }
  is_complete_ = is_garbage_;
  if (is_garbage_ || numbers_.size() < numbers_wanted_) return;
  // Points and faces, or simplices.
  expected_ = numbers_.back() + (numbers_wanted_ > 1 ? numbers_[numbers_.size() - 2] : 0);
  is_complete_ = *expected_ == 0;
}

bool Answer::is_in_step() const {
  return is_complete_ && !is_garbage_ && is_blank(std::string_view(text_).substr(end_));
}

namespace {

void close_both(int (&ends)[2]) {
  for (int& end : ends) {
    if (end >= 0) close(end);
    end = -1;
  }
}

}  // namespace

int Worker::start(const Request& request, const Limits& limits) {
  // A worker that ends while this process writes to it must not end this process.
  signal(SIGPIPE, SIG_IGN);
  int in[2] = {-1, -1};
  int out[2] = {-1, -1};
  int reason = 0;
  if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) reason = errno;
  files_[kError] = opened_empty(request.stderr_file);
  if (reason == 0 && files_[kError] < 0) reason = errno;
  if (reason == 0) {
    // The file of what it prints is truncated for each case, and it continues at the new end.
    fcntl(files_[kError], F_SETFL, O_APPEND);
    const Surroundings now = {
        around_.lifeline, {}, around_.containment};  // It is its turn already.
    const pid_t process =
        start_program(request, limits, now, {in[0], out[1], files_[kError]}, request.talk->cases);
    if (process < 0) reason = -process;
    if (process > 0) process_ = process;
  }
  if (reason == 0) {
    files_[kIn] = std::exchange(in[1], -1);
    files_[kOut] = std::exchange(out[0], -1);
    for (const File file : {kIn, kOut}) fcntl(files_[file], F_SETFL, O_NONBLOCK);
    folder_ = request.folder;
    answers_ = 0;
  }
  close_both(in);
  close_both(out);
  if (reason != 0) end();
  return reason;
}

int Worker::end() {
  const int status = process_ > 0 ? killed(process_, around_.containment) : 0;
  process_ = -1;
  for (int& file : files_) {
    if (file >= 0) close(file);
    file = -1;
  }
  return status;
}

std::string Worker::left_over() {
  Answer text(Talk::Form::kSimplices, 0);
  read_into(text);
  return text.text();
}

Ended Worker::ask(const Request& request, const Limits& limits) {
  if (!around_.turn.take(around_.lifeline)) return {Ending::kInterrupted};
  const Ended ended = answered(request, limits);
  around_.turn.give_back();
  return ended;
}

Ended Worker::answered(const Request& request, const Limits& limits) {
  const auto write_answer = [&request, &limits](const std::string& text) {
    const int file = opened_empty(request.stdout_file);
    std::size_t written = 0;
    const std::size_t size = std::min<std::uint64_t>(text.size(), limits.output);
    while (file >= 0 && written < size) {
      const ssize_t count = write(file, text.data() + written, size - written);
      if (count < 0 && errno != EINTR) break;
      written += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    if (file >= 0) close(file);
    return file < 0 || written < size ? errno : 0;
  };
  if (answers_ >= request.talk->cases || folder_ != request.folder) end();
  if (process_ > 0) {
    const std::string more = left_over();
    if (!is_blank(more)) {
      end();
      const int reason = write_answer(more);
      return reason != 0 ? Ended{Ending::kNotStarted, reason} : Ended{Ending::kOutOfStep};
    }
    siginfo_t about{};
    waitid(P_PID, static_cast<id_t>(process_), &about, WEXITED | WNOHANG | WNOWAIT);
    if (about.si_pid != 0) end();
  }
  if (process_ < 0) {
    const int reason = start(request, limits);
    if (reason != 0) return {Ending::kNotStarted, reason};
  }
  static_cast<void>(ftruncate(files_[kError], 0));

  std::ostringstream question;
  question << std::ifstream(request.stdin_file, std::ios::binary).rdbuf();
  if (!question)
    return {Ending::kNotStarted, EIO};  // the program need not answer a part of a question
  Answer answer(request.talk->form, limits.output);
  Ended ended;
  {
    Watch watch(process_, request, limits, around_.lifeline);
    const std::optional<Ending> ending = talk(question.str(), answer, watch, limits);
    const int reason = write_answer(answer.text());
    ended.ending = Ending::kExited;
    if (!ending && answer.is_in_step()) {
      ++answers_;
    } else {
      const int status = end();
      if (ending) ended = described(*ending, status, request, limits);
    }
    if (reason != 0) ended = {Ending::kNotStarted, reason};
    ended.seconds = watch.seconds();
  }
  ended.lines = answer.lines();
  ended.expected_lines = answer.expected_lines();
  return ended;
}

// Nothing: there is an answer, and the whole question has been read.
std::optional<Ending> Worker::talk(const std::string& question, Answer& answer, Watch& watch,
                                   const Limits& limits) {
  std::size_t sent = 0;
  bool is_open = true;
  double next_look = Watch::kTick;
  while (!answer.is_complete()) {
    pollfd files[4] = {{is_open ? files_[kOut] : -1, POLLIN, 0},
                       {sent < question.size() ? files_[kIn] : -1, POLLOUT, 0},
                       {around_.lifeline, POLLRDHUP, 0},
                       {watch.file(), POLLIN, 0}};
    poll(files, 4, static_cast<int>(Watch::kTick * 1000));
    if ((files[2].revents & (POLLRDHUP | POLLHUP)) != 0) return Ending::kInterrupted;
    const bool has_ended = files[3].revents != 0 || (watch.file() < 0 && watch.has_ended());
    if (is_open) is_open = read_into(answer);
    if (!answer.is_complete() && answer.text().size() > limits.output) return Ending::kOutputLimit;
    if (has_ended && !answer.is_complete()) return Ending::kExited;
    if (files[1].revents != 0) write_from(question, sent);
    if (watch.seconds() < next_look) continue;
    next_look = watch.seconds() + Watch::kTick;
    if (const std::optional<Ending> limit = watch.exceeded()) return limit;
  }
  // It would take the unsent rest for the next case.
  if (sent < question.size()) end();
  return std::nullopt;
}

bool Worker::read_into(Answer& answer) {
  // The most that a pipe may hold when its writer has ended; the rest is read after checking the
  // limits.
  constexpr std::size_t kMost = 1 << 20;
  char block[1 << 16];
  for (std::size_t all = 0; all < kMost && !answer.is_complete();) {
    const ssize_t count = read(files_[kOut], block, sizeof(block));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN;
    if (count == 0) return false;
    answer.add(block, static_cast<std::size_t>(count));
    all += static_cast<std::size_t>(count);
  }
  return true;
}

void Worker::write_from(const std::string& question, std::size_t& sent) {
  const ssize_t count = write(files_[kIn], question.data() + sent, question.size() - sent);
  if (count > 0) sent += static_cast<std::size_t>(count);
  // It stops reading, and will say why, or end.
  if (count < 0 && errno == EPIPE) sent = question.size();
}

}  // namespace circumspect::campaign
