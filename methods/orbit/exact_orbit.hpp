#pragma once
// An exact periodic orbit: the polish of one sequence of events, and the search for a sequence that has one.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "methods/orbit/exact_trajectory.hpp"
#include "methods/orbit/impact_orders.hpp"
#include "methods/orbit/orbit_guess.hpp"

namespace signorini {

/// Displacement that the summed rest of a chatter may leave out, over X [-]
inline constexpr double kLeftOut = 1e-9;

/// Whether a solution of the orbit equations is a motion of the scene.
struct Admissibility {
  bool ok = true;           ///< all conditions hold
  std::string reason = {};  ///< which one fails first, where
  /// Largest x_j - g_j of an open contact between events over X, or lambda_j of a closed one over its scale
  /// [-].
  double violation = 0.0;
  double weakest_impact = 0.0;  ///< smallest approach speed of an impact, relative to V; 0 without one [-]
  /// Of each event the displacement that the rest of a chatter leaves out (`left_out_by_chatter`), over X; 0
  /// where no infinite sequence of impacts ends in sticking, m [-].
  Eigen::VectorXd chatter_error = {};
  int impacts = 0;  ///< resolved
  /// Contacts of the scene that are taken for open (OpenContacts) and pass their stops, where nothing else is
  /// wrong.
  std::vector<int> reached = {};
};

/// Checks an orbit as last evaluated: between events no open contact beyond its stop, those included that are
/// taken for open throughout, and no closed one pulling (sampled at a sixteenth of the fastest period still
/// alive in the guards, local maxima polished by Newton's method, those between two samples found by where
/// the rate turns), all contacts that an event closes at their stops, approach speeds positive, impulses
/// compressive, each impact by the scene's law, all to kAdmissible in the scales of the motion. A contact
/// that stops with e > 0 is accepted as the limit of a chatter if what `left_out_by_chatter` says is less
/// than kLeftOut X, of elastic impacts 1.5 kFadedHeight X.
///
/// \param expired  asked before each arc \throws std::runtime_error if the time is up
Admissibility check_admissible(const OrbitModel& model, const OrbitGuess& orbit,
                               const OrbitEquations& equations, const Expired& expired = {});

/// What became of a sequence, from an orbit of the scene to what tells least of one.
enum class OrbitOutcome {
  converged,       ///< an admissible orbit
  chatter,         ///< an admissible orbit with a complete chatter: infinitely many impacts, then contact
  grazing,         ///< an orbit with an impact too slow to tell from none: multipliers undefined
  not_admissible,  ///< the equations hold, the contact conditions do not
  events_merge,    ///< two events of the sequence come together: there is no orbit with it nearby
  no_convergence,  ///< Newton's method failed, or no sequence was found
};

/// Lower-case words for messages and records: "converged", "not admissible", ...
std::string describe(OrbitOutcome outcome);

/// How far a polish goes.
struct PolishOptions {
  double tolerance = 1e-12;        ///< of the residual, relative to the scales of the motion [-]
  int max_iterations = 40;         ///< Newton steps
  double grazing = 1e-7;           ///< approach speed over V below which an impact grazes [-]
  bool second_evaluation = false;  ///< evaluate once more, by Green's function or exponentials
  Expired expired = {};            ///< true ends it between two events
};

/// A polished orbit, or why there is none.
struct ExactOrbit {
  OrbitOutcome outcome = OrbitOutcome::no_convergence;     ///< what became of the sequence
  std::string reason = {};                                 ///< one clause
  std::string origin = {};                                 ///< of the sequence that led here
  std::shared_ptr<const ExactTrajectory> trajectory = {};  ///< where the equations were solved
  double residual = 0.0;                                   ///< largest of the equations, in scales [-]
  double attainable = 0.0;                                 ///< round-off of the residual [-]
  /// Of the motion, relative to X: |J^-1| times the residual and its noise [-].
  double error_bar = 0.0;
  double condition = 1.0;             ///< estimate for J, in its scales; where there is a trajectory [-]
  int iterations = 0;                 ///< Newton steps
  OrbitMultipliers multipliers = {};  ///< Floquet, 2 Nd, Nc more if acting contacts relax
  Admissibility admissibility = {};   ///< where there is a trajectory

