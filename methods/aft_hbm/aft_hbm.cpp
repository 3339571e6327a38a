#include "methods/aft_hbm/aft_hbm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "methods/aft_hbm/aft_residual.hpp"
#include "methods/aft_hbm/newton_krylov.hpp"
#include "methods/complementarity/projected_law.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/harmonic_balance/compensated_solve.hpp"
#include "methods/harmonic_balance/harmonics_option.hpp"
#include "methods/harmonic_balance/projected_contact.hpp"
#include "methods/solvers/complementarity_solver.hpp"
#include "methods/structure/periodic_response.hpp"

namespace signorini {

namespace {

constexpr int kNewtonSteps = 100;
// Cold, Newton converges at once or creeps (of the one-mass population it solves no scene): the
// homotopy takes over early.
constexpr int kColdSteps = 5;

class PreparedAft final : public PreparedMethod {
 public:
  PreparedAft(Eigen::VectorXd gap, const AftHbm::Options& options, ContactReceptance receptance, LawAt law_at,
              std::shared_ptr<CompensatedSolve> compensated, double softness = 1.0)
      : options_(options),
        gap_(std::move(gap)),
        receptance_(std::move(receptance)),
        law_at_(std::move(law_at)),
        law_(softened(law_at_(receptance_), softness)),
        quadrature_(quadrature_of(options_)),
        compensated_(std::move(compensated)) {}

  Solution solve(const Start& start) override {
    if (receptance_.contacts() == 0) return contact_free_response(receptance_);
    const Work work{.unknowns = (2L * receptance_.harmonics() + 1) * receptance_.contacts(), .iterations = 0};
    return solve_compensated(compensated_.get(), {receptance_, gap_, law_, options_.tolerance},
                             options_.max_iterations, start, work, [this, &start](Work& spent) {
                               std::optional<Solution> solution = climb(start, spent);
                               return solution ? *std::move(solution) : solve_on_grids(start, spent);
                             });
  }

 private:
  /// Permanent contact, or many harmonics from few; null where that is not asked for or does not serve.
  std::optional<Solution> climb(const Start& start, Work& work) const {
    const bool free =
        homotopy() && options_.max_iterations == 0 && quadrature_ == Quadrature::exact && !fixed_samples();
    if (!free || start.guess) return std::nullopt;
    return solve_by_climbing(
        receptance_, gap_, law_at_, options_.tolerance, start, work,
        [this, &start](const ContactReceptance& few, double softness) {
          return PreparedAft(gap_, options_, few, law_at_, nullptr, softness).solve(start);
        });
  }

  /// On the grids of SampleLadder.
  Solution solve_on_grids(const Start& start, Work& work) const {
    Solution solution;
    Eigen::MatrixXcd guess =
        start.guess ? force_spectrum(*start.guess, receptance_.harmonics()) : Eigen::MatrixXcd{};
    SampleLadder ladder(receptance_.harmonics(), fixed_samples(), quadrature_);
    while (true) {
      AftResidual residual(receptance_, gap_, law_, ladder.samples());
      const Outcome outcome = solve_on_grid(residual, guess, start, work);
      FourierTrajectory::Data data =
          fourier_data(receptance_, gap_, law_, residual.coefficients(outcome.newton.lambda));
      const bool converged = outcome.newton.converged;
      if (converged) guess = data.lambda;
      solution.condition = outcome.newton.condition;
      std::string quadrature = fmt::format("N = {}", ladder.samples());
      bool exact = converged && data.lambda.norm() == 0.0;
      if (converged && !exact && quadrature_ == Quadrature::exact) {
        const ExactProjection refined =
            refine_quadrature(receptance_, law_, ladder.samples(), options_.tolerance, data);
        exact = refined.converged;
        if (exact) work.iterations = *work.iterations + refined.iterations;
        if (exact && refined.condition) solution.condition = refined.condition;
        quadrature += exact ? ", contact integral exact" : ", contact integral sampled: no exact one nearby";
      }
      const double ratio = net_work_ratio(data.x, data.lambda);
      const bool in_limit = options_.max_iterations == 0 || spent(work) <= options_.max_iterations;
      const bool accepted = converged && in_limit && ladder.accepts(exact, ratio);
      solution.verdict = accepted ? Verdict::converged : Verdict::not_converged;
      solution.residual = outcome.newton.residual;
      solution.message =
          fmt::format("{}; {}, net contact work {:.1e} of that exchanged",
                      in_limit ? outcome.message : "max_iterations used up", quadrature, ratio);
      if (data.lambda.allFinite()) solution.trajectory = std::make_shared<FourierTrajectory>(std::move(data));
      if (fixed_samples() || !in_limit || start.expired() || !ladder.climb(converged, exact, ratio)) break;
      // Newton alone that has lost its way is not helped by more samples.
      if (!converged && !homotopy()) break;
    }
    return solution;
  }

