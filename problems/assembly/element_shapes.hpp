#pragma once
// Finite elements of meshes: simplices and cubes of degree 1 and 2, their shape functions and integrals.

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace signorini {

/// What an element of a mesh is: a point, or a simplex or cube of one, two or three dimensions whose shape
/// functions are all polynomials of its degree, of a cube in each variable. Its nodes are counted as Gmsh
/// does [geuzaine2009]. The reference simplex has a corner at 0 and one at each unit vector, the reference
/// cube reaches from -1 to 1.
struct ElementShape {
  std::string_view name;  ///< for people, "tetrahedra of 10 nodes"
  int gmsh = 0;           ///< the number of the type in Gmsh's files
  int dimension = 0;      ///< d, 0..3
  int degree = 1;         ///< 1 or 2; of a point it means nothing
  bool simplex = true;    ///< else a cube
  int nodes = 1;          ///< n
};

/// Points, and lines, triangles, quadrangles, tetrahedra, hexahedra of both degrees.
const std::vector<ElementShape>& element_shapes();

/// The shape of a type of Gmsh; null for another one.
const ElementShape* shape_of_gmsh_type(int type);

/// Places of the nodes in the reference element, d x n [-].
Eigen::MatrixXd reference_nodes(const ElementShape& shape);

/// Shape functions at a point of the reference element: column 0 their values, column k their derivatives
/// along coordinate k - 1, n x (1 + d) [-]. \param point  d numbers
Eigen::MatrixXd shape_functions(const ElementShape& shape, const Eigen::VectorXd& point);

/// A point of a quadrature rule of a reference element.
struct QuadraturePoint {
  double weight = 0.0;        ///< > 0 [-]
  Eigen::MatrixXd functions;  ///< shape_functions there, n x (1 + d) [-]
};

/// A rule with degree + 1 points along each direction, exact for polynomials of twice the degree plus 1: the
/// product of two shape functions of a straight element. For simplices the conical product of rules of
/// Gauss and Jacobi, whose points are within [stroud1971].
std::vector<QuadraturePoint> quadrature(const ElementShape& shape);

/// A rule of Gauss and Jacobi: sum of weight_i f(x_i) = integral of (1 - x)^alpha f(x) over 0..1, for
/// polynomials of degree 2 n - 1 [golub1969].
struct JacobiRule {
  Eigen::VectorXd points;   ///< x_i, n, rising [-]
  Eigen::VectorXd weights;  ///< n [-]
};
/// \param points  n >= 1  \param alpha  >= 0
JacobiRule jacobi_rule(int points, int alpha);

}  // namespace signorini
