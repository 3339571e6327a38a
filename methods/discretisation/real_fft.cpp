#include "methods/discretisation/real_fft.hpp"

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <deque>
#include <new>
#include <unsupported/Eigen/FFT>
#include <vector>

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

/// By the transforms that Eigen has, KISS FFT, whose tables are cosines alone.
class RealFft::Small final : public RealFft::Transform {
 public:
  static bool takes(int samples) {
    constexpr int kMost = 256;
    return samples <= kMost && samples % 4 == 0;
  }

  explicit Small(int samples) : Transform(samples), spectrum_(static_cast<std::size_t>(samples) / 2 + 1) {
    fft_.SetFlag(Eigen::FFT<double>::Unscaled);
    fft_.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  }

  void forward(const double* values, Complex* spectrum) override {
    fft_.fwd(spectrum, values, size);
    for (int n = 0; n <= size / 2; ++n) spectrum[n] /= size;
  }

  void inverse(const Complex* spectrum, int given, double* values) override {
    for (int n = 0; n <= size / 2; ++n)
      spectrum_[static_cast<std::size_t>(n)] = n < given ? spectrum[n] : Complex();
    // Their imaginary parts belong to no real function.
    spectrum_.front().imag(0.0);
    spectrum_.back().imag(0.0);
    fft_.inv(values, spectrum_.data(), size);
  }

 private:
  Eigen::FFT<double> fft_;
  std::vector<Complex> spectrum_;
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
  if (Small::takes(samples))
    transform_ = std::make_shared<Small>(samples);
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
