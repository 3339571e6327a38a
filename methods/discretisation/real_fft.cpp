#include "methods/discretisation/real_fft.hpp"

#include <fftw3.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <deque>
#include <new>

namespace signorini {

struct RealFft::Plans {
  explicit Plans(int samples)
      : size(samples),
        real(fftw_alloc_real(static_cast<std::size_t>(samples))),
        complex(fftw_alloc_complex(static_cast<std::size_t>(samples) / 2 + 1)) {
    if (real != nullptr && complex != nullptr) {
      to_spectrum = fftw_plan_dft_r2c_1d(size, real, complex, FFTW_ESTIMATE);
      to_values = fftw_plan_dft_c2r_1d(size, complex, real, FFTW_ESTIMATE);
    }
    if (to_spectrum == nullptr || to_values == nullptr) {
      release();
      throw std::bad_alloc();
    }
  }
  ~Plans() { release(); }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  void release() {
    fftw_destroy_plan(to_spectrum);
    fftw_destroy_plan(to_values);
    fftw_free(real);
    fftw_free(complex);
  }

  int size;
  double* real;
  fftw_complex* complex;
  fftw_plan to_spectrum = nullptr;
  fftw_plan to_values = nullptr;
};

RealFft::RealFft(int samples) {
  // The few sizes in use at a time stay planned; the oldest gives way.
  constexpr std::size_t kKept = 8;
  thread_local std::deque<std::shared_ptr<Plans>> planned;
  const auto known =
      std::find_if(planned.begin(), planned.end(), [&](const auto& p) { return p->size == samples; });
  if (known != planned.end()) {
    plans_ = *known;
    return;
  }
  plans_ = std::make_shared<Plans>(samples);
  planned.push_front(plans_);
  if (planned.size() > kKept) planned.pop_back();
}

int RealFft::samples() const { return plans_->size; }

void RealFft::forward(const Eigen::Ref<const Eigen::VectorXd>& values,
                      Eigen::Ref<Eigen::VectorXcd> spectrum) {
  std::copy_n(values.data(), plans_->size, plans_->real);
  fftw_execute(plans_->to_spectrum);
  const double scale = 1.0 / plans_->size;
  for (int n = 0; n < coefficients(); ++n) {
    spectrum[n] = scale * std::complex<double>(plans_->complex[n][0], plans_->complex[n][1]);
  }
}

void RealFft::inverse(const Eigen::Ref<const Eigen::VectorXcd>& spectrum,
                      Eigen::Ref<Eigen::VectorXd> values) {
  const auto given = static_cast<int>(spectrum.size());
  for (int n = 0; n < coefficients(); ++n) {
    plans_->complex[n][0] = n < given ? spectrum[n].real() : 0.0;
    plans_->complex[n][1] = n < given ? spectrum[n].imag() : 0.0;
  }
  fftw_execute(plans_->to_values);  // destroys the complex buffer, which is refilled each time
  std::copy_n(plans_->real, plans_->size, values.data());
}

}  // namespace signorini
