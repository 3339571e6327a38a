#pragma once
// Where trajectories from several starts go, for each value of a number of the scene: the bifurcation diagram
// by brute force.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/motion/long_motion.hpp"
#include "harness/records/record.hpp"
#include "harness/table.hpp"
#include "methods/continuation/interval_gaps.hpp"
#include "methods/curve.hpp"

namespace signorini {

/// What some of the starts go to. Periodic motions and states of rest are told apart by order and extremes of
/// x, within 1e-5 of the largest; irregular ones are not.
struct Attractor {
  LongRun verdict = LongRun::undecided;
  int order = 0;                                 ///< forcing periods per period; 0 unless periodic
  int starts = 0;                                ///< that go there
  double share = 0.0;                            ///< of all starts
  bool from_rest = false;                        ///< one of them is rest
  std::vector<double> least = {}, largest = {};  ///< x of each contact [m]
  /// x of the contact that moves most at t = 0 of forcing periods [m]
  std::vector<double> once_a_period = {};
  std::string reason = {};              ///< of the first start that is undecided
  std::vector<OrbitEvent> events = {};  ///< of one period, unless it is irregular
  std::vector<bool> pushing = {};       ///< contacts that push throughout, likewise
  /// Whether a branch passes through it, once `off_branches` has looked.
  std::optional<bool> on_branch = {};

  /// Half of largest less least x of the contact that moves most [m].
  [[nodiscard]] double amplitude() const;
};

/// Those at one value.
struct AttractorsAt {
  double value = 0.0;                      ///< of the parameter, in its unit
  int starts = 0;                          ///< followed
  std::vector<Attractor> attractors = {};  ///< the most starts first
  std::string failure = {};                ///< why there are none
};

/// How they are looked for.
struct AttractorOptions {
  int starts = 10;        ///< from rest and from random states, those of `motion`; >= 1
  int jobs = 1;           ///< values computed at the same time, in processes of their own
  double timeout = 10.0;  ///< processor time of all starts at one value [s]
};

/// Follows the motions (`follow_long_motion`) at each of the values. Ends early after an interrupt: values
/// without starts are then left out.
/// \param on_done  called as soon as a value is done
std::vector<AttractorsAt> attractors_over(const ParametrisedScene& scene, const std::vector<double>& values,
                                          const AttractorOptions& options,
                                          const std::function<void()>& on_done = {});

/// The periodic motions and states of rest among them, of at most `max_order` forcing periods, as beginnings
/// of branches (CurveLimits::begin_at).
std::vector<KnownMotion> motions_of(const ParametrisedScene& scene, const std::vector<AttractorsAt>& all,
                                    int max_order);

/// Says of each of these whether a branch passes through it: has a point at the value, of its order, whose
/// largest x and amplitude of each contact are its own to 1e-5 of the largest. Returns those through which
/// none passes in words: "at 2.31 rad/s 5 of 24 starts settle to a motion of 3 periods that lies on no
/// branch". \param branches  with points at the values (CurveLimits::at) \param unit  of the values
/// \param max_order  of the branches
std::vector<std::string> off_branches(std::vector<AttractorsAt>& all, const std::vector<Branch>& branches,
                                      const std::string& unit, int max_order);

/// What starts at rest go to in the middle of parts of the interval, the widest three, in words: "at 85.5
/// rad/s the motion from rest is irregular". \param unit  of the parameter \param timeout  processor time of
/// all [s]
std::vector<std::string> motions_from_rest(const ParametrisedScene& scene, std::vector<ParameterRange> parts,
                                           const std::string& unit, double timeout);

/// A row for each attractor. \param parameter  the title of the first column
Table attractor_table(const std::vector<AttractorsAt>& all, const std::string& parameter);

/// Keys `value`, `starts`, `failure` and `attractors`, a list with `verdict`, `order`, `starts`, `share`,
/// `from_rest`, `x_min`, `x_max`, `once_a_period`, `events`, `pushing`, `reason`, `on_branch`; null where
/// there is none.
nlohmann::ordered_json to_json(const AttractorsAt& at);

}  // namespace signorini
