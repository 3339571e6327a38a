#include "methods/linear_flow/modes/harmonic_integrals.hpp"

#include <cblas.h>

#include <algorithm>
#include <complex>
#include <functional>
#include <vector>

#include "methods/discretisation/gauss_rule.hpp"

namespace signorini {

using Complex = std::complex<double>;

namespace {

constexpr double kSmall = 0.5;  // |z| below which (e^z - 1) / z is a series
// Gauss' nodes by which the mean of e^{z s} over 0 <= s <= 1 is right to rounding for |z| <= 2 kSmall.
constexpr int kNodes = 6;

// (e^z - 1) / z for |z| <= kSmall.
Complex mean_growth(Complex z) {
  constexpr int kTerms = 16;  // kSmall^16 / 17! is far below rounding
  Complex sum = 1.0;
  for (int k = kTerms; k > 1; --k) sum = 1.0 + sum * z / static_cast<double>(k);
  return sum;
}

// Terms of the motion: rates by falling magnitude.
struct Terms {
  Eigen::VectorXcd rates, grown;  // nu, e^{nu d}
  Eigen::MatrixXcd values;        // c, terms x outputs

  // How many rates are larger.
  [[nodiscard]] Eigen::Index faster_than(double rate) const {
    const auto slow = std::partition_point(rates.begin(), rates.end(),
                                           [rate](const Complex& nu) { return std::abs(nu) > rate; });
    return slow - rates.begin();
  }
};

Terms sorted_terms(const Eigen::VectorXcd& rates, const Eigen::MatrixXcd& values, double duration) {
  constexpr double kUnseen = 1e-17;
  const double least = kUnseen * values.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < rates.size(); ++k) {
    if (values.row(k).cwiseAbs().maxCoeff() > least) kept.push_back(k);
  }
  std::ranges::stable_sort(kept, std::greater(), [&](Eigen::Index k) { return std::abs(rates[k]); });
  Terms terms{.rates = rates(kept), .grown = {}, .values = values(kept, Eigen::all)};
  terms.grown = (terms.rates * duration).array().exp();
  return terms;
}

// What the terms from `first` on make together at the nodes, times their weights, kNodes x outputs.
Eigen::MatrixXd weighed_at_nodes(const Terms& terms, Eigen::Index first, double duration) {
  const GaussRule& rule = gauss_rule(kNodes);
  const Eigen::Index count = terms.rates.size() - first;
  Eigen::MatrixXd result(kNodes, terms.values.cols());
  for (int q = 0; q < kNodes; ++q) {
    const double time = 0.5 * (1.0 + rule.nodes[q]) * duration;
    const Eigen::VectorXcd grown = (terms.rates.tail(count) * time).array().exp();
    result.row(q) = 0.5 * rule.weights[q] * (terms.values.bottomRows(count).transpose() * grown).real();
  }
  return result;
}

// Some harmonics n of one interval, in real arrays: most of the time is spent on their quotients.
class Harmonics {
 public:
  Harmonics(double w, double begin, double duration, Eigen::Index first, Eigen::Index count)
      : turn_(count), angle_(count), turned_(count), at_begin_(count), duration_(duration) {
    for (Eigen::Index n = 0; n < count; ++n) {
      turn_[n] = w * static_cast<double>(first + n);
      angle_[n] = turn_[n] * duration;
      turned_[n] = std::polar(1.0, -angle_[n]);
      at_begin_[n] = std::polar(1.0, -turn_[n] * begin);
    }
    phase_ = duration * at_begin_;
    turned_real_ = turned_.real();
    turned_imag_ = turned_.imag();
  }

  // The first terms, each by its quotient. Re c e^{nu t} = (c e^{nu t} + conj) / 2: harmonics by terms is one
  // matrix, terms by outputs another.
  [[nodiscard]] Eigen::MatrixXcd of_quotients(const Terms& terms, Eigen::Index fast) const {
    const Eigen::Index count = turn_.size(), outputs = terms.values.cols();
    Eigen::MatrixXcd integrals(count, 2 * fast), halves(2 * fast, outputs), sums(count, outputs);
    for (Eigen::Index k = 0; k < fast; ++k) {
      integrate(terms.rates[k], terms.grown[k], integrals.col(2 * k));
      integrate(std::conj(terms.rates[k]), std::conj(terms.grown[k]), integrals.col(2 * k + 1));
      halves.row(2 * k) = 0.5 * terms.values.row(k);
      halves.row(2 * k + 1) = 0.5 * terms.values.row(k).conjugate();
    }
    // By the BLAS, several times faster than generic code.
    const auto rows = static_cast<int>(count), inner = static_cast<int>(2 * fast);
    const Complex one = 1.0, zero = 0.0;
    cblas_zgemm(CblasColMajor, CblasNoTrans, CblasNoTrans, rows, static_cast<int>(outputs), inner, &one,
                integrals.data(), rows, halves.data(), std::max(1, inner), &zero, sums.data(), rows);
    return sums;
  }

