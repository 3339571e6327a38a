#include "methods/linear_flow/harmonic_integrals.hpp"

#include <cblas.h>

#include <algorithm>
#include <complex>

namespace signorini {

using Complex = std::complex<double>;

namespace {

constexpr double kSmall = 0.5;  // |z| below which (e^z - 1) / z is a series

// (e^z - 1) / z for |z| <= kSmall.
Complex mean_growth(Complex z) {
  constexpr int kTerms = 16;  // kSmall^16 / 17! is far below rounding
  Complex sum = 1.0;
  for (int k = kTerms; k > 1; --k) sum = 1.0 + sum * z / static_cast<double>(k);
  return sum;
}

// Some harmonics n of one interval, in real arrays: most of the time is spent on their quotients.
class Harmonics {
 public:
  Harmonics(double w, double begin, double duration, Eigen::Index first, Eigen::Index count)
      : angle_(count), turned_(count), phase_(count), duration_(duration) {
    for (Eigen::Index n = 0; n < count; ++n) {
      const double turn = w * static_cast<double>(first + n);
      angle_[n] = turn * duration;
      turned_[n] = std::polar(1.0, -angle_[n]);
      phase_[n] = duration * std::polar(1.0, -turn * begin);
    }
    turned_real_ = turned_.real();
    turned_imag_ = turned_.imag();
  }

  // phase_n (e^z - 1) / z, z = nu d - i angle_n.
  void integrate(Complex nu, Complex grown, Eigen::Ref<Eigen::VectorXcd> integrals) const {
    const double a = nu.real() * duration_, c = nu.imag() * duration_;
    const double g = grown.real(), h = grown.imag();
    const Eigen::ArrayXd b = c - angle_, square = a * a + b.square();
    const Eigen::ArrayXd real = g * turned_real_ - h * turned_imag_ - 1.0;
    const Eigen::ArrayXd imag = g * turned_imag_ + h * turned_real_;
    integrals.real() = (real * a + imag * b) / square;
    integrals.imag() = (imag * a - real * b) / square;
    for (Eigen::Index n = 0; n < b.size(); ++n) {
      if (square[n] <= kSmall * kSmall) integrals[n] = mean_growth({a, b[n]});
    }
    integrals.array() *= phase_;
  }

 private:
  Eigen::ArrayXd angle_;
  Eigen::ArrayXcd turned_, phase_;
  double duration_;
  Eigen::ArrayXd turned_real_, turned_imag_;
};

}  // namespace

// Re c e^{nu t} = (c e^{nu t} + conj) / 2. Terms by outputs is one matrix, harmonics by terms another, some
// harmonics at a time.
Eigen::MatrixXcd harmonic_integrals(const Eigen::VectorXcd& rates, const Eigen::MatrixXcd& terms,
                                    double begin, double end, double w, Eigen::Index harmonics) {
  constexpr Eigen::Index kAtOnce = 256;
  constexpr double kUnseen = 1e-17;
  const double duration = end - begin, least = kUnseen * terms.cwiseAbs().maxCoeff();
  Eigen::VectorXcd nu(2 * rates.size());
  Eigen::MatrixXcd halves(nu.size(), terms.cols());
  Eigen::Index kept = 0;
  for (Eigen::Index k = 0; k < rates.size(); ++k) {
    if (!(terms.row(k).cwiseAbs().maxCoeff() > least)) continue;
    nu[kept] = rates[k];
    halves.row(kept++) = 0.5 * terms.row(k);
    nu[kept] = std::conj(rates[k]);
    halves.row(kept++) = 0.5 * terms.row(k).conjugate();
  }
  nu.conservativeResize(kept);
  halves.conservativeResize(kept, Eigen::NoChange);
  const Eigen::VectorXcd grown = (nu * duration).array().exp();
  Eigen::MatrixXcd sums(harmonics + 1, terms.cols());
  Eigen::MatrixXcd integrals(std::min(kAtOnce, sums.rows()), kept), part(integrals.rows(), terms.cols());
  for (Eigen::Index first = 0; first < sums.rows(); first += kAtOnce) {
    const Eigen::Index count = std::min(kAtOnce, sums.rows() - first);
    const Harmonics some(w, begin, duration, first, count);
    for (Eigen::Index k = 0; k < kept; ++k) some.integrate(nu[k], grown[k], integrals.col(k).head(count));
    // By the BLAS, several times faster than generic code.
    const auto rows = static_cast<int>(integrals.rows()), inner = static_cast<int>(kept);
    const Complex one = 1.0, zero = 0.0;
    cblas_zgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, static_cast<int>(count),
                static_cast<int>(terms.cols()), inner, &one, integrals.data(), rows, halves.data(),
                std::max(1, static_cast<int>(halves.rows())), &zero, part.data(), rows);
    sums.middleRows(first, count) = part.topRows(count);
  }
  return sums;
}

}  // namespace signorini
