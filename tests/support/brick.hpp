#pragma once
// Elastic bricks of any size: matrices with the fill of three-dimensional structures.

#include "problems/problem.hpp"

namespace signorini::test {

/// A block of nx x ny x nz cubes of edge 1 / ny, trilinear displacements, clamped at x = 0; Lame constants
/// and density
/// 1. The nodes of a square grid of the end face, side x side of them, may meet a stop; the corners are
/// loaded.
struct Brick {
  int nx = 4;
  int ny = 4;
  int nz = 4;
  int side = 2;        ///< Nc = side^2, side <= min(ny, nz) + 1
  double alpha = 0.0;  ///< [1/s]
  double beta = 0.0;   ///< [s]
  double frequency = 1.0;
};

/// Nd = 3 nx (ny + 1) (nz + 1).
Problem to_problem(const Brick& brick);

}  // namespace signorini::test
