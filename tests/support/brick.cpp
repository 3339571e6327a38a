#include "tests/support/brick.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>

namespace signorini::test {

namespace {

struct Element {
  Eigen::Matrix<double, 24, 24> stiffness = Eigen::Matrix<double, 24, 24>::Zero();
  Eigen::Matrix<double, 8, 8> mass = Eigen::Matrix<double, 8, 8>::Zero();  // of each direction
};

// Gauss' rule with two points a side. Corner i of the cube lies at bit d of i in direction d.
Element cube(double edge) {
  Element element;
  const double weight = edge * edge * edge / 8.0;
  for (int point = 0; point < 8; ++point) {
    Eigen::Matrix<double, 8, 1> shape = Eigen::Matrix<double, 8, 1>::Ones();
    Eigen::Matrix<double, 8, 3> gradient = Eigen::Matrix<double, 8, 3>::Ones();
    for (int i = 0; i < 8; ++i) {
      for (int d = 0; d < 3; ++d) {
        const double sign = (i >> d & 1) != 0 ? 1.0 : -1.0;
        const double here = (point >> d & 1) != 0 ? 1.0 : -1.0;
        const double factor = 0.5 * (1.0 + sign * here / std::sqrt(3.0));
        shape(i) *= factor;
        for (int e = 0; e < 3; ++e) gradient(i, e) *= e == d ? sign / edge : factor;
      }
    }
    element.mass += weight * shape * shape.transpose();
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 8; ++j) {
        const Eigen::Matrix3d outer = gradient.row(i).transpose() * gradient.row(j);
        element.stiffness.block<3, 3>(3 * i, 3 * j) +=
            weight * (outer + outer.transpose() + outer.trace() * Eigen::Matrix3d::Identity());
      }
    }
  }
  return element;
}

// First coordinate of a node; negative where it is clamped.
int coordinate(const Brick& brick, int i, int j, int k) {
  return 3 * (i - 1 + brick.nx * (j + (brick.ny + 1) * k));
}

void assemble(const Brick& brick, Problem& problem) {
  const int size = 3 * brick.nx * (brick.ny + 1) * (brick.nz + 1);
  const Element element = cube(1.0 / brick.ny);
  std::vector<Eigen::Triplet<double>> mass;
  std::vector<Eigen::Triplet<double>> stiffness;
  const int cubes = brick.nx * brick.ny * brick.nz;
  for (int c = 0; c < cubes; ++c) {
    const int i = c % brick.nx;
    const int j = c / brick.nx % brick.ny;
    const int k = c / brick.nx / brick.ny;
    std::array<int, 24> place{};
    for (int corner = 0; corner < 8; ++corner) {
      const int x = i + (corner & 1);
      for (int d = 0; d < 3; ++d) {
        place[static_cast<std::size_t>(3 * corner + d)] =
            x == 0 ? -1 : d + coordinate(brick, x, j + (corner >> 1 & 1), k + (corner >> 2 & 1));
      }
    }
    for (int a = 0; a < 24; ++a) {
      for (int b = 0; b < 24; ++b) {
        const int row = place[static_cast<std::size_t>(a)];
        const int column = place[static_cast<std::size_t>(b)];
        if (row < 0 || column < 0) continue;
        stiffness.emplace_back(row, column, element.stiffness(a, b));
        if (a % 3 == b % 3) mass.emplace_back(row, column, element.mass(a / 3, b / 3));
      }
    }
  }
  problem.mass = SparseMatrix(size, size);
  problem.stiffness = SparseMatrix(size, size);
  problem.mass.setFromTriplets(mass.begin(), mass.end());
  problem.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  problem.damping = brick.alpha * problem.mass + brick.beta * problem.stiffness;
}

}  // namespace

Problem to_problem(const Brick& brick) {
  Problem problem;
  problem.name = "brick";
  problem.kind = "brick";
  assemble(brick, problem);
  problem.frequency = brick.frequency;
  for (int a = 0; a < brick.side; ++a) {
    for (int b = 0; b < brick.side; ++b) {
      problem.contacts.push_back({{{coordinate(brick, brick.nx, a, b), 1.0}}, 0.1});
    }
  }
  problem.force = {{coordinate(brick, brick.nx, brick.ny, brick.nz), 1, 1.0, 0.5},
                   {coordinate(brick, brick.nx, brick.ny, 0) + 1, 3, 0.0, 0.7},
                   {coordinate(brick, brick.nx, 0, brick.nz) + 2, 0, 0.25, 0.0}};
  problem.law = Restitution{1.0};
  return problem;
}

}  // namespace signorini::test
