#include "harness/report/figures/gnuplot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::gnuplot_test {
namespace {

TEST(WithoutDate, ChangesNothingButTheDate) {
  const std::string pdf = "%PDF /CreationDate (D:20261121213658Z) rest";
  EXPECT_EQ(without_date(pdf), "%PDF /CreationDate (D:19700101000000Z) rest");
  EXPECT_EQ(without_date("none"), "none");
}

Figure parabola() {
  return {.name = "parabola",
          .caption = "x^2",
          .script = "plot data using 1:2 with lines notitle\n",
          .data = "0 0\n1 1\n2 4\n",
          .width = 10.0,
          .height = 5.0};
}

TEST(WholeScript, MakesBothFormatsOfItsDataInTheSizeOfTheFigure) {
  const std::string script = whole_script(parabola());
  EXPECT_NE(script.find("data = 'parabola.dat'\n"), std::string::npos) << script;
  EXPECT_NE(script.find("svg size 378,189 "), std::string::npos) << "96 pixels an inch: " << script;
  EXPECT_NE(script.find("pdfcairo size 10.0cm,5.0cm "), std::string::npos) << script;
  EXPECT_NE(script.find("set output 'parabola.'.format\nplot data"), std::string::npos) << script;
}

TEST(DrawFigures, LeavesScriptDataAndDrawingsThatGnuplotMakesAgain) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  const std::filesystem::path folder = test::fresh_folder("gnuplot");
  draw_figures(folder, std::vector{parabola()});
  const std::string svg = read_file(folder / "parabola.svg");
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_EQ(read_file(folder / "parabola.pdf").substr(0, 4), "%PDF");
  EXPECT_EQ(read_file(folder / "parabola.dat"), parabola().data);
  EXPECT_FALSE(std::filesystem::exists(folder / "gnuplot.log"));
  EXPECT_EQ(std::system(("cd '" + folder.string() + "' && gnuplot parabola.gp").c_str()), 0);
  EXPECT_EQ(read_file(folder / "parabola.svg"), svg);
}

TEST(DrawFigures, KeepsWhatGnuplotComplainsOf) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  const std::filesystem::path folder = test::fresh_folder("gnuplot");
  Figure bad = parabola();
  bad.script = "plot nonsense nonsense\n";
  EXPECT_THROW(draw_figures(folder, std::vector{bad}), UsageError);
  EXPECT_FALSE(read_file(folder / "gnuplot.log").empty());
}

TEST(LineStyle, TellsConfigurationsApartByColourAndByMark) {
  std::set<std::string> lines, marks;
  for (std::size_t c = 0; c < 6; ++c) {
    lines.insert(line_style(c).line);
    marks.insert(line_style(c).mark);
    EXPECT_NE(line_style(c).filled, line_style(c).hollow);
  }
  EXPECT_EQ(lines.size(), 6U);
  EXPECT_EQ(marks.size(), 6U);
}

TEST(LineStyle, GivesAMarkAnotherColourWhenMarksComeRoundAgain) {
  EXPECT_EQ(line_style(0).mark, line_style(6).mark);
  EXPECT_NE(line_style(0).filled, line_style(6).filled);
}

TEST(KeyPanel, HasOneEntryPerLineAndPlotsNothing) {
  const std::string script = key_panel({{"lc 1", "a"}, {"lc 2", "b[n=1]"}}, 0.25, 3);
  EXPECT_NE(script.find("set tmargin at screen 0.25\n"), std::string::npos) << script;
  EXPECT_NE(script.find("maxcols 3 "), std::string::npos) << script;
  EXPECT_NE(script.find("plot 2 notitle, \\\n  keyentry with linespoints lc 1 title 'a', \\\n"
                        "  keyentry with linespoints lc 2 title 'b[n=1]'\n"),
            std::string::npos)
      << script;
}

TEST(GnuplotString, HasNoCharacterThatEndsIt) {
  EXPECT_EQ(gnuplot_string("hat-lcp[samples=64]"), "'hat-lcp[samples=64]'");
  EXPECT_EQ(gnuplot_string("x'.system('touch PWN').'"), "'x''.system(''touch PWN'').'''");
  EXPECT_EQ(gnuplot_string("a\nb"), "'a b'");
}

TEST(DrawFigures, RunsNoCommandThatATitleHolds) {
  if (!test::gnuplot_draws()) GTEST_SKIP() << test::kNoGnuplot;
  const std::filesystem::path folder = test::fresh_folder("gnuplot-attack");
  Figure figure = parabola();
  figure.script = "set key noenhanced\nplot data using 1:2 title " +
                  gnuplot_string("x'.system('touch${IFS}PWN').'`touch PWN`@data\\") + "\n";
  draw_figures(folder, std::vector{figure});
  EXPECT_FALSE(std::filesystem::exists(folder / "PWN"));
}

TEST(DrawFigures, WritesNoFileOutsideItsFolder) {
  const std::filesystem::path folder = test::fresh_folder("gnuplot-names");
  for (const char* name : {"../escape", "a'b", "", ".hidden", "-option", "a b"}) {
    Figure figure = parabola();
    figure.name = name;
    EXPECT_THROW(draw_figures(folder / "figures", std::vector{figure}), UsageError) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "escape.gp"));
}

TEST(TicStep, IsRoundAndGivesAtMostSoMany) {
  EXPECT_DOUBLE_EQ(tic_step(0.9, 5), 0.2);
  EXPECT_DOUBLE_EQ(tic_step(1.0, 5), 0.2);
  EXPECT_DOUBLE_EQ(tic_step(1.01, 5), 0.5);
  EXPECT_DOUBLE_EQ(tic_step(3.5e-7, 4), 1e-7);
  EXPECT_DOUBLE_EQ(tic_step(60.0, 7), 10.0);
  EXPECT_EQ(tic_step(0.0, 5), 1.0);
}
TEST(Canvas, NumbersBlocksOverAllPanels) {
  Canvas canvas;
  EXPECT_TRUE(canvas.empty());
  const auto first = canvas.add("0 1\n", "a method");
  canvas.plot(first, "using 1:2 with lines");
  canvas.draw("2 3\n", "with points");
  EXPECT_EQ(canvas.panel(), "plot data index 0 using 1:2 with lines, \\\n  data index 1 with points\n");
  canvas.plot(first, "with steps");
  canvas.plot("0.5 with lines");
  EXPECT_EQ(canvas.panel(), "plot data index 0 with steps, \\\n  0.5 with lines\n");
  EXPECT_EQ(canvas.data(), "# a method\n0 1\n\n\n2 3\n\n\n");
}

TEST(Canvas, LeavesOutWhatHasNoLines) {
  Canvas canvas;
  EXPECT_EQ(canvas.add("", "a method"), std::nullopt);
  canvas.draw("", "with lines");
  EXPECT_TRUE(canvas.empty());
  EXPECT_EQ(canvas.data(), "");
  EXPECT_NE(canvas.panel().find("plot 2 notitle"), std::string::npos);  // a frame without curves
}

}  // namespace
}  // namespace signorini::gnuplot_test
