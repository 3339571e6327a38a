#include "tests/harness/conformance/flawed_method.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>
#include <utility>

#include "harness/conformance/transformations.hpp"
#include "harness/plan/plan.hpp"

namespace signorini::test {

namespace {

/// What a scale that is not the scene's does to an answer: more than its tolerance, less than its error.
constexpr double kSlight = 1e-5;

void widen_gaps(Problem& problem, double share) {
  for (Contact& contact : problem.contacts) contact.gap *= 1.0 + kSlight * share;
}

/// The scene as the flawed method sees it.
Problem altered(Problem problem, Flaw flaw) {
  const int last = problem.size() - 1;
  switch (flaw) {
    case Flaw::depends_on_numbering: {
      const double first = problem.stiffness().coeff(0, 0);
      widen_gaps(problem, first / (first + 2.0 * problem.stiffness().coeff(last, last)));
      return problem;
    }
    case Flaw::depends_on_the_time_origin: {
      const ForceTerm& load = problem.force.front();
      widen_gaps(problem, std::abs(load.cos) / std::hypot(load.cos, load.sin));
      return problem;
    }
    case Flaw::depends_on_the_unit_of_force:
      widen_gaps(problem, 1.0 / (1.0 + problem.stiffness().diagonal().sum()));
      return problem;
    case Flaw::depends_on_the_unit_of_length:
      for (Contact& contact : problem.contacts) contact.gap += kSlight;
      return problem;
    case Flaw::depends_on_the_unit_of_time:
      widen_gaps(problem, 1.0 / (1.0 + problem.frequency));
      return problem;
    case Flaw::passes_through_stops:
      return with_stops_at(std::move(problem), 1e3);
    default:
      return problem;
  }
}

class PreparedFlawed final : public PreparedMethod {
 public:
  PreparedFlawed(const Method& sound, const Problem& problem, Flaw flaw)
      : problem_(altered(problem, flaw)), flaw_(flaw), sound_(sound.prepare(problem_)) {}

  Solution solve(const Start& start) override {
    ++solves_;
    if (flaw_ == Flaw::crashes_when_repeated && solves_ > 1) std::raise(SIGSEGV);
    if (flaw_ == Flaw::hangs) {
      for (;;) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (flaw_ == Flaw::ignores_its_budget && start.expired())
      std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    if (flaw_ == Flaw::gives_up) return {.verdict = Verdict::not_converged, .message = "it is too hard"};
    Solution solution = sound_->solve(start);
    if (flaw_ == Flaw::drifts && solution.trajectory)
      solution.trajectory = std::make_shared<MappedMotion>(solution.trajectory,
                                                           MotionMap{.displacement = 1.0 + 1e-9 * solves_});
    return solution;
  }

 private:
  Problem problem_;
  Flaw flaw_;
  int solves_ = 0;
  std::unique_ptr<PreparedMethod> sound_;
};

class FlawedMethod final : public Method {
 public:
  FlawedMethod(Flaw flaw, std::unique_ptr<Method> sound) : flaw_(flaw), sound_(std::move(sound)) {}

  [[nodiscard]] std::vector<OptionEcho> options() const override { return sound_->options(); }
  [[nodiscard]] Support supports(const Problem& problem) const override {
    if (flaw_ == Flaw::refuses_without_reason) return {.ok = false};
    return sound_->supports(problem);
  }
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override {
    if (flaw_ == Flaw::declares_another_law) return Restitution{0.5};
    return sound_->law(problem);
  }
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override {
    return std::make_unique<PreparedFlawed>(*sound_, problem, flaw_);
  }

 private:
  Flaw flaw_;
  std::unique_ptr<Method> sound_;
};

const MethodEntry& sound() { return find_method("fourier-lipschitz"); }

template <Flaw kFlaw>
std::unique_ptr<Method> make(std::span<const OptionSetting> settings) {
  if (kFlaw == Flaw::accepts_any_option) {
    try {
      return std::make_unique<FlawedMethod>(kFlaw, sound().make(settings));
    } catch (const InvalidOption&) {
      return std::make_unique<FlawedMethod>(kFlaw, sound().make({}));
    }
  }
  return std::make_unique<FlawedMethod>(kFlaw, sound().make(settings));
}

template <int... kFlaws>
auto makers(std::integer_sequence<int, kFlaws...>) {
  return std::array{&make<static_cast<Flaw>(kFlaws)>...};
}

}  // namespace

MethodEntry flawed_method(Flaw flaw) {
  static const auto make_flawed =
      makers(std::make_integer_sequence<int, static_cast<int>(Flaw::refuses_without_reason) + 1>());
  MethodEntry entry = sound();
  entry.name = "flawed-method";
  entry.ladder = flaw == Flaw::has_a_ladder_that_it_refuses ? "harmonics=0|40" : "harmonics=10|40";
  if (flaw == Flaw::claims_too_high_an_order) entry.order = 8.0;
  entry.make = make_flawed[static_cast<std::size_t>(flaw)];
  return entry;
}

}  // namespace signorini::test
