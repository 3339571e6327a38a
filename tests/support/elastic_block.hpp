#pragma once
// Contact scenes on the `block` kind, of any size: matrices with the fill of three-dimensional structures.

#include "methods/discretisation/symbols.hpp"
#include "problems/problem.hpp"

namespace signorini::test {

/// A block of nx x ny x nz cubes of edge 1 / ny, clamped at x = 0; both Lame constants and the density are 1.
/// The nodes of a square grid of the end face, side x side of them, may meet a stop along x; three corners of
/// that face are loaded, at harmonics 0, 1 and 3.
struct ElasticBlock {
  int nx = 4;
  int ny = 4;
  int nz = 4;
  int side = 2;        ///< Nc = side^2, side <= min(ny, nz) + 1
  double alpha = 0.0;  ///< [1/s]
  double beta = 0.0;   ///< [s]
  double frequency = 1.0;
};

/// Those of exact time, of the harmonics of a scene's base frequency.
inline WeightsOfHarmonic harmonics_of(const Problem& problem) {
  return [base = problem.base_frequency()](int n) { return exact_weights(n * base); };
}

/// Nd = 3 nx (ny + 1) (nz + 1).
Problem elastic_block_problem(const ElasticBlock& block);

}  // namespace signorini::test
