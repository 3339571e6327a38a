#include "methods/structure/contact_receptance.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace {

TEST(ContactMotion, IsTheFreeMotionAndWhatEachForceAddsHarmonicByHarmonic) {
  ContactReceptance receptance;
  for (int n = 0; n < 4; ++n) receptance.receptance.push_back(Eigen::MatrixXcd::Random(2, 2));
  receptance.free_response = Eigen::MatrixXcd::Random(4, 2);
  const Eigen::MatrixXcd lambda = Eigen::MatrixXcd::Random(6, 2);  // harmonics beyond H do not count
  const Eigen::MatrixXcd x = contact_motion(receptance, lambda);
  ASSERT_EQ(x.rows(), 4);
  for (int n = 0; n < 4; ++n) {
    for (int c = 0; c < 2; ++c) {
      std::complex<double> expected = receptance.free_response(n, c);
      for (int d = 0; d < 2; ++d)
        expected += receptance.receptance[static_cast<std::size_t>(n)](c, d) * lambda(n, d);
      EXPECT_LE(std::abs(x(n, c) - expected), 1e-14);
    }
  }
}

TEST(ContactReceptance, CountsItsHarmonicsAndContacts) {
  ContactReceptance receptance;
  receptance.receptance.assign(8, Eigen::MatrixXcd::Zero(3, 3));
  receptance.free_response = Eigen::MatrixXcd::Zero(8, 3);
  EXPECT_EQ(receptance.harmonics(), 7);
  EXPECT_EQ(receptance.contacts(), 3);
}

}  // namespace
}  // namespace signorini
