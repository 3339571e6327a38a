#pragma once
// The orbits of a scene one of whose numbers is left free.

#include <algorithm>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <utility>

#include "methods/curve.hpp"
#include "methods/linear_flow/shared_modes.hpp"
#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

/// Why the orbits of a scene cannot be followed: too many coordinates; no periodic load, but dampers or
/// impacts that take energy, so that nothing but rest returns; rigid motions that no contact feels, of parts
/// with contacts, or that the mean load drives. Empty where they can.
std::string continuation_obstacle(const Problem& problem);

/// Units in which the length of a curve is measured. One set for all curves of a family: units that changed
/// along a curve would bend its metric.
struct CurveUnits {
  double displacement = 1.0;  ///< X [m]
  double velocity = 1.0;      ///< V = omega X, omega that of the middle of the interval [m/s]
  double parameter = 1.0;     ///< a third of the interval
};

/// The models of a parametrised scene, each made when first asked for, with idle parts held
/// (with_idle_parts_held).
class OrbitFamily {
 public:
  /// X is the largest deflection under the amplitudes of the load at rest, the largest gap or
  /// MotionScales::displacement, whichever is largest, in the middle of the interval.
  /// \throws std::runtime_error with flow_obstacle(problem) if there is one
  explicit OrbitFamily(ParametrisedScene scene);
  /// The same with units of another family, and modes that other scenes have found.
  OrbitFamily(ParametrisedScene scene, const CurveUnits& units,
              std::shared_ptr<SharedModes> modes = std::make_shared<SharedModes>(kMostAlongCurves));

  /// The scene at a value of the parameter. Its last few models are kept. \throws std::runtime_error
  std::shared_ptr<OrbitModel> model(double parameter);
  [[nodiscard]] const ParametrisedScene& scene() const { return scene_; }  ///< as given
  [[nodiscard]] const CurveUnits& units() const { return units_; }         ///< of its curves
  /// False of free motions, which a periodic load drives not: any phase of theirs is as good as another, and
  /// their energy does not change.
  [[nodiscard]] bool driven() const { return driven_; }
  /// Of its models so far.
  [[nodiscard]] const std::shared_ptr<SharedModes>& modes() const { return modes_; }

 private:
  [[nodiscard]] double typical_displacement();

  ParametrisedScene scene_;
  CurveUnits units_;
  bool driven_ = true;
  std::shared_ptr<SharedModes> modes_;
  std::unique_ptr<OrbitModel> middle_;                                // where the frequency is the parameter
  std::list<std::pair<double, std::shared_ptr<OrbitModel>>> recent_;  // latest first
};

}  // namespace signorini
