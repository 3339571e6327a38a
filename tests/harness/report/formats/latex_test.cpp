#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "harness/files.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/sections/sections.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"
#include "tests/support/other_programs.hpp"

namespace signorini::latex_test {
namespace {

namespace fs = std::filesystem;

TEST(LatexEscaped, SpellsOutWhatTexTakesForItsOwn) {
  EXPECT_EQ(latex_escaped("50 % & a_b #1 {x} <2 [n]"), "50 \\% \\& a\\_b \\#1 \\{x\\} $<$2 {[}n]");
  EXPECT_EQ(latex_escaped("e = 1 ≠ scene"), "e = 1 $\\neq$ scene");
  EXPECT_EQ(latex_escaped("a → b"), "a ? b");
}

TEST(ToLatex, PrintsNumbersAsJournalsDo) {
  Section section{.id = "t", .title = "t"};
  section.table = {{"a", "b", "c", "d", "e"},
                   {{"1.2e-03", "59.4 us", "<2.8e-11", "m[tolerance=1e-06]", "22e05f4a"}}};
  EXPECT_NE(to_latex(section).find("$1.2\\cdot10^{-3}$ & 59.4 $\\mu$s & $<$$2.8\\cdot10^{-11}$ & "
                                   "m{[}tolerance=1e-06] & 22e05f4a \\\\"),
            std::string::npos)
      << to_latex(section);
}

TEST(ToLatex, HasAsManyCellsInEveryRowAsColumns) {
  for (const Section& section : sections_of(Evaluation(test::records_of_a_run()))) {
    const std::string text = to_latex(section);
    const std::size_t columns = section.table.header.size();
    for (const char* rule : {"\\toprule", "\\midrule", "\\bottomrule"})
      EXPECT_NE(text.find(rule), std::string::npos);
    std::istringstream lines(text);
    std::size_t rows = 0;
    for (std::string line; std::getline(lines, line);) {
      if (line.size() < 2 || line.substr(line.size() - 2) != "\\\\") continue;
      ++rows;
      std::size_t cells = 1;
      for (std::size_t i = 1; i < line.size(); ++i) cells += line[i] == '&' && line[i - 1] != '\\' ? 1 : 0;
      EXPECT_EQ(cells, columns) << line;
    }
    EXPECT_EQ(rows, section.table.rows.size() + 1);
  }
}

TEST(ToLatex, IsTypesetWithoutComplaint) {
  if (!test::succeeds("pdflatex --version && kpsewhich booktabs.sty && kpsewhich longtable.sty"))
    GTEST_SKIP() << "pdflatex with booktabs and longtable is not installed (texlive-latex-recommended)";
  const fs::path folder = test::fresh_folder("latex");
  std::string document = "\\documentclass{article}\\usepackage{booktabs,longtable}\\begin{document}\\tiny\n";
  for (const Section& section : sections_of(Evaluation(test::records_of_a_run()))) {
    std::ofstream(folder / (section.id + ".tex")) << to_latex(section);
    document += "\\input{" + section.id + ".tex}\n\n";
  }
  std::ofstream(folder / "all.tex") << document << "\\end{document}\n";
  const std::string command =
      "cd '" + folder.string() + "' && pdflatex -interaction=nonstopmode -halt-on-error all.tex >log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "log");
}

}  // namespace
}  // namespace signorini::latex_test
