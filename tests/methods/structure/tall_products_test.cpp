#include "methods/structure/tall_products.hpp"

#include <gtest/gtest.h>

namespace signorini {
namespace {

TEST(TallProducts, AreThoseOfEigen) {
  for (const int rows : {1, 7, 500}) {
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(rows, 5), b = Eigen::MatrixXd::Random(rows, 3);
    const Eigen::MatrixXd product = transposed_product(a, b);
    EXPECT_LE((product - (a.transpose() * b).eval()).norm(), 1e-14 * a.norm() * b.norm());
    const Eigen::MatrixXd s = Eigen::MatrixXd::Random(5, 3);
    Eigen::MatrixXd c = Eigen::MatrixXd::Random(rows, 3);
    const Eigen::MatrixXd expected = c - (a * s).eval();
    subtract_product(a, s, c);
    EXPECT_LE((c - expected).norm(), 1e-14 * (1.0 + a.norm() * s.norm()));
  }
}

TEST(TallProducts, TakeEmptyMatrices) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(6, 0), b = Eigen::MatrixXd::Random(6, 2);
  EXPECT_EQ(transposed_product(a, b).rows(), 0);
  EXPECT_EQ(transposed_product(a, b).cols(), 2);
  const Eigen::MatrixXd before = Eigen::MatrixXd::Random(6, 2);
  Eigen::MatrixXd c = before;
  subtract_product(a, Eigen::MatrixXd(0, 2), c);
  EXPECT_EQ(c, before);
}

}  // namespace
}  // namespace signorini
