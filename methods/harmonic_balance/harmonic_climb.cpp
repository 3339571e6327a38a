#include "methods/harmonic_balance/harmonic_climb.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/solvers/small_lcp.hpp"

namespace signorini {

namespace {

constexpr int kFootHarmonics = 20;
constexpr int kFewestHarmonics = 5;
constexpr int kFootUnknowns = 800;  // harmonics times contacts: pivots grow with both
constexpr double kFootSoftness = 1.0 / 16.0;
constexpr double kStride = 2.0;  // harmonics are multiplied by this where Newton follows
constexpr int kAttempts = 20;
constexpr int kSamplesPerHarmonic = 16;  // tells every extremum of a polynomial of that degree

Eigen::MatrixXcd extended(const Eigen::MatrixXcd& lambda, int harmonics) {
  Eigen::MatrixXcd longer = Eigen::MatrixXcd::Zero(harmonics + 1, lambda.cols());
  const Eigen::Index common = std::min(longer.rows(), lambda.rows());
  longer.topRows(common) = lambda.topRows(common);
  return longer;
}

// The contacts that the mean of the load alone closes, in rising order.
std::vector<int> closed_under_mean_load(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                        const ProjectedLaw& law) {
  Eigen::MatrixXd compliance = receptance.receptance[0].real();
  compliance.diagonal().array() += (1.0 - law.relief.array()) / law.constant.array();
  const Eigen::VectorXd open = gap - receptance.free_response.row(0).real().transpose();
  const std::vector<bool> none(static_cast<std::size_t>(gap.size()), false);
  std::vector<int> closed;
  if (const auto pressure = solve_small_lcp(compliance, open, none)) {
    for (int c = 0; c < gap.size(); ++c) {
      if ((*pressure)[c] > 0.0) closed.push_back(c);
    }
  }
  return closed;
}

}  // namespace

ContactReceptance truncated(const ContactReceptance& receptance, int harmonics) {
  const auto count = std::min(harmonics, receptance.harmonics()) + 1;
  return {receptance.period,
          {receptance.receptance.begin(), receptance.receptance.begin() + count},
          receptance.free_response.topRows(count)};
}

ProjectedLaw softened(const ProjectedLaw& law, double softness) {
  return {softness * law.constant, (1.0 - softness * (1.0 - law.relief.array())).matrix()};
}

ExactProjection permanent_contact(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                  const ProjectedLaw& law, double tolerance) {
  const std::vector<int> closed = closed_under_mean_load(receptance, gap, law);
  if (closed.empty()) return {};
  // Where closed y = -lambda throughout: c (x_f - g) + (c C + 1 - relief) lambda = 0.
  const int harmonics = receptance.harmonics();
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(harmonics + 1, receptance.contacts());
  for (int n = 0; n <= harmonics; ++n) {
    Eigen::VectorXcd free = receptance.free_response.row(n).transpose();
    if (n == 0) free -= gap;
    Eigen::MatrixXcd block = law.constant.asDiagonal() * receptance.receptance[static_cast<std::size_t>(n)];
    block.diagonal() += (1.0 - law.relief.array()).matrix();
    const Eigen::MatrixXcd held = block(closed, closed);
    const Eigen::VectorXcd load = law.constant.cwiseProduct(free)(closed);
    const Eigen::VectorXcd force = -held.partialPivLu().solve(load);
    lambda(n, closed) = force.transpose();
  }
  if (!lambda.allFinite()) return {};
  Eigen::MatrixXcd penetration = contact_motion(receptance, lambda);
  penetration.row(0) -= gap.transpose();
  const int samples = kSamplesPerHarmonic * std::max(1, harmonics);
  RealFft fft(samples);
  Eigen::VectorXd signal(samples);
  for (int c = 0; c < receptance.contacts(); ++c) {
    const bool presses = std::binary_search(closed.begin(), closed.end(), c);
    fft.inverse(presses ? lambda.col(c) : penetration.col(c), signal);
    if (signal.maxCoeff() >= 0.0) return {};
  }
  return project_exactly(receptance, gap, law, lambda, samples, tolerance);
}

ClimbFoot climb_foot(const ContactReceptance& receptance) {
  int loaded = 0;
  for (int n = 0; n <= receptance.harmonics(); ++n) {
    if (receptance.free_response.row(n).cwiseAbs().maxCoeff() > 0.0) loaded = n;
  }
  const int affordable =
      std::clamp(kFootUnknowns / std::max(1, receptance.contacts()), kFewestHarmonics, kFootHarmonics);
  const int harmonics = std::max(affordable, 2 * loaded);
  return harmonics < receptance.harmonics() ? ClimbFoot{harmonics, kFootSoftness} : ClimbFoot{};
}

HarmonicClimb climb_harmonics(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                              const LawAt& law_at, const ClimbFoot& foot, Eigen::MatrixXcd lambda,
                              double tolerance, const Start& start) {
  const int top = receptance.harmonics();
  const auto stride = [top](int harmonics) {
    return std::min(top, static_cast<int>(std::ceil(kStride * harmonics)));
  };
  HarmonicClimb climb;
  ClimbFoot here = foot;
  ClimbFoot next{stride(here.harmonics), 1.0};
  for (int attempt = 0; attempt < kAttempts && !start.expired(); ++attempt) {
    const ContactReceptance level = truncated(receptance, next.harmonics);
    ExactProjection exact =
        project_exactly(level, gap, softened(law_at(level), next.softness), extended(lambda, next.harmonics),
                        kSamplesPerHarmonic * next.harmonics, tolerance, {}, start);
    climb.iterations += exact.iterations;
    if (exact.converged) {
      here = next;
      if (here.harmonics == top && here.softness == 1.0) {
        climb.top = std::move(exact);
        break;
      }
      lambda = std::move(exact.lambda);
      next = {stride(here.harmonics), 1.0};
    } else {
      const int halfway = static_cast<int>(std::sqrt(static_cast<double>(here.harmonics) * next.harmonics));
      const double softer = std::sqrt(here.softness * next.softness);
      if (halfway == here.harmonics && softer < 1.05 * here.softness) break;
      next = {halfway, softer};
    }
  }
  return climb;
}

}  // namespace signorini
