#pragma once
// What every method of harmonic balance on the projected equations is, whatever its law and its solver.

#include <memory>
#include <optional>

#include "methods/curve.hpp"
#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/harmonic_balance/strategy.hpp"
#include "methods/method.hpp"

namespace signorini {

/// A method of harmonic balance: the scenes that it takes, the law that it represents and its way to an
/// answer (prepare_harmonic_balance) are the same for all. A preset says which law it imposes on the
/// harmonics and what it does on a grid of samples.
class ProjectedMethod : public Method {
 public:
  /// Scenes whose load its harmonics and samples carry.
  [[nodiscard]] Support supports(const Problem& problem) const override;
  /// Of each contact the scene's own if it is conservative, restitution 1 on a rigid stop; a penalty asked
  /// for replaces a spring's stiffness.
  [[nodiscard]] RepresentedLaw law(const Problem& problem) const override;
  [[nodiscard]] std::unique_ptr<PreparedMethod> prepare(const Problem& problem) const final;

 protected:
  /// \param penalty  asked for in place of a spring of the scene
  /// \throws InvalidOption
  explicit ProjectedMethod(const HarmonicOptions& common, const std::optional<Scaled>& penalty = {});

  /// What a method says of itself, with the laws and the ladder of all where it has none of its own.
  static constexpr MethodText completed(MethodText text) {
    if (text.laws.empty()) text.laws = "restitution 1; penalty; massless";
    if (text.ladder.empty()) text.ladder = "harmonics=10|40|160";
    return text;
  }

  /// The options that all share.
  [[nodiscard]] const HarmonicOptions& common() const { return common_; }
  /// What it adds for a scene, which outlives the result.
  [[nodiscard]] virtual HarmonicMethod preset(const Problem& problem) const = 0;

 private:
  HarmonicOptions common_;
  std::optional<Scaled> penalty_;
};

/// One that follows curves of its equations.
class FollowedMethod : public ProjectedMethod, public CurveMethod {
 public:
  [[nodiscard]] const CurveMethod* curve() const final { return this; }
  /// Over the frequency of the load.
  [[nodiscard]] Support follows(const ParametrisedScene& scene) const final {
    return follows_frequency(*this, scene);
  }
  /// Of its equations (series_diagram).
  [[nodiscard]] BranchDiagram follow(const ParametrisedScene& scene, const CurveLimits& limits) const final;

 protected:
  using ProjectedMethod::ProjectedMethod;

  /// With the limits, the order and the former options of all where it has none of its own, too.
  static constexpr MethodText completed(MethodText text) {
    if (text.limits.empty())
      text.limits =
          "On a rigid stop restitution 1 alone, and at impacts the error of x falls like 1/H: 10 % takes "
          "some "
          "40 harmonics, 1 % some 300. With few harmonics a solution may show impacts that no exact motion "
          "has.";
    if (!text.order) text.order = 1.0;
    if (text.former.empty()) text.former = kOptionsOfClosure;
    return ProjectedMethod::completed(text);
  }
};

/// A preset that solves each grid as a complementarity problem (lcp_grid_solver).
HarmonicMethod by_complementarity(LawAt law, const HarmonicOptions& common, ComplementaritySolver solver);

}  // namespace signorini
