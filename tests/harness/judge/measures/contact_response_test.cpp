#include "harness/judge/measures/contact_response.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>
#include <stdexcept>

#include "methods/structure/periodic_response.hpp"
#include "methods/structure/receptance.hpp"
#include "tests/harness/fake_method.hpp"
#include "tests/support/elastic_block.hpp"
#include "tests/support/impact_oscillator.hpp"
#include "tests/support/structure_scenes.hpp"

namespace signorini::contact_response_test {
namespace {

using Complex = std::complex<double>;

/// A contact force given by its Fourier coefficients; nothing is known of the motion.
class HarmonicForce final : public Trajectory {
 public:
  HarmonicForce(double period, Eigen::MatrixXcd coefficients)
      : period_(period), coefficients_(std::move(coefficients)) {}
  [[nodiscard]] int contact_count() const override { return static_cast<int>(coefficients_.cols()); }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override {
    const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(count, coefficients_.cols());
    return {zero, zero, sample_series(coefficients_, count)};
  }
  [[nodiscard]] std::optional<int> bandwidth() const override {
    return static_cast<int>(coefficients_.rows()) - 1;
  }
  [[nodiscard]] Eigen::MatrixXcd force_coefficients() const override { return coefficients_; }

 private:
  double period_;
  Eigen::MatrixXcd coefficients_;
};

/// Harmonics 0..H of a force on each contact, none like another.
Eigen::MatrixXcd coefficients(int harmonics, int contacts) {
  Eigen::MatrixXcd force(harmonics + 1, contacts);
  for (int n = 0; n <= harmonics; ++n) {
    for (int c = 0; c < contacts; ++c) force(n, c) = std::polar(1.0 / (1.0 + n), 0.7 * n + 1.3 * n * c);
  }
  return force;
}

/// Work per period, from the whole field of every harmonic.
struct FieldWork {
  double load = 0.0;
  Eigen::VectorXd contacts;
  double dissipation = 0.0;
};

FieldWork field_work(const Problem& problem, const HarmonicForce& force) {
  const ForceSeries series = force_series(problem, force, 512);
  const SparseMatrix W = contact_directions(problem);
  FieldWork work{.contacts = Eigen::VectorXd::Zero(W.cols())};
  DynamicStiffness stiffness(problem, problem.size() < 200);
  for (int n = 1; n < series.lambda.rows(); ++n) {
    const double w = n * series.base_frequency;
    Eigen::VectorXcd load = Eigen::VectorXcd::Zero(problem.size());
    if (n % series.order == 0) load = 0.5 * load_harmonic(problem, n / series.order);
    const Eigen::VectorXcd lambda = series.lambda.row(n).transpose();
    stiffness.factorise(exact_weights(w));
    const Eigen::VectorXcd v = Complex(0.0, w) * stiffness.solve(load + W * lambda).col(0);
    work.load += 2.0 * force.period() * load.dot(v).real();
    work.contacts += 2.0 * force.period() * lambda.conjugate().cwiseProduct(W.transpose() * v).real();
    work.dissipation += 2.0 * force.period() * v.dot(problem.damping() * v).real();
  }
  return work;
}

void expect_what_the_field_shows(const Problem& problem, const HarmonicForce& force, double tolerance,
                                 const ContactSpace* space = nullptr) {
  const ContactResponse response(problem, force_series(problem, force, 512), space);
  const SparseMatrix W = contact_directions(problem);
  const Eigen::MatrixXd x = PeriodicResponse(problem, force).displacement(32) * W;
  EXPECT_LE((response.displacement(32) - x).norm(), tolerance * x.norm());
  const HarmonicForce none(force.period(),
                           Eigen::MatrixXcd::Zero(*force.bandwidth() + 1, force.contact_count()));
  const Eigen::MatrixXd free = PeriodicResponse(problem, none).displacement(32) * W;
  EXPECT_LE((response.free_displacement(32) - free).norm(), tolerance * free.norm());
  const FieldWork work = field_work(problem, force);
  EXPECT_LE((response.contact_work() - work.contacts).norm(), tolerance * work.contacts.norm());
  EXPECT_NEAR(response.work_of_load(), work.load, tolerance * response.largest_work_of_load());
  EXPECT_LE(std::abs(response.work_of_load()), response.largest_work_of_load());
  EXPECT_NEAR(response.dissipation(), work.dissipation, tolerance * work.dissipation);
}

TEST(ContactResponse, OfASmallStructureIsThatOfItsField) {
  const Problem problem =
      test::elastic_block_problem({.nx = 3, .ny = 2, .nz = 2, .beta = 0.05, .frequency = 0.3});
  expect_what_the_field_shows(problem, HarmonicForce(problem.period(), coefficients(6, 4)), 1e-12);
}

TEST(ContactResponse, CarriesTheLoadAtTheHarmonicsOfALongerPeriod) {
  const Problem problem =
      test::elastic_block_problem({.nx = 3, .ny = 2, .nz = 2, .beta = 0.05, .frequency = 0.3});
  expect_what_the_field_shows(problem, HarmonicForce(3.0 * problem.period(), coefficients(10, 4)), 1e-12);
}

TEST(ContactResponse, OfALargeStructureIsThatOfItsField) {
  const Problem problem =
      test::elastic_block_problem({.nx = 9, .ny = 8, .nz = 8, .side = 2, .beta = 0.02, .frequency = 0.2});
  ASSERT_GT(problem.size(), 2000);
  // Receptances are good to 1e-10 of their norm; dissipation is a difference of two works.
  expect_what_the_field_shows(problem, HarmonicForce(problem.period(), coefficients(5, 4)), 1e-8);
}

// A space whose bound holds is taken, one whose bound does not is grown first: the response is right either
// way, and differs from that by receptances by rounding.
TEST(ContactResponse, TakesASpaceWhereItsBoundHolds) {
  const Problem problem = test::padded_block_problem({});
  const HarmonicForce force(problem.period(), coefficients(5, 9));
  const ContactSpace large(problem), small(problem, {.small = 10, .whole = 20});
  expect_what_the_field_shows(problem, force, 1e-7, &large);
  expect_what_the_field_shows(problem, force, 1e-7, &small);
  const auto work = [&](const ContactSpace* space) {
    return ContactResponse(problem, force_series(problem, force, 512), space).work_of_load();
  };
  EXPECT_NE(work(&large), work(nullptr));
  EXPECT_NE(work(&small), work(nullptr));
  EXPECT_NE(work(&small), work(&large));
}

// Forty contacts, more than a space starts from, in any phase to each other: it grows for the force and for
// its conjugate until their work is known.
TEST(ContactResponse, TakesASpaceOfManyContactsThatHasGrown) {
  const Problem problem =
      test::padded_block_problem({.elements = {10, 3, 3}, .patch = {{{0.1, 2.0}, {0.0, 0.5}}}});
  const HarmonicForce force(problem.period(), coefficients(8, problem.contact_count()));
  const ContactSpace space(problem, {.small = 24, .whole = 48});
  expect_what_the_field_shows(problem, force, 1e-6, &space);
  const auto work = [&](const ContactSpace* given) {
    return ContactResponse(problem, force_series(problem, force, 512), given).contact_work().sum();
  };
  EXPECT_NE(work(&space), work(nullptr));
}

TEST(ContactResponse, OfALargeStructureWithOtherDampingIsThatOfItsField) {
  Problem problem =
      test::elastic_block_problem({.nx = 9, .ny = 8, .nz = 8, .side = 1, .beta = 0.02, .frequency = 0.2});
  problem.edit_structure([&](Structure& s) { s.damping.coeffRef(0, 0) += 1.0; });
  expect_what_the_field_shows(problem, HarmonicForce(problem.period(), coefficients(3, 1)), 1e-12);
}

const test::ImpactOscillator kStop{.damping = 0.1, .frequency = 2.2, .gap = 0.2, .restitution = 0.8};

TEST(ContactResponse, WithoutContactDissipatesWhatTheLoadPutsIn) {
  const Problem problem = test::to_problem(kStop);
  const HarmonicForce none(problem.period(), Eigen::MatrixXcd::Zero(1, 1));
  const ContactResponse response(problem, force_series(problem, none, 512));
  // Work in over a period equals work out: pi |F| |u| sin(phase) = pi c w |u|^2.
  const std::complex<double> amplitude = 1.0 / std::complex<double>(1.0 - 2.2 * 2.2, 0.1 * 2.2);
  const double work = std::numbers::pi * 0.1 * 2.2 * std::norm(amplitude);
  EXPECT_NEAR(response.work_of_load(), work, 1e-13);
  EXPECT_NEAR(response.dissipation(), work, 1e-13);
  EXPECT_NEAR(response.contact_work()[0], 0.0, 1e-15);
}

// A disc that whirls on a circle z = Z e^{i w t}, z'' + d z' + (k - i s) z = F e^{i w t}: per period, D takes
// d w^2 |Z|^2 T and the circulatory force feeds s w |Z|^2 T.
TEST(ContactResponse, CountsWhatACirculatoryForceFeeds) {
  constexpr double kDamping = 0.3, kCirculatory = 0.2, kFrequency = 1.7;
  Problem problem;
  problem.frequency = kFrequency;
  problem.edit_structure([&](Structure& s) {
    s.mass = Eigen::Matrix2d::Identity().sparseView();
    s.damping = Eigen::Matrix2d(kDamping * Eigen::Matrix2d::Identity()).sparseView();
    s.stiffness = Eigen::Matrix2d{{1.0, kCirculatory}, {-kCirculatory, 1.0}}.sparseView();
  });
  problem.force = {{.dof = 0, .cos = 1.0}, {.dof = 1, .sin = 1.0}};
  const ContactResponse response(
      problem, {.order = 1, .base_frequency = kFrequency, .lambda = Eigen::MatrixXcd::Zero(3, 0)});
  const double size =
      std::norm(1.0 / Complex(1.0 - kFrequency * kFrequency, kDamping * kFrequency - kCirculatory));
  const double expected = (kDamping * kFrequency - kCirculatory) * kFrequency * size * problem.period();
  EXPECT_NEAR(response.dissipation(), expected, 1e-12 * expected);
  EXPECT_NEAR(response.work_of_load(), expected, 1e-12 * expected);
}

TEST(ContactResponse, BalancesItsEnergyOverAnImpact) {
  const Problem problem = test::to_problem(kStop);
  const auto orbit = test::single_impact_orbits(kStop).front();
  constexpr int kHarmonics = 4000;
  Eigen::MatrixXcd impact(kHarmonics + 1, 1);
  for (int n = 0; n <= kHarmonics; ++n) {
    impact(n, 0) = -orbit.impulse / orbit.period *
                   std::polar(1.0, -2.0 * std::numbers::pi * n * orbit.impact_time / orbit.period);
  }
  const ContactResponse response(problem,
                                 force_series(problem, HarmonicForce(orbit.period, impact), kHarmonics));
  const double balance = response.work_of_load() + response.contact_work()[0] - response.dissipation();
  EXPECT_NEAR(balance, 0.0, 1e-12 * response.work_of_load());
  // The impact takes m (1 - e^2) v^2 / 2; truncation leaves 1/H of it out.
  const double loss = 0.5 * (1.0 - 0.64) * orbit.approach * orbit.approach;
  EXPECT_NEAR(-response.contact_work()[0], loss, 2e-3 * loss);
}

TEST(VelocityJumps, AreTheInverseMassSeenByTheContacts) {
  Problem problem = test::one_mass();
  problem.edit_structure([](Structure& s) { s.mass *= 4.0; });
  problem.contacts[0].normal = {{0, -2.0}};
  EXPECT_DOUBLE_EQ(velocity_jumps(problem)(0, 0), -0.5);
  problem.edit_structure([](Structure& s) { s.mass *= 0.0; });
  EXPECT_THROW((void)velocity_jumps(problem), std::invalid_argument);
}

}  // namespace
}  // namespace signorini::contact_response_test
