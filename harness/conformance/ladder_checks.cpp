#include "harness/conformance/ladder_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/conformance/fall.hpp"

namespace signorini {

namespace {

/// The command that runs one step again.
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

/// The result of one step, with the command that shows it.
CheckResult at_step(CheckResult result, const LadderRecords& ladder, std::size_t step) {
  result.why = label(ladder, step) + ": " + result.why;
  result.reproduce = solve_command(ladder, step);
  return result;
}

/// "crashed: signal 11"; the reason why a certificate refutes an answer is the certificate's.
std::string status_text(const Record& record) {
  const bool refuted = record.status == Status::inaccurate;
  const std::string& reason = refuted ? record.certificate.reason : record.message;
  return fmt::format("{}{}{}", status_name(record.status), reason.empty() ? "" : ": ", reason);
}

bool applies(const Record& record) { return record.status != Status::not_applicable; }

/// Where no step applies there is nothing to look at.
std::optional<CheckResult> why_no_record(const LadderRecords& ladder) {
  if (ladder.records.empty()) return not_applicable("there is no record");
  if (std::any_of(ladder.records.begin(), ladder.records.end(), applies)) return std::nullopt;
  return not_applicable("the method does not apply: " + ladder.records.front().message);
}

bool says_converged(const Record& record) {
  return record.status == Status::converged || record.status == Status::inaccurate ||
         record.status == Status::invalid_output;
}

bool is_certified(const Record& record) {
  return record.status == Status::converged && record.certificate.status == CertificateStatus::certified;
}

}  // namespace

CheckResult check_convergence(const LadderRecords& ladder) {
  if (auto nothing = why_no_record(ladder)) return *nothing;
  for (std::size_t i = 0; i < ladder.records.size(); ++i) {
    const Record& record = ladder.records[i];
    if (applies(record) && !says_converged(record)) return at_step(failed(status_text(record)), ladder, i);
  }
  return passed();
}

CheckResult check_certificate(const LadderRecords& ladder) {
  if (auto nothing = why_no_record(ladder)) return *nothing;
  std::optional<CheckResult> remark;
  for (std::size_t i = 0; i < ladder.records.size(); ++i) {
    const Record& record = ladder.records[i];
    if (!says_converged(record)) continue;
    if (record.status != Status::converged) return at_step(failed(status_text(record)), ladder, i);
    if (!remark && !is_certified(record))
      remark = at_step(remarked("no orbit is known to judge it by: " + record.certificate.reason), ladder, i);
  }
  if (remark) return *remark;
  const bool answered = std::any_of(ladder.records.begin(), ladder.records.end(), says_converged);
  return answered ? passed() : not_applicable("it claims nothing");
}

CheckResult check_order(const LadderRecords& ladder) {
  if (auto nothing = why_no_record(ladder)) return *nothing;
  CheckResult worst = not_applicable("no step has a certified orbit to measure its error against");
  for (const LadderBranch& branch : branches_of(ladder.ladder)) {
    std::vector<LadderStep> steps;
    double floor = 1e-9;
    for (std::size_t i = 0; i < branch.places.size(); ++i) {
      const Record& record = ladder.records[branch.places[i]];
      const Measure error = record.errors.x_l2 ? record.errors.x_l2 : record.errors.u_l2;
      if (!is_certified(record) || !error) continue;
      if (record.law && std::holds_alternative<Undetermined>(*record.law))
        return not_applicable("its law is undetermined: no orbit is the one that it approaches");
      floor = std::max(floor, measurable_error(record));
      steps.push_back({.size = branch.sizes[i], .error = *error});
    }
    if (steps.empty()) continue;
    CheckResult result = judge_fall(steps, ladder.entry.order, floor);
    if (result.outcome == CheckOutcome::failed) return at_step(result, ladder, branch.places.back());
    worst = std::move(result);
  }
  return worst;
}

std::span<const LadderCheck> ladder_checks() {
  static const std::array checks{
      LadderCheck{"convergence", "converges at every step of its ladder", check_convergence},
      LadderCheck{"certificate", "claims nothing that the harness refutes", check_certificate},
      LadderCheck{"order", "errs less and less along its ladder, as fast as it declares", check_order},
  };
  return checks;
}

}  // namespace signorini
