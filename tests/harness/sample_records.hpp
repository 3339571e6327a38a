#pragma once
// Records made by hand.

#include <string>
#include <vector>

#include "harness/records/record.hpp"
#include "harness/report/evaluation/evaluation.hpp"
#include "harness/run_folder/run_folder.hpp"

namespace signorini::test {

/// Every key present.
Record full_record();

/// A converged, certified and timed run.
Record good_record(const std::string& scene, const std::string& method, const std::string& resolution,
                   double error, double seconds);

/// One record of each status, two of converged: certified and not.
std::vector<Record> records_of_every_status();

/// Records of every status, and two methods at two resolutions on two more scenes; the last of them
/// represents another law.
std::vector<Record> records_of_a_run();

/// Methods a and b at two resolutions on s1 and s2, all solved.
std::vector<Record> records_of_two_methods();

/// A run in this folder with good records of the scene s and the method m at these resolutions.
RunFolder part_of_a_run(const std::string& path, const std::vector<std::string>& resolutions);

/// The results of these records, in their order.
CaseResults results_of(const std::vector<Record>& records);

/// All of csv_report, and of measures_csv.
std::string csv_text(const Evaluation& evaluation);
std::string measures_text(const Evaluation& evaluation);

}  // namespace signorini::test
