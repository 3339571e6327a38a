#include "harness/conformance/resolution_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "harness/judge/measures/motion.hpp"

namespace signorini {

namespace {

std::optional<double> positive_number(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !(number > 0.0)) return std::nullopt;
  return number;
}

std::string words_of(const Settings& settings) {
  std::string words;
  for (const OptionSetting& setting : settings) {
    if (positive_number(setting.second)) continue;
    words += (words.empty() ? "" : ",") + setting.first + "=" + setting.second;
  }
  return words;
}

/// The key of the only number that varies between the settings, empty if there are none or several.
std::string varying_key(const std::vector<Settings>& ladder, const std::vector<std::size_t>& places) {
  std::map<std::string, std::set<double>> values;
  for (const std::size_t place : places) {
    for (const OptionSetting& setting : ladder[place]) {
      if (const auto number = positive_number(setting.second)) values[setting.first].insert(*number);
    }
  }
  std::string key;
  for (const auto& [name, numbers] : values) {
    if (numbers.size() < 2) continue;
    if (!key.empty()) return {};
    key = name;
  }
  return key;
}

double value_of(const Settings& settings, const std::string& key) {
  for (const OptionSetting& setting : settings) {
    if (setting.first == key) return positive_number(setting.second).value_or(1.0);
  }
  return 1.0;
}

void add_sizes(const std::vector<Settings>& ladder, ResolutionSeries& series) {
  const std::string key = varying_key(ladder, series.places);
  if (key.empty()) {
    for (std::size_t i = 0; i < series.places.size(); ++i)
      series.sizes.push_back(1.0 / static_cast<double>(i + 1));
    return;
  }
  const bool grows =
      value_of(ladder[series.places.front()], key) < value_of(ladder[series.places.back()], key);
  for (const std::size_t place : series.places) {
    const double value = value_of(ladder[place], key);
    series.sizes.push_back(grows ? 1.0 / value : value);
  }
}

/// The command that runs a step of the ladder again.
std::string solve_command(const LadderRecords& ladder, std::size_t step) {
  const Record& record = ladder.records[step];
  std::string command = fmt::format("signorini solve {} --method {}", record.scene, record.method);
  for (const OptionSetting& setting : ladder.ladder[step])
    command += fmt::format(" --set {}={}", setting.first, setting.second);
  return command;
}

std::string label(const LadderRecords& ladder, std::size_t step) {
  return MethodChoice{&ladder.entry, ladder.ladder[step]}.label();
}

/// The result of a step with the label of the step and the command that shows it.
CheckResult at_step(CheckResult result, const LadderRecords& ladder, std::size_t step) {
  result.why = label(ladder, step) + ": " + result.why;
  result.reproduce = solve_command(ladder, step);
  return result;
}

/// Status and reason, "crashed: signal 11". The certificate gives the reason of its refusal.
std::string status_text(const Record& record) {
  const bool refuted = record.status == Status::inaccurate;
  const std::string& reason = refuted ? record.certificate.reason : record.message;
  return fmt::format("{}{}{}", status_name(record.status), reason.empty() ? "" : ": ", reason);
}

bool applies(const Record& record) { return record.status != Status::not_applicable; }

/// The result of a check that needs a record, if the method applies at no step.
std::optional<CheckResult> unless_recorded(const LadderRecords& ladder) {
  if (ladder.records.empty()) return not_applicable("there is no record");
  if (std::ranges::any_of(ladder.records, applies)) return std::nullopt;
  return not_applicable("the method does not apply: " + ladder.records.front().message);
}

bool says_converged(const Record& record) {
  return record.status == Status::converged || record.status == Status::inaccurate ||
         record.status == Status::invalid_output;
}

/// Errors below this are round-off, whatever the orbit is known to [-].
constexpr double kErrorFloor = 1e-9;

/// Which of two results of one check stands: the higher one.
int severity(CheckOutcome outcome) {
  constexpr std::array kSeverities{1, 2, 0, 3};  // in the order of CheckOutcome
  return kSeverities.at(static_cast<std::size_t>(outcome));
}

/// Whether an orbit is known to measure its error against: its own, or one that is near.
bool has_orbit(const Record& record) {
  return claim_of(record) == Claim::certified || (claim_of(record) == Claim::unproven && record.errors.x_l2);
}

}  // namespace

