#pragma once
// A figure of errors over a cost, both in decades: what those against time, resolution and constants share.

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/report/figures/column.hpp"

namespace signorini {

/// One answer.
struct ErrorMark {
  double cost = 0.0, error = 0.0;
  bool hollow = false;      ///< an error that ErrorCurve::hollow says something about
  std::string words = {};   ///< beside the mark, where there is room
  std::string source = {};  ///< the case, beside the numbers in the data
};

/// Answers of one method and the line through some of them.
struct ErrorCurve {
  std::string name = {}, label = {};  ///< in the data, in the figure
  std::size_t place = 0;              ///< of its style
  std::string hollow = {};            ///< what hollow marks are: "below ten error bars"
  std::vector<ErrorMark> marks = {};
  std::vector<std::pair<double, double>> line = {};  ///< costs and errors; none: the curve is not drawn
};

/// What the axes of a figure say, and how far down they go.
struct ErrorAxes {
  std::string cost = {}, error = {};
  double floor = 0.0;   ///< drawn as a line where it is not 0
  bool slopes = false;  ///< with triangles of orders 1 and 2
};

/// The figure, without a caption; without data if no curve has points.
Figure error_figure(const std::string& name, std::span<const ErrorCurve> curves, const ErrorAxes& axes,
                    Column column);

}  // namespace signorini
