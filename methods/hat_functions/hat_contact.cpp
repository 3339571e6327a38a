#include "methods/hat_functions/hat_contact.hpp"

#include <complex>
#include <numbers>
#include <utility>

#include "methods/complementarity/hat_form.hpp"
#include "methods/discretisation/real_fft.hpp"
#include "methods/discretisation/trajectories.hpp"
#include "methods/hat_functions/hat_strategy.hpp"
#include "methods/structure/receptance.hpp"

namespace signorini {

namespace {

/// C_n and free response under the scheme, n = 0..N/2.
ContactReceptance scheme_receptance(const Problem& problem, const HatSettings& settings) {
  const double step = problem.period() / settings.samples;
  return contact_receptance(problem, settings.samples / 2, [&](int n) {
    return scheme_weights(settings.scheme, 2.0 * std::numbers::pi * n / settings.samples, step);
  });
}

class PreparedHat final : public PreparedMethod {
 public:
  PreparedHat(const Problem& problem, const HatSettings& options, std::optional<double> restitution)
      : problem_(problem),
        options_(options),
        receptance_(scheme_receptance(problem, options)),
        stops_(nodal_stops(problem, restitution)) {}

  Solution solve(const Start& start) override {
    if (receptance_.contacts() == 0) return finish(Eigen::VectorXd{}, {.status = LcpStatus::solved});
    const HatForm form = hat_form(receptance_, stops_, samples());
    const LcpResult result = solve_hat_problem({problem_, stops_, form, options_}, start);
    return finish(form.pressure(result.z), result);
  }

 private:
  [[nodiscard]] int samples() const { return options_.samples; }

  /// Nodal motion behind the nodal pressures -lambda >= 0 [N].
  [[nodiscard]] Solution finish(const Eigen::VectorXd& pressure, const LcpResult& result) const {
    const int contacts = receptance_.contacts();
    RealFft fft(samples());
    Eigen::MatrixXcd spectrum(fft.coefficients(), contacts);
    Eigen::MatrixXd force(samples(), contacts);
    for (int c = 0; c < contacts; ++c) {
      force.col(c) = -pressure.segment(c * samples(), samples());
      fft.forward(force.col(c), spectrum.col(c));
    }
    Eigen::MatrixXd x(samples(), contacts);
    if (contacts > 0) spectrum = contact_motion(receptance_, spectrum);
    for (int c = 0; c < contacts; ++c) fft.inverse(spectrum.col(c), x.col(c));
    Solution solution;
    const bool finite = x.allFinite() && force.allFinite();
    solution.verdict =
        finite && result.status == LcpStatus::solved ? Verdict::converged : Verdict::not_converged;
    solution.message = contacts == 0 ? "no contact in the scene: linear response" : describe(result.status);
    solution.residual = result.residual;
    solution.condition = result.condition;
    solution.work.unknowns = samples() * contacts;
    if (options_.solver == ComplementaritySolver::newton) {
      solution.work.iterations = result.iterations;
      solution.work.factorisations = result.factorisations;
    } else {
      solution.work.pivots = result.pivots;
    }
    if (finite) {
      solution.trajectory =
          std::make_shared<NodalTrajectory>(receptance_.period, std::move(x), std::move(force));
    }
    return solution;
  }

  const Problem& problem_;
  HatSettings options_;
  ContactReceptance receptance_;
  NodalStops stops_;
};

}  // namespace

std::unique_ptr<PreparedMethod> hat_contact(const Problem& problem, const HatSettings& settings,
                                            std::optional<double> restitution) {
  return std::make_unique<PreparedHat>(problem, settings, restitution);
}

}  // namespace signorini
