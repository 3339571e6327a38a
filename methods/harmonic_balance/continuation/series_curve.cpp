#include "methods/harmonic_balance/continuation/series_curve.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "methods/discretisation/fourier_series.hpp"
#include "methods/structure/mean_balance.hpp"
#include "problems/linear_algebra/lu.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

/// Per packed coefficient the largest |C_m|, m >= n, of its contact's diagonal.
Eigen::VectorXd decreasing_receptance(const ContactReceptance& receptance) {
  const Eigen::Index stride = 2 * receptance.harmonics() + 1;
  Eigen::VectorXd sizes(stride * receptance.contacts());
  for (Eigen::Index c = 0; c < receptance.contacts(); ++c) {
    double largest = 0.0;
    for (Eigen::Index n = receptance.harmonics(); n >= 0; --n) {
      largest = std::max(largest, std::abs(receptance.receptance[static_cast<std::size_t>(n)](c, c)));
      sizes[c * stride + (n == 0 ? 0 : 2 * n)] = largest;
      if (n > 0) sizes[c * stride + 2 * n - 1] = largest;
    }
  }
  return sizes;
}

}  // namespace

SeriesCurve::SeriesCurve(const SeriesFamily& family, int multiple)
    : family_(family),
      multiple_(multiple),
      harmonics_(multiple * family.harmonics),
      problem_(with_subharmonic(family.problem, multiple * family.problem.subharmonic)),
      gap_(contact_gaps(family.problem)) {
  weight_ = decreasing_receptance(fourier_receptance(problem_, harmonics_)) / family.displacement_unit;
}

Eigen::VectorXd SeriesCurve::unknowns(const Eigen::MatrixXcd& lambda, double frequency) const {
  Eigen::VectorXd x(size() + 1);
  x << weight_.cwiseProduct(pack_harmonics(lambda)), frequency / family_.frequency_unit;
  return x;
}

Eigen::MatrixXcd SeriesCurve::force(const Eigen::VectorXd& x) const {
  return unpack_harmonics(x.head(size()).cwiseQuotient(weight_), harmonics_);
}

ContactReceptance SeriesCurve::of_scenes_order(const ContactReceptance& receptance) const {
  if (multiple_ == 1) return receptance;
  ContactReceptance part;
  part.period = receptance.period / multiple_;
  part.free_response.resize(family_.harmonics + 1, receptance.contacts());
  for (int n = 0; n <= family_.harmonics; ++n) {
    part.receptance.push_back(receptance.receptance[static_cast<std::size_t>(n * multiple_)]);
    part.free_response.row(n) = receptance.free_response.row(n * multiple_);
  }
  return part;
}

bool SeriesCurve::evaluate(const Eigen::VectorXd& x) {
  const double frequency = x[size()] * family_.frequency_unit;
  if (!x.allFinite() || !(frequency > 0.0)) return false;
  problem_ = at_frequency(std::move(problem_), frequency);
  try {
    receptance_ = receptance_with_rate(
        problem_, harmonics_, [base = problem_.base_frequency()](int n) { return exact_weights(n * base); });
  } catch (const SingularStiffness&) {
    return false;
  }
  constexpr double kDifference = 1e-6;  // of the frequency
  const double h = kDifference * frequency;
  ContactReceptance below = of_scenes_order(receptance_.value), above = below;
  law_ = family_.law_at(below);
  for (std::size_t n = 0; n < below.receptance.size(); ++n) {
    const Eigen::MatrixXcd change = h * receptance_.receptance[n * static_cast<std::size_t>(multiple_)];
    below.receptance[n] -= change;
    above.receptance[n] += change;
  }
  const ProjectedLaw before = family_.law_at(below), after = family_.law_at(above);
  law_rate_ = {(after.constant - before.constant) / (2.0 * h),
               (after.multiplier_weight - before.multiplier_weight) / (2.0 * h)};

  x_ = x;
  lambda_ = force(x);
  motion_ = carried_motion(receptance_.value, lambda_);
  // At any tolerance: `error` is not asked for.
  pressing_.emplace(ProjectedEquations{receptance_.value, gap_, law_}, family_.samples * multiple_, 1.0,
                    StopShifts{}, family_.integral);
  const Eigen::VectorXd& root = pressing_->root();
  const Eigen::VectorXd scaled =
      pressing_->residual(pack_harmonics(lambda_ * root.cwiseInverse().asDiagonal()));
  residual_ = weight_.cwiseProduct(pack_harmonics(unpack_harmonics(scaled, harmonics_) * root.asDiagonal()));
  noise_ = pressing_->rounding() * root.maxCoeff() * weight_.maxCoeff();
  return residual_.allFinite();
}

// y' of the frequency [N s].
Eigen::MatrixXcd SeriesCurve::pressure_rate() const {
  Eigen::MatrixXcd clearance = motion_;
  clearance.row(0) -= gap_.transpose();
  const Eigen::MatrixXcd lambda = balanced_force(receptance_.value, lambda_);
  Eigen::MatrixXcd motion_rate = receptance_.free_response;
  for (Eigen::Index n = 0; n <= harmonics_; ++n)
    motion_rate.row(n) +=
        (receptance_.receptance[static_cast<std::size_t>(n)] * lambda.row(n).transpose()).transpose();
  if (const MeanBalance balance(receptance_.value); balance.compliance.size() > 0)  // as 1 / w^2
    motion_rate.row(0) -=
        (2.0 / problem_.frequency) * (balance.compliance * lambda_.row(0).transpose()).transpose();
  return clearance * law_rate_.constant.asDiagonal() + motion_rate * law_.constant.asDiagonal() -
         lambda * law_rate_.multiplier_weight.asDiagonal();
}

