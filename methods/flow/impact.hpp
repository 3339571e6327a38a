#pragma once
// The impact law for a few contacts that close at the same instant.

#include <Eigen/Core>
#include <optional>

namespace signorini {

/// Newton's law for contacts that touch at the same instant.
struct ImpactInput {
  Eigen::MatrixXd delassus;     ///< G of the touching contacts, m x m [1/kg]
  Eigen::VectorXd approach;     ///< x'_- of each, m; <= 0 where the contact is not closing [m/s]
  Eigen::VectorXd restitution;  ///< e of each, m [-]
};

/// Impulses p <= 0 such that x'_+ = x'_- + G p satisfies
///
///     x'_+ + e max(x'_-, 0) <= 0,   p <= 0,   p_j (x'_+ + e max(x'_-, 0))_j = 0:
///
/// a contact that pushes rebounds by Newton's law, one that the others carry away gets no impulse, and a
/// resting one passes an impulse on.
/// \return p, m [N s]; empty only if G is degenerate and no solution was found
std::optional<Eigen::VectorXd> newton_impulses(const ImpactInput& input);

}  // namespace signorini
