#include "methods/aft_hbm/aft_hbm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "methods/aft_hbm/aft_residual.hpp"
#include "methods/aft_hbm/gap_path.hpp"
#include "methods/kernels/periodic_response.hpp"
#include "methods/kernels/projected_contact.hpp"
#include "methods/kernels/projected_law.hpp"
#include "methods/kernels/trajectories.hpp"

namespace signorini {

namespace {

constexpr int kNewtonSteps = 100;

class PreparedAft final : public PreparedMethod {
 public:
  PreparedAft(Eigen::VectorXd gap, const AftHbm::Options& options, ContactReceptance receptance, LawAt law_at,
              double softness = 1.0)
      : options_(options),
        gap_(std::move(gap)),
        receptance_(std::move(receptance)),
        law_at_(std::move(law_at)),
        law_(softened(law_at_(receptance_), softness)) {}

  Solution solve(const Start& start) override {
    if (receptance_.contacts() == 0) return contact_free_response(receptance_);
    Work work{.unknowns = (2L * options_.harmonics + 1) * receptance_.contacts(), .iterations = 0};
    std::optional<Solution> solution = climb(start, work);
    if (!solution) solution = solve_on_grids(start, work);
    solution->work = work;
    return *std::move(solution);
  }

 private:
  /// Permanent contact, or many harmonics from few; null where that is not asked for or does not serve.
  std::optional<Solution> climb(const Start& start, Work& work) const {
    const bool free = options_.homotopy && options_.max_iterations == 0 &&
                      options_.quadrature == Quadrature::exact && !options_.samples;
    if (!free || start.guess) return std::nullopt;
    if (ExactProjection closed = permanent_contact(receptance_, gap_, law_, options_.tolerance);
        closed.converged)
      return exact_solution(receptance_, gap_, law_, std::move(closed.lambda), closed.residual,
                            "permanent contact");
    const ClimbFoot foot = climb_foot(receptance_);
    if (foot.harmonics == 0) return std::nullopt;
    AftHbm::Options few = options_;
    few.harmonics = foot.harmonics;
    PreparedAft coarse(gap_, few, truncated(receptance_, foot.harmonics), law_at_, foot.softness);
    const Solution base = coarse.solve(start);
    work.iterations = *work.iterations + base.work.iterations.value_or(0);
    if (base.verdict != Verdict::converged) return std::nullopt;
    HarmonicClimb climb = climb_harmonics(receptance_, gap_, law_at_, foot,
                                          base.trajectory->force_coefficients(), options_.tolerance, start);
    work.iterations = *work.iterations + climb.iterations;
    if (!climb.converged) return std::nullopt;
    return exact_solution(receptance_, gap_, law_, std::move(climb.lambda), climb.residual,
                          fmt::format("{} harmonics first, Newton from there", foot.harmonics));
  }

  /// On the grids of SampleLadder.
  Solution solve_on_grids(const Start& start, Work& work) const {
    Solution solution;
    Eigen::MatrixXcd guess =
        start.guess ? force_spectrum(*start.guess, options_.harmonics) : Eigen::MatrixXcd{};
    SampleLadder ladder(options_.harmonics, options_.samples, options_.quadrature);
    while (true) {
      AftResidual residual(receptance_, gap_, law_, ladder.samples());
      const Outcome outcome = solve_on_grid(residual, guess, start);
      work.iterations = *work.iterations + outcome.iterations;
      FourierTrajectory::Data data =
          fourier_data(receptance_, gap_, law_, residual.coefficients(outcome.newton.lambda));
      const bool converged = outcome.newton.converged;
      if (converged) guess = data.lambda;
      std::string quadrature = fmt::format("N = {}", ladder.samples());
      bool exact = converged && data.lambda.norm() == 0.0;
      if (converged && !exact && options_.quadrature == Quadrature::exact) {
        const auto steps = refine_quadrature(receptance_, law_, ladder.samples(), options_.tolerance, data);
        exact = steps.has_value();
        work.iterations = *work.iterations + steps.value_or(0);
        quadrature += exact ? ", contact integral exact" : ", contact integral sampled: no exact one nearby";
      }
      const double ratio = net_work_ratio(data.x, data.lambda);
      const bool in_limit = options_.max_iterations == 0 || *work.iterations <= options_.max_iterations;
      const bool accepted = converged && in_limit && ladder.accepts(exact, ratio);
      solution.verdict = accepted ? Verdict::converged : Verdict::not_converged;
      solution.residual = outcome.newton.residual;
      solution.message =
          fmt::format("{}; {}, net contact work {:.1e} of that exchanged",
                      in_limit ? outcome.message : "max_iterations used up", quadrature, ratio);
      if (data.lambda.allFinite()) solution.trajectory = std::make_shared<FourierTrajectory>(std::move(data));
      if (options_.samples || !in_limit || start.expired() || !ladder.climb(converged, exact, ratio)) break;
      // Newton alone that has lost its way is not helped by more samples.
      if (!converged && !options_.homotopy) break;
    }
    return solution;
  }

