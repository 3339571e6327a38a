#pragma once
// The data of a figure in blocks, and the curves of its panels that plot them.

#include <optional>
#include <string>
#include <string_view>

namespace signorini {

/// How gnuplot draws the line of a stop.
inline constexpr std::string_view kStopStyle = "lc rgb '#D55E00' dt (12,6) lw 1.2";

/// Collects blocks of data, and for one panel after the other what is plotted in it.
class Canvas {
 public:
  /// Adds a block, which gnuplot's `index` names; single blank lines in it part its pieces. Empty where there
  /// is no line.
  std::optional<int> add(const std::string& lines, std::string_view comment = {});
  /// Plots a block in the panel that is begun: "using 1:2 with lines". Nothing where there is no block.
  void plot(std::optional<int> block, std::string_view how);
  /// Both at once.
  void draw(const std::string& lines, std::string_view how, std::string_view comment = {}) {
    plot(add(lines, comment), how);
  }
  /// Plots what is no data: a function, an entry of the key.
  void plot(std::string_view what);

  /// The command that plots the panel, and the next one begins. A panel without curves is an empty frame.
  std::string panel();
  /// All blocks.
  [[nodiscard]] const std::string& data() const { return data_; }
  /// Whether there is any block.
  [[nodiscard]] bool empty() const { return blocks_ == 0; }

 private:
  std::string data_, curves_;
  int blocks_ = 0;
};

}  // namespace signorini
