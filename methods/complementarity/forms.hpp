#pragma once
// Contact conditions as linear complementarity problems on the grid: the rows of docs/theory.md, section 2.

#include <Eigen/Core>

#include "methods/complementarity/projected_law.hpp"
#include "methods/solvers/lcp.hpp"

namespace signorini {

/// The projected equations on N samples, (15) and (16) there, the penalty and the Lipschitz form: find
/// z >= 0 with w = q + A z >= 0 and z^T w = 0, A block-circulant of symbol
///
///     A_n = 1 + B_n for n <= H (contact_symbol.hpp), 1 above;   q = sqrt(c) (g - x_f).
///
/// The unknown is z / sqrt(c) per contact, contact by contact, N Nc, which makes the blocks of A symmetric in
/// the contacts and their diagonal of order one.
Lcp projected_lcp(const ContactReceptance& receptance, const Eigen::VectorXd& gap, const ProjectedLaw& law,
                  int samples);

/// Coefficients n = 0..H of lambda = -P z behind a solution of projected_lcp, (H+1) x Nc [N].
Eigen::MatrixXcd force_coefficients(const ProjectedLaw& law, const Eigen::VectorXd& z_scaled, int samples,
                                    int harmonics);

}  // namespace signorini
