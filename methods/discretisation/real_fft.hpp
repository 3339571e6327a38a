#pragma once
// Real discrete Fourier transforms on a uniform time grid: the only place that knows whose they are.

#include <Eigen/Core>
#include <memory>

namespace signorini {

/// Transforms between N equidistant samples x_i = x(i T / N) and Fourier coefficients,
///
///     X_n = (1/N) sum_i x_i e^{-2 pi j n i / N},   n = 0..N/2,
///     x_i = sum_{|n| <= N/2} X_n e^{2 pi j n i / N},   X_{-n} = conj X_n,
///
/// so that coefficients do not depend on N (for even N the one at N/2 stands for both signs together).
/// By FFTW [frigo2005], planned with FFTW_ESTIMATE so that results are the same from run to run; up to 256
/// samples, a multiple of four, by Eigen's transforms, which need no planner: FFTW's takes a millisecond,
/// twenty times what a first solve on such a grid has to do. Plans are shared by all transforms of one size
/// in a thread, so that a new one or a copy costs nothing; a transform must stay in its thread.
class RealFft {
 public:
  explicit RealFft(int samples);  ///< samples >= 1

  /// N.
  [[nodiscard]] int samples() const;
  /// N/2 + 1, the number of coefficients.
  [[nodiscard]] int coefficients() const { return samples() / 2 + 1; }

  /// \param values N; \param spectrum N/2 + 1, written
  void forward(const Eigen::Ref<const Eigen::VectorXd>& values, Eigen::Ref<Eigen::VectorXcd> spectrum);
  /// \param spectrum at most N/2 + 1 coefficients, missing ones are zero; \param values N, written
  void inverse(const Eigen::Ref<const Eigen::VectorXcd>& spectrum, Eigen::Ref<Eigen::VectorXd> values);

 private:
  class Transform;
  class Planned;
  class Small;
  std::shared_ptr<Transform> transform_;
};

}  // namespace signorini
