#pragma once
// What a method returns: a verdict of its own, a trajectory the harness samples, and counts of work.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace signorini {

/// Instants of a period on which a motion that is no grid is looked at, where its shortest contacts count
/// [-].
inline constexpr int kFineInstants = 4096;

/// Equidistant samples of one period at the contacts, t_i = i * period / count.
struct Samples {
  Eigen::MatrixXd x;         ///< count x Nc, contact displacement [m]
  Eigen::MatrixXd velocity;  ///< count x Nc, right-sided where it jumps [m/s]
  Eigen::MatrixXd force;     ///< count x Nc, lambda <= 0 without impulses [N]
};

/// A jump of momentum at a contact.
struct Impulse {
  int contact = 0;     ///< in [0, Nc)
  double time = 0.0;   ///< in [0, period) [s]; t = 0 is the time origin of the forcing terms
  double value = 0.0;  ///< on the structure along the contact coordinate, <= 0 [N s]
};

/// What happens to one contact at one instant. Its impulse, if it takes one, also is an `Impulse` of the
/// motion: momentum that a list of events names is the momentum that the list of impulses has.
struct ContactEvent {
  /// How the contact changes.
  enum class Kind {
    impact,  ///< takes an impulse, and is open or closed afterwards as it was before
    /// Closed from here on. A rigid stop takes the momentum of the approach as `impulse`; a closing without
    /// one ends a chatter: infinitely many impacts, of which those that the method resolved are listed.
    close,
    open,  ///< open from here on: at a rigid stop the force, at a compliant one the penetration has vanished
  };
  Kind kind = Kind::impact;  ///< how the contact changes
  int contact = 0;           ///< in [0, Nc)
  double time = 0.0;         ///< in [0, period) [s]; t = 0 is the time origin of the forcing terms
  double impulse = 0.0;      ///< on the structure along the contact coordinate, <= 0 [N s]
  /// Of an opening whose method knows it: the integral of the force over the contact that ends, without
  /// impulses, <= 0 [N s]. Samples miss a contact that is shorter than their step.
  std::optional<double> push = {};
};

/// A periodic motion seen at the contacts, in the method's own representation. The harness samples
/// it wherever it likes, so that no interpolation error enters the scores.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  /// Nc.
  [[nodiscard]] virtual int contact_count() const = 0;
  /// [s]
  [[nodiscard]] virtual double period() const = 0;
  /// One period at `count` >= 1 equidistant instants; finite values only.
  [[nodiscard]] virtual Samples sample(int count) const = 0;
  /// Impulses within one period, ordered in time; empty where force is an ordinary function.
  [[nodiscard]] virtual std::vector<Impulse> impulses() const { return {}; }
  /// Impacts, closings and openings within one period, ordered in time; a contact that pushes throughout has
  /// none. Empty: the method does not know them, and whoever wants them reads them off samples and impulses.
  [[nodiscard]] virtual std::optional<std::vector<ContactEvent>> events() const { return std::nullopt; }
  /// Equidistant instants t_i = i period / nodes on which the representation keeps its values, where it is a
  /// grid of them: samples at so many are these values, and each force acts over period / nodes. Empty: it is
  /// no grid.
  [[nodiscard]] virtual std::optional<int> nodes() const { return std::nullopt; }
  /// Harmonics of 2 pi / period that the representation resolves: the structure's response to
  /// `force` and `impulses` up to this harmonic is the method's own field. Empty: all of them.
  [[nodiscard]] virtual std::optional<int> bandwidth() const { return std::nullopt; }
  /// Fourier coefficients n = 0..bandwidth of force and impulses where the representation is made of them,
  /// (H+1) x Nc [N]; empty: they are taken from `sample` and `impulses`.
  [[nodiscard]] virtual Eigen::MatrixXcd force_coefficients() const { return {}; }
};

/// What the method believes. The harness forms its own verdict.
enum class Verdict { converged, not_converged };

/// Counts of work; an empty one means the method has no such notion.
struct Work {
  std::optional<long> unknowns = {};         ///< of the equations that are solved
  std::optional<long> iterations = {};       ///< what the method calls so
  std::optional<long> pivots = {};           ///< of a complementarity problem
  std::optional<long> rhs_evaluations = {};  ///< of an integrator
  std::optional<long> factorisations = {};   ///< of matrices, from scratch
  std::optional<long> points = {};  ///< solutions of the curve that was followed to the answer, it included
};

/// The result of one solve: verdict, answer and work.
struct Solution {
  Verdict verdict = Verdict::not_converged;           ///< the method's own word
  std::string message = {};                           ///< one sentence for a person
  std::shared_ptr<const Trajectory> trajectory = {};  ///< best iterate; null if there is none
  Work work = {};                                     ///< of this solve
  std::optional<double> residual = {};                ///< of the method's own equations, relative [-]
  /// Estimated condition number, in the 1-norm, of the linear system solved last, scaled and preconditioned
  /// as the method does (by Krylov steps: a lower bound): log10 of it is the digits that may be lost. Empty:
  /// none was factorised. [-]
  std::optional<double> condition = {};
};

}  // namespace signorini
