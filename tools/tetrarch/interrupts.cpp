// SPDX-License-Identifier: GPL-2.0-or-later
#include "interrupts.hpp"

#include "command.hpp"

#include "tetrarch/format/text.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <optional>
#include <semaphore.h>
#include <string>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace tetrarch::program {
namespace {

constexpr long grace = 500'000'000; ///< nanoseconds that a job has to notice

/// What the handler of signals may touch.
sem_t came;
std::atomic<bool> must_end{false};

/// A thread waits for the signal by way of a semaphore: libraries have threads of their own, older than
/// `main`, to which a signal that is only blocked would go.
class Watch {
public:
  Watch() {
    sem_init(&came, 0, 0);
    termios now{};
    if (tcgetattr(STDIN_FILENO, &now) == 0) terminal_ = now;
    std::thread([this] { listen(); }).detach();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal);
    std::signal(SIGXFSZ, SIG_IGN);
  }

  std::stop_token token() {
    const std::lock_guard lock(mutex_);
    source_ = std::stop_source();
    asked_ = 0;
    writing_ = false;
    leaving_ = false;
    return source_.get_token();
  }
  void be_patient() { patient_ = true; }
  void note_writing() { writing_ = true; }
  bool take_leave() { return !leaving_.exchange(true); }

private:
  static void handle(int signal) {
    struct sigaction action {};
    // What nohup did stays done.
    if (signal == SIGHUP && sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) return;
    action = {};
    action.sa_handler = [](int number) {
      if (number != SIGINT) must_end = true;
      sem_post(&came);
    };
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }

  [[noreturn]] void listen() {
    while (true) {
      while (sem_wait(&came) != 0) {
      }
      if (!ask_again()) wait_and_end();
    }
  }

  /// Asks the job to stop; whether that is all for now.
  bool ask_again() {
    constexpr int patience = 4;
    const std::lock_guard lock(mutex_);
    source_.request_stop();
    return ++asked_ < patience && patient_ && !must_end;
  }

  /// The program ends by itself within the grace, or here; at once if a second signal comes.
  [[noreturn]] void wait_and_end() {
    timespec until{};
    clock_gettime(CLOCK_REALTIME, &until);
    constexpr long second = 1'000'000'000;
    until.tv_sec += (until.tv_nsec + grace) / second;
    until.tv_nsec = (until.tv_nsec + grace) % second;
    sem_timedwait(&came, &until);
    format::remove_unfinished_files();
    if (terminal_) tcsetattr(STDIN_FILENO, TCSANOW, &*terminal_); // the editor of lines changed it
    if (take_leave())
      say_goodbye();
    else
      std::this_thread::sleep_for(
          std::chrono::nanoseconds(grace)); // the job is saying so, and ends the program
    std::_Exit(static_cast<int>(Status::interrupted));
  }

  /// Not through a stream, which the job may hold.
  void say_goodbye() const {
    const std::string clear = isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "";
    const std::string line = clear + "tetrarch: interrupted" +
                             (writing_ ? " while files were written" : "; nothing was written") + "\n";
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return; // nobody is there to be told
  }

  std::mutex mutex_;
  std::stop_source source_;
  std::optional<termios> terminal_;
  std::atomic<bool> patient_{false};
  std::atomic<bool> writing_{false};
  std::atomic<bool> leaving_{false};
  int asked_ = 0;
};

/// Its thread outlives every function, so that it is never destroyed.
Watch& the_watch() {
  static auto* const watch = new Watch;
  return *watch;
}

} // namespace

void watch_signals() {
  the_watch();
}

std::stop_token token_of_next_job() {
  return the_watch().token();
}

void be_patient() {
  the_watch().be_patient();
}

void note_writing() {
  the_watch().note_writing();
}

bool take_leave() {
  return the_watch().take_leave();
}

} // namespace tetrarch::program
