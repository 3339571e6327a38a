#include "methods/structure/bases/structure_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "methods/structure/receptance.hpp"
#include "problems/assembly/beam.hpp"
#include "problems/assembly/damping.hpp"

namespace signorini::structure_modes_test {
namespace {

using Complex = std::complex<double>;

constexpr double kRatio = 0.02, kFrequency = 1.3;

/// A bar, everything 1, of one damping ratio, a contact at its tip.
Problem damped_bar(int elements, const std::vector<double>& ratios = {kRatio}) {
  Problem problem;
  problem.edit_structure([&](Structure& s) {
    s = assemble(Bar{.elements = elements});
    s.damping = damping_matrix(ModalDamping{ratios}, s.mass, s.stiffness);
  });
  problem.frequency = kFrequency;
  problem.contacts = {Contact{.normal = {{elements - 1, 1.0}}, .gap = 0.1, .law = Restitution{}}};
  return problem;
}

/// At the tip, from the modes of the elements in closed form: sin(theta_k i) at node i, theta_k = (2 k - 1)
/// pi / (2 N).
Complex closed_form(int elements, double w) {
  const double N = elements, h = 1.0 / N;
  Complex sum = 0.0;
  for (int k = elements; k >= 1; --k) {
    const double theta = (2.0 * k - 1.0) * std::numbers::pi / (2.0 * N);
    const double half = std::sin(0.5 * theta);
    const double mass = h / 6.0 * (4.0 + 2.0 * std::cos(theta)) * N / 2.0;
    const double square = 12.0 / (h * h) * half * half / (2.0 + std::cos(theta));
    sum += 1.0 / (mass * Complex(square - w * w, 2.0 * kRatio * std::sqrt(square) * w));
  }
  return sum;
}

TEST(StructureModes, GiveTheReceptanceOfABarInClosedForm) {
  for (const int elements : {50, 1000}) {
    const Problem problem = damped_bar(elements);
    constexpr int kHarmonics = 32;
    const ContactReceptance found = fourier_receptance(problem, kHarmonics);
    for (int n = 0; n <= kHarmonics; ++n) {
      const Complex exact = closed_form(elements, n * kFrequency);
      EXPECT_LT(std::abs(found.receptance[static_cast<std::size_t>(n)](0, 0) - exact),
                1e-10 * std::abs(exact))
          << elements << " elements, harmonic " << n;
    }
  }
}

/// Receptances by the modes beside those by dense factors: between modes, at one, and far above all.
/// \param first  0: from the static one on
void expect_dense_form(const Problem& problem, int first = 0, double tolerance = 1e-10) {
  const auto modes = uncoupled_modes(problem);
  ASSERT_NE(modes, nullptr);
  EXPECT_EQ(modes, uncoupled_modes(problem)) << "they are made once";
  const Eigen::Index third = modes->mass.size() - 3;
  const std::vector<double> rates = {0.0,  1.3,   std::sqrt(modes->stiffness[third] / modes->mass[third]),
                                     17.0, 300.0, 1e4};
  const auto weights = [&](int n) { return exact_weights(rates[static_cast<std::size_t>(n)]); };
  DynamicStiffness factors(problem, true);
  const int tip = problem.contacts.front().normal.front().first;
  for (int n = first; n < static_cast<int>(rates.size()); ++n) {
    const HarmonicWeights w = weights(n);
    factors.factorise(w);
    const Complex exact = factors.solve(Eigen::VectorXcd::Unit(problem.size(), tip))(tip, 0);
    Complex sum = 0.0;
    for (Eigen::Index k = 0; k < modes->mass.size(); ++k) {
      const double seen = modes->vectors(tip, k);
      sum += seen * seen /
             (w.mass * modes->mass[k] + w.damping * modes->damping[k] + w.stiffness * modes->stiffness[k]);
    }
    EXPECT_LT(std::abs(sum - exact), tolerance * std::abs(exact)) << n;
  }
}

TEST(StructureModes, AreTheDenseForm) { expect_dense_form(damped_bar(300, {0.05, 0.0, 0.01})); }

TEST(StructureModes, HoldMotionsWithoutMass) {
  constexpr int kElements = 120;
  Problem problem = damped_bar(kElements);
  problem.edit_structure([](Structure& s) {
    s = assemble(
        Bar{.elements = kElements, .contact_mass = ContactMass::massless, .contacts = {kElements - 1}});
    s.damping = damping_matrix(ModalDamping{{kRatio}}, s.mass, s.stiffness);
  });
  problem.set_law(Massless{});
  expect_dense_form(problem);
}

TEST(StructureModes, HoldAFreeStructure) {
  Problem free = damped_bar(60);
  free.edit_structure([](Structure& s) {
    s.stiffness.coeffRef(0, 0) = -s.stiffness.coeff(0, 1);  // without the element at the wall
    s.damping = damping_matrix(ModalDamping{{kRatio}}, s.mass, s.stiffness);
  });
  const auto modes = uncoupled_modes(free);
  ASSERT_NE(modes, nullptr);
  EXPECT_LT(modes->stiffness.minCoeff(), 1e-12);
  expect_dense_form(free, 1, 1e-9);
}

TEST(StructureModes, AreNoneWhereDampingCouplesThem) {
  const auto changed = [](const std::function<void(Structure&)>& change) {
    Problem problem = damped_bar(40);
    problem.edit_structure(change);
    return uncoupled_modes(problem);
  };
  EXPECT_NE(changed([](Structure&) {}), nullptr);
  EXPECT_EQ(changed([](Structure& s) { s.damping.coeffRef(0, 0) += 1e-4; }), nullptr);
  EXPECT_EQ(changed([](Structure& s) { s.damping.coeffRef(0, 1) += 0.1; }), nullptr);
}

}  // namespace
}  // namespace signorini::structure_modes_test
