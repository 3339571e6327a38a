#include "methods/harmonic_balance/projected_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "methods/complementarity/contact_symbol.hpp"
#include "methods/complementarity/exact_quadrature.hpp"
#include "methods/discretisation/free_penetration.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/resolutions.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

// Samples per harmonic. On 32 the path of pivots met no ray on a population with damping ratios down to
// 0.0016 (docs/theory.md). Where the exact contact integral follows, a coarser grid will do to begin with: it
// decides the path, not the answer.
constexpr int kSampled = 32;
constexpr int kCoarse = 8;
constexpr int kFinest = 128;
// A sampled answer is good enough when the contact's net work is this small a part of the work exchanged.
constexpr double kEnergyIdentity = 1e-3;

}  // namespace

Lcp projected_lcp(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                  int samples) {
  const ContactSymbol rate(receptance, law);
  std::vector<Eigen::MatrixXcd> symbol;
  symbol.reserve(receptance.receptance.size());
  for (int n = 0; n <= rate.harmonics(); ++n) {
    symbol.push_back(rate.block(n));
    symbol.back().diagonal().array() += 1.0;
  }
  return {BlockCirculant(samples, symbol, 1.0),
          -free_penetration(receptance.free_response, gap, rate.root(), samples)};
}

Eigen::MatrixXcd force_coefficients(const ProjectedLaw& law, const Eigen::VectorXd& z_scaled, int samples,
                                    int harmonics) {
  RealFft fft(samples);
  Eigen::VectorXcd spectrum(fft.coefficients());
  Eigen::MatrixXcd lambda(harmonics + 1, law.constant.size());
  for (Eigen::Index c = 0; c < lambda.cols(); ++c) {
    fft.forward(z_scaled.segment(c * samples, samples), spectrum);
    lambda.col(c) = -std::sqrt(law.constant[c]) * spectrum.head(lambda.rows());
  }
  return lambda;
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

ProjectedContact::ProjectedContact(Eigen::VectorXd gap, ContactReceptance receptance, LawAt law_at,
                                   ProjectedOptions options, double softness)
    : gap_(std::move(gap)),
      receptance_(std::move(receptance)),
      law_at_(std::move(law_at)),
      law_(softened(law_at_(receptance_), softness)),
      options_(std::move(options)) {}

SampleLadder::SampleLadder(int harmonics, std::optional<int> fixed, Quadrature quadrature)
    : quadrature_(quadrature),
      samples_(fixed.value_or(std::max(kCoarse * kFewestOnGrid,
                                       (quadrature == Quadrature::exact ? kCoarse : kSampled) * harmonics))),
      trusted_(kSampled * harmonics),
      finest_(fixed ? 0 : kFinest * harmonics) {}

bool SampleLadder::accepts(bool exact, double net_work) const {
  return exact || quadrature_ == Quadrature::sampled || net_work <= kEnergyIdentity;
}

bool SampleLadder::climb(bool converged, bool exact, double net_work) {
  const bool sampled_well = samples_ >= trusted_ && net_work <= kEnergyIdentity;
  if ((converged && (exact || sampled_well)) || 2 * samples_ > finest_) return false;
  samples_ *= 2;
  return true;
}

FourierTrajectory::Data fourier_data(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                     const ProjectedLaw& law, Eigen::MatrixXcd lambda) {
  Eigen::MatrixXcd x = contact_motion(receptance, lambda);
  return {receptance.period, std::move(x), std::move(lambda), gap, law.constant, law.relief};
}

ExactProjection refine_quadrature(const ContactReceptance& receptance, const ProjectedLaw& law, int samples,
                                  double tolerance, FourierTrajectory::Data& data) {
  ExactProjection exact = project_exactly(receptance, data.gap, law, data.lambda, samples, tolerance);
  if (exact.converged) data = fourier_data(receptance, data.gap, law, exact.lambda);
  return exact;
}

Solution exact_solution(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                        const ProjectedLaw& law, const ExactProjection& solved, const std::string& how) {
  FourierTrajectory::Data data = fourier_data(receptance, gap, law, solved.lambda);
  const double ratio = net_work_ratio(data.x, data.lambda);
  return {.verdict = Verdict::converged,
          .message = fmt::format("{}; contact integral exact, net contact work {:.1e} of that exchanged", how,
                                 ratio),
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .residual = solved.residual,
          .condition = solved.condition};
}

std::optional<Solution> solve_by_climbing(const ContactReceptance& receptance, const Eigen::VectorXd& gap,
                                          const LawAt& law_at, double tolerance, const Start& start,
                                          Work& work, const FootSolver& solve_foot) {
  const ProjectedLaw law = law_at(receptance);
  if (const ExactProjection closed = permanent_contact(receptance, gap, law, tolerance); closed.converged)
    return exact_solution(receptance, gap, law, closed, "permanent contact");
  const ClimbFoot foot = climb_foot(receptance);
  if (foot.harmonics == 0) return std::nullopt;
  const Solution base = solve_foot(truncated(receptance, foot.harmonics), foot.softness);
  add_effort(base.work, work);
  if (base.verdict != Verdict::converged) return std::nullopt;
  const HarmonicClimb climb =
      climb_harmonics(receptance, gap, law_at, foot, base.trajectory->force_coefficients(), tolerance, start);
  work.iterations = work.iterations.value_or(0) + climb.iterations;
  if (!climb.top.converged) return std::nullopt;
  return exact_solution(receptance, gap, law, climb.top,
                        fmt::format("{} harmonics first, Newton from there", foot.harmonics));
}

Solution contact_free_response(const ContactReceptance& receptance) {
  FourierTrajectory::Data data;
  data.period = receptance.period;
  data.x = receptance.free_response;
  data.lambda = data.x;
  return {.verdict = Verdict::converged,
          .message = "no contact in the scene: linear response",
          .trajectory = std::make_shared<FourierTrajectory>(std::move(data)),
          .work = {.unknowns = 0},
          .residual = 0.0};
}

std::optional<Solution> ProjectedContact::solve_without_grid(const Start& start, Work& work) const {
  const bool free = options_.solver.solver == ComplementaritySolver::automatic &&
                    options_.solver.max_iterations == 0 && options_.quadrature == Quadrature::exact &&
                    !options_.samples;
  if (!free) return std::nullopt;
  const double tolerance = options_.solver.tolerance;
  const int harmonics = receptance_.harmonics();
  if (start.guess) {
    const ExactProjection near =
        project_exactly(receptance_, gap_, law_, force_spectrum(*start.guess, harmonics),
                        kCoarse * std::max(harmonics, kFewestOnGrid), tolerance);
    work.iterations = work.iterations.value_or(0) + near.iterations;
    if (near.converged) return exact_solution(receptance_, gap_, law_, near, "Newton from the guess");
    return std::nullopt;
  }
  return solve_by_climbing(receptance_, gap_, law_at_, tolerance, start, work,
                           [this, &start](const ContactReceptance& few, double softness) {
                             ProjectedOptions options = options_;
                             options.compensated = nullptr;
                             return ProjectedContact(gap_, few, law_at_, options, softness).solve(start);
                           });
}

Solution ProjectedContact::solve(const Start& start) {
  if (receptance_.contacts() == 0) return contact_free_response(receptance_);
  const Work work{.unknowns = (2L * receptance_.harmonics() + 1) * receptance_.contacts()};
  return solve_compensated(options_.compensated.get(), {receptance_, gap_, law_, options_.solver.tolerance},
                           options_.solver.max_iterations, start, work, [this, &start](Work& spent) {
                             std::optional<Solution> solution = solve_without_grid(start, spent);
                             return solution ? *std::move(solution) : solve_on_grids(start, spent);
                           });
}

Solution ProjectedContact::solve_on_grids(const Start& start, Work& work) const {
  SolverSettings settings = options_.solver;
  settings.deadline = start.deadline;
  const bool newton = settings.solver == ComplementaritySolver::newton;
  Solution solution;
  SampleLadder ladder(receptance_.harmonics(), options_.samples, options_.quadrature);
  while (true) {
    const int samples = ladder.samples();
    Lcp lcp = projected_lcp(receptance_, gap_, law_, samples);
    const Eigen::VectorXd guess =
        start.guess ? pressure_samples(*start.guess, samples, law_.constant.cwiseSqrt()) : Eigen::VectorXd{};
    const long limit = options_.solver.max_iterations;
    const auto spent = [&work] { return work.pivots.value_or(0) + work.iterations.value_or(0); };
    if (limit > 0) settings.max_iterations = static_cast<int>(std::max(1L, limit - spent()));
    const LcpResult result = solve_lcp(lcp, settings, guess);
    work.unknowns = lcp.matrix.size();
    if (newton) {
      work.iterations = work.iterations.value_or(0) + result.iterations;
      work.factorisations = work.factorisations.value_or(0) + result.factorisations;
    } else {
      work.pivots = work.pivots.value_or(0) + result.pivots;
    }
    FourierTrajectory::Data data = fourier_data(
        receptance_, gap_, law_, force_coefficients(law_, result.z, samples, receptance_.harmonics()));
    const bool solved = result.status == LcpStatus::solved;
    solution.condition = result.condition;
    std::string quadrature = fmt::format("N = {}", samples);
    // Where nothing touches, the sampled integral is exact.
    bool exact = solved && result.z.maxCoeff() == 0.0;
    if (solved && !exact && options_.quadrature == Quadrature::exact) {
      const ExactProjection refined = refine_quadrature(receptance_, law_, samples, settings.tolerance, data);
      exact = refined.converged;
      if (exact) work.iterations = work.iterations.value_or(0) + refined.iterations;
      if (exact && refined.condition) solution.condition = refined.condition;
      quadrature += exact ? ", contact integral exact" : ", contact integral sampled: no exact one nearby";
    }
    const double ratio = net_work_ratio(data.x, data.lambda);
    const bool in_limit = limit == 0 || spent() <= limit;
    const bool accepted = solved && in_limit && ladder.accepts(exact, ratio);
    solution.verdict = accepted ? Verdict::converged : Verdict::not_converged;
    solution.residual = result.residual;
    solution.message = fmt::format("{}; {}, net contact work {:.1e} of that exchanged",
                                   describe(in_limit ? result.status : LcpStatus::limit), quadrature, ratio);
    if (result.z.allFinite()) solution.trajectory = std::make_shared<FourierTrajectory>(std::move(data));
    // More samples repair a ray or a coarse quadrature, not a Newton iteration that has lost its way.
    if ((newton && !solved) || result.status == LcpStatus::interrupted || !in_limit) break;
    if (!ladder.climb(solved, exact, ratio)) break;
  }
  return solution;
}

}  // namespace signorini
