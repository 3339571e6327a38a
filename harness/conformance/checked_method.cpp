#include "harness/conformance/checked_method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "harness/failure.hpp"
#include "harness/judge/measures/motion.hpp"
#include "harness/plan/deadline.hpp"
#include "harness/run/trial.hpp"

namespace signorini {

namespace {

/// Assumed bound of 1 / (1 - |multiplier|) on all scenes: what a solve leaves of its periodicity condition,
/// times this, is the error of its orbit.
constexpr double kAmplification = 2000.0;
constexpr int kCoarsestGrid = 128;
constexpr int kCoarsestOwn = 16;

/// The value of a numerical option; empty if the method has none of this name.
std::optional<double> number_of(const Method& method, std::string_view name) {
  const std::vector<OptionEcho> options = method.options();
  const OptionValue* value = value_of(options, name);
  return value == nullptr ? std::nullopt : as_number(*value);
}

/// Whether the method has this option and chooses its value itself ("auto").
bool chooses_itself(const Method& method, std::string_view name) {
  const std::vector<OptionEcho> options = method.options();
  const OptionValue* value = value_of(options, name);
  return value != nullptr && std::holds_alternative<std::monostate>(*value);
}

/// The coarsest number of `samples` that the method accepts with these settings.
std::optional<int> fixed_grid(const MethodEntry& entry, const Settings& settings) {
  for (int samples = kCoarsestGrid; samples <= kGrid; samples *= 2) {
    Settings fixed = settings;
    fixed.emplace_back("samples", std::to_string(samples));
    try {
      (void)entry.make(fixed);
      return samples;
    } catch (const InvalidOption&) {  // too few for these settings
    }
  }
  return std::nullopt;
}

/// Number of instants per period of the method's own grid: its `samples`, or the whole number that its ladder
/// refines, whether it is called steps or nodes.
std::optional<int> own_grid(const Method& method, const Settings& resolution) {
  std::vector<std::string> names{"samples"};
  for (const OptionSetting& setting : resolution) names.push_back(setting.first);
  for (const std::string& name : names) {
    const std::optional<double> number = number_of(method, name);
    if (number && *number >= kCoarsestOwn && *number <= kGrid && *number == std::floor(*number))
      return static_cast<int>(*number);
  }
  return std::nullopt;
}

}  // namespace

const OptionValue* value_of(const std::vector<OptionEcho>& options, std::string_view name) {
  const auto found = std::ranges::find(options, name, &OptionEcho::name);
  return found == options.end() ? nullptr : &found->value;
}

std::optional<double> as_number(const OptionValue& value) {
  if (const auto* whole = std::get_if<long>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

std::vector<Settings> usable_ladder(const MethodEntry& entry) {
  try {
    std::vector<Settings> ladder = ladder_of(entry);
    for (const Settings& settings : ladder) (void)entry.make(settings);
    if (!ladder.empty()) return ladder;
  } catch (const UsageError&) {
  } catch (const InvalidOption&) {
  }
  return {Settings{}};
}

CheckSettings check_settings_of(const MethodEntry& entry) {
  CheckSettings result;
  result.resolution = usable_ladder(entry).front();
  if (chooses_itself(*entry.make(result.resolution), "samples")) {
    if (const std::optional<int> samples = fixed_grid(entry, result.resolution))
      result.resolution.emplace_back("samples", std::to_string(*samples));
  }
  const std::unique_ptr<Method> method = entry.make(result.resolution);
  result.grid = own_grid(*method, result.resolution).value_or(result.grid);
  if (const auto tolerance = number_of(*method, "tolerance"))
    // A periodicity defect of `tolerance` moves the orbit by up to 1 / (1 - |multiplier|) times as much.
    result.agreement = std::clamp(kAmplification * *tolerance, result.agreement, 0.1);
  return result;
}

Solution solve_or_stopped(PreparedMethod& prepared, const Start& start) try {
  return prepared.solve(start);
} catch (const SolveFailure& failure) {
  if (failure.status != Status::timeout) throw;
  return {.message = failure.what()};
}

CheckedMethod::CheckedMethod(const MethodEntry& entry, Problem problem, CheckSettings settings)
    : entry_(entry),
      problem_(std::move(problem)),
      settings_(std::move(settings)),
      method_(entry.make(settings_.resolution)),
      support_(method_->supports(problem_)) {}

const Solution& CheckedMethod::answer() const {
  if (!answer_) answer_ = solve(problem_);
  return *answer_;
}

Solution CheckedMethod::solve(const Problem& problem, std::shared_ptr<const Trajectory> guess) const {
  const std::unique_ptr<PreparedMethod> prepared = method_->prepare(problem);
  return solve_or_stopped(*prepared,
                          {.guess = std::move(guess), .deadline = Deadline::after(settings_.timeout)});
}

CheckedMethod CheckedMethod::with(const Settings& resolution) const {
  CheckSettings settings = settings_;
  settings.resolution = resolution;
  return {entry_, problem_, settings};
}

std::optional<CheckResult> unless_supported(const CheckedMethod& checked) {
  if (checked.support().ok) return std::nullopt;
  return not_applicable("the method does not apply: " + checked.support().reason);
}

std::optional<CheckResult> unless_answered(const CheckedMethod& checked) {
  if (auto refusal = unless_supported(checked)) return refusal;
  const Solution& answer = checked.answer();
  if (answer.verdict != Verdict::converged) return not_applicable("there is no answer: " + answer.message);
  if (!answer.trajectory) return not_applicable("the answer has no trajectory");
  return std::nullopt;
}

double displacement_scale(const Problem& problem, const Samples& samples) {
  double scale = std::numeric_limits<double>::min();
  if (samples.x.size() > 0) scale = std::max(scale, samples.x.cwiseAbs().maxCoeff());
  for (const Contact& contact : problem.contacts) scale = std::max(scale, std::abs(contact.gap));
  return scale;
}

double load_scale(const Problem& problem) {
  double scale = std::numeric_limits<double>::min();
  for (const ForceTerm& term : problem.force)
    scale = std::max(scale, std::abs(force_amplitude(term, problem.frequency)));
  return scale;
}

}  // namespace signorini
