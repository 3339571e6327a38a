#pragma once
// A method that behaves as badly as told, and motions given by formulas.

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "harness/judge/reference.hpp"
#include "harness/plan/plan.hpp"
#include "methods/catalogue.hpp"

namespace signorini::test {

enum class Behaviour {
  good,
  segfault,
  abort_now,
  exit_three,
  throw_error,
  throw_number,
  spin,
  allocate,
  not_a_number,
  ignore_sigterm,
  overflow_stack,
  lie,
  no_trajectory,
  wrong_size,
  wrong_period,
  give_up,
  obey_deadline,
  orphan,
  unsupported,
  crash_when_asked,
  crash_when_repeated,
  singular,
  waver,
  hand_back,
  carry_on  ///< serves other frequencies, but for kFatalFrequency, and says for which one it was set up
};

/// At which `carry_on` dies [rad/s].
inline constexpr double kFatalFrequency = 2.5;

/// Motion of one contact given by formulas of time; any number of contacts repeats it.
class FormulaMotion final : public Trajectory {
 public:
  using Formula = std::function<double(double)>;
  FormulaMotion(
      double period, Formula x, Formula velocity, Formula force = [](double) { return 0.0; },
      std::vector<Impulse> impulses = {}, std::optional<int> bandwidth = {}, int contacts = 1)
      : period_(period),
        x_(std::move(x)),
        velocity_(std::move(velocity)),
        force_(std::move(force)),
        impulses_(std::move(impulses)),
        bandwidth_(bandwidth),
        contacts_(contacts) {}

  [[nodiscard]] int contact_count() const override { return contacts_; }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::vector<Impulse> impulses() const override { return impulses_; }
  [[nodiscard]] std::optional<int> bandwidth() const override { return bandwidth_; }

 private:
  double period_;
  Formula x_, velocity_, force_;
  std::vector<Impulse> impulses_;
  std::optional<int> bandwidth_;
  int contacts_;
};

/// Answers with the contact-free response of a one-mass scene unless told to misbehave.
class FakeMethod final : public Method {
 public:
  static constexpr MethodText kText{.name = "fake-method",
                                    .title = "misbehaves as told",
                                    .laws = "any",
                                    .ladder = "behaviour=good|give_up"};

  struct Options {
    Behaviour behaviour = Behaviour::good;
    int level = 1;
    void visit(auto&& field) {
      field("behaviour", behaviour, "[-]", "what to do");
      field("level", level, "[-]", "does nothing");
    }
  };

  explicit FakeMethod(const Options& options) : options_(options) {}
  [[nodiscard]] std::vector<OptionEcho> options() const override { return echo_options(options_); }
  [[nodiscard]] Support supports(const Problem& problem) const override;
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const override;

 private:
  Options options_;
};

/// m = k = F = 1, d = 0.1, driven at 2 rad/s by a cosine; one stop at `gap` with restitution e.
Problem one_mass(double gap = 10.0, double e = 1.0);
Scene one_mass_scene(double gap = 10.0, double e = 1.0);

/// The contact-free motion of `one_mass`.
std::shared_ptr<const Trajectory> free_motion(const Problem& problem);

/// An orbit solver that always finds the contact-free motion.
OrbitSolver free_orbits();

/// The catalogue of fakes: only `fake-method`.
std::span<const MethodEntry> fake_catalogue();
Case fake_case(const Scene& scene, const std::string& behaviour);

/// A new empty folder of this test.
std::filesystem::path fresh_folder(const std::string& name);

}  // namespace signorini::test

namespace signorini {
template <>
struct EnumNames<test::Behaviour> {
  static constexpr std::array<std::string_view, 25> values{"good",
                                                           "segfault",
                                                           "abort_now",
                                                           "exit_three",
                                                           "throw_error",
                                                           "throw_number",
                                                           "spin",
                                                           "allocate",
                                                           "not_a_number",
                                                           "ignore_sigterm",
                                                           "overflow_stack",
                                                           "lie",
                                                           "no_trajectory",
                                                           "wrong_size",
                                                           "wrong_period",
                                                           "give_up",
                                                           "obey_deadline",
                                                           "orphan",
                                                           "unsupported",
                                                           "crash_when_asked",
                                                           "crash_when_repeated",
                                                           "singular",
                                                           "waver",
                                                           "hand_back",
                                                           "carry_on"};
};
}  // namespace signorini
