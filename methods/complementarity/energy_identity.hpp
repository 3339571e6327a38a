#pragma once
// How well a series keeps the energy identity of the projected equations.

#include <Eigen/Core>

namespace signorini {

/// Net work of the contact force over a period, relative to the work exchanged, summed over contacts:
///
///     |2 T sum_n Re(conj(lambda_n) i n w x_n)| / (2 T sum_n n w |lambda_n| |x_n|)  [-].
///
/// Zero for exact quadrature (docs/theory.md, section 3): what is left measures how well N samples resolve
/// the contact. Zero also where nothing is exchanged.
///
/// \param x, lambda  n = 0..H, (H+1) x Nc [m], [N]
double net_work_ratio(const Eigen::MatrixXcd& x, const Eigen::MatrixXcd& lambda);

}  // namespace signorini
