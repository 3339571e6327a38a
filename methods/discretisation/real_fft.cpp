#include "methods/discretisation/real_fft.hpp"

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <deque>
#include <new>
#include <vector>

#include "methods/solvers/constants.hpp"

namespace signorini {

namespace {

using Complex = std::complex<double>;

}  // namespace

/// Transforms of one size with their work space.
class RealFft::Transform {
 public:
  explicit Transform(int samples) : size(samples) {}
  virtual ~Transform() = default;
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;

  virtual void forward(const double* values, Complex* spectrum) = 0;  // N/2 + 1, scaled
  /// \param spectrum  so many coefficients as are given, N/2 + 1 at most
  virtual void inverse(const Complex* spectrum, int given, double* values) = 0;

  const int size;
};

class RealFft::Planned final : public RealFft::Transform {
 public:
  explicit Planned(int samples)
      : Transform(samples),
        real_(fftw_alloc_real(static_cast<std::size_t>(samples))),
        complex_(fftw_alloc_complex(static_cast<std::size_t>(samples) / 2 + 1)) {
    if (real_ != nullptr && complex_ != nullptr) {
      to_spectrum_ = fftw_plan_dft_r2c_1d(size, real_, complex_, FFTW_ESTIMATE);
      to_values_ = fftw_plan_dft_c2r_1d(size, complex_, real_, FFTW_ESTIMATE);
    }
    if (to_spectrum_ == nullptr || to_values_ == nullptr) {
      release();
      throw std::bad_alloc();
    }
  }
  ~Planned() override { release(); }

  void forward(const double* values, Complex* spectrum) override {
    std::copy_n(values, size, real_);
    fftw_execute(to_spectrum_);
    const double scale = 1.0 / size;
    for (int n = 0; n <= size / 2; ++n) spectrum[n] = scale * Complex(complex_[n][0], complex_[n][1]);
  }

  void inverse(const Complex* spectrum, int given, double* values) override {
    for (int n = 0; n <= size / 2; ++n) {
      complex_[n][0] = n < given ? spectrum[n].real() : 0.0;
      complex_[n][1] = n < given ? spectrum[n].imag() : 0.0;
    }
    fftw_execute(to_values_);  // destroys the complex buffer, which is refilled each time
    std::copy_n(real_, size, values);
  }

 private:
  void release() {
    fftw_destroy_plan(to_spectrum_);
    fftw_destroy_plan(to_values_);
    fftw_free(real_);
    fftw_free(complex_);
  }

  double* real_;
  fftw_complex* complex_;
  fftw_plan to_spectrum_ = nullptr;
  fftw_plan to_values_ = nullptr;
};

/// N = 2^k real samples as M = N/2 complex ones, z_k = x_2k + i x_2k+1, which Stockham's autosort algorithm
/// transforms by factors of four and at last of two [frigo2005].
class RealFft::RadixFour final : public RealFft::Transform {
 public:
  static bool takes(int samples) {
    constexpr int kLeast = 4, kMost = 256;
    return samples >= kLeast && samples <= kMost && (samples & (samples - 1)) == 0;
  }

  explicit RadixFour(int samples)
      : Transform(samples), half_(samples / 2), waves_(as_size(samples)), z_(as_size(half_)), other_(z_) {
    // e^{-2 pi i k / N} by quarters of a turn, so that waves a quarter apart are so to the last digit.
    const int quarter = size / 4;
    for (int k = 0; k < quarter; ++k) {
      const Complex wave = std::polar(1.0, -kTwoPi * k / size);
      Complex turned = wave;
      for (int turn = k; turn < size; turn += quarter) {
        waves_[as_size(turn)] = turned;
        turned = {turned.imag(), -turned.real()};
      }
    }
  }

  void forward(const double* values, Complex* spectrum) override {
    for (int k = 0; k < half_; ++k) z_[as_size(k)] = {values[2 * k], values[2 * k + 1]};
    transform();
    const double scale = 0.5 / size;
    for (int n = 0; n <= half_; ++n) {
      const Complex a = z_[as_size(n % half_)], b = std::conj(z_[as_size((half_ - n) % half_)]);
      const Complex turned = waves_[as_size(n)] * (a - b);
      spectrum[n] = scale * (a + b + Complex(turned.imag(), -turned.real()));
    }
  }

