#pragma once
// The progress of a long command on a terminal.

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace signorini {

/// One line on stderr that counts cases and says when the rest will be done; silent unless stderr is a
/// terminal.
class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Clears the line for other output.
  void clear() const;
  /// Prints the line with what is being done.
  void begin(const std::string& what);
  /// Counts this many cases, or a share of one, as done.
  void advance(double cases = 1.0) { done_ += cases; }

 private:
  std::size_t total_;
  double done_ = 0.0;
  bool visible_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One line on stderr that says what is being done and for how long, from half a second on, every second:
/// for work whose end nothing foretells. Silent unless stderr is a terminal. It is written by a thread, which
/// calls write(2) alone: a process that is forked meanwhile finds nothing locked.
class Waiting {
 public:
  explicit Waiting(std::string what);
  ~Waiting();  ///< clears the line
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

 private:
  void tell();

  std::string what_;
  bool done_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::thread teller_;
};

/// Width of a line on a terminal that does not tell its own [characters].
inline constexpr std::size_t kLineWidth = 79;

/// "solving 1:05", cut to so many characters.
std::string waiting_line(const std::string& what, std::chrono::seconds elapsed,
                         std::size_t width = kLineWidth);

/// "[12/240] 5 % ETA 1:23 what", the rest assumed to take as long per case as what is done; no ETA before
/// anything is done.
std::string progress_line(double done, std::size_t total, double elapsed_seconds, const std::string& what);

}  // namespace signorini
