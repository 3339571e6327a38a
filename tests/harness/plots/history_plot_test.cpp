#include "harness/plots/history_plot.hpp"

#include <gtest/gtest.h>

#include <string>

#include "harness/report/figures/gnuplot.hpp"

namespace signorini::history_plot_test {
namespace {

TEST(HistoryPlot, DrawsWhatEachRunHas) {
  const History history{.cases = 8,
                        .points = {{.date = "2026-01-02T03:04:05Z",
                                    .commit = "0123456789ab",
                                    .certified = 4,
                                    .error = 1e-3,
                                    .seconds = 0.5},
                                   {.date = "2026-02-03", .commit = "it's", .certified = 6, .error = 1e-4}}};
  const Figure figure = history_plot(history);
  EXPECT_NE(figure.data.find("0 50\n1 75\n"), std::string::npos) << figure.data;
  EXPECT_NE(figure.data.find("0 0.001\n1 0.0001\n"), std::string::npos) << figure.data;
  EXPECT_NE(figure.data.find("\n0 0.5\n"), std::string::npos) << figure.data;
  EXPECT_EQ(figure.data.find("1 0\n"), std::string::npos) << "a time that is not known is no point";
  const std::string svg = drawn(figure, "svg");
  for (const char* label : {"2026-01-02 0123456", "2026-02-03 it", "certified [%]"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
}

}  // namespace
}  // namespace signorini::history_plot_test