  struct Outcome {
    NewtonKrylov newton;
    std::string message;
  };

  /// Newton from the guess or the contact-free response; failing that, from the end of the gap homotopy.
  Outcome solve_on_grid(AftResidual& residual, const Eigen::MatrixXcd& guess, const Start& start,
                        Work& work) const {
    const bool cold = guess.size() == 0;
    const auto allowed = [this](int steps) {
      return options_.max_iterations > 0 ? std::min(options_.max_iterations, steps) : steps;
    };
    Outcome outcome;
    outcome.newton = solve_newton_krylov(
        residual, cold ? Eigen::VectorXd::Zero(residual.unknowns()) : residual.unknowns_of(guess),
        options_.tolerance, allowed(cold && homotopy() ? kColdSteps : kNewtonSteps), start);
    work.iterations = work.iterations.value_or(0) + outcome.newton.iterations;
    outcome.message = outcome.newton.converged ? "Newton-Krylov" : "Newton-Krylov found no descent";
    if (outcome.newton.converged || !homotopy() || spent_all(work)) return outcome;
    SolverSettings settings{.tolerance = options_.tolerance, .deadline = start.deadline};
    if (options_.max_iterations > 0)
      settings.max_iterations = options_.max_iterations - static_cast<int>(spent(work));
    Lcp lcp = projected_lcp(receptance_, gap_, law_, residual.samples());
    const LcpResult path = solve_lcp(lcp, settings);
    work.pivots = work.pivots.value_or(0) + path.pivots;
    outcome.message = fmt::format("gap homotopy: {}", describe(path.status));
    if (path.status != LcpStatus::solved) return outcome;
    const Eigen::MatrixXcd lambda =
        force_coefficients(law_, path.z, residual.samples(), receptance_.harmonics());
    outcome.newton = solve_newton_krylov(residual, residual.unknowns_of(lambda), options_.tolerance,
                                         allowed(kNewtonSteps), start);
    if (!outcome.newton.condition) outcome.newton.condition = path.condition;  // no step was needed
    work.iterations = *work.iterations + outcome.newton.iterations;
    outcome.message = "gap homotopy and Newton-Krylov";
    return outcome;
  }

  [[nodiscard]] std::optional<int> fixed_samples() const {
    return samples_of(options_, receptance_.harmonics());
  }

  static long spent(const Work& work) { return work.iterations.value_or(0) + work.pivots.value_or(0); }

  [[nodiscard]] bool spent_all(const Work& work) const {
    return options_.max_iterations > 0 && spent(work) >= options_.max_iterations;
  }

  [[nodiscard]] bool homotopy() const { return options_.homotopy.value_or(!options_.plain); }

  AftHbm::Options options_;
  Eigen::VectorXd gap_;
  ContactReceptance receptance_;
  LawAt law_at_;
  ProjectedLaw law_;
  Quadrature quadrature_;
  std::shared_ptr<CompensatedSolve> compensated_;
};

}  // namespace

AftHbm::AftHbm(const Options& options) : options_(options) {
  validate_harmonic_options(options_);
  require_option(!options_.c || *options_.c > 0.0, "c", options_.c, "must be positive, or auto");
  require_option(!options_.penalty || options_.penalty->value > 0.0, "penalty", options_.penalty,
                 "must be positive, or auto");
  require_option(!options_.c || options_.law == ContactLaw::dlft, "c", options_.c,
                 "must be auto unless law = dlft");
  require_option(!options_.penalty || options_.law == ContactLaw::penalty, "penalty", options_.penalty,
                 "must be auto unless law = penalty");
}

Support AftHbm::supports(const Problem& problem) const {
  return supports_harmonics(problem, first_harmonics(options_.harmonics, problem), options_.samples);
}

RepresentedLaw AftHbm::law(const Problem& problem) const {
  return projected_method_law(problem, options_.penalty);
}

std::unique_ptr<PreparedMethod> AftHbm::prepare(const Problem& problem) const {
  const auto law = [&problem, options = options_](const ContactReceptance& receptance) {
    return options.law == ContactLaw::penalty ? penalty_law(problem, options.penalty, receptance)
                                              : lipschitz_law(problem, options.c, receptance);
  };
  return prepare_harmonics(options_, problem, [&problem, law, options = options_](int harmonics) {
    ContactReceptance receptance = fourier_receptance(problem, harmonics);
    std::shared_ptr<CompensatedSolve> compensated;
    if (compensates(options))
      compensated = compensated_solve(problem, receptance,
                                      {options.homotopy.value_or(!options.plain), hardening_of(options)});
    return std::make_unique<PreparedAft>(contact_gaps(problem), options, std::move(receptance), law,
                                         std::move(compensated));
  });
}

}  // namespace signorini
