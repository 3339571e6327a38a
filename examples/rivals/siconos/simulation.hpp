#pragma once
// Siconos' two simulations of a linear structure with stops, behind plain types: its headers are C++17, those
// of signorini C++20.

#include <Eigen/Core>
#include <functional>
#include <memory>

namespace siconos_rivals {

/// M u'' + D u' + K u = f(t) + W lambda, 0 <= -lambda and g - W^T u >= 0, v+ = -e v- at an impact.
struct System {
  Eigen::MatrixXd mass, damping, stiffness;     ///< Nd x Nd [kg] [N s/m] [N/m]
  Eigen::MatrixXd directions;                   ///< W, Nd x Nc
  Eigen::VectorXd gap;                          ///< g, Nc [m]
  double restitution = 1.0;                     ///< e [-]
  std::function<Eigen::VectorXd(double)> load;  ///< f at a time [s], Nd [N]
};

/// Displacements and velocities of all coordinates.
struct State {
  Eigen::VectorXd u, v;
};

/// TimeStepping with MoreauJeanOSI and Lemke's method, from a state at t = 0.
class Stepping {
 public:
  /// Steps of h [s] until `end` [s].
  Stepping(const System& system, const State& start, double h, double end, double theta);
  ~Stepping();
  Stepping(const Stepping&) = delete;
  Stepping& operator=(const Stepping&) = delete;

  [[nodiscard]] State state() const;
  /// One step; the impulses -lambda h >= 0 of the stops in it, Nc [N s].
  Eigen::VectorXd step();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// EventDriven with LsodarOSI and Lemke's method, from rest at t = 0.
class Events {
 public:
  /// LSODAR is stopped every h [s] besides the events, until `end` [s].
  Events(const System& system, double h, double end);
  ~Events();
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;

  [[nodiscard]] State state() const;
  /// -lambda of closed stops without impulses, Nc [N].
  [[nodiscard]] Eigen::VectorXd pressure() const;
  /// What advance() met.
  struct Arrival {
    double time = 0.0;     ///< [s]
    bool at_stop = false;  ///< an event of a stop, and not an instant k h
  };
  /// Integrates to the next event; state() is then that before it.
  Arrival advance();
  /// Takes the event; the impulses -lambda >= 0 of the stops in it, Nc [N s]. state() is then that after it.
  Eigen::VectorXd process();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace siconos_rivals
