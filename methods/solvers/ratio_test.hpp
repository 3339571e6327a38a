#pragma once
// The ratio test of Lemke's method: where a linear piece of the path ends.

#include <Eigen/Core>
#include <limits>

namespace signorini {

/// The variables that move along the path: their values, or their rates along the driving variable.
struct PathVariables {
  Eigen::VectorXd basic;  ///< basic z and tau, in the order of the basis's columns
  Eigen::VectorXd w;      ///< all w, size of q; those held at zero are zero, and so are their rates
};

/// What stops the path at the end of one linear piece.
struct Blocking {
  /// Which variable stops it.
  enum class Kind {
    none,  ///< nothing: the piece is a ray
    tau,   ///< the homotopy parameter reaches zero: the problem is solved
    z,     ///< a basic z reaches zero: that sample opens
    w,     ///< a positive w reaches zero: that sample closes
  };
  Kind kind = Kind::none;  ///< of the variable that stops it
  int position = 0;        ///< of z and tau: place in the order of columns; of w: index in the problem
  double step = std::numeric_limits<double>::infinity();  ///< of the driving variable up to there
};

/// The first variable to reach its bound at value + step rate, step >= 0.
///
/// In exact arithmetic that is the smallest ratio value / -rate over falling variables. With rounding, ties
/// and near-ties would often pick a variable of tiny rate, whose exchange makes the basis ill-conditioned. So
/// the test has two passes [harris1973]: the longest step that violates no bound by more than a tolerance of
/// rounding size, and among the variables met up to there the one that falls fastest, the largest pivot.
/// tau has precedence, since it ends the path.
/// \param tau  position of tau among value.basic; -1 if it is not basic
/// \param scale  max |q|, the size of w against which rounding is measured
Blocking find_blocking(const PathVariables& value, const PathVariables& rate, int tau, double scale);

}  // namespace signorini
