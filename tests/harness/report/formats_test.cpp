// The same sections in every format.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/records/record_store.hpp"
#include "harness/report/formats/html.hpp"
#include "harness/report/formats/latex.hpp"
#include "harness/report/formats/markdown.hpp"
#include "harness/report/formats/page.hpp"
#include "harness/report/formats/record_csv.hpp"
#include "harness/report/report.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/harness/sample_records.hpp"

namespace signorini {
namespace {

namespace fs = std::filesystem;

std::vector<Record> a_run() {
  std::vector<Record> records = test::records_of_every_status();
  for (const char* scene : {"scene-b", "scene-c"}) {
    for (const char* method : {"method-b", "method-c"}) {
      records.push_back(test::good_record(scene, method, "n=1", 0.1, 1e-3));
      records.push_back(test::good_record(scene, method, "n=2", 1e-3, 1e-2));
      records.back().waveforms = test::full_record().waveforms;
    }
  }
  records.back().law_matches_scene = false;
  return records;
}

/// Every file below a folder, by its path.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
  }
  return files;
}

bool has_gnuplot() { return std::system("gnuplot --version >/dev/null 2>&1") == 0; }

TEST(WriteReport, IsByteIdenticalWhateverTheOrderOfTheRecords) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed";
  std::vector<Record> records = a_run();
  const fs::path folder = test::fresh_folder("report");
  write_report(folder, Evaluation(records), report_formats());
  const auto before = contents(folder);
  EXPECT_TRUE(before.contains("table.md"));
  EXPECT_TRUE(before.contains("measures.csv"));
  EXPECT_TRUE(before.contains("tables/means-1.tex"));
  EXPECT_TRUE(before.contains("report.html"));
  for (const char* ending : {"gp", "dat", "svg", "pdf"})
    EXPECT_TRUE(before.contains(std::string("figures/scene-b-work-precision.") + ending));
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::mt19937 random(3);
  std::shuffle(records.begin(), records.end(), random);
  write_report(folder, Evaluation(records), report_formats());
  const auto after = contents(folder);
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [name, text] : before) EXPECT_TRUE(after.at(name) == text) << name;
}

TEST(HtmlPage, NeedsNothingButItself) {
  const Evaluation evaluation(a_run());
  const std::string page =
      html_page("a & b", {{"compiler", "GNU"}}, evaluation, sections_of(evaluation), {}, {});
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
  for (const char* outside : {"http://", "https://", "src=\"/", "@import", "url("})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_NE(page.find("<h1>a &amp; b</h1>"), std::string::npos);
}

TEST(HtmlPage, HoldsTheRecordBehindEveryLink) {
  const Evaluation evaluation(a_run());
  const std::string page = html_page("run", {}, evaluation, sections_of(evaluation), {}, {});
  std::size_t links = 0;
  const std::string link = "href=\"#record-";
  for (std::size_t at = page.find(link); at != std::string::npos; at = page.find(link, at + 1), ++links) {
    const std::size_t begin = at + link.size() - std::string("record-").size();
    const std::string id = page.substr(begin, page.find('"', begin) - begin);
    EXPECT_NE(page.find("<details id=\"" + id + "\">"), std::string::npos) << id;
  }
  EXPECT_GE(links, evaluation.records().size());
  EXPECT_NE(page.find("&quot;case&quot;: &quot;scene-b/method-b[n=1]&quot;"), std::string::npos);
}

