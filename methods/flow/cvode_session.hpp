#pragma once
// CVODE behind one owner: no SUNDIALS type, return flag or C callback is seen outside.

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <stdexcept>

namespace signorini {

/// CVODE could not go on; what() names the call and CVODE's own message.
class IntegrationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Families of linear multistep methods of variable order and step.
enum class Multistep {
  adams,  ///< order 1..12, fixed-point iteration: steps no longer than the fastest rate of the system allows
  bdf     ///< backward differentiation, order 1..5, Newton iteration with a dense Jacobian by differences
};

/// y' = rhs(t, y), step by step. The local error of each step is held below rtol |y_i| + atol_i in the root
/// mean square [hindmarsh2005].
class CvodeSession {
 public:
  /// Writes y' at a time and a state.
  using Rhs = std::function<void(double time, const Eigen::Ref<const Eigen::VectorXd>& y,
                                 Eigen::Ref<Eigen::VectorXd> derivative)>;

  /// \param absolute_tolerance  one per component, > 0, in the unit of y_i
  /// \throws IntegrationError
  CvodeSession(double relative_tolerance, const Eigen::VectorXd& absolute_tolerance, Rhs rhs,
               Multistep multistep = Multistep::adams);
  ~CvodeSession();
  CvodeSession(const CvodeSession&) = delete;
  CvodeSession& operator=(const CvodeSession&) = delete;

  /// Forgets the past and starts from y(time) towards `stop` > time, which no step passes.
  void start(double time, const Eigen::VectorXd& y, double stop, double largest_step);
  /// One step of the integrator's own choice, within which can be interpolated. \return the time at its end
  double step();
  /// y at a time within the last step, accurate to the tolerance of the integration.
  void interpolate(double time, Eigen::VectorXd& y) const;
  /// Right-hand sides since construction.
  [[nodiscard]] long rhs_evaluations() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace signorini
