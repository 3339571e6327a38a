#include "problems/assembly/element_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>

namespace signorini::element_shapes_test {
namespace {

/// A point within the reference element.
Eigen::VectorXd random_point(const ElementShape& shape, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Eigen::VectorXd point(shape.dimension);
  for (double& x : point) x = share(random);
  if (shape.simplex && point.sum() > 1.0) point /= 2.0 * shape.dimension;
  return shape.simplex ? point : Eigen::VectorXd(2.0 * point.array() - 1.0);
}

/// Calls visit(shape, point) with some points within every shape.
void at_random_points(const std::function<void(const ElementShape&, const Eigen::VectorXd&)>& visit) {
  std::mt19937 random(17);
  for (const ElementShape& shape : element_shapes()) {
    for (int trial = 0; trial < 20; ++trial) visit(shape, random_point(shape, random));
  }
}

/// Places of nodes of an element from 0 to 2 along each axis, a digit per axis: "000 200 110".
Eigen::MatrixXd places(const std::string& digits, int dimension, int nodes) {
  Eigen::MatrixXd result(dimension, nodes);
  for (int node = 0; node < nodes; ++node) {
    for (int axis = 0; axis < dimension; ++axis)
      result(axis, node) = digits[static_cast<std::size_t>((dimension + 1) * node + axis)] - '0';
  }
  return result;
}

/// Integral of the product of powers over the reference element.
double moment(const ElementShape& shape, const std::vector<int>& powers) {
  double product = 1.0;
  int sum = shape.dimension;
  for (const int k : powers) {
    product *= shape.simplex ? std::tgamma(k + 1.0) : (k % 2 == 0 ? 2.0 / (k + 1.0) : 0.0);
    sum += k;
  }
  return shape.simplex ? product / std::tgamma(sum + 1.0) : product;
}

/// Calls visit(powers) for all monomials of at most these degrees, in all and along each axis.
void for_each_monomial(int dimension, int total, int along,
                       const std::function<void(const std::vector<int>&)>& visit) {
  std::vector<int> powers(static_cast<std::size_t>(dimension), 0);
  const std::function<void(std::size_t, int)> choose = [&](std::size_t axis, int left) {
    if (axis == powers.size()) return visit(powers);
    for (int k = 0; k <= std::min(left, along); ++k) {
      powers[axis] = k;
      choose(axis + 1, left - k);
    }
  };
  choose(0, total);
}

TEST(ElementShapes, AreFoundByTheirTypeInGmsh) {
  std::set<int> types;
  for (const ElementShape& shape : element_shapes()) {
    EXPECT_EQ(shape_of_gmsh_type(shape.gmsh), &shape) << shape.name;
    EXPECT_TRUE(types.insert(shape.gmsh).second) << shape.name;
  }
  EXPECT_EQ(types, (std::set<int>{1, 2, 3, 4, 5, 8, 9, 10, 11, 12, 15}));
  for (const int other : {-1, 0, 6, 7, 13, 16, 17, 1000}) EXPECT_EQ(shape_of_gmsh_type(other), nullptr);
}

// As gmsh 4.8.4 writes a box of 2 x 2 x 2 that is one element, and elements with straight edges.
TEST(ElementShapes, CountTheirNodesAsGmshDoes) {
  const std::map<int, std::string> expected{
      {1, "0 2"},
      {8, "0 2 1"},
      {2, "00 20 02"},
      {9, "00 20 02 10 11 01"},
      {3, "00 20 22 02"},
      {10, "00 20 22 02 10 21 12 01 11"},
      {4, "000 200 020 002"},
      {11, "000 200 020 002 100 110 010 001 011 101"},
      {5, "000 200 220 020 002 202 222 022"},
      {12,
       "000 200 220 020 002 202 222 022 100 010 001 210 201 120 221 021 102 012 212 122 110 101 011 211 121 "
       "112 111"}};
  for (const auto& [type, digits] : expected) {
    const ElementShape& shape = *shape_of_gmsh_type(type);
    const Eigen::MatrixXd from_0_to_2 = places(digits, shape.dimension, shape.nodes);
    const Eigen::MatrixXd nodes =
        shape.simplex ? Eigen::MatrixXd(0.5 * from_0_to_2) : Eigen::MatrixXd(from_0_to_2.array() - 1.0);
    ASSERT_EQ(reference_nodes(shape).cols(), shape.nodes) << shape.name;
    EXPECT_EQ(reference_nodes(shape), nodes) << shape.name;
  }
}

TEST(ShapeFunctions, SumToOneAndTheirGradientsToNothing) {
  at_random_points([](const ElementShape& shape, const Eigen::VectorXd& point) {
    const Eigen::MatrixXd functions = shape_functions(shape, point);
    ASSERT_EQ(functions.rows(), shape.nodes);
    ASSERT_EQ(functions.cols(), 1 + shape.dimension);
    EXPECT_NEAR(functions.col(0).sum(), 1.0, 1e-14) << shape.name;
    for (int axis = 0; axis < shape.dimension; ++axis)
      EXPECT_NEAR(functions.col(1 + axis).sum(), 0.0, 1e-14) << shape.name;
  });
}

TEST(ShapeFunctions, AreOneAtTheirNodeAndNoneAtTheOthers) {
  for (const ElementShape& shape : element_shapes()) {
    const Eigen::MatrixXd nodes = reference_nodes(shape);
    for (int node = 0; node < shape.nodes; ++node) {
      const Eigen::VectorXd values = shape_functions(shape, nodes.col(node)).col(0);
      EXPECT_LT((values - Eigen::VectorXd::Unit(shape.nodes, node)).cwiseAbs().maxCoeff(), 1e-15)
          << shape.name << ", node " << node;
    }
  }
}

TEST(ShapeFunctions, GiveBackEveryLinearFunction) {
  at_random_points([](const ElementShape& shape, const Eigen::VectorXd& point) {
    const Eigen::VectorXd again = reference_nodes(shape) * shape_functions(shape, point).col(0);
    EXPECT_LT((again - point).norm(), 1e-14) << shape.name;
  });
}

// Of polynomials of degree 1 or 2 along an axis central differences are exact.
TEST(ShapeFunctions, HaveTheDerivativesOfTheirDifferences) {
  at_random_points([](const ElementShape& shape, const Eigen::VectorXd& point) {
    constexpr double kStep = 0.25;
    const Eigen::MatrixXd functions = shape_functions(shape, point);
    for (int axis = 0; axis < shape.dimension; ++axis) {
      const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(shape.dimension, axis);
      const Eigen::VectorXd difference =
          (shape_functions(shape, point + step).col(0) - shape_functions(shape, point - step).col(0)) /
          (2.0 * kStep);
      EXPECT_LT((functions.col(1 + axis) - difference).cwiseAbs().maxCoeff(), 1e-14) << shape.name;
    }
  });
}

TEST(Quadrature, IsExactToTwiceTheDegreePlusOne) {
  for (const ElementShape& shape : element_shapes()) {
    const Eigen::MatrixXd nodes = reference_nodes(shape);
    const std::vector<QuadraturePoint> rule = quadrature(shape);
    const int degree = 2 * shape.degree + 1;
    // Of a cube along each axis, however much that is in all.
    const int total = shape.simplex ? degree : shape.dimension * degree;
    const double volume = moment(shape, std::vector<int>(static_cast<std::size_t>(shape.dimension), 0));
    for_each_monomial(shape.dimension, total, degree, [&](const std::vector<int>& powers) {
      double sum = 0.0;
      for (const QuadraturePoint& point : rule) {
        const Eigen::VectorXd place = nodes * point.functions.col(0);
        double value = point.weight;
        for (int axis = 0; axis < shape.dimension; ++axis)
          value *= std::pow(place[axis], powers[static_cast<std::size_t>(axis)]);
        sum += value;
      }
      EXPECT_NEAR(sum, moment(shape, powers), 1e-14 * volume) << shape.name;
    });
  }
}

TEST(Quadrature, HasPositiveWeightsAtPointsWithin) {
  for (const ElementShape& shape : element_shapes()) {
    const Eigen::MatrixXd nodes = reference_nodes(shape);
    EXPECT_EQ(std::ssize(quadrature(shape)), std::lround(std::pow(shape.degree + 1, shape.dimension)));
    for (const QuadraturePoint& point : quadrature(shape)) {
      EXPECT_GT(point.weight, 0.0) << shape.name;
      const Eigen::VectorXd place = nodes * point.functions.col(0);
      EXPECT_EQ(point.functions.rows(), shape.nodes) << shape.name;
      EXPECT_LT((point.functions - shape_functions(shape, place)).cwiseAbs().maxCoeff(), 1e-14) << shape.name;
      for (const double x : place) EXPECT_TRUE(x > (shape.simplex ? 0.0 : -1.0) && x < 1.0) << shape.name;
      EXPECT_TRUE(!shape.simplex || place.sum() < 1.0) << shape.name;
    }
  }
}

// Integral of (1 - x)^alpha x^k over 0..1: alpha! k! / (alpha + k + 1)!.
TEST(JacobiRule, HasTheMomentsOfItsWeight) {
  for (int points = 1; points <= 6; ++points) {
    for (int alpha = 0; alpha <= 4; ++alpha) {
      const JacobiRule rule = jacobi_rule(points, alpha);
      ASSERT_EQ(rule.points.size(), points);
      ASSERT_EQ(rule.weights.size(), points);
      for (int k = 0; k <= 2 * points; ++k) {
        const double sum = rule.weights.dot(Eigen::VectorXd(rule.points.array().pow(k)));
        const double exact = std::tgamma(alpha + 1.0) * std::tgamma(k + 1.0) / std::tgamma(alpha + k + 2.0);
        const double error = std::abs(sum - exact);
        if (k == 2 * points) {
          EXPECT_GT(error, 1e-8 * exact) << "no rule of so few points is exact there";
        } else {
          EXPECT_LT(error, 1e-14 / (alpha + 1.0)) << points << " points, (1 - x)^" << alpha << " x^" << k;
        }
      }
    }
  }
}

TEST(JacobiRule, HasRisingPointsWithinAndPositiveWeights) {
  for (int alpha = 0; alpha <= 4; ++alpha) {
    const JacobiRule rule = jacobi_rule(6, alpha);
    EXPECT_GT(rule.points[0], 0.0);
    EXPECT_LT(rule.points[5], 1.0);
    EXPECT_GT(rule.weights.minCoeff(), 0.0);
    for (int i = 1; i < 6; ++i) EXPECT_GT(rule.points[i], rule.points[i - 1]);
  }
}

}  // namespace
}  // namespace signorini::element_shapes_test
