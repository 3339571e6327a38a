#pragma once
// A march through time before stops of several laws, which shares no code with the program's flows.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "problems/problem.hpp"

namespace signorini::test {

/// The classical Runge-Kutta method through time on the coordinates with mass; a step in which a rigid stop
/// is passed is halved until it ends there, and Newton's law follows. Stops that are springs are part of the
/// force; those with a damper push with k (x - g) + c x' until that is zero, go back by themselves, and are
/// met where they are, at instants found likewise. Motions that stay at a rigid stop are beyond it.
class StopMarch {
 public:
  struct Stop {
    Eigen::VectorXd normal;
    double gap = 0.0, stiffness = 0.0, restitution = 0.0,
           damping = 0.0;                 // a spring if its stiffness is not 0
    bool closed = false;                  // of those with a damper:
    double compressed = 0.0, left = 0.0;  // when it was left, and when
    [[nodiscard]] bool rigid() const { return stiffness == 0.0; }
    [[nodiscard]] double compression(double t, const Eigen::VectorXd& y) const {
      if (damping == 0.0) return 0.0;
      if (closed) return normal.dot(y.head(normal.size())) - gap;
      return compressed * std::exp(-stiffness / damping * (t - left));
    }
    /// Of a stop with a damper that is touched.
    [[nodiscard]] double push(const Eigen::VectorXd& y) const {
      return stiffness * (normal.dot(y.head(normal.size())) - gap) +
             damping * normal.dot(y.tail(normal.size()));
    }
  };

  StopMarch(const Problem& problem, std::vector<Stop> stops)
      : n_(stops.front().normal.size()),
        problem_(problem),
        inverse_(Eigen::MatrixXd(problem.mass()).topLeftCorner(n_, n_).inverse()),
        damping_(Eigen::MatrixXd(problem.damping()).topLeftCorner(n_, n_)),
        stiffness_(Eigen::MatrixXd(problem.stiffness()).topLeftCorner(n_, n_)),
        stops_(std::move(stops)),
        y_(Eigen::VectorXd::Zero(2 * n_)) {
    for (const Stop& stop : stops_) {  // what faces add to the structure
      if (stop.damping == 0.0) continue;
      stiffness_ -= stop.stiffness * stop.normal * stop.normal.transpose();
      damping_ -= stop.damping * stop.normal * stop.normal.transpose();
    }
  }

  /// Moves on by `periods`; the displacements at the ends of `count` equal parts of the last one.
  Eigen::MatrixXd run(int periods, int count) {
    constexpr int kSteps = 8;  // per part
    const double part = problem_.period() / count;
    Eigen::MatrixXd x(count, n_);
    compressions = Eigen::MatrixXd::Zero(count, std::ssize(stops_));
    for (int k = 0; k < periods * count; ++k) {
      for (int i = 0; i < kSteps; ++i) advance((k + static_cast<double>(i) / kSteps) * part, part / kSteps);
      x.row((k + 1) % count) = y_.head(n_).transpose();
      for (std::size_t j = 0; j < stops_.size(); ++j)
        compressions((k + 1) % count, static_cast<Eigen::Index>(j)) =
            stops_[j].compression((k + 1) * part, y_);
    }
    return x;
  }

  Eigen::MatrixXd compressions;  ///< of the stops with a damper, there
  int struck_while_pushing = 0;  ///< impacts while such a stop is touched

 private:
  [[nodiscard]] Eigen::VectorXd rate(double t, const Eigen::VectorXd& y) const {
    Eigen::VectorXd force = load_at(problem_, t).head(n_) - stiffness_ * y.head(n_) - damping_ * y.tail(n_);
    for (const Stop& stop : stops_) {
      if (stop.closed)
        force -= stop.push(y) * stop.normal;
      else if (stop.damping == 0.0)
        force -= stop.stiffness * std::max(0.0, stop.normal.dot(y.head(n_)) - stop.gap) * stop.normal;
    }
    Eigen::VectorXd result(2 * n_);
    result << y.tail(n_), inverse_ * force;
    return result;
  }
  [[nodiscard]] Eigen::VectorXd stepped(double t, double h) const {
    const Eigen::VectorXd a = rate(t, y_), b = rate(t + 0.5 * h, y_ + 0.5 * h * a),
                          c = rate(t + 0.5 * h, y_ + 0.5 * h * b), d = rate(t + h, y_ + h * c);
    return y_ + h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  /// The stop at which something happens before t, or -1.
  [[nodiscard]] int passed(double t, const Eigen::VectorXd& y) const {
    for (std::size_t j = 0; j < stops_.size(); ++j) {
      const Stop& stop = stops_[j];
      const double beyond = stop.normal.dot(y.head(n_)) - stop.gap, speed = stop.normal.dot(y.tail(n_));
      const double back = stop.compression(t, y);
      const bool meets = stop.rigid()          ? beyond > 0.0 && speed > 0.0
                         : stop.damping == 0.0 ? false
                         : stop.closed         ? stop.push(y) < 0.0
                                       : beyond > back && stop.damping * speed + stop.stiffness * back > 0.0;
      if (meets) return static_cast<int>(j);
    }
    return -1;
  }
  void leave(Stop& stop, double t) const {
    stop.compressed = stop.compression(t, y_);
    stop.left = t;
    stop.closed = false;
  }
  void happen(Stop& stop, double t) {
    if (!stop.rigid()) {
      if (stop.closed)
        leave(stop, t);
      else
        stop.closed = true;
      return;
    }
    const Eigen::VectorXd back = inverse_ * stop.normal;
    y_.tail(n_) -= (1.0 + stop.restitution) * stop.normal.dot(y_.tail(n_)) / stop.normal.dot(back) * back;
    for (Stop& other : stops_) {
      struck_while_pushing += other.closed ? 1 : 0;
      if (other.closed && other.push(y_) < 0.0) leave(other, t);
    }
  }
  void advance(double t, double h) {
    Eigen::VectorXd next = stepped(t, h);
    if (passed(t + h, next) < 0) {
      y_ = next;
      return;
    }
    double safe = 0.0, beyond = h;
    while (beyond - safe > 1e-15) {
      const double middle = 0.5 * (safe + beyond);
      (passed(t + middle, stepped(t, middle)) < 0 ? safe : beyond) = middle;
    }
    next = stepped(t, beyond);
    const int stop = passed(t + beyond, next);
    y_ = next;
    happen(stops_[static_cast<std::size_t>(stop)], t + beyond);
    if (h > beyond) advance(t + beyond, h - beyond);
  }

  Eigen::Index n_;
  const Problem& problem_;
  Eigen::MatrixXd inverse_, damping_, stiffness_;
  std::vector<Stop> stops_;
  Eigen::VectorXd y_;
};

}  // namespace signorini::test