std::vector<ResolutionSeries> resolution_series(const std::vector<Settings>& ladder) {
  std::vector<ResolutionSeries> found;
  for (std::size_t place = 0; place < ladder.size(); ++place) {
    const std::string words = words_of(ladder[place]);
    const auto known =
        std::ranges::find_if(found, [&](const ResolutionSeries& series) { return series.words == words; });
    (known == found.end() ? found.emplace_back(ResolutionSeries{.words = words}) : *known)
        .places.push_back(place);
  }
  for (ResolutionSeries& series : found) add_sizes(ladder, series);
  return found;
}

std::optional<double> observed_order(const std::vector<ResolutionStep>& steps) {
  if (steps.size() < 2) return std::nullopt;
  const double refinement = steps.front().size / steps.back().size;
  if (!(refinement > 1.0) || !(steps.front().error > 0.0) || !(steps.back().error > 0.0)) return std::nullopt;
  // error = C h^p at both ends, so p = log(e_1 / e_n) / log(h_1 / h_n).
  return std::log(steps.front().error / steps.back().error) / std::log(refinement);
}

CheckResult check_error_decay(const std::vector<ResolutionStep>& steps, std::optional<double> order,
                              double floor) {
  if (steps.empty()) return not_applicable("there is no error to judge");
  const double first = steps.front().error, last = steps.back().error;
  // Below the floor round-off or the error bar is measured, not the method: no order can be asked for.
  if (last <= floor) return passed();
  if (steps.size() < 2) return not_applicable(fmt::format("a single error, {:.1e}, says nothing", last));
  const std::optional<double> observed = observed_order(steps);
  if (order && observed) {
    if (*observed >= kOrderShare * *order) return passed();
    return failed(fmt::format("the error goes from {:.1e} to {:.1e}: order {:.2f}, and {:g} is declared",
                              first, last, *observed, *order));
  }
  if (last <= kErrorRatio * first) return passed();
  return failed(fmt::format("the error goes from {:.1e} to {:.1e} along the ladder (must at least halve)",
                            first, last));
}

CheckResult check_convergence(const LadderRecords& ladder) {
  if (auto nothing = unless_recorded(ladder)) return *nothing;
  for (std::size_t i = 0; i < ladder.records.size(); ++i) {
    const Record& record = ladder.records[i];
    if (applies(record) && !says_converged(record)) return at_step(failed(status_text(record)), ladder, i);
  }
  return passed();
}

CheckResult check_certificate(const LadderRecords& ladder) {
  if (auto nothing = unless_recorded(ladder)) return *nothing;
  std::optional<CheckResult> remark;
  for (std::size_t i = 0; i < ladder.records.size(); ++i) {
    const Record& record = ladder.records[i];
    if (!says_converged(record)) continue;
    if (record.status != Status::converged) return at_step(failed(status_text(record)), ladder, i);
    if (!remark && !has_orbit(record))
      remark = at_step(remarked("no orbit is known to judge it by: " + record.certificate.reason), ladder, i);
  }
  if (remark) return *remark;
  const bool answered = std::ranges::any_of(ladder.records, says_converged);
  return answered ? passed() : not_applicable("it claims nothing");
}

CheckResult check_order(const LadderRecords& ladder) {
  if (auto nothing = unless_recorded(ladder)) return *nothing;
  CheckResult worst = not_applicable("no step has an orbit to measure its error against");
  const auto worsen = [&worst](CheckResult result) {
    if (severity(result.outcome) > severity(worst.outcome)) worst = std::move(result);
  };
  for (const ResolutionSeries& series : resolution_series(ladder.ladder)) {
    std::vector<ResolutionStep> steps;
    double floor = 0.0;                     // of the finest step
    const std::size_t* unjudged = nullptr;  // place of the last claim without an orbit
    for (std::size_t i = 0; i < series.places.size(); ++i) {
      const Record& record = ladder.records[series.places[i]];
      const Measure error = record.errors.x_l2 ? record.errors.x_l2 : record.errors.u_l2;
      if (!has_orbit(record) || !error) {
        if (says_converged(record)) unjudged = &series.places[i];
        continue;
      }
      unjudged = nullptr;
      if (record.law && std::holds_alternative<Undetermined>(*record.law))
        return not_applicable("its law is undetermined: no orbit is the one that it approaches");
      floor = std::max(kErrorFloor, measurable_error(record));
      steps.push_back({.size = series.sizes[i], .error = *error});
    }
    if (steps.empty()) continue;
    CheckResult result = check_error_decay(steps, ladder.entry.order, floor);
    if (result.outcome == CheckOutcome::failed) return at_step(result, ladder, series.places.back());
    worsen(std::move(result));
    if (unjudged)
      worsen(at_step(remarked("a finer step than those judged has no orbit to measure its error against"),
                     ladder, *unjudged));
  }
  return worst;
}

}  // namespace signorini
