#pragma once
// Fixed coordinates written as very stiff springs, K = 1e20 say: beside such a number those of the structure
// are below rounding.

#include <string>
#include <vector>

#include "problems/structure.hpp"

namespace signorini {

/// A coordinate whose diagonal of K is more than 1e12 times the median of those above 0, of rows that no
/// single link carries, or where links carry all the least.
struct PenaltySpring {
  int coordinate = 0;  ///< i
  int tied_to = -1;    ///< the other coordinate whose coupling exceeds 1e-10 of the diagonal; -1: the ground
  double stiffness = 0.0;  ///< K_ii [N/m]
  double usual = 0.0;      ///< the median [N/m]
};

/// In the order of coordinates.
std::vector<PenaltySpring> penalty_springs(const SparseMatrix& K);

/// Holds coordinates on penalty springs to the ground exactly at rest: they lose their couplings and their
/// mass, and have the median as their stiffness; a line of each is appended to `notices`. \return them
std::vector<int> hold_supports(Structure& structure, std::vector<std::string>& notices);

/// Rows and columns of these coordinates become 0.
void uncouple(SparseMatrix& A, const std::vector<int>& coordinates);

/// Why a K is singular beside rounding of its penalty springs, with the cure; empty where it has none.
std::string penalty_explanation(const SparseMatrix& K);

}  // namespace signorini
