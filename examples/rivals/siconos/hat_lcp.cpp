#include "hat_lcp.hpp"

#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SiconosConfig.h>
#include <SolverOptions.h>
#include <lcp_cst.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "methods/complementarity/forms.hpp"
#include "methods/hat_functions/hat_contact.hpp"
#include "methods/structure/receptance.hpp"

namespace siconos_rivals {

namespace {

using signorini::Problem;

struct Answer {
  Eigen::VectorXd z;
  int status = 0;  ///< as Siconos returns it, 0: solved
};

/// Lemke's method with the options that Siconos gives it.
Answer by_lemke(const signorini::Lcp& lcp) {
  const int size = lcp.matrix->size();
  std::vector<int> all(static_cast<std::size_t>(size));
  std::iota(all.begin(), all.end(), 0);
  Eigen::MatrixXd A = lcp.matrix->submatrix(all, all);  // by columns, as Siconos keeps arrays
  Eigen::VectorXd q = lcp.offset;
  Answer answer{.z = Eigen::VectorXd::Zero(size)};
  Eigen::VectorXd w = Eigen::VectorXd::Zero(size);
  const std::unique_ptr<NumericsMatrix, void (*)(NumericsMatrix*)> matrix(
      NM_create_from_data(NM_DENSE, size, size, A.data()), [](NumericsMatrix* m) {
        m->matrix0 = nullptr;  // Eigen's
        NM_clear(m);
        free(m);
      });
  LinearComplementarityProblem problem{size, matrix.get(), q.data()};
  SolverOptions* options = solver_options_create(SICONOS_LCP_LEMKE);
  answer.status = linearComplementarity_driver(&problem, answer.z.data(), w.data(), options);
  solver_options_delete(options);
  return answer;
}

class Prepared final : public signorini::PreparedMethod {
 public:
  Prepared(const Problem& problem, int samples)
      : samples_(samples),
        receptance_(grid_receptance(problem, signorini::HatScheme::galerkin, samples)),
        stops_(nodal_stops(problem, scene_restitution(problem))) {
    if (receptance_.rigid_count() > 0)
      throw std::runtime_error("a rigid motion that no spring holds has no place in this problem");
  }

  signorini::Solution solve(const signorini::Start&) override {
    const signorini::HatForm form = hat_form(receptance_, stops_, samples_);
    const Answer answer = by_lemke(form.lcp);
    signorini::Solution solution;
    solution.work.unknowns = form.lcp.matrix->size();
    solution.residual = natural_residual(form.lcp, answer.z);
    solution.message = "status " + std::to_string(answer.status) + " of Lemke's method";
    solution.trajectory = nodal_motion(receptance_, form.pressure(answer.z), samples_,
                                       Eigen::RowVectorXd::Zero(stops_.gap.size()));
    solution.verdict = answer.status == 0 && solution.trajectory ? signorini::Verdict::converged
                                                                 : signorini::Verdict::not_converged;
    return solution;
  }

 private:
  int samples_;
  signorini::ContactReceptance receptance_;
  signorini::NodalStops stops_;
};

}  // namespace

HatLemke::HatLemke(const Options& options) : options_(options) {
  signorini::require_option(options.samples >= 4 && options.samples <= 4096, "samples", options.samples,
                            "must be from 4 to 4096");
}

signorini::Support HatLemke::supports(const Problem& problem) const {
  if (problem.contact_count() == 0) return {false, "no contact in the scene"};
  if (problem.contact_count() * options_.samples > 16384)
    return {false, "an array of more than 16384 unknowns"};
  return grid_support(problem, options_.samples);
}

signorini::RepresentedLaw HatLemke::law(const Problem& problem) const {
  return signorini::as_represented(problem.law());
}

std::unique_ptr<signorini::PreparedMethod> HatLemke::prepare(const Problem& problem) const {
  return std::make_unique<Prepared>(problem, options_.samples);
}

}  // namespace siconos_rivals
