#include "methods/orbit/family/growth.hpp"

#include <cmath>
#include <vector>

#include "methods/orbit/family/extended_equations.hpp"
#include "problems/linear_algebra/singular_values.hpp"

namespace signorini {

namespace {

// The speeds of the impacts that have none at an orbit, over V, and the lengths of the phases of contact that
// have none there [-], [rad].
class NewEvents {
 public:
  explicit NewEvents(const ExtendedEquations& equations) {
    constexpr double kNone = 1e-7;
    const SequencedOrbit& orbit = equations.orbit();
    for (Eigen::Index i = 0; i < orbit.count(); ++i) {
      const SequenceEvent& event = orbit.events[static_cast<std::size_t>(i)];
      const bool impact = event.kind == ContactEvent::Kind::impact;
      if (impact && std::abs(speed(equations, i)) < kNone) impacts_.push_back(i);
      if (!impact && i > 0 && orbit.events[static_cast<std::size_t>(i) - 1].contact == event.contact &&
          orbit.phase(i) - orbit.phase(i - 1) < kNone)
        phases_.push_back(i);
    }
  }
  [[nodiscard]] Eigen::VectorXd of(const ExtendedEquations& at) const {
    std::vector<double> all;
    for (const Eigen::Index i : impacts_) all.push_back(speed(at, i));
    for (const Eigen::Index i : phases_) all.push_back(at.orbit().phase(i) - at.orbit().phase(i - 1));
    return Eigen::VectorXd::Map(all.data(), static_cast<Eigen::Index>(all.size()));
  }

 private:
  static double speed(const ExtendedEquations& at, Eigen::Index i) {
    return at.equations().crossings()[static_cast<std::size_t>(i)].approach / at.family().units().velocity;
  }
  std::vector<Eigen::Index> impacts_, phases_;
};

}  // namespace

std::optional<Eigen::VectorXd> way_of_growth(OrbitFamily& family, const SequencedOrbit& orbit) {
  constexpr double kBeside = 1e-6, kSingular = 1e-8, kResolved = 1e-6;  // of the largest singular value
  ExtendedEquations equations(family, orbit);
  if (!equations.evaluate(orbit.x)) return std::nullopt;
  const NewEvents fresh(equations);
  const Eigen::MatrixXd J = equations.accurate_jacobian(), C = equations.conditions();
  Eigen::MatrixXd all(J.rows() + C.rows(), J.cols());
  all << J, C;
  if (!all.allFinite()) return std::nullopt;
  const SingularValues svd = singular_vectors(all);
  const Eigen::Index rank = (svd.values.array() > kSingular * svd.values[0]).count();
  const Eigen::MatrixXd ways = svd.V.rightCols(svd.V.cols() - rank);
  Eigen::MatrixXd rates(fresh.of(equations).size(), ways.cols());
  for (Eigen::Index k = 0; k < ways.cols(); ++k) {
    if (!equations.evaluate(orbit.x + kBeside * ways.col(k))) return std::nullopt;
    const Eigen::VectorXd ahead = fresh.of(equations);
    if (!equations.evaluate(orbit.x - kBeside * ways.col(k))) return std::nullopt;
    rates.col(k) = (ahead - fresh.of(equations)) / (2.0 * kBeside);
  }
  if (rates.size() == 0 || !rates.allFinite()) return std::nullopt;
  const SingularValues by_way = singular_vectors(rates);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(ways.cols());
  for (Eigen::Index k = 0; k < by_way.values.size(); ++k) {
    if (by_way.values[k] > kResolved * by_way.values[0])
      shares += by_way.U.col(k).sum() / by_way.values[k] * by_way.V.col(k);
  }
  if (!((rates * shares).array() > 0.0).all()) return std::nullopt;
  return (ways * shares).normalized();
}

}  // namespace signorini
