#include "methods/harmonic_balance/series_solution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <vector>

#include "methods/structure/receptance.hpp"
#include "tests/support/impact_oscillator.hpp"

namespace signorini::series_solution_test {
namespace {

using Complex = std::complex<double>;

TEST(NetWorkRatio, SeesAForceInPhaseWithTheVelocity) {
  Eigen::MatrixXcd x(2, 1);
  Eigen::MatrixXcd lambda(2, 1);
  x << 0.0, Complex(1.0, 0.0);
  lambda << 0.0, Complex(0.0, 2.0);
  EXPECT_DOUBLE_EQ(net_work_ratio(x, lambda), 1.0);
  lambda(1, 0) = -3.0;
  EXPECT_DOUBLE_EQ(net_work_ratio(x, lambda), 0.0);
}

// The integral of lambda x' over a period, by a sum over samples.
TEST(NetWorkRatio, IsTheWorkIntegral) {
  Eigen::MatrixXcd x(3, 1);
  Eigen::MatrixXcd lambda(3, 1);
  x << 0.2, Complex(0.5, 0.1), Complex(-0.2, 0.3);
  lambda << -1.0, Complex(0.4, -0.3), Complex(0.1, 0.6);
  constexpr int kSamples = 64;
  double work = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    double velocity = 0.0;
    double force = lambda(0, 0).real();
    for (int n = 1; n <= 2; ++n) {
      const Complex turn = std::polar(1.0, 2.0 * std::numbers::pi * n * i / kSamples);
      velocity += 2.0 * (Complex(0.0, 2.0 * std::numbers::pi * n) * x(n, 0) * turn).real();
      force += 2.0 * (lambda(n, 0) * turn).real();
    }
    work += force * velocity / kSamples;
  }
  double exchanged = 0.0;
  for (int n = 1; n <= 2; ++n)
    exchanged += 4.0 * std::numbers::pi * n * std::abs(x(n, 0)) * std::abs(lambda(n, 0));
  EXPECT_NEAR(net_work_ratio(x, lambda), std::abs(work) / exchanged, 1e-14);
}

TEST(NetWorkRatio, IsZeroWithoutForceOrMotion) {
  const Eigen::MatrixXcd some = Eigen::MatrixXcd::Constant(3, 2, Complex(1.0, 1.0));
  const Eigen::MatrixXcd none = Eigen::MatrixXcd::Zero(3, 2);
  EXPECT_EQ(net_work_ratio(some, none), 0.0);
  EXPECT_EQ(net_work_ratio(none, some), 0.0);
}

TEST(NetWorkRatio, SumsOverContactsBeforeItTakesTheSize) {
  // What one contact takes from the structure the other gives back.
  Eigen::MatrixXcd x = Eigen::MatrixXcd::Zero(2, 2);
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(2, 2);
  x.row(1) << 1.0, 1.0;
  lambda.row(1) << Complex(0.0, 1.0), Complex(0.0, -1.0);
  EXPECT_DOUBLE_EQ(net_work_ratio(x, lambda), 0.0);
}

/// One oscillator and its equations.
struct Scene {
  Problem problem = test::to_problem({.damping = 0.1, .frequency = 2.2, .gap = 0.2});
  ContactReceptance receptance = fourier_receptance(problem, 4);
  Eigen::VectorXd gap = contact_gaps(problem);
  ProjectedLaw law{Eigen::VectorXd::Constant(1, 8.0), Eigen::VectorXd::Constant(1, 0.75)};