  // Whether the interval is short even for the last of these harmonics.
  [[nodiscard]] bool brief() const { return angle_[angle_.size() - 1] <= kSmall; }

  // Those with |nu| d <= kSmall of a short interval: by Gauss' rule. \param weighed  `weighed_at_nodes`
  [[nodiscard]] Eigen::MatrixXcd of_brief(const Eigen::MatrixXd& weighed) const {
    const GaussRule& rule = gauss_rule(kNodes);
    Eigen::MatrixXcd turned(turn_.size(), kNodes);
    for (int q = 0; q < kNodes; ++q) {
      for (Eigen::Index n = 0; n < turned.rows(); ++n)
        turned(n, q) = phase_[n] * std::polar(1.0, -0.5 * (1.0 + rule.nodes[q]) * angle_[n]);
    }
    return turned * weighed.cast<Complex>();
  }

  // The others, |nu| <= kSlow n w. With f what they make together, by parts
  //
  //     int f e^{-i n w t} dt = [(i / n w) sum_m (-i / n w)^m f^(m) e^{-i n w t}],
  //
  // at both ends; f^(m) is real, and (nu / n w)^m falls below rounding.
  [[nodiscard]] Eigen::MatrixXcd of_slow(const Terms& terms, Eigen::Index fast) const {
    const Eigen::Index slow = terms.rates.size() - fast;
    const double least = turn_[0];
    const Eigen::VectorXcd ratio = terms.rates.tail(slow) / least;
    const Eigen::MatrixXcd values = terms.values.bottomRows(slow);
    const Eigen::ArrayXd small = least / turn_;
    const auto by_parts = [&](Eigen::MatrixXcd weighted) {  // (i / n w) sum_m (-i / n w)^m f^(m)
      // Horner's rule in (least / n w)^2, even and odd m apart: (-i)^m is real or imaginary.
      Eigen::MatrixXd derivatives(kOrders, values.cols());
      for (Eigen::Index m = 0; m < kOrders; ++m) {
        derivatives.row(m) = weighted.real().colwise().sum();
        weighted = ratio.asDiagonal() * weighted;
      }
      const Eigen::ArrayXd square = -small.square();
      Eigen::MatrixXcd sums(turn_.size(), values.cols());
      for (Eigen::Index j = 0; j < values.cols(); ++j) {
        Eigen::ArrayXd even = Eigen::ArrayXd::Zero(turn_.size()), odd = even;
        for (Eigen::Index m = kOrders - 2; m >= 0; m -= 2) {
          even = even * square + derivatives(m, j);
          odd = odd * square + derivatives(m + 1, j);
        }
        // (i / n w) (even - i small odd)
        sums.col(j).real() = (small * odd / turn_).matrix();
        sums.col(j).imag() = (even / turn_).matrix();
      }
      return sums;
    };
    const Eigen::MatrixXcd begin = by_parts(values);
    const Eigen::MatrixXcd end = by_parts(terms.grown.tail(slow).asDiagonal() * values);
    const Eigen::VectorXcd at_end = (at_begin_ * turned_).matrix();
    return at_end.asDiagonal() * end - at_begin_.matrix().asDiagonal() * begin;
  }

  // Rates up to this share of n w are slow; the highest order is then below rounding.
  static constexpr double kSlow = 0.5;

 private:
  static constexpr Eigen::Index kOrders = 56;

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

  Eigen::ArrayXd turn_, angle_;
  Eigen::ArrayXcd turned_, at_begin_, phase_;
  double duration_;
  Eigen::ArrayXd turned_real_, turned_imag_;
};

}  // namespace

Eigen::MatrixXcd harmonic_integrals(const Eigen::VectorXcd& rates, const Eigen::MatrixXcd& terms,
                                    double begin, double end, double w, Eigen::Index harmonics) {
  constexpr Eigen::Index kAtOnce = 256;
  const double duration = end - begin;
  const Terms sorted = sorted_terms(rates, terms, duration);
  const Eigen::Index steep = sorted.faster_than(kSmall / duration);
  const Eigen::MatrixXd weighed = weighed_at_nodes(sorted, steep, duration);
  Eigen::MatrixXcd sums(harmonics + 1, terms.cols());
  for (Eigen::Index first = 0; first < sums.rows(); first += kAtOnce) {
    const Eigen::Index count = std::min(kAtOnce, sums.rows() - first);
    const Harmonics some(w, begin, duration, first, count);
    auto part = sums.middleRows(first, count);
    if (some.brief()) {
      part = some.of_quotients(sorted, steep) + some.of_brief(weighed);
      continue;
    }
    const double slow = Harmonics::kSlow * w * static_cast<double>(first);
    const Eigen::Index fast = first == 0 ? sorted.rates.size() : sorted.faster_than(slow);
    part = some.of_quotients(sorted, fast);
    if (fast < sorted.rates.size()) part += some.of_slow(sorted, fast);
  }
  return sums;
}

}  // namespace signorini
