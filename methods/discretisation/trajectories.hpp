#pragma once
// The two representations of a periodic motion that the grid methods produce.

#include <Eigen/Core>

#include "methods/discretisation/contact_phases.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// Truncated Fourier series of displacement and force, with the unprojected complementary force
///
///     x(t) = sum_{|n|<=H} x_n e^{i n w t},   force(t) = -max(0, stiffness (x(t) - g(t)) - alpha lambda(t)),
///
/// w = 2 pi / period, g(t) = gap less the shift of the stop. The projection of `force` on |n| <= H is
/// lambda(t) up to quadrature, and unlike lambda(t) it is never positive (no Gibbs ripple between contacts).
class FourierTrajectory final : public Trajectory {
 public:
  /// Coefficients n = 0..H per contact; negative n by conjugation.
  struct Data {
    double period = 1.0;        ///< [s]
    Eigen::MatrixXcd x;         ///< (H+1) x Nc [m]
    Eigen::MatrixXcd lambda;    ///< (H+1) x Nc [N]
    Eigen::VectorXd gap;        ///< Nc [m]
    Eigen::VectorXd stiffness;  ///< Nc, > 0 [N/m]: c, or the penalty
    /// alpha, Nc [-]: 1 for a rigid stop, 1 - c / k_p for a stop of stiffness k_p
    Eigen::VectorXd multiplier_weight;
    StopShifts shifts = {};  ///< of the stops that the series meets (impact_closure.hpp)
  };

  /// Sizes must agree.
  explicit FourierTrajectory(Data data) : data_(std::move(data)) {}

  [[nodiscard]] int contact_count() const override { return static_cast<int>(data_.x.cols()); }
  [[nodiscard]] double period() const override { return data_.period; }
  /// Exact at any count: the series is summed at each instant by one inverse transform.
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::optional<int> bandwidth() const override { return static_cast<int>(data_.x.rows()) - 1; }
  [[nodiscard]] Eigen::MatrixXcd force_coefficients() const override { return data_.lambda; }
  /// The coefficients.
  [[nodiscard]] const Data& data() const { return data_; }

 private:
  Data data_;
};

/// Nodal values on N equidistant instants joined by straight lines (periodic hat functions); velocity
/// is the slope of the element to the right. The force at a node acts over one time step, so that
/// the impulse per period is (period / N) * sum of the nodal forces.
class NodalTrajectory final : public Trajectory {
 public:
  /// \param x, force  N x Nc [m], [N]
  NodalTrajectory(double period, Eigen::MatrixXd x, Eigen::MatrixXd force)
      : period_(period), x_(std::move(x)), force_(std::move(force)) {}

  [[nodiscard]] int contact_count() const override { return static_cast<int>(x_.cols()); }
  [[nodiscard]] double period() const override { return period_; }
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::optional<int> bandwidth() const override { return static_cast<int>(x_.rows() - 1) / 2; }
  [[nodiscard]] std::optional<int> nodes() const override { return static_cast<int>(x_.rows()); }

 private:
  double period_;
  Eigen::MatrixXd x_, force_;
};

}  // namespace signorini
