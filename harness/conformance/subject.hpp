#pragma once
// A method on a scene while it is checked.

#include <memory>
#include <optional>

#include "harness/plan/selection.hpp"
#include "methods/catalogue.hpp"
#include "problems/problem.hpp"

namespace signorini {

/// How a method is run where it is checked, and how far two of its answers may differ.
struct Terms {
  Settings settings = {};  ///< of a cheap resolution
  int grid = 64;  ///< answers are compared at these parts of the period: the method's own where it has a grid
  double agreement = 1e-8;  ///< of answers to equivalent problems, relative to the largest x and force [-]
  double identity = 1e-9;   ///< of one trajectory with itself at common instants, relative [-]
  double timeout = 10.0;    ///< of one solve [s]
  double patience = 1.0;    ///< from the end of the time budget to the end of the solve [s]
};

/// Its ladder; where that cannot be used, which check_declaration tells, the defaults alone.
std::vector<Settings> usable_ladder(const MethodEntry& entry);

/// Terms from what a method says of itself: the first step of its ladder, `samples` fixed where they are left
/// to it (a delay by whole steps needs a grid), and an agreement of its `tolerance` amplified by the slowest
/// decay of scenes.
Terms terms_of(const MethodEntry& entry);

/// A method on a scene, and its cold answer, which is computed once.
class Subject {
 public:
  /// \throws InvalidOption if the method refuses the settings
  Subject(const MethodEntry& entry, Problem problem, Terms terms);

  [[nodiscard]] const MethodEntry& entry() const { return entry_; }
  [[nodiscard]] const Method& method() const { return *method_; }
  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const Terms& terms() const { return terms_; }
  [[nodiscard]] const Support& support() const { return support_; }
  /// Of the scene itself, from a cold start. Only where the method applies.
  [[nodiscard]] const Solution& answer() const;
  /// Of any problem, in the time that a solve is given.
  [[nodiscard]] Solution solve(const Problem& problem, std::shared_ptr<const Trajectory> guess = {}) const;
  /// With other settings of the same method. \throws InvalidOption
  [[nodiscard]] Subject with(const Settings& settings) const;

 private:
  const MethodEntry& entry_;
  Problem problem_;
  Terms terms_;
  std::unique_ptr<Method> method_;
  Support support_;
  mutable std::optional<Solution> answer_;
};

/// Largest |x| and |gap|: the scale of displacements [m].
double displacement_scale(const Problem& problem, const Samples& samples);

/// Largest term of the load: the scale of forces [N].
double load_scale(const Problem& problem);

}  // namespace signorini
