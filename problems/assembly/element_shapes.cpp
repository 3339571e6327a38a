#include "problems/assembly/element_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/linear_algebra/symmetric_eigen.hpp"

namespace signorini {

namespace {

// The corners, a digit each, that each node beyond the corners is in the middle of, in Gmsh's order.
std::vector<std::string_view> middles(const ElementShape& shape) {
  if (shape.degree < 2) return {};
  if (shape.simplex && shape.dimension == 2) return {"01", "12", "02"};
  if (shape.simplex) return {"01", "12", "02", "03", "23", "13"};
  if (shape.dimension == 1) return {"01"};
  if (shape.dimension == 2) return {"01", "12", "23", "30", "0123"};
  return {"01", "03", "04",   "12",   "15",   "23",   "26",   "37",   "45",      "47",
          "56", "67", "0123", "0145", "0347", "1256", "2367", "4567", "01234567"};
}

Eigen::MatrixXd corners(const ElementShape& shape) {
  const int d = shape.dimension;
  if (shape.simplex) {
    Eigen::MatrixXd places = Eigen::MatrixXd::Zero(d, d + 1);
    places.rightCols(d).setIdentity();
    return places;
  }
  Eigen::MatrixXd places(d, 1 << d);
  for (int c = 0; c < places.cols(); ++c) {
    const bool round = (c & 2) != 0;  // around a square: -1, 1, 1, -1 along the first axis
    places(0, c) = ((c & 1) != 0) != round ? 1.0 : -1.0;
    if (d > 1) places(1, c) = round ? 1.0 : -1.0;
    if (d > 2) places(2, c) = (c & 4) != 0 ? 1.0 : -1.0;
  }
  return places;
}

// The polynomial of degree 1 or 2 on -1..1 that is 1 at `node`, one of -1, 0, 1, and 0 at the others; and its
// derivative.
std::pair<double, double> along_axis(int degree, double node, double x) {
  if (degree == 1) return {0.5 * (1.0 + node * x), 0.5 * node};
  if (node == 0.0) return {1.0 - x * x, -2.0 * x};
  return {0.5 * x * (x + node), x + 0.5 * node};
}

Eigen::MatrixXd cube_functions(const ElementShape& shape, const Eigen::VectorXd& point) {
  const Eigen::MatrixXd nodes = reference_nodes(shape);
  Eigen::MatrixXd functions = Eigen::MatrixXd::Ones(shape.nodes, 1 + shape.dimension);
  for (int node = 0; node < shape.nodes; ++node) {
    for (int axis = 0; axis < shape.dimension; ++axis) {
      const auto [value, slope] = along_axis(shape.degree, nodes(axis, node), point[axis]);
      for (int column = 0; column <= shape.dimension; ++column)
        functions(node, column) *= column == axis + 1 ? slope : value;
    }
  }
  return functions;
}

// In the barycentric coordinates L: L_a of degree 1; L_a (2 L_a - 1) and 4 L_a L_b of degree 2.
Eigen::MatrixXd simplex_functions(const ElementShape& shape, const Eigen::VectorXd& point) {
  const int d = shape.dimension;
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(d + 1, 1 + d);
  L(0, 0) = 1.0 - point.sum();
  L.col(0).tail(d) = point;
  L.row(0).tail(d).setConstant(-1.0);
  L.bottomRightCorner(d, d).setIdentity();
  if (shape.degree == 1) return L;
  Eigen::MatrixXd functions(shape.nodes, 1 + d);
  for (int a = 0; a <= d; ++a) {
    functions(a, 0) = L(a, 0) * (2.0 * L(a, 0) - 1.0);
    functions.row(a).tail(d) = (4.0 * L(a, 0) - 1.0) * L.row(a).tail(d);
  }
  int node = d + 1;
  for (const std::string_view edge : middles(shape)) {
    const int a = edge[0] - '0', b = edge[1] - '0';
    functions(node, 0) = 4.0 * L(a, 0) * L(b, 0);
    functions.row(node).tail(d) = 4.0 * (L(a, 0) * L.row(b).tail(d) + L(b, 0) * L.row(a).tail(d));
    ++node;
  }
  return functions;
}

}  // namespace

const std::vector<ElementShape>& element_shapes() {
  static const std::vector<ElementShape> shapes{// name, type of Gmsh, dimension, degree, simplex, nodes
                                                {"points", 15, 0, 1, true, 1},
                                                {"lines of 2 nodes", 1, 1, 1, false, 2},
                                                {"lines of 3 nodes", 8, 1, 2, false, 3},
                                                {"triangles of 3 nodes", 2, 2, 1, true, 3},
                                                {"triangles of 6 nodes", 9, 2, 2, true, 6},
                                                {"quadrangles of 4 nodes", 3, 2, 1, false, 4},
                                                {"quadrangles of 9 nodes", 10, 2, 2, false, 9},
                                                {"tetrahedra of 4 nodes", 4, 3, 1, true, 4},
                                                {"tetrahedra of 10 nodes", 11, 3, 2, true, 10},
                                                {"hexahedra of 8 nodes", 5, 3, 1, false, 8},
                                                {"hexahedra of 27 nodes", 12, 3, 2, false, 27}};
  return shapes;
}

const ElementShape* shape_of_gmsh_type(int type) {
  const auto found = std::ranges::find(element_shapes(), type, &ElementShape::gmsh);
  return found == element_shapes().end() ? nullptr : &*found;
}

Eigen::MatrixXd reference_nodes(const ElementShape& shape) {
  const Eigen::MatrixXd ends = corners(shape);
  Eigen::MatrixXd places(shape.dimension, shape.nodes);
  places.leftCols(ends.cols()) = ends;
  Eigen::Index node = ends.cols();
  for (const std::string_view around : middles(shape)) {
    places.col(node).setZero();
    for (const char corner : around)
      places.col(node) += ends.col(corner - '0') / static_cast<double>(around.size());
    ++node;
  }
  return places;
}

Eigen::MatrixXd shape_functions(const ElementShape& shape, const Eigen::VectorXd& point) {
  return shape.simplex ? simplex_functions(shape, point) : cube_functions(shape, point);
}

JacobiRule jacobi_rule(int points, int alpha) {
  // The three-term recurrence of the orthogonal polynomials is a symmetric matrix: its eigenvalues are the
  // points, the first entries of its eigenvectors give the weights. On -1..1, beta = 0.
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(points, points);
  for (int k = 0; k < points; ++k) {
    const double s = 2.0 * k + alpha;
    J(k, k) = alpha == 0 ? 0.0 : -static_cast<double>(alpha * alpha) / (s * (s + 2.0));
    if (k == 0) continue;
    const double n = k;
    const double b = 4.0 * n * n * (n + alpha) * (n + alpha) / (s * s * (s + 1.0) * (s - 1.0));
    J(k, k - 1) = J(k - 1, k) = std::sqrt(b);
  }
  const SymmetricEigen found = symmetric_eigen(J);
  const double whole = 1.0 / (alpha + 1.0);  // integral of the weight over 0..1
  return {.points = (0.5 * (1.0 + found.values.array())).matrix(),
          .weights = whole * found.vectors.row(0).transpose().array().square().matrix()};
}

std::vector<QuadraturePoint> quadrature(const ElementShape& shape) {
  const int d = shape.dimension, along = shape.degree + 1;
  std::vector<JacobiRule> rules;  // along each direction
  for (int axis = 0; axis < d; ++axis) rules.push_back(jacobi_rule(along, shape.simplex ? d - 1 - axis : 0));
  std::vector<QuadraturePoint> points;
  int count = 1;
  for (int axis = 0; axis < d; ++axis) count *= along;
  for (int number = 0; number < count; ++number) {
    Eigen::VectorXd place(d);
    double weight = 1.0, left = 1.0;  // left: of a simplex, what the coordinates before leave of 1
    for (int axis = 0, rest = number; axis < d; ++axis, rest /= along) {
      const JacobiRule& rule = rules[static_cast<std::size_t>(axis)];
      const double x = rule.points[rest % along];
      weight *= rule.weights[rest % along];
      place[axis] = shape.simplex ? left * x : 2.0 * x - 1.0;
      if (shape.simplex)
        left *= 1.0 - x;
      else
        weight *= 2.0;
    }
    points.push_back({.weight = weight, .functions = shape_functions(shape, place)});
  }
  return points;
}

}  // namespace signorini
