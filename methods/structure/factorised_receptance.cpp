#include "methods/structure/factorised_receptance.hpp"

#include <algorithm>

#include "methods/structure/dynamic_stiffness.hpp"

namespace signorini {

namespace {

// Right-hand sides solved for at a time: bounds what is kept beside the factors.
constexpr int kColumns = 32;

}  // namespace

ContactReceptance factorised_receptance(const Problem& problem, int harmonics,
                                        const WeightsOfHarmonic& weights, bool dense) {
  const int contacts = problem.contact_count();
  const SparseMatrix directions = contact_directions(problem);
  const int loaded = load_bandwidth(problem);
  DynamicStiffness stiffness(problem, dense);
  ContactReceptance result;
  result.period = problem.period();
  result.report.method = dense ? ReceptanceMethod::dense : ReceptanceMethod::direct;
  result.receptance.assign(static_cast<std::size_t>(harmonics) + 1, Eigen::MatrixXcd(contacts, contacts));
  result.free_response = Eigen::MatrixXcd::Zero(harmonics + 1, contacts);
  for (int n = 0; n <= harmonics; ++n) {
    const HarmonicWeights weight = weights(n);
    stiffness.factorise(weight);
    for (int first = 0; first < contacts; first += kColumns) {
      const int count = std::min(kColumns, contacts - first);
      const Eigen::MatrixXcd columns =
          Eigen::MatrixXd(directions.middleCols(first, count)).cast<std::complex<double>>();
      result.receptance[static_cast<std::size_t>(n)].middleCols(first, count) =
          directions.transpose() * stiffness.solve(columns);
    }
    if (n > loaded) continue;
    const Eigen::MatrixXcd load = weight.load * load_coefficient(problem, n);
    result.free_response.row(n) = (directions.transpose() * stiffness.solve(load)).transpose();
  }
  return result;
}

}  // namespace signorini