  [[nodiscard]] ProjectedEquations equations() const { return {receptance, gap, law}; }
};

TEST(SeriesData, IsTheResponseToLoadAndForce) {
  const Scene scene;
  Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(5, 1);
  lambda(0, 0) = -0.5;
  lambda(3, 0) = std::complex<double>(0.1, -0.2);
  const FourierTrajectory::Data data = series_data(scene.equations(), lambda);
  EXPECT_EQ(data.lambda, lambda);
  EXPECT_EQ(data.period, scene.receptance.period);
  EXPECT_EQ(data.stiffness[0], 8.0);
  EXPECT_EQ(data.multiplier_weight[0], 0.75);
  EXPECT_TRUE(data.shifts.empty());
  // Static stiffness 1: x_0 = lambda_0; harmonic 3 answers by 1 / (1 - 9 w^2 + 3 i d w).
  EXPECT_LE(std::abs(data.x(0, 0) + 0.5), 1e-15);
  const std::complex<double> stiffness(1.0 - 9.0 * 2.2 * 2.2, 3.0 * 0.1 * 2.2);
  EXPECT_LE(std::abs(data.x(3, 0) - lambda(3, 0) / stiffness), 1e-15);
}

TEST(ExactSolution, ClaimsTheProjectionAndSaysHowItWasFound) {
  const Scene scene;
  const ExactProjection solved{
      .converged = true, .residual = 1e-12, .condition = 30.0, .lambda = Eigen::MatrixXcd::Zero(5, 1)};
  const Solution solution = exact_solution(scene.equations(), solved, "by hand");
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(solution.message, "by hand; contact integral exact, net contact work 0.0e+00 of that exchanged");
  EXPECT_EQ(solution.residual, 1e-12);
  EXPECT_EQ(solution.condition, 30.0);
  EXPECT_EQ(solution.trajectory->bandwidth(), 4);
}

TEST(ContactFreeResponse, HasAPeriodAndNoContact) {
  Scene scene;
  scene.problem.contacts.clear();
  const Solution solution = contact_free_response(fourier_receptance(scene.problem, 4));
  EXPECT_EQ(solution.verdict, Verdict::converged);
  EXPECT_EQ(solution.trajectory->contact_count(), 0);
  EXPECT_DOUBLE_EQ(solution.trajectory->period(), scene.problem.period());
  EXPECT_EQ(solution.work.unknowns, 0);
}

/// Solves on a grid from so many samples on, always with the same force; notes what it is asked.
class SolverOnFineGrids {
 public:
  SolverOnFineGrids(int finest, bool finer_may_help) : fewest_(finest), finer_may_help_(finer_may_help) {}
  GridSolution operator()(const ProjectedEquations& equations, int samples, const Eigen::MatrixXcd& previous,
                          const Start& /*start*/, Work& work) {
    asked.push_back(samples);
    warm.push_back(previous.size() > 0);
    work.pivots = work.pivots.value_or(0) + 10;
    const auto& receptance = equations.receptance;
    Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(receptance.harmonics() + 1, receptance.contacts());
    return {.solved = samples >= fewest_,
            .finer_may_help = finer_may_help_,
            .lambda = lambda,
            .message = "asked"};
  }

  std::vector<int> asked;
  std::vector<bool> warm;

