#include "methods/structure/factorised_receptance.hpp"

#include <gtest/gtest.h>

#include "methods/structure/dynamic_stiffness.hpp"
#include "tests/support/damped_chain.hpp"

namespace signorini {
namespace {

// 40 contacts: more columns than are solved for at a time.
TEST(FactorisedReceptance, IsTheInverseOfEachDynamicStiffnessSeenByTheContacts) {
  constexpr int kHarmonics = 4;
  const Problem problem = test::damped_chain(45, 40);
  const Eigen::MatrixXd directions(contact_directions(problem));
  const auto weights = [](int n) { return scheme_weights(HatScheme::galerkin, 0.4 * n, 0.3); };
  for (const bool dense : {true, false}) {
    const ContactReceptance receptance = factorised_receptance(problem, kHarmonics, weights, dense);
    ASSERT_EQ(receptance.harmonics(), kHarmonics);
    EXPECT_EQ(receptance.report.method, dense ? ReceptanceMethod::dense : ReceptanceMethod::direct);
    EXPECT_FALSE(receptance.report.error.has_value());
    for (int n = 0; n <= kHarmonics; ++n) {
      const HarmonicWeights w = weights(n);
      const Eigen::MatrixXcd inverse =
          test::dense_stiffness(problem, w.mass, w.damping, w.stiffness).fullPivLu().inverse();
      const Eigen::MatrixXcd expected = directions.transpose() * inverse * directions;
      EXPECT_LE((receptance.receptance[static_cast<std::size_t>(n)] - expected).norm(),
                1e-11 * expected.norm());
      const Eigen::VectorXcd free =
          directions.transpose() * inverse * (w.load * load_coefficient(problem, n));
      EXPECT_LE((receptance.free_response.row(n).transpose() - free).norm(), 1e-11 * (1e-3 + free.norm()));
    }
  }
}

TEST(FactorisedReceptance, DropsLoadsBeyondItsHarmonics) {
  const Problem problem = test::damped_chain(5);  // loaded at harmonics 0, 1 and 3
  const auto weights = [](int n) { return exact_weights(1.3 * n); };
  const ContactReceptance few = factorised_receptance(problem, 2, weights, true);
  const ContactReceptance more = factorised_receptance(problem, 3, weights, true);
  EXPECT_EQ(few.free_response, more.free_response.topRows(3));
  EXPECT_EQ(few.free_response.row(2).norm(), 0.0);
  EXPECT_GT(more.free_response.row(3).norm(), 0.0);
}

}  // namespace
}  // namespace signorini
