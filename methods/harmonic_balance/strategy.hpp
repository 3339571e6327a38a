#pragma once
// How a method of harmonic balance solves a scene: the list of its attempts.

#include <functional>
#include <memory>
#include <utility>

#include "methods/harmonic_balance/harmonic_setup.hpp"
#include "methods/method.hpp"

namespace signorini {

/// A solve with some number of harmonics.
struct HarmonicSolve {
  Solution solution = {};          ///< the answer, or the best iterate
  bool harmonics_may_help = true;  ///< more of them, where this did not converge
};

/// A solution of the projected equations, its impacts as the series has them: restitution 1 on rigid stops
/// (docs/theory.md, section 3). Each attempt is asked only where those before it gave nothing; the message
/// says which one found it. Always gives an answer or the best iterate, its work apart: that is added to
/// `work`.
Solution solve_series(const HarmonicSetup& setup, const Start& start, Work& work);

/// Solves a scene with the harmonics of its setup: the projected equations, by solve_series. A method whose
/// equations have more in them derives from it.
class HarmonicSolver {
 public:
  /// A solver of this scene by these options; throws nothing.
  explicit HarmonicSolver(HarmonicSetup setup) : setup_(std::move(setup)) {}
  virtual ~HarmonicSolver() = default;
  HarmonicSolver(const HarmonicSolver&) = delete;  // its parts refer to the setup
  HarmonicSolver& operator=(const HarmonicSolver&) = delete;

  /// The scene, its options and its linear part, for as long as the solver lives.
  [[nodiscard]] const HarmonicSetup& setup() const { return setup_; }
  /// One solve with these harmonics and its work. Without contacts the linear response.
  HarmonicSolve solve(const Start& start);

 private:
  /// The same where there are contacts; the effort is added to `work`.
  virtual HarmonicSolve solve_contacts(const Start& start, Work& work);

  HarmonicSetup setup_;
};

/// What solves a scene that is set up.
using MakeHarmonicSolver = std::function<std::unique_ptr<HarmonicSolver>(HarmonicSetup setup)>;

/// A scene prepared for a method of harmonic balance, with the harmonics that the options ask for. Where
/// these and all that depends on them are left to the method, harmonics are doubled, up to 640, until two
/// answers agree within 5 % (refined_until_agreed): one that no other number of harmonics confirms is not
/// claimed. The answer with H harmonics is that of `harmonics` = H.
///
/// Every answer that is claimed solves the projected equations of the method to its tolerance; the message
/// says how it was found. `problem` must outlive the result.
/// \param method_for  called once, with the problem to be solved: each stop of `problem` stands in it once
/// \throws std::runtime_error if the structure cannot be factorised
std::unique_ptr<PreparedMethod> prepare_harmonic_balance(const Problem& problem,
                                                         const HarmonicOptions& options,
                                                         const HarmonicMethodFor& method_for);

/// The same for a method with a solver of its own. \param make_solver  called for each number of harmonics
std::unique_ptr<PreparedMethod> prepare_harmonic_balance(const Problem& problem,
                                                         const HarmonicOptions& options,
                                                         const HarmonicMethodFor& method_for,
                                                         const MakeHarmonicSolver& make_solver);

}  // namespace signorini
