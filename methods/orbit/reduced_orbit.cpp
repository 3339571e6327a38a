#include "methods/orbit/reduced_orbit.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "methods/discretisation/trajectories.hpp"
#include "methods/marching/periodic_march.hpp"
#include "problems/matrix_properties.hpp"

namespace signorini {

namespace {

constexpr int kMarchedPerPeriod = 256;

ContactReduction reduced(const Problem& problem, int vectors) {
  ContactReduction reduction = reduce_to_contacts(problem, {.vectors = vectors});
  if (!reduction.obstacle.empty()) throw std::runtime_error(reduction.obstacle);
  return reduction;
}

double largest_change(const Trajectory& fine, const Trajectory& coarse) {
  constexpr int kInstants = 1024;
  const Eigen::MatrixXd x = fine.sample(kInstants).x, y = coarse.sample(kInstants).x;
  const double largest = x.cwiseAbs().maxCoeff();
  return largest > 0.0 ? (x - y).cwiseAbs().maxCoeff() / largest : 0.0;
}

}  // namespace

std::string reduction_obstacle(const Problem& problem) {
  if (std::string obstacle = march_obstacle(problem); !obstacle.empty()) return obstacle;
  const auto damping = proportional_damping(problem.mass(), problem.stiffness(), problem.damping());
  if (!damping) return "the damping is not proportional to mass and stiffness";
  if (damping->beta > 0.0 && std::holds_alternative<Penalty>(problem.law))
    return "springs on a reduced structure whose damping grows with the stiffness";
  return {};
}

ReducedPair::ReducedPair(const Problem& problem, int vectors)
    : coarse(reduced(problem, vectors)), fine(reduced(problem, static_cast<int>(coarse.vectors() * 3 / 2))) {}

ReducedOrbit find_reduced_orbit(const Problem& problem, const ReducedPair& pair,
                                const SearchOptions& options) {
  ReducedOrbit result;
  ContactMarch march(pair.coarse, march_grid(problem, kMarchedPerPeriod * problem.subharmonic));
  PeriodicMarch marched = march_to_periodic_motion(march);
  result.start = "marching, " + std::string(describe(marched.by));
  result.iterations = marched.newton_steps;
  const NodalTrajectory motion(problem.period(), std::move(marched.motion), std::move(marched.force));
  OrbitFinder coarse(problem, condensed(pair.coarse)), fine(problem, condensed(pair.fine));
  OrbitSearch found = coarse.find(motion, options);
  result.iterations += found.iterations;
  result.orbit = std::move(found.orbit);
  if (!result.orbit.certified()) return result;
  const std::shared_ptr<const Trajectory> before = result.orbit.trajectory;
  found = fine.find(*before, options);
  result.iterations += found.iterations;
  result.orbit = std::move(found.orbit);
  if (result.orbit.trajectory) result.change = largest_change(*result.orbit.trajectory, *before);
  return result;
}

}  // namespace signorini
