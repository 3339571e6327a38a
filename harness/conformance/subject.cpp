#include "harness/conformance/subject.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "harness/failure.hpp"

namespace signorini {

namespace {

constexpr double kSmallest = std::numeric_limits<double>::min();
/// A perturbation dies out in so many periods that what a solve leaves is multiplied by this.
constexpr double kAmplification = 2000.0;
constexpr int kCoarsestGrid = 128;
constexpr int kFinestGrid = 8192;
constexpr int kCoarsestOwn = 16;

/// The value of an option as a number, if it is there and is one.
std::optional<double> number_of(const Method& method, std::string_view name) {
  for (const OptionEcho& option : method.options()) {
    if (option.name != name) continue;
    if (const auto* whole = std::get_if<long>(&option.value)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&option.value)) return *number;
  }
  return std::nullopt;
}

bool leaves_to_itself(const Method& method, std::string_view name) {
  const std::vector<OptionEcho> options = method.options();
  return std::any_of(options.begin(), options.end(), [&](const OptionEcho& option) {
    return option.name == name && std::holds_alternative<std::monostate>(option.value);
  });
}

/// The coarsest grid that the method accepts beside its settings.
std::optional<int> fixed_grid(const MethodEntry& entry, const Settings& settings) {
  for (int samples = kCoarsestGrid; samples <= kFinestGrid; samples *= 2) {
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

/// The number of instants that the method computes at, as far as it tells: its `samples`, or the whole number
/// that its ladder refines, be it called steps or nodes.
std::optional<int> own_grid(const Method& method, const Terms& terms) {
  std::vector<std::string> names{"samples"};
  for (const OptionSetting& setting : terms.settings) names.push_back(setting.first);
  for (const std::string& name : names) {
    const std::optional<double> number = number_of(method, name);
    if (number && *number >= kCoarsestOwn && *number <= kFinestGrid && *number == std::floor(*number))
      return static_cast<int>(*number);
  }
  return std::nullopt;
}

}  // namespace

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

Terms terms_of(const MethodEntry& entry) {
  Terms terms;
  terms.settings = usable_ladder(entry).front();
  if (leaves_to_itself(*entry.make(terms.settings), "samples")) {
    if (const std::optional<int> samples = fixed_grid(entry, terms.settings))
      terms.settings.emplace_back("samples", std::to_string(*samples));
  }
  const std::unique_ptr<Method> method = entry.make(terms.settings);
  terms.grid = own_grid(*method, terms).value_or(terms.grid);
  if (const auto tolerance = number_of(*method, "tolerance"))
    terms.agreement = std::clamp(kAmplification * *tolerance, terms.agreement, 0.1);
  return terms;
}

Subject::Subject(const MethodEntry& entry, Problem problem, Terms terms)
    : entry_(entry),
      problem_(std::move(problem)),
      terms_(std::move(terms)),
      method_(entry.make(terms_.settings)),
      support_(method_->supports(problem_)) {}

const Solution& Subject::answer() const {
  if (!answer_) answer_ = solve(problem_);
  return *answer_;
}

Solution Subject::solve(const Problem& problem, std::shared_ptr<const Trajectory> guess) const {
  const auto limit = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(terms_.timeout));
  const std::unique_ptr<PreparedMethod> prepared = method_->prepare(problem);
  return prepared->solve({.guess = std::move(guess), .deadline = std::chrono::steady_clock::now() + limit});
}

Subject Subject::with(const Settings& settings) const {
  Terms terms = terms_;
  terms.settings = settings;
  return {entry_, problem_, terms};
}

double displacement_scale(const Problem& problem, const Samples& samples) {
  double scale = kSmallest;
  if (samples.x.size() > 0) scale = std::max(scale, samples.x.cwiseAbs().maxCoeff());
  for (const Contact& contact : problem.contacts) scale = std::max(scale, std::abs(contact.gap));
  return scale;
}

double load_scale(const Problem& problem) {
  double scale = kSmallest;
  for (const ForceTerm& term : problem.force) scale = std::max(scale, std::hypot(term.cos, term.sin));
  return scale;
}

}  // namespace signorini
