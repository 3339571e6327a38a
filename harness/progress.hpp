#pragma once

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

  /// What is under way.
  void begin(const std::string& what);
  /// One more case is done.
  void step() { ++done_; }

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool visible_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "[12/240] 5 % ETA 1:23 what", the rest assumed to take as long per case as what is done; no ETA before
/// the first case is done.
std::string progress_line(std::size_t done, std::size_t total, double elapsed_seconds,
                          const std::string& what);

}  // namespace signorini
