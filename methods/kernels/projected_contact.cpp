#include "methods/kernels/projected_contact.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "methods/kernels/real_fft.hpp"

namespace signorini {

namespace {

// Samples per harmonic that the automatic choice begins with, and how often it may double them.
// At 32 the pivoting path met no ray on a population with damping ratios down to 0.0016 (docs/theory.md).
constexpr int kSamplesPerHarmonic = 32;
constexpr int kDoublings = 4;
// The automatic choice is content when the contact's net work is this small a part of the work exchanged.
constexpr double kEnergyIdentity = 1e-3;

}  // namespace

Lcp projected_lcp(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                  int samples) {
  const int contacts = receptance.contacts();
  const Eigen::VectorXd root = law.constant.cwiseSqrt();
  std::vector<Eigen::MatrixXcd> symbol;
  symbol.reserve(receptance.receptance.size());
  for (const Eigen::MatrixXcd& c : receptance.receptance) {
    symbol.emplace_back(root.asDiagonal() * c * root.asDiagonal());
    symbol.back().diagonal() += (1.0 - law.relief.array()).matrix();
  }
  Eigen::VectorXd offset(samples * contacts);
  RealFft fft(samples);
  for (int c = 0; c < contacts; ++c) {
    auto part = offset.segment(c * samples, samples);
    fft.inverse(receptance.free_response.col(c), part);
    part = root[c] * (gap[c] - part.array());
  }
  return {BlockCirculant(samples, symbol, 1.0), std::move(offset)};
}

double net_work_ratio(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda) {
  double net = 0.0;
  double exchanged = 0.0;
  for (Eigen::Index n = 1; n < x.rows(); ++n) {
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      const double order = static_cast<double>(n);
      net += order * std::imag(std::conj(x(n, c)) * lambda(n, c));
      exchanged += order * std::abs(x(n, c)) * std::abs(lambda(n, c));
    }
  }
  return exchanged > 0.0 ? std::abs(net) / exchanged : 0.0;
}

ProjectedContact::ProjectedContact(const Problem& problem, ContactReceptance receptance, ProjectedLaw law,
                                   ProjectedOptions options)
    : receptance_(std::move(receptance)),
      gap_(contact_gaps(problem)),
      law_(std::move(law)),
      options_(std::move(options)) {}

Solution ProjectedContact::linear_response() const {
  FourierTrajectory::Data data{receptance_.period, receptance_.free_response,
                               Eigen::MatrixXcd(receptance_.free_response.rows(), 0),
                               gap_, law_.constant, law_.relief};
  return {.verdict = Verdict::converged,
          .message = "no contact in the scene: linear response",
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .work = {.unknowns = 0},
          .residual = 0.0};
}

Solution ProjectedContact::solve(const Start& start) {
  if (receptance_.contacts() == 0) return linear_response();
  const bool automatic = !options_.samples.has_value();
  int samples = options_.samples.value_or(std::max(64, kSamplesPerHarmonic * receptance_.harmonics()));
  SolverSettings settings = options_.solver;
  settings.deadline = start.deadline;
  Solution solution;
  Work work{.unknowns = 0};
  double ratio = 0.0;
  for (int round = 0;; ++round, samples *= 2) {
    Lcp lcp = projected_lcp(receptance_, gap_, law_, samples);
    const Eigen::VectorXd guess = start.guess ? guess_from(*start.guess, samples) : Eigen::VectorXd{};
    const LcpResult result = solve_lcp(lcp, settings, guess);
    work.unknowns = lcp.matrix.size();
    if (settings.solver == ComplementaritySolver::newton) {
      work.iterations = work.iterations.value_or(0) + result.iterations;
      work.factorisations = work.factorisations.value_or(0) + result.factorisations;
    } else {
      work.pivots = work.pivots.value_or(0) + result.pivots;
    }
    auto data = coefficients(result.z, samples);
    ratio = net_work_ratio(data.x, data.lambda);
    solution.verdict = result.status == LcpStatus::solved ? Verdict::converged : Verdict::not_converged;
    solution.residual = result.residual;
    solution.message = fmt::format("{}; N = {}, net contact work {:.1e} of that exchanged", describe(result.status),
                                   samples, ratio);
    if (result.status != LcpStatus::breakdown && result.z.allFinite()) {
      solution.trajectory = std::make_shared<FourierTrajectory>(std::move(data));
    }
    const bool content = solution.verdict == Verdict::converged && ratio <= kEnergyIdentity;
    // More samples repair a ray or a coarse quadrature, not a Newton iteration that has lost its way.
    const bool lost = settings.solver == ComplementaritySolver::newton && result.status != LcpStatus::solved;
    if (!automatic || content || lost || round == kDoublings || result.status == LcpStatus::interrupted) break;
  }
  solution.work = work;
  return solution;
}

Eigen::VectorXd ProjectedContact::guess_from(const Trajectory& trajectory, int samples) const {
  const Samples motion = trajectory.sample(samples);
  Eigen::VectorXd guess(samples * receptance_.contacts());
  for (int c = 0; c < receptance_.contacts(); ++c) {
    // A trajectory that presses somewhere states z itself; one that only gives x is judged by x.
    guess.segment(c * samples, samples) =
        (-motion.force.col(c).array() / std::sqrt(law_.constant[c])).max(0.0).matrix();
  }
  return guess;
}

FourierTrajectory::Data ProjectedContact::coefficients(const Eigen::VectorXd& z_scaled, int samples) const {
  const int contacts = receptance_.contacts();
  const int harmonics = receptance_.harmonics();
  FourierTrajectory::Data data;
  data.period = receptance_.period;
  data.gap = gap_;
  data.stiffness = law_.constant;
  data.relief = law_.relief;
  data.lambda.resize(harmonics + 1, contacts);
  data.x = receptance_.free_response;
  RealFft fft(samples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  for (int c = 0; c < contacts; ++c) {
    fft.forward(z_scaled.segment(c * samples, samples), spectrum);
    data.lambda.col(c) = -std::sqrt(law_.constant[c]) * spectrum.head(harmonics + 1);
  }
  for (int n = 0; n <= harmonics; ++n) {
    data.x.row(n) += (receptance_.receptance[static_cast<std::size_t>(n)] * data.lambda.row(n).transpose()).transpose();
  }
  return data;
}

}  // namespace signorini