  /// An orbit of the scene stands behind this.
  [[nodiscard]] bool certified() const {
    return outcome == OrbitOutcome::converged || outcome == OrbitOutcome::chatter;
  }
  /// "largest multiplier 0.7", or what they are undefined for.
  [[nodiscard]] std::string describe_multipliers() const;
};

/// Solves the orbit equations from a guess by Newton's method. Steps are shortened so that no interval
/// between events loses more than four fifths of its length, and halved until the residual falls. Impacts
/// that have overtaken others change places, and the equations are solved again.
///
/// Converged: residual <= tolerance, or at the round-off of its evaluation (`attainable`, 32 epsilon times
/// the largest state met). The error bar is the largest row sum of |J^-1|, rows of instants weighted with the
/// speed there, times residual plus `attainable`; where a chatter ends, what its rest displaces and what
/// stops moved by as much would change besides; with `second_evaluation` no less than the distance to a
/// second evaluation: of purely impulsive orbits the motion by the periodic Green's function at 17 instants,
/// else |J^-1 r'|, r' the residual by matrix exponentials. Failures are outcomes, never exceptions.
ExactOrbit polish_sequence(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess,
                           const PolishOptions& options = {});

/// The periodic motion next to a state whose motion touches nothing, where rigid motions make it one of a
/// family: the equations are singular along these alone, their solution is that of least distance, or, where
/// that one passes a stop, the nearest one that stays 1e-3 X clear of all, and multipliers are undefined. Not
/// certified for a sequence with events, where there is no such family, or where every member meets a stop.
ExactOrbit polish_free_member(const std::shared_ptr<OrbitModel>& model, const OrbitGuess& guess,
                              const PolishOptions& options = {});

/// What a search found, and what was tried on the way.
struct OrbitSearch {
  ExactOrbit orbit;     ///< the certified one, or the attempt that came furthest
  int attempts = 0;     ///< sequences polished
  long iterations = 0;  ///< Newton steps in all
};

/// Whether a search takes motions that touch nothing where rigid motions make a family of them: not at all,
/// where it finds no other from there, or before it looks for others.
enum class FreeFamilies { refused, last, first };

/// How far a search goes.
struct SearchOptions {
  PolishOptions polish = {};                           ///< of each attempt
  int rounds = 4;                                      ///< simulations from what the polish left
  int followed = 0;                                    ///< periods marched next, for stable orbits; 0: none
  int shootings = 25;                                  ///< Newton steps of the shooting that follows; 0: none
  int marched = 0;                                     ///< periods marched on at the very end; 0: none
  FreeFamilies free_families = FreeFamilies::refused;  ///< motions that touch nothing
  std::function<bool()> expired = [] { return false; };  ///< true ends the search
};

/// Exact orbits of one scene of period Problem::period(). Idle parts of it are held (with_idle_parts_held),
/// and orbits have no multipliers then: a free part that nothing holds is nowhere at home. Not thread-safe:
/// flows are made when first needed.
class OrbitFinder {
 public:
  /// \throws std::runtime_error with flow_obstacle(problem) if there is one
  explicit OrbitFinder(const Problem& problem);
  /// `condensed` in place of condense(problem): orbits of a reduced structure.
  /// \param shared  modes known from other scenes, if any
  OrbitFinder(const Problem& problem, CondensedStructure condensed, std::shared_ptr<SharedModes> shared = {});

  /// Candidates in order, until one polishes to an admissible orbit: the sequence read off the contact force
  /// (`orbit_guess`); the one met in one period's flow from its state (`simulated_sequence`); those from the
  /// states that inadmissible solutions left, for several rounds; those met while marching (`followed`);
  /// those along Newton's method on the stroboscopic map (`find_fixed_point`, whose sequence may change at
  /// each step); those met while marching on. Motions that touch nothing, one of a family each, as
  /// `free_families` says (`polish_free_member`).
  OrbitSearch find(const Trajectory& trajectory, const SearchOptions& options = {});
  /// The same from a sequence.
  OrbitSearch find(const OrbitGuess& guess, const SearchOptions& options = {});

  /// The scene as its orbits see it.
  [[nodiscard]] const std::shared_ptr<OrbitModel>& model() const { return model_; }

 private:
  class Search;
  std::shared_ptr<OrbitModel> model_;
  bool idle_parts_held_ = false;
};

}  // namespace signorini
