// Pages show what is committed in results/, digit by digit.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "harness/files.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/report.hpp"
#include "harness/run_folder/run_folder.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini::readme_test {
namespace {

TEST(Readme, ShowsTheTablesOfTheCommittedRecords) {
  const std::filesystem::path root = test::data_folder() / "../..";
  for (const std::string run : {"article", "catalogue", "hard", "responses", "structures"}) {
    const std::filesystem::path folder = root / "results" / run;
    const Evaluation evaluation = evaluation_of_run(folder, limits_of_run(folder));
    const std::vector<Section> sections = document_sections(run, evaluation);
    for (const char* page : {"README.md", "docs/results.md", "docs/methods.md"}) {
      const std::string text = read_file(root / page);
      if (text.find("<!-- table " + run + "/") == std::string::npos) continue;
      EXPECT_EQ(with_tables(text, run, sections), text)
          << "signorini report results/" << run << " --into " << page << " brings it up to date";
    }
  }
}

TEST(Readme, ShowsTheVerdictAndTheResultsEveryTable) {
  const std::filesystem::path root = test::data_folder() / "../..";
  EXPECT_NE(read_file(root / "README.md").find("<!-- table catalogue/verdict -->\n\n| scenes"),
            std::string::npos);
  const std::string results = read_file(root / "docs/results.md");
  for (const char* table :
       {"catalogue/screen", "catalogue/summary", "article/time-to-error-1", "hard/breakdown-1e-01"})
    EXPECT_NE(results.find(std::string("<!-- table ") + table + " -->"), std::string::npos) << table;
}

}  // namespace
}  // namespace signorini::readme_test
