#include "methods/orbit/family/orbit_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/linear_algebra/sparse/sparse_factors.hpp"
#include "problems/skew_parts.hpp"

namespace signorini {

std::string continuation_obstacle(const Problem& problem) {
  if (problem.size() > kMostInDenseFlow)
    return fmt::format("{} coordinates are more than {}", problem.size(), kMostInDenseFlow);
  const bool loses =
      problem.damping().norm() > 0.0 || std::ranges::any_of(problem.contacts, [](const Contact& contact) {
        const auto* law = std::get_if<Restitution>(&contact.law);
        return law != nullptr && law->e < 1.0;
      });
  if (highest_load_harmonic(problem) == 0 && loses) return "without a periodic load it comes to rest";
  return flow_obstacle(problem);
}

OrbitFamily::OrbitFamily(ParametrisedScene scene, const CurveUnits& units, std::shared_ptr<SharedModes> modes)
    : scene_(std::move(scene)), units_(units), modes_(std::move(modes)) {
  const Problem problem = scene_.at(scene_.middle());
  driven_ = highest_load_harmonic(problem) > 0;
  if (scene_.parameter == kFrequency && !load_grows(problem) && !follows_speed(problem))
    middle_ = std::make_unique<OrbitModel>(problem, modes_);
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
    recent_.emplace_front(parameter, middle_ ? std::make_shared<OrbitModel>(*middle_, parameter, modes_)
                                             : std::make_shared<OrbitModel>(scene_.at(parameter), modes_));
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