 private:
  int fewest_;
  bool finer_may_help_;
};

template <class Solver>
HarmonicSetup setup_with(const std::shared_ptr<Solver>& solver,
                         const HarmonicOptions& options = {.harmonics = 10}) {
  // The gap is so wide that nothing touches: no force solves the equations.
  const Problem problem = test::to_problem({.frequency = 2.2, .gap = 3.0});
  return harmonic_setup(
      problem, *options.harmonics, options,
      {.law_at =
           [](const ContactReceptance& level) {
             return ProjectedLaw{highest_dynamic_stiffness(level), Eigen::VectorXd::Ones(1)};
           },
       .grid_solver = std::ref(*solver)});
}

TEST(SolveOnGrids, RefinesUntilTheSolverConverges) {
  const auto solver = std::make_shared<SolverOnFineGrids>(300, true);
  HarmonicSetup setup = setup_with(solver);
  Work work;
  const Solution solution = solve_on_grids(setup, {}, work);
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_EQ(solver->asked, (std::vector<int>{80, 160, 320}));
  EXPECT_EQ(work.pivots, 30);
  EXPECT_EQ(solution.message, "asked; N = 320, net contact work 0.0e+00 of that exchanged");
}

std::vector<int> grids_asked(const HarmonicOptions& options, int fewest) {
  const auto solver = std::make_shared<SolverOnFineGrids>(fewest, true);
  Work work;
  (void)solve_on_grids(setup_with(solver, options), {}, work);
  return solver->asked;
}

TEST(SolveOnGrids, BeginsCoarseWhereTheExactIntegralFollows) {
  EXPECT_EQ(grids_asked({.harmonics = 20}, 1), (std::vector<int>{160}));
  EXPECT_EQ(grids_asked({.harmonics = 3}, 1), (std::vector<int>{64}));
  EXPECT_EQ(grids_asked({.harmonics = 20, .quadrature = Quadrature::sampled}, 1), (std::vector<int>{640}));
}

TEST(SolveOnGrids, DoublesUpTo128SamplesPerHarmonicUnlessTheUserFixedThem) {
  constexpr int kNever = 1000000;
  EXPECT_EQ(grids_asked({.harmonics = 20}, kNever), (std::vector<int>{160, 320, 640, 1280, 2560}));
  EXPECT_EQ(grids_asked({.harmonics = 20, .samples = 777}, kNever), (std::vector<int>{777}));
}

/// Claims to have solved with a force whose first harmonic does net work; notes the grids it is asked for.
struct WorkingForce {
  GridSolution operator()(const ProjectedEquations& equations, int samples,
                          const Eigen::MatrixXcd& /*previous*/, const Start& /*start*/, Work& /*work*/) {
    asked.push_back(samples);
    Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Zero(equations.receptance.harmonics() + 1, 1);
    lambda(1, 0) = 0.5;
    return {.solved = true, .lambda = lambda, .message = "asked"};
  }
  std::vector<int> asked;
};

TEST(SolveOnGrids, RefinesASampledIntegralUntilTheEnergyIdentityHoldsOrNoGridIsLeft) {
  const auto solver = std::make_shared<WorkingForce>();
  const HarmonicSetup setup = setup_with(solver, {.harmonics = 10, .quadrature = Quadrature::sampled});
  Work work;
  const Solution solution = solve_on_grids(setup, {}, work);
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;  // as asked for
  EXPECT_EQ(solver->asked, (std::vector<int>{320, 640, 1280}));
}

TEST(SolveOnGrids, StopsWhereTheExactIntegralFollows) {
  const auto solver = std::make_shared<WorkingForce>();
  const HarmonicSetup setup = setup_with(solver);
  Work work;
  const Solution solution = solve_on_grids(setup, {}, work);
  EXPECT_EQ(solution.verdict, Verdict::converged) << solution.message;
  EXPECT_NE(solution.message.find("contact integral exact"), std::string::npos) << solution.message;
  EXPECT_EQ(solver->asked, (std::vector<int>{80}));
}

TEST(SolveOnGrids, StopsWhereFinerGridsCannotHelp) {
  const auto solver = std::make_shared<SolverOnFineGrids>(300, false);
  HarmonicSetup setup = setup_with(solver);
  Work work;
  EXPECT_EQ(solve_on_grids(setup, {}, work).verdict, Verdict::not_converged);
  EXPECT_EQ(solver->asked, (std::vector<int>{80}));
}

TEST(SolveOnGrids, KeepsWithinItsLimit) {
  const auto solver = std::make_shared<SolverOnFineGrids>(300, true);
  HarmonicSetup setup = setup_with(solver);
  setup.options.max_iterations = 15;
  Work work;
  const Solution solution = solve_on_grids(setup, {}, work);
  EXPECT_EQ(solution.verdict, Verdict::not_converged);
  EXPECT_EQ(solver->asked, (std::vector<int>{80, 160}));
  EXPECT_EQ(solution.message.find("pivots or iterations used up"), 0U) << solution.message;
}

}  // namespace
}  // namespace signorini::series_solution_test