  void inverse(const Complex* spectrum, int given, double* values) override {
    const auto coefficient = [&](int n) -> Complex {
      if (n >= given) return 0.0;
      return n == 0 || n == half_ ? spectrum[n].real() : spectrum[n];
    };
    // The inverse is the transform with real and imaginary parts exchanged before and after.
    for (int n = 0; n < half_; ++n) {
      const Complex a = coefficient(n), b = std::conj(coefficient(half_ - n));
      const Complex turned = std::conj(waves_[as_size(n)]) * (a - b);
      z_[as_size(n)] = {a.imag() + b.imag() + turned.real(), a.real() + b.real() - turned.imag()};
    }
    transform();
    for (int k = 0; k < half_; ++k) {
      values[2 * k] = z_[as_size(k)].imag();
      values[2 * k + 1] = z_[as_size(k)].real();
    }
  }

 private:
  static std::size_t as_size(int n) { return static_cast<std::size_t>(n); }

  /// z_n <- sum_k z_k e^{-2 pi i n k / M}.
  void transform() {
    int length = half_, stride = 1;
    for (; length >= 4; length /= 4, stride *= 4) {
      for (int p = 0; p < length / 4; ++p) fours(length, stride, p);
      z_.swap(other_);
    }
    if (length < 2) return;
    for (int q = 0; q < stride; ++q) {
      const Complex a = z_[as_size(q)], b = z_[as_size(q + stride)];
      other_[as_size(q)] = a + b;
      other_[as_size(q + stride)] = a - b;
    }
    z_.swap(other_);
  }

  /// Of `stride` transforms of this length the p-th four of each.
  void fours(int length, int stride, int p) {
    const int turn = p * (size / length);
    const Complex w1 = waves_[as_size(turn)], w2 = waves_[as_size(2 * turn)], w3 = waves_[as_size(3 * turn)];
    const Complex* const from = z_.data() + p * stride;
    Complex* const to = other_.data() + 4 * p * stride;
    const int apart = stride * (length / 4);
    for (int q = 0; q < stride; ++q) {
      const Complex a = from[q], b = from[q + apart], c = from[q + 2 * apart], d = from[q + 3 * apart];
      const Complex even = a + c, odd = a - c, sum = b + d;
      const Complex turned{d.imag() - b.imag(), b.real() - d.real()};  // i (b - d)
      to[q] = even + sum;
      to[q + stride] = w1 * (odd - turned);
      to[q + 2 * stride] = w2 * (even - sum);
      to[q + 3 * stride] = w3 * (odd + turned);
    }
  }

  int half_;
  std::vector<Complex> waves_;      // e^{-2 pi i k / N}, k = 0..N-1
  std::vector<Complex> z_, other_;  // M
};

RealFft::RealFft(int samples) {
  // The few sizes in use at a time stay planned; the oldest gives way.
  constexpr std::size_t kKept = 8;
  thread_local std::deque<std::shared_ptr<Transform>> planned;
  const auto known =
      std::find_if(planned.begin(), planned.end(), [&](const auto& p) { return p->size == samples; });
  if (known != planned.end()) {
    transform_ = *known;
    return;
  }
  if (RadixFour::takes(samples))
    transform_ = std::make_shared<RadixFour>(samples);
  else
    transform_ = std::make_shared<Planned>(samples);
  planned.push_front(transform_);
  if (planned.size() > kKept) planned.pop_back();
}

int RealFft::samples() const { return transform_->size; }

void RealFft::forward(const Eigen::Ref<const Eigen::VectorXd>& values,
                      Eigen::Ref<Eigen::VectorXcd> spectrum) {
  transform_->forward(values.data(), spectrum.data());
}

void RealFft::inverse(const Eigen::Ref<const Eigen::VectorXcd>& spectrum,
                      Eigen::Ref<Eigen::VectorXd> values) {
  transform_->inverse(spectrum.data(), static_cast<int>(spectrum.size()), values.data());
}

}  // namespace signorini
