#pragma once
// A curve of harmonic balance with the depths of its short contacts among the unknowns.

#include <Eigen/Core>
#include <vector>

#include "methods/harmonic_balance/continuation/series_curve.hpp"

namespace signorini {

/// An extremum of y in a short interval of contact (a maximum above zero), or in a short gap between two of
/// them (a minimum below zero). Its depth w >= 0 is w^2 = y / unit, or -y / unit in a gap: half the length of
/// the interval as a phase of the period, times H, to first order.
struct ContactDepth {
  Eigen::Index contact = 0;
  bool gap = false;
  double time = 0.0;  ///< of the extremum, share of the period
  double unit = 1.0;  ///< |y''| / (2 H^2), primes by the phase 2 pi t [N]
};

/// The equations R(x) = 0 of a SeriesCurve and w_i^2 = +-y_i(x) / unit_i as a CurveEquations. Unknowns: those
/// of lambda, the depths w_i, and the frequency: z = (lambda, w, omega).
///
/// A contact that begins at omega_g has a depth that grows as the root of omega - omega_g, a force that grows
/// as its cube, and so the curve of x alone turns there on a radius of the inverse fourth power of H. In z
/// it is a straight line along w to first order, and Newton's method at a prescribed depth has an explicit
/// answer. w -> -w is the same motion: a contact has ceased where its depth is zero.
class DepthCurve {
 public:
  /// \param family  kept by the caller \throws as SeriesCurve
  DepthCurve(const SeriesFamily& family, int multiple) : series_(family, multiple) {}

  [[nodiscard]] Eigen::Index size() const { return series_.size() + count(); }
  /// False where SeriesCurve's is, or where an extremum has left the neighbourhood of its instant.
  bool evaluate(const Eigen::VectorXd& z);
  [[nodiscard]] Eigen::VectorXd residual() const;
  [[nodiscard]] Eigen::MatrixXd jacobian() const;
  [[nodiscard]] double noise() const;
  [[nodiscard]] double frequency() const { return series_.frequency(); }  ///< [rad/s]

  [[nodiscard]] SeriesCurve& series() { return series_; }
  [[nodiscard]] const SeriesCurve& series() const { return series_; }
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(depths_.size()); }  ///< of w
  [[nodiscard]] const std::vector<ContactDepth>& depths() const { return depths_; }
  /// Takes these depths for unknowns from now on; the instants are those of the motion evaluated last.
  void follow(std::vector<ContactDepth> depths);

  /// (lambda, omega) of z.
  [[nodiscard]] Eigen::VectorXd without_depths(const Eigen::VectorXd& z) const;
  /// z of x and w.
  [[nodiscard]] Eigen::VectorXd with_depths(const Eigen::VectorXd& x, const Eigen::VectorXd& w) const;
  [[nodiscard]] const Eigen::VectorXd& w() const { return w_; }  ///< of the last evaluation
  /// One of the depths, its instant that of the motion evaluated last.
  [[nodiscard]] const ContactDepth& depth_here(Eigen::Index i) const {
    return here_[static_cast<std::size_t>(i)];
  }
  /// z of the last evaluation.
  [[nodiscard]] Eigen::VectorXd z() const { return with_depths(series_.x(), w_); }
  /// w as the motion evaluated last has them.
  [[nodiscard]] Eigen::VectorXd depths_here() const;
  /// The direction of z along a direction of x, where follow() was called and no depth is zero.
  [[nodiscard]] Eigen::VectorXd lifted(const Eigen::VectorXd& direction) const;

 private:
  SeriesCurve series_;
  std::vector<ContactDepth> depths_, here_;  // here_: their instants where evaluated last
  Eigen::VectorXd w_;
};

/// d(w^2) / dx of an extremum along a direction of x, where the curve is evaluated.
double square_rate(const SeriesCurve& curve, const ContactDepth& depth, const Eigen::VectorXd& direction);

/// Length of a contact or a gap, as a phase times H, below which it counts as none.
inline constexpr double kNoPhase = 1e-5;

/// The short contacts and gaps of the motion at which the curve is evaluated: from kNoPhase / H to 3 / H as
/// a phase.
std::vector<ContactDepth> short_contacts(const SeriesCurve& curve);

/// Whether two depths are of one extremum.
bool same_extremum(const ContactDepth& one, const ContactDepth& other);

/// An extremum of y that is about to become a contact or a gap, and how far along the curve.
struct NascentContact {
  ContactDepth depth;
  double distance = 0.0;  ///< along the direction asked for, to first order
};

/// Those at which w^2 is at most zero, to 1e-9, grows along a direction of x, and is zero within `reach`,
/// nearest first.
std::vector<NascentContact> nascent_contacts(const SeriesCurve& curve, const Eigen::VectorXd& direction,
                                             double reach);

}  // namespace signorini
