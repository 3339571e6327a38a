// The README shows what is committed in results/, digit by digit.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "harness/files.hpp"
#include "harness/records/record_store.hpp"
#include "harness/records/run_folder.hpp"
#include "harness/report/formats/formats.hpp"
#include "harness/report/report.hpp"
#include "tests/support/data_folder.hpp"

namespace signorini {
namespace {

TEST(Readme, ShowsTheTablesOfTheCommittedRecords) {
  const std::filesystem::path root = test::data_folder() / "../..";
  const std::string readme = read_file(root / "README.md");
  for (const std::string run : {"article", "hard", "quick"}) {
    const std::filesystem::path folder = root / "results" / run;
    ASSERT_NE(readme.find("<!-- table " + run + "/"), std::string::npos);
    const Evaluation evaluation(read_records(folder / "records.jsonl"), limits_of_run(folder));
    EXPECT_EQ(with_tables(readme, run, document_sections(run, evaluation)), readme)
        << "signorini report results/" << run << " --into README.md brings it up to date";
  }
}

}  // namespace
}  // namespace signorini