  struct Outcome {
    NewtonKrylov newton;
    int iterations = 0;
    std::string message;
  };

  /// Newton from the guess or the contact-free response; failing that, the homotopy and Newton from its end.
  Outcome solve_on_grid(AftResidual& residual, const Eigen::MatrixXcd& guess, const Start& start) const {
    Outcome outcome;
    const int newton_steps =
        options_.max_iterations > 0 ? std::min(options_.max_iterations, kNewtonSteps) : kNewtonSteps;
    const Eigen::VectorXd first =
        guess.size() > 0 ? residual.unknowns_of(guess) : Eigen::VectorXd::Zero(residual.unknowns());
    outcome.newton = solve_newton_krylov(residual, first, options_.tolerance, newton_steps, start);
    outcome.iterations = outcome.newton.iterations;
    outcome.message = outcome.newton.converged ? "Newton-Krylov" : "Newton-Krylov found no descent";
    if (outcome.newton.converged || !options_.homotopy) return outcome;
    const int limit = 6000 + 10 * residual.samples() * residual.contacts();
    const int allowed = options_.max_iterations > 0 ? options_.max_iterations - outcome.iterations : limit;
    const GapPath path = follow_gap_path(residual, std::max(0, allowed), start);
    outcome.iterations += path.switches;
    if (path.end == GapPath::End::arrived) {
      outcome.newton = solve_newton_krylov(residual, path.lambda, options_.tolerance, newton_steps, start);
      outcome.iterations += outcome.newton.iterations;
    }
    outcome.message = describe(path.end);
    return outcome;
  }

  static std::string describe(GapPath::End end) {
    switch (end) {
      case GapPath::End::arrived:
        return "gap homotopy and Newton-Krylov";
      case GapPath::End::ray:
        return "the gap homotopy ended on a ray";
      case GapPath::End::limit:
        return "the gap homotopy used up its iterations";
      case GapPath::End::singular:
        return "a linear system of the gap homotopy could not be solved";
      case GapPath::End::interrupted:
        return "time budget used up";
    }
    return "unknown";
  }

  AftHbm::Options options_;
  Eigen::VectorXd gap_;
  ContactReceptance receptance_;
  LawAt law_at_;
  ProjectedLaw law_;
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
  return supports_harmonics(problem, options_.harmonics);
}

RepresentedLaw AftHbm::law(const Problem& problem) const {
  return projected_method_law(problem, options_.penalty);
}

std::unique_ptr<PreparedMethod> AftHbm::prepare(const Problem& problem) const {
  const auto law = [&problem, options = options_](const ContactReceptance& receptance) {
    return options.law == ContactLaw::penalty ? penalty_law(problem, options.penalty, receptance)
                                              : lipschitz_law(problem, options.c, receptance);
  };
  return std::make_unique<PreparedAft>(contact_gaps(problem), options_,
                                       fourier_receptance(problem, options_.harmonics), law);
}

}  // namespace signorini