Eigen::MatrixXd SeriesCurve::jacobian() const {
  const Eigen::Index n = size(), stride = 2 * harmonics_ + 1;
  Eigen::VectorXd scale = weight_;  // of the residual's unit, sqrt(c) per contact, in the unknowns
  for (Eigen::Index c = 0; c < gap_.size(); ++c) scale.segment(c * stride, stride) *= pressing_->root()[c];
  Eigen::MatrixXd J(n, n + 1);
  J.leftCols(n) = scale.asDiagonal() * pressing_->jacobian() * scale.cwiseInverse().asDiagonal();
  // The edges of contact move where y = 0.
  J.col(n) =
      family_.frequency_unit * weight_.cwiseProduct(pack_harmonics(pressing_->pressed(pressure_rate())));
  return J;
}

Eigen::VectorXcd SeriesCurve::pressure(Eigen::Index contact) const {
  const Eigen::MatrixXcd lambda = balanced_force(receptance_.value, lambda_);
  Eigen::VectorXcd y =
      law_.constant[contact] * motion_.col(contact) - law_.multiplier_weight[contact] * lambda.col(contact);
  y[0] -= law_.constant[contact] * gap_[contact];
  return y;
}

Eigen::VectorXd SeriesCurve::pressure_gradient(Eigen::Index contact, double time) const {
  const Eigen::Index stride = 2 * harmonics_ + 1;
  Eigen::VectorXd gradient(size() + 1);
  const MeanBalance balance(receptance_.value);
  for (Eigen::Index j = 0; j < gap_.size(); ++j) {
    for (Eigen::Index n = 0; n <= harmonics_; ++n) {
      Complex b =
          law_.constant[contact] * receptance_.value.receptance[static_cast<std::size_t>(n)](contact, j);
      if (j == contact) b -= law_.multiplier_weight[contact];
      if (n == 0) {
        if (balance.share.size() > 0)
          b = law_.constant[contact] * balance.moved(contact, j) -
              law_.multiplier_weight[contact] * ((j == contact ? 1.0 : 0.0) - balance.share(contact, j));
        gradient[j * stride] = b.real();
        continue;
      }
      b *= std::numbers::sqrt2 * std::polar(1.0, 2.0 * std::numbers::pi * static_cast<double>(n) * time);
      gradient[j * stride + 2 * n - 1] = b.real();
      gradient[j * stride + 2 * n] = -b.imag();
    }
  }
  gradient.head(size()) = gradient.head(size()).cwiseQuotient(weight_).eval();
  gradient[size()] = family_.frequency_unit * trigonometric_jet(pressure_rate().col(contact), time).value;
  return gradient;
}

Eigen::MatrixXd SeriesCurve::doubled_jacobian() const {
  const double base = problem_.base_frequency();
  const ContactReceptance between =
      contact_receptance(problem_, harmonics_ - 1, [base](int n) { return exact_weights((n + 0.5) * base); });
  const ContactSymbol symbol(between, law_);
  const Eigen::Index contacts = gap_.size(), stride = 2 * harmonics_;
  Eigen::MatrixXd J = Eigen::MatrixXd::Identity(stride * contacts, stride * contacts);
  for (Eigen::Index row = 0; row < contacts; ++row) {
    const Eigen::VectorXcd& chi = pressing_->indicators()[static_cast<std::size_t>(row)].spectrum();
    for (Eigen::Index column = 0; column < contacts; ++column) {
      for (Eigen::Index m = 0; m < harmonics_; ++m) {
        const Complex b = symbol.block(m)(row, column);
        for (Eigen::Index n = 0; n < harmonics_; ++n) {
          // (chi s)_{n + 1/2} = chi_{n-m} s_m + chi_{n+m+1} conj(s_m), s_m = b of a cosine, i b of a sine.
          const Complex direct = (n >= m ? chi[n - m] : std::conj(chi[m - n])) * b;
          const Complex mirrored = chi[n + m + 1] * std::conj(b);
          const Complex cosine = direct + mirrored, sine = Complex(0.0, 1.0) * (direct - mirrored);
          const Eigen::Index i = row * stride + 2 * n, j = column * stride + 2 * m;
          J(i, j) += cosine.real();
          J(i + 1, j) += cosine.imag();
          J(i, j + 1) += sine.real();
          J(i + 1, j + 1) += sine.imag();
        }
      }
    }
  }
  return J;
}

double signed_pivots(const Eigen::MatrixXd& A) {
  const LuFactors lu(A);
  const Eigen::VectorXd pivots = lu.pivots();
  double sign = lu.permutation_sign();
  double logarithm = 0.0;
  for (const double pivot : pivots) {
    if (pivot == 0.0) return 0.0;
    if (pivot < 0.0) sign = -sign;
    logarithm += std::log(std::abs(pivot));
  }
  return sign * std::exp(logarithm / static_cast<double>(pivots.size()));
}

}  // namespace signorini
