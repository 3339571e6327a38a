#pragma once
// The least that makes a method: a mass that stands still, and says so.

#include "methods/plugin/plugin.hpp"

namespace tiny {

class Standstill final : public signorini::Trajectory {
 public:
  explicit Standstill(const signorini::Problem& problem)
      : contacts_(problem.contact_count()), period_(problem.period()) {}
  [[nodiscard]] int contact_count() const override { return contacts_; }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] signorini::Samples sample(int count) const override {
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, contacts_);
    return {zero, zero, zero};
  }

 private:
  int contacts_;
  double period_;
};

/// The one option.
struct Options {
  int level = 1;
  void visit(auto&& field) { field("level", level, "[-]", "1..3"); }
};

/// What the methods of this folder have in common; `Solve` makes a Solution of a Problem.
template <class Solve>
class Method : public signorini::Method {
 public:
  using Options = tiny::Options;
  explicit Method(const Options& options) : options_(options) {
    signorini::require_option(options.level >= 1 && options.level <= 3, "level", options.level,
                              "must be in 1..3");
  }
  [[nodiscard]] std::vector<signorini::OptionEcho> options() const override {
    return signorini::echo_options(options_);
  }
  [[nodiscard]] signorini::Support supports(const signorini::Problem&) const override { return {}; }
  [[nodiscard]] signorini::RepresentedLaw law(const signorini::Problem& problem) const override {
    return std::visit([](const auto& held) -> signorini::RepresentedLaw { return held; }, problem.law());
  }
  [[nodiscard]] std::unique_ptr<signorini::PreparedMethod> prepare(
      const signorini::Problem& problem) const override {
    return std::make_unique<Prepared>(problem);
  }

 private:
  class Prepared final : public signorini::PreparedMethod {
   public:
    explicit Prepared(const signorini::Problem& problem) : problem_(problem) {}
    signorini::Solution solve(const signorini::Start&) override { return Solve{}(problem_); }

   private:
    const signorini::Problem& problem_;
  };

  Options options_;
};

/// What they say of themselves but for the name.
constexpr signorini::MethodText text_of(std::string_view name) {
  return {.name = name, .title = "A method for tests", .laws = "restitution 0..1", .ladder = "level=1|2"};
}

struct StandStill {
  signorini::Solution operator()(const signorini::Problem& problem) const {
    return {.verdict = signorini::Verdict::converged, .trajectory = std::make_shared<Standstill>(problem)};
  }
};

}  // namespace tiny
