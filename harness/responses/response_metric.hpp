#pragma once
// How far two points of a frequency response are from each other.

#include <Eigen/Core>
#include <optional>
#include <utility>

namespace signorini {

/// Instants of a forcing period at which motions are compared.
inline constexpr int kComparedPhases = 128;

/// A motion at a frequency of the load.
struct ResponsePoint {
  double frequency = 0.0;                ///< omega [rad/s]
  int order = 1;                         ///< forcing periods per period
  Eigen::MatrixXd motion = {};           ///< x_j at t = i T / 128, i < 128 order, 128 order x Nc [m]
  std::optional<bool> stable = {};       ///< where it is known
  std::optional<double> amplitude = {};  ///< as DrawnBranch has it, where more than `motion` tells it [m]
};

/// When a motion may begin that is the same motion all the same.
enum class Delays {
  whole_periods,  ///< of the load later: it has a phase
  any             ///< of free motions, which have none
};

/// The distance of two points of responses over one interval of frequencies,
///
///     d = max(|omega - omega'| / W, min_s max_j rms_t(x_j(t) - x'_j(t - s T)) / A),
///
/// W the length of the interval, A half of the largest peak to peak of any x_j on the response compared with,
/// T the forcing period, s = 0 .. n - 1 the shifts by whole forcing periods, of free motions any s; infinite
/// where the least periods differ. No origin enters: A is of peak to peak, and x_j - x'_j is of positions.
class ResponseMetric {
 public:
  /// \param window  W > 0 [rad/s] \param amplitude  A > 0 [m]
  ResponseMetric(double window, double amplitude, Delays delays = Delays::whole_periods)
      : window_(window), amplitude_(amplitude), delays_(delays) {}

  /// d; points of different order are infinitely far.
  [[nodiscard]] double operator()(const ResponsePoint& a, const ResponsePoint& b) const;
  /// The size of a motion: root mean square of each x_j about its mean, Nc [m].
  [[nodiscard]] static Eigen::RowVectorXd size_of(const Eigen::MatrixXd& motion);
  /// A lower bound of d from the sizes of two motions.
  [[nodiscard]] double between(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b) const;
  /// The same motion over its least period: shorter ones count where the motion repeats to 2e-3 A.
  [[nodiscard]] ResponsePoint primitive(ResponsePoint point) const;
  /// `b` delayed by the whole forcing periods, of free motions by the instants, that bring it closest to `a`,
  /// both over the least common period.
  [[nodiscard]] std::pair<ResponsePoint, ResponsePoint> aligned(const ResponsePoint& a,
                                                                const ResponsePoint& b) const;

 private:
  /// The delay of b that brings it closest to a.
  struct Closest {
    Eigen::Index instants = 0;
    double distance = 0.0;
  };

  [[nodiscard]] double square(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::Index delay) const;
  [[nodiscard]] Closest closest(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const;

  double window_, amplitude_;
  Delays delays_;
};

}  // namespace signorini
