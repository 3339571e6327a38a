#include "methods/marching/deferred_correction.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "methods/solvers/newton_krylov.hpp"

namespace signorini {

namespace {

// Of the linear effect of a defect: two digits of a bar are enough.
constexpr double kBarTolerance = 1e-4;
// Part of the correction by which a corrected motion may violate the conditions: at the ends of a contact,
// which lie between nodes, it does so by a part of its own size.
constexpr double kViolation = 0.25;
// Part of a predicted change by which the change that a correction made may differ from it.
constexpr double kDisagreement = 0.5;
// Changes below this part of max |x| are the rounding of marches, in units of their tolerance.
constexpr double kMarchRounding = 10.0;
// Rate of the corrections beyond which they are not trusted to converge.
constexpr double kSlowest = 0.5;

/// The periodic change of motion and force under displacements added to x, on the sets of the last period.
std::optional<ContactMarch::Change> periodic_change(ContactMarch& march, const Eigen::MatrixXd& moved) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(march.size());
  const Eigen::VectorXd pushed = march.change(none, moved).state;
  const KrylovSolve solve =
      solve_by_gmres([&](const Eigen::VectorXd& v) { return Eigen::VectorXd(v - march.tangent(v)); },
                     [](const Eigen::VectorXd& v) { return v; }, pushed, kBarTolerance);
  if (solve.x.size() == 0) return std::nullopt;
  return march.change(solve.x, moved);
}

/// Whether x + dx stays before the stops where contacts are open, and they pull nowhere.
bool admissible_change(const PeriodicMarch& answer, const MarchGrid& grid,
                       const ContactMarch::Change& change) {
  const double step = kViolation * change.motion.cwiseAbs().maxCoeff();
  const double push = kViolation * change.force.cwiseAbs().maxCoeff();
  for (Eigen::Index c = 0; c < answer.motion.cols(); ++c) {
    for (Eigen::Index k = 0; k < answer.motion.rows(); ++k) {
      const bool closed = answer.force(k, c) < 0.0;
      if (closed && answer.force(k, c) + change.force(k, c) > push) return false;
      if (!closed && answer.motion(k, c) + change.motion(k, c) > grid.gap[c] + step) return false;
    }
  }
  return true;
}

/// Whether a correction changed the motion as predicted, rounding apart.
bool agrees_with(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& predicted, double rounding) {
  return (actual - predicted).cwiseAbs().maxCoeff() <=
         kDisagreement * predicted.cwiseAbs().maxCoeff() + rounding;
}

CorrectedMarch without_bar(CorrectedMarch result, std::string why) {
  result.bar.reset();
  result.refusal = std::move(why);
  return result;
}

/// How fast the defects fell: the largest ratio of the last two pairs; 0 of a single march.
double rate_of(const std::vector<double>& defects) {
  double rate = 0.0;
  const std::size_t count = defects.size();
  for (std::size_t k = count > 2 ? count - 2 : 1; k < count; ++k) {
    if (defects[k - 1] > 0.0) rate = std::max(rate, defects[k] / defects[k - 1]);
  }
  return rate;
}

}  // namespace

CorrectedMarch march_with_corrections(ContactMarch& march, const MarchGrid& grid,
                                      const ContactReceptance& whole, const CorrectionSettings& settings) {
  CorrectedMarch result;
  Eigen::MatrixXd added = Eigen::MatrixXd::Zero(march.samples(), whole.contacts());
  Eigen::MatrixXd before;                      // motion of the march before
  std::optional<ContactMarch::Change> change;  // predicted for the next one
  for (int correction = 0; correction <= settings.corrections; ++correction) {
    result.answer = correction == 0 ? march_to_periodic_motion(march, settings.march)
                                    : march_from(march, result.answer.state, settings.march);
    const Eigen::MatrixXd& motion = result.answer.motion;
    if (!result.answer.found()) return without_bar(std::move(result), "no periodic motion was found");
    const double largest = motion.cwiseAbs().maxCoeff();
    if (largest == 0.0) {
      result.bar = 0.0;
      return result;
    }
    const double rounding = kMarchRounding * settings.march.tolerance * largest;
    const bool linear = correction == 0 || agrees_with(motion - before, change->motion, rounding);
    const Eigen::MatrixXd defect = nodal_response(whole, result.answer.force) - motion;
    result.defects.push_back(defect.cwiseAbs().maxCoeff() / largest);
    change = periodic_change(march, defect);
    if (!change) return without_bar(std::move(result), "the linear effect of the defect was not found");
    const bool small = result.defects.back() <= settings.tolerance;
    if (!small && correction < settings.corrections) {
      before = motion;
      added += defect;
      march.move(added);
      continue;
    }
    const double rate = rate_of(result.defects);
    if (!small && rate > kSlowest)
      return without_bar(std::move(result), "the corrections do not converge: more vectors are needed");
    if (!linear)
      return without_bar(std::move(result), "the last correction did not do what linear theory says");
    if (!admissible_change(result.answer, grid, *change))
      return without_bar(std::move(result), "the corrected motion has other contacts");
    const double effect = 2.0 * change->motion.cwiseAbs().maxCoeff() / (1.0 - std::min(rate, kSlowest));
    result.bar = (effect + rounding) / largest;
    break;
  }
  return result;
}

}  // namespace signorini
