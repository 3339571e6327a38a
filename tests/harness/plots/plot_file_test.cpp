#include "harness/plots/plot_file.hpp"

#include <gtest/gtest.h>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "tests/harness/program.hpp"
#include "tests/problems/temporary_folder.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::plot_file_test {
namespace {

namespace fs = std::filesystem;

Figure parabola() {
  return {
      .name = "parabola",
      .script = "set multiplot layout 1,2\nplot data with lines\nplot data with points\nunset multiplot\n",
      .data = "0 0\n1 1\n2 4\n"};
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WritePlot, WritesTheFormatOfTheEndingAndNothingElse) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  const test::TemporaryFolder folder;
  for (const auto& [name, magic] : {std::pair{"a.svg", "<?xml"}, {"a.pdf", "%PDF"}, {"a.png", "\x89PNG"}}) {
    write_plot(folder.path() / name, parabola());
    EXPECT_EQ(read_file(folder.path() / name).rfind(magic, 0), 0U) << name;
  }
  EXPECT_EQ(files_in(folder.path()), 3U);
}

TEST(WritePlot, IsTheSameEachTime) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  const test::TemporaryFolder folder;
  write_plot(folder.path() / "a.pdf", parabola());
  write_plot(folder.path() / "b.pdf", parabola());
  EXPECT_EQ(read_file(folder.path() / "a.pdf"), read_file(folder.path() / "b.pdf"));
}

TEST(WritePlot, SaysWhatGnuplotDoesNotUnderstand) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  const test::TemporaryFolder folder;
  EXPECT_THROW(write_plot(folder.path() / "a.svg", {.name = "bad", .script = "no such command\n"}),
               UsageError);
  EXPECT_FALSE(fs::exists(folder.path() / "a.svg"));
}

TEST(PlotObstacle, RefusesOtherEndingsAndFoldersThatAreNotThere) {
  EXPECT_EQ(plot_obstacle("a.svg"), "");
  EXPECT_EQ(plot_obstacle("/tmp/a.png"), "");
  EXPECT_EQ(plot_obstacle("a.jpg"), "plot = a.jpg (must end in .svg, .pdf or .png)");
  EXPECT_EQ(plot_obstacle("svg"), "plot = svg (must end in .svg, .pdf or .png)");
  EXPECT_EQ(plot_obstacle("/no/such/folder/a.svg"),
            "plot = /no/such/folder/a.svg (must stand in a folder that is there)");
}

TEST(PlotOption, DrawsWhatEachCommandHasFound) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  const test::TemporaryFolder folder;
  const auto drawn = [&](const std::string& command, const std::string& name) {
    const std::string file = (folder.path() / name).string();
    const test::Outcome outcome = test::run_program(command + " --plot " + file);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return fs::exists(file) && fs::file_size(file) > 5000;
  };
  EXPECT_TRUE(drawn("sweep sdof-stop --methods exact-orbit --from 2.3 --to 2.6", "response.svg"));
  EXPECT_TRUE(drawn("sweep sdof-stop --method exact-orbit --from 2.3 --to 2.6 --points 9", "steps.svg"));
  EXPECT_TRUE(drawn("solve sdof-stop --method exact-orbit", "motion.pdf"));
  EXPECT_TRUE(drawn("orbits sdof-stop --starts 4", "orbits.png"));
}

TEST(PlotOption, RefusesABadNameBeforeAnyWork) {
  for (const char* command : {"sweep sdof-stop --methods exact-orbit --from 2 --to 3",
                              "solve sdof-stop --method hat-lcp", "orbits sdof-stop"}) {
    const test::Outcome outcome = test::run_program(std::string(command) + " --plot x.jpg");
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_NE(outcome.err.find("must end in .svg, .pdf or .png"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
}  // namespace signorini::plot_file_test
