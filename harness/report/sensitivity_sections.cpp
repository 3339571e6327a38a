// How answers depend on what should not matter: a constant, the samples at fixed harmonics, the repetition.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "harness/contest/ladder.hpp"
#include "harness/report/cells.hpp"
#include "harness/report/section.hpp"
#include "harness/statistics.hpp"

namespace signorini {

namespace {

/// A method with all its settings but one: "fourier-lipschitz[harmonics=40]", and the key of that one.
using Varied = std::pair<std::string, std::string>;

/// Records by the value of what is varied, values in the order in which they ran.
struct Variation {
  std::vector<std::string> values = {};
  std::map<std::string, std::vector<const Record*>> records = {};
};

constexpr std::size_t kFewestValues = 3;

/// Every way to single out one setting while another number stands; a number alone is the method's
/// resolution.
std::map<Varied, Variation> variations_of(const Evaluation& evaluation) {
  std::map<Varied, Variation> variations;
  for (const Record& record : evaluation.records()) {
    const std::vector<std::string> settings = settings_of(record);
    for (std::size_t varied = 0; varied < settings.size(); ++varied) {
      std::vector<std::string> others = settings;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(varied));
      if (std::none_of(others.begin(), others.end(), is_numeric)) continue;
      const std::size_t equals = settings[varied].find('=');
      const std::string value = settings[varied].substr(equals + 1);
      Variation& variation = variations[{fmt::format("{}[{}]", record.method, fmt::join(others, ",")),
                                         settings[varied].substr(0, equals)}];
      std::vector<const Record*>& records = variation.records[value];
      if (records.empty()) variation.values.push_back(value);
      records.push_back(&record);
    }
  }
  std::erase_if(variations, [](const auto& entry) { return entry.second.values.size() < kFewestValues; });
  return variations;
}

/// What became of one method at one value.
struct Outcome {
  int cases = 0, solved = 0, refuted = 0;
  std::vector<double> errors = {};  // infinite where not solved
};

Outcome outcome_of(const std::vector<const Record*>& records) {
  Outcome outcome;
  for (const Record* record : records) {
    if (record->status == Status::not_applicable) continue;
    ++outcome.cases;
    const bool solved = record->status == Status::converged &&
                        record->certificate.status == CertificateStatus::certified && record->errors.x_l2;
    outcome.solved += solved ? 1 : 0;
    outcome.refuted += record->status == Status::inaccurate ? 1 : 0;
    outcome.errors.push_back(solved ? std::max(*record->errors.x_l2, measurable_error(*record))
                                    : std::numeric_limits<double>::infinity());
  }
  return outcome;
}

Cell error_cell(double error) {
  return {std::isfinite(error) ? fmt::format("{:.1e}", error) : "not solved", error};
}

}  // namespace

std::vector<Section> sensitivity_sections(const Evaluation& evaluation) {
  Section section{.id = "sensitivity", .title = "Sensitivity to one option at a time"};
  section.text =
      "The same scenes at several values of one option, the others as stated. Solved: "
      "certified answers. Errors of x against the certified orbit; a failure counts as infinite.";
  section.table.header = {"method", "option", "value", "solved", "refuted", "median error", "largest error"};
  for (const auto& [varied, variation] : variations_of(evaluation)) {
    for (const std::string& value : variation.values) {
      const Outcome outcome = outcome_of(variation.records.at(value));
      if (outcome.cases == 0) continue;
      section.table.rows.push_back(
          {varied.first, varied.second, value,
           Cell(fmt::format("{} of {}", outcome.solved, outcome.cases), outcome.solved),
           count_cell(outcome.refuted), error_cell(median(outcome.errors)),
           error_cell(*std::max_element(outcome.errors.begin(), outcome.errors.end()))});
    }
  }
  return {std::move(section)};
}

std::vector<Section> repeat_sections(const Evaluation& evaluation) {
  struct Tally {
    int cases = 0, identical = 0, solves = 0;
  };
  std::map<std::string, Tally> tallies;
  for (const Record& record : evaluation.records()) {
    if (!record.repeats) continue;
    Tally& tally = tallies[record.method];
    ++tally.cases;
    tally.solves += record.repeats->solves;
    tally.identical += record.repeats->identical == record.repeats->solves ? 1 : 0;
  }
  Section section{.id = "repeats", .title = "Repeated solves"};
  section.text =
      "Cases solved again, in the same process and in others, and those of them whose every answer had the "
      "same bits as the first.";
  section.table.header = {"method", "cases solved again", "solves compared", "same bits"};
  for (const auto& [method, tally] : tallies)
    section.table.rows.push_back(
        {method, count_cell(tally.cases), count_cell(tally.solves),
         Cell(fmt::format("{} of {}", tally.identical, tally.cases), tally.identical)});
  return {std::move(section)};
}

}  // namespace signorini
