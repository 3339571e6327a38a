#include "methods/orbit/family/orbit_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "methods/structure/rigid_motions.hpp"
#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/skew_parts.hpp"

namespace signorini {

namespace {

// The scene as its orbits are isolated.
Problem held(const Problem& problem) { return with_idle_parts_held(problem).value_or(problem); }

// Along motions that no contact feels one point of a curve is as good as another.
std::string free_motion_obstacle(const Problem& problem) {
  if (rigid_motions(problem).cols() == 0) return {};
  if (std::string unbalanced = unbalanced_mean_load(problem); !unbalanced.empty()) return unbalanced;
  const Eigen::MatrixXd motions = rigid_motions(held(problem));
  if (motions.cols() == 0 || problem.contacts.empty()) return {};
  if (felt_first(problem, motions).felt == motions.cols()) return {};
  return "parts that contacts alone tie together may be anywhere as one: hold one of them by a weak spring";
}

}  // namespace

std::string continuation_obstacle(const Problem& problem) {
  if (problem.size() > kMostAlongCurves)
    return fmt::format("{} coordinates are more than {}", problem.size(), kMostAlongCurves);
  const bool loses =
      problem.damping().norm() > 0.0 || std::ranges::any_of(problem.contacts, [](const Contact& contact) {
        const auto* law = std::get_if<Restitution>(&contact.law);
        return law != nullptr && law->e < 1.0;
      });
  if (highest_load_harmonic(problem) == 0 && loses) return "without a periodic load it comes to rest";
  if (std::string obstacle = free_motion_obstacle(problem); !obstacle.empty()) return obstacle;
  return flow_obstacle(problem);
}

OrbitFamily::OrbitFamily(ParametrisedScene scene, const CurveUnits& units, std::shared_ptr<SharedModes> modes)
    : scene_(std::move(scene)), units_(units), modes_(std::move(modes)) {
  const Problem problem = scene_.at(scene_.middle());
  driven_ = highest_load_harmonic(problem) > 0;
  if (scene_.parameter == kFrequency && !load_grows(problem) && !follows_speed(problem))
    middle_ = std::make_unique<OrbitModel>(held(problem), modes_);
}

OrbitFamily::OrbitFamily(ParametrisedScene scene) : OrbitFamily(std::move(scene), CurveUnits{}) {
  units_.parameter = (scene_.high() - scene_.low()) / 3.0;
  units_.displacement = typical_displacement();
  units_.velocity = units_.displacement * model(scene_.middle())->dynamics.structure().frequency;
}

std::shared_ptr<OrbitModel> OrbitFamily::model(double parameter) {
  constexpr std::size_t kKept = 4;  // a point, its neighbour for the derivative, and those before
  const auto found = std::find_if(recent_.begin(), recent_.end(),
                                  [&](const auto& entry) { return entry.first == parameter; });
  if (found != recent_.end()) {
    recent_.splice(recent_.begin(), recent_, found);
  } else {
    recent_.emplace_front(parameter, middle_
                                         ? std::make_shared<OrbitModel>(*middle_, parameter, modes_)
                                         : std::make_shared<OrbitModel>(held(scene_.at(parameter)), modes_));
    if (recent_.size() > kKept) recent_.pop_back();
  }
  return recent_.front().second;
}

// Coarse units do no harm, phases and parameter still bound the steps; fine ones cost points.
double OrbitFamily::typical_displacement() {
  const auto middle = model(scene_.middle());
  const FlowStructure& structure = middle->dynamics.structure();
  double X = structure.gaps.size() == 0 ? 0.0 : structure.gaps.cwiseAbs().maxCoeff();
  const SparseLdlt factors(symmetric_part(structure.stiffness));
  if (factors.regular()) {
    const Eigen::MatrixXd deflections = factors.solve(Eigen::MatrixXd(structure.load.cwiseAbs()));
    if (deflections.allFinite()) X = std::max(X, deflections.cwiseAbs().rowwise().sum().maxCoeff());
  }
  X = std::max(X, structure.scales.displacement);
  return X > 0.0 && std::isfinite(X) ? X : 1.0;
}

}  // namespace signorini
