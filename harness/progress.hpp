#pragma once
// The progress of a long command on a terminal.

#include <chrono>
#include <cstddef>
#include <string>

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

/// "[12/240] 5 % ETA 1:23 what", the rest assumed to take as long per case as what is done; no ETA before
/// anything is done.
std::string progress_line(double done, std::size_t total, double elapsed_seconds, const std::string& what);

}  // namespace signorini
