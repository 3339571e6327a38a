#include "methods/complementarity/contact_nodes.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "methods/complementarity/exact_quadrature.hpp"

namespace signorini::contact_nodes_test {
namespace {

// sum_q w_q e^{2 pi i (n - m) t_q} is the integral over the contacts: the conjugate spectrum of their
// indicator function, which is known in closed form.
TEST(ContactNodes, IntegrateProductsOfPolynomialsOverAllIntervals) {
  for (const int harmonics : {1, 20, 300}) {
    const std::vector<ContactInterval> intervals{{0.1, 0.1 + 0.3 / harmonics}, {0.4, 0.75}, {0.9, 1.05}};
    const ContactNodes nodes = nodes_on(intervals, harmonics);
    EXPECT_NEAR(nodes.weight.sum(), 0.5 + 0.3 / harmonics, 1e-13);
    const Eigen::VectorXcd sums =
        phases_at(nodes.time, 2 * harmonics).transpose() * nodes.weight.cast<std::complex<double>>();
    const Eigen::VectorXcd spectrum = indicator_spectrum(intervals, 2 * harmonics);
    EXPECT_LT((sums.conjugate() - spectrum).lpNorm<Eigen::Infinity>(), 1e-12) << harmonics;
  }
}

TEST(ContactNodes, AreFewOnAShortContactWhateverTheNumberOfHarmonics) {
  for (const int harmonics : {10, 1000, 100000})
    EXPECT_LE(nodes_on(0.3, 0.3 + 1.0 / harmonics, harmonics).time.size(), 16) << harmonics;
}

TEST(ContactNodes, OfSamplesAreTheseWithinTheIntervals) {
  const ContactNodes nodes = samples_on({{1.5 / 8.0, 4.5 / 8.0}, {6.5 / 8.0, 8.5 / 8.0}}, 8);
  EXPECT_LT((nodes.time - Eigen::VectorXd{{0.25, 0.375, 0.5, 0.875, 1.0}}).norm(), 1e-15);
  EXPECT_LT((nodes.weight.array() - 0.125).matrix().norm(), 1e-15);
  EXPECT_EQ(samples_on({}, 8).time.size(), 0);
}

TEST(Phases, AreThePowersOfAnInstantsPhase) {
  const Eigen::MatrixXcd phases = phases_at(Eigen::VectorXd{{0.3, 0.7}}, 3);
  ASSERT_EQ(phases.rows(), 2);
  ASSERT_EQ(phases.cols(), 4);
  EXPECT_LT(std::abs(phases(1, 3) - std::polar(1.0, 2.0 * std::numbers::pi * 3 * 0.7)), 1e-14);
}

}  // namespace
}  // namespace signorini::contact_nodes_test