TEST(HtmlTable, CarriesTheValuesThatItSortsBy) {
  const Table table{{"method", "time"}, {{"a", Cell("1 ms", 1e-3, 4U)}, {"<b>", Cell("none", INFINITY)}}};
  const std::string text = html_table(table);
  EXPECT_NE(text.find("<td class=\"n\" data-v=\"0.001\"><a href=\"#record-5\">1 ms</a></td>"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("<td class=\"n\">none</td>"), std::string::npos) << text;
  EXPECT_EQ(text.find("<b>"), std::string::npos);
}

TEST(FactsOfManifest, NamesWhatIsThereAndRefusesWhatIsNoObject) {
  EXPECT_TRUE(facts_of_manifest("").empty());
  EXPECT_EQ(facts_of_manifest(R"({"suite": "quick", "machine": {"processors": 2}})"),
            (RunFacts{{"suite", "quick"}, {"processors", "2"}}));
  EXPECT_THROW(facts_of_manifest("[1"), UsageError);
}

TEST(LatexEscaped, SpellsOutWhatTexTakesForItsOwn) {
  EXPECT_EQ(latex_escaped("50 % & a_b #1 {x} <2 [n]"), "50 \\% \\& a\\_b \\#1 \\{x\\} $<$2 {[}n]");
  EXPECT_EQ(latex_escaped("e = 1 ≠ scene"), "e = 1 $\\neq$ scene");
  EXPECT_EQ(latex_escaped("a → b"), "a ? b");
}

TEST(ToLatex, HasAsManyCellsInEveryRowAsColumns) {
  for (const Section& section : sections_of(Evaluation(a_run()))) {
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
  if (std::system("pdflatex --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "pdflatex is not installed";
  const fs::path folder = test::fresh_folder("latex");
  std::string document = "\\documentclass{article}\\usepackage{booktabs,longtable}\\begin{document}\\tiny\n";
  for (const Section& section : sections_of(Evaluation(a_run()))) {
    std::ofstream(folder / (section.id + ".tex")) << to_latex(section);
    document += "\\input{" + section.id + ".tex}\n\n";
  }
  std::ofstream(folder / "all.tex") << document << "\\end{document}\n";
  const std::string command =
      "cd '" + folder.string() + "' && pdflatex -interaction=nonstopmode -halt-on-error all.tex >log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "log");
}

TEST(WithTables, ReplacesWhatStandsBetweenTheMarkersOfItsRun) {
  const std::vector<Section> sections{{.id = "one",
                                       .title = {},
                                       .text = {},
                                       .table = {{"a", "b"}, {{"x", "1"}, {"y", "2"}}},
                                       .note = {},
                                       .figures = {}}};
  const std::string document =
      "head\n<!-- table run/one y -->\nold\n<!-- /table -->\nmiddle\n<!-- table other/one -->\nold\n<!-- "
      "/table "
      "-->\ntail\n";
  const std::string expected =
      "head\n<!-- table run/one y -->\n\n| a | b |\n|---|---|\n| y | 2 |\n\n<!-- /table -->\nmiddle\n<!-- "
      "table "
      "other/one -->\nold\n<!-- /table -->\ntail\n";
  EXPECT_EQ(with_tables(document, "run", sections), expected);
  EXPECT_EQ(with_tables(expected, "run", sections), expected);
}

TEST(WithTables, RefusesWhatItCannotFillIn) {
  const std::vector<Section> none;
  EXPECT_THROW(with_tables("<!-- table run/one -->\n<!-- /table -->", "run", none), UsageError);
  EXPECT_THROW(with_tables("<!-- table run/one -->\n", "run", none), UsageError);
  try {
    with_tables("<!-- table run/one -->\ntext\n", "run", none);
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "<!-- table run/one --> (must be closed by a line <!-- /table -->)");
  }
}

TEST(WithTables, FindsNothingToDoWhereNoMarkerOrNoRowIsMeant) {
  Section section;
  section.id = "one";
  section.table = {{"a", "b"}, {{"x", "1"}}};
  const std::vector<Section> sections{section};
  const std::string document = "<!-- table run/one y -->\n<!-- /table -->\n";
  EXPECT_THROW(with_tables(document, "run", sections), NothingMatched);
  EXPECT_THROW(with_tables(document, "other", sections), NothingMatched);
}

TEST(MeasuresCsv, HasOneRowPerSceneAndContestant) {
  std::vector<Record> records{test::good_record("s", "m", "n=1", 0.05, 0.5),
                              test::good_record("s", "m", "n=2", 0.005, 1.0)};
  EXPECT_EQ(measures_csv(Evaluation(records)),
            "scene,contestant,law,standing,runs,solved,seconds_to_1e-01,seconds_to_1e-02,seconds_to_1e-03,"
            "seconds_to_1e-06,seconds_to_1e-09\n"
            "s,m,e = 1,competes,2,2,5.000000000e-01,1.000000000e+00,inf,inf,inf\n");
}

/// The line of a section's table that begins with these cells.
std::vector<std::string> row_of(const std::vector<Section>& sections, const std::string& id,
                                const std::vector<std::string>& begin) {
  for (const Section& section : sections) {
    if (section.id != id) continue;
    for (const auto& row : section.table.rows) {
      std::vector<std::string> texts;
      for (const Cell& cell : row) texts.push_back(cell.text);
      if (std::equal(begin.begin(), begin.end(), texts.begin())) return texts;
    }
  }
  return {};
}

TEST(ContestSections, SaySuccessBeforeAnyTime) {
  std::vector<Record> records;
  for (int i = 0; i < 8; ++i) {
    Record fragile = test::good_record("s" + std::to_string(i), "fragile", "n=1", 0.001, 1e-3);
    if (i >= 3) fragile.status = Status::timeout;
    records.push_back(fragile);
    records.push_back(test::good_record("s" + std::to_string(i), "robust", "n=1", 0.001, 2.0));
  }
  const std::vector<Section> sections = sections_of(Evaluation(records, {.timeout = 10.0}));
  EXPECT_EQ(row_of(sections, "time-to-error-1", {"fragile"})[1], "3 of 8");
  EXPECT_EQ(row_of(sections, "time-to-error-1", {"robust"})[1], "8 of 8, 2 s");
  const std::vector<std::string> means = row_of(sections, "means-1", {"1e-02", "fragile"});
  ASSERT_EQ(means.size(), 10U);
  EXPECT_EQ(means[2], "3 of 8");
  EXPECT_EQ(means[6], "12.5 s");  // PAR2: (3 * 1 ms + 5 * 20 s) / 8
  EXPECT_EQ(means[7], "38 %");
  EXPECT_EQ(means[9], "38 %");
}

TEST(ContestSections, CallNobodySlowWhoWasNotTimed) {
  Record record = test::good_record("s", "m", "n=1", 0.005, 1.0);
  record.seconds.reset();
  record.not_timed = "not a Release build";
  const std::vector<Section> sections = sections_of(Evaluation({record}));
  EXPECT_TRUE(row_of(sections, "time-to-error-1", {"m"}).empty());
  EXPECT_TRUE(row_of(sections, "means-1", {"1e-02"}).empty());
  EXPECT_EQ(row_of(sections, "work-1", {"1e-02", "m"})[2], "12");
  const std::vector<std::string> ladder = row_of(sections, "scenes", {"s"});
  ASSERT_EQ(ladder.size(), 9U);
  EXPECT_EQ(ladder[5], "not timed");
  EXPECT_EQ(ladder[6], "not reached");
}

TEST(ContestSections, SayWhereTheShiftDecidesTheOrder) {
  std::vector<Record> records;
  for (int i = 0; i < 4; ++i) {
    const std::string scene = "s" + std::to_string(i);
    records.push_back(test::good_record(scene, "mostly-fast", "n=1", 0.05, i < 3 ? 1e-5 : 0.5));
    records.push_back(test::good_record(scene, "even", "n=1", 0.05, 0.01));
  }
  const auto note = [&] {
    for (const Section& section : sections_of(Evaluation(records))) {
      if (section.id == "means-1") return section.note;
    }
    return std::string();
  };
  EXPECT_NE(note().find("changes with the shift at error 1e-01:"), std::string::npos) << note();
  for (Record& record : records) record.seconds->median = record.method == "even" ? 1.0 : 2.0;
  EXPECT_NE(note().find("the same with all three shifts"), std::string::npos) << note();
}

}  // namespace
}  // namespace signorini
