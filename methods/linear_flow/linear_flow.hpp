#pragma once
// The linear motion between events in closed form: by complex modes, or where they fail by the matrix
// exponential.

#include <Eigen/Core>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "methods/linear_flow/mode_equations.hpp"
#include "methods/linear_flow/modes/complex_modes.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// A term of a motion that oscillates or decays, and how long it matters.
struct FadingRate {
  double rate = 0.0;   ///< |mu_k| or h omega [rad/s]
  double until = 0.0;  ///< [s]
};

/// Largest rate that still matters at a time; `terms` as `LinearArc::fading_rates` gives them [rad/s].
inline double fastest_left(const std::vector<FadingRate>& terms, double time) {
  for (const FadingRate& term : terms) {
    if (term.until > time) return term.rate;
  }
  return 0.0;
}

/// One motion of a flow, which must outlive it. Evaluations share a cache of the last instant, so that one
/// arc belongs to one thread.
class LinearArc {
 public:
  virtual ~LinearArc() = default;

  /// Makes this the motion through `state` at `time`.
  virtual void start(double time, const State& state) = 0;
  /// The terms of the motion, fastest first. A mode matters until its share in every guard (gap of an open
  /// contact over X, force of a closed one over its scale; a bound of what it is in those of OpenContacts)
  /// has fallen below `floor`; with `turn` and `order`, until its share and those of all faster ones in
  /// step^k times the k-th derivatives have, k <= order, by the step in which the next slower one turns by so
  /// much [rad]. The load is one term, that of its slowest harmonic down to which the shares sum to `floor`,
  /// at least omega.
  [[nodiscard]] virtual std::vector<FadingRate> fading_rates(double floor, double turn = 0.0,
                                                             int order = 0) const = 0;
  /// (u, xi), Np, and v, Nd, at a time.
  virtual void state(double time, State& state) const = 0;
  /// (u, xi, v)' at a time.
  virtual void rate(double time, Eigen::VectorXd& rate) const = 0;
  /// Adds the integrals of lambda_j e^{-i n w t} from `begin`, not before the start, to `end`: to row n,
  /// n = 0..H, column j of `sums`, (H+1) x Nc [N s]. False where the motion is not known as a sum of terms.
  [[nodiscard]] virtual bool add_force_integrals(double /*begin*/, double /*end*/, double /*w*/,
                                                 Eigen::MatrixXcd& /*sums*/) const {
    return false;
  }
  /// order-th derivative (0..8) of x_j; of an open contact, from Nc on, 0..2 [m / s^order].
  [[nodiscard]] double displacement(int contact, double time, int order = 0) const {
    const int open = contact - equations_.structure().contact_count();
    if (open < 0) return output(contact, time, order);
    return open_displacements({&time, 1}, order, open, 1)[static_cast<std::size_t>(order)](0, 0);
  }
  /// order-th derivative (0..8) of lambda_j, zero at open contacts [N / s^order].
  [[nodiscard]] double force(int contact, double time, int order = 0) const {
    const Eigen::Index row = equations_.force_row(contact);
    return row < 0 ? 0.0 : output(row, time, order);
  }
  /// x of all contacts and, below, the forces of the closed ones at one instant, with derivatives up to the
  /// highest order (0..8), column by order: (Nc + |A|) x (highest + 1), to the bit what `displacement` and
  /// `force` give one by one [m / s^order], [N / s^order].
  [[nodiscard]] virtual Eigen::MatrixXd outputs_at(double time, int highest) const;
  /// Bound of |x_j''| from a time on; infinite where none is known [m / s^2].
  [[nodiscard]] double displacement_bound(int contact, double time) const {
    return curvature_bound(contact, time);
  }
  /// Bound of |lambda_j''| likewise [N / s^2].
  [[nodiscard]] double force_bound(int contact, double time) const {
    const Eigen::Index row = equations_.force_row(contact);
    return row < 0 ? 0.0 : curvature_bound(row, time);
  }
  /// x of all contacts and, below, the forces of the closed ones (`mode`), at several times, and their
  /// derivatives up to the highest order (0..8): of each order (Nc + |A|) x times.size() [m / s^order],
  /// [N / s^order].
  [[nodiscard]] virtual std::vector<Eigen::MatrixXd> outputs(std::span<const double> times,
                                                             int highest) const;
  /// The same of x of `count` open contacts (OpenContacts) from `first` on, up to order 2 at most, count x
  /// times.size().
  [[nodiscard]] virtual std::vector<Eigen::MatrixXd> open_displacements(std::span<const double> times,
                                                                        int highest, int first,
                                                                        int count) const;
  [[nodiscard]] const ContactMode& mode() const { return equations_.mode; }  ///< of the flow
  /// Nc, of those that act.
  [[nodiscard]] int contact_count() const { return equations_.structure().contact_count(); }

 protected:
  /// \param equations  of the flow
  explicit LinearArc(const ModeEquations& equations) : equations_(equations) {}
  /// order-th derivative of one output of the mode.
  [[nodiscard]] virtual double output(Eigen::Index row, double time, int order) const = 0;
  /// Bound of its second derivative from a time on.
  [[nodiscard]] virtual double curvature_bound(Eigen::Index, double) const {
    return std::numeric_limits<double>::infinity();
  }

  const ModeEquations& equations_;  ///< of the flow

 private:
  [[nodiscard]] Eigen::VectorXd derivative_of_u(double time, int order) const;
};

/// A transition as writing * reading: what the motion keeps of a state (u, xi, v), Ns numbers, and what it
/// makes of that.
struct TransitionFactors {
  Eigen::MatrixXd writing;  ///< Ns x r
  Eigen::MatrixXd reading;  ///< r x Ns
};

/// The linear motions of one contact mode in closed form: ModalFlow or ExponentialFlow.
class LinearFlow {
 public:
  virtual ~LinearFlow() = default;

  [[nodiscard]] const ContactMode& mode() const { return equations_.mode; }  ///< whose flow this is
  [[nodiscard]] int size() const { return equations_.size(); }               ///< Nd
  [[nodiscard]] int positions() const { return equations_.positions(); }     ///< Np, of u and xi
  [[nodiscard]] int states() const { return equations_.states(); }           ///< Ns, of (u, xi, v)
  /// An arc of this flow, not yet started.
  [[nodiscard]] virtual std::unique_ptr<LinearArc> arc() const = 0;
  /// d(u, xi, v)(t0 + duration) / d(u, xi, v)(t0), Ns x Ns; deviations normal to the constraint are dropped.
  [[nodiscard]] virtual Eigen::MatrixXd transition(double duration) const = 0;
  /// The same without the modes that have faded to e^-50, r <= Ns.
  [[nodiscard]] virtual TransitionFactors transition_factors(double duration) const {
    return {.writing = transition(duration), .reading = Eigen::MatrixXd::Identity(states(), states())};
  }
  /// What impulses at the contacts, each `time` before now, have made of a structure at rest without load.
  [[nodiscard]] virtual State response(const std::vector<Impulse>& impulses) const = 0;
  /// d lambda_j / d(u, xi, v) at a closed contact, else d x_j / d(u, xi, v), 1 x Ns.
  [[nodiscard]] auto gradient(int contact, bool of_force) const {
    return equations_.output_of_state.row(of_force ? equations_.force_row(contact) : contact);
  }

 protected:
  /// \param equations  of the mode
  explicit LinearFlow(ModeEquations equations) : equations_(std::move(equations)) {}

  const ModeEquations equations_;  ///< of the mode
};

/// How a flow is represented.
enum class FlowForm {
  automatic,    ///< complex modes; where they fail, the exponential
  exponential,  ///< the matrix exponential of structure and load together: slow, always defined
};

/// Coordinates that a closed-form flow takes: its matrices are dense [-]
inline constexpr int kMostInDenseFlow = 300;

class SharedModes;

/// The flow of a mode. \throws std::runtime_error if the structure has more coordinates than `shared` is for,
/// without it kMostInDenseFlow
/// \param shared  where its complex modes may be known from another scene; empty: nowhere
std::unique_ptr<const LinearFlow> linear_flow(const ContactDynamics& dynamics, ContactMode mode,
                                              FlowForm form = FlowForm::automatic,
                                              const std::shared_ptr<SharedModes>& shared = {});

/// The flows of a scene's contact modes, each made when first asked for.
class LinearFlows {
 public:
  /// \param dynamics  of the scene, kept by the caller
  explicit LinearFlows(const ContactDynamics& dynamics, FlowForm form = FlowForm::automatic,
                       std::shared_ptr<SharedModes> shared = {})
      : dynamics_(dynamics), form_(form), shared_(std::move(shared)) {}
  /// The flow in which exactly the contacts with closed[j] are closed. \throws std::runtime_error
  const LinearFlow& of(const std::vector<bool>& closed);
  /// Lets all of them go once they take more than `most` bytes, with the modes that they share: a motion that
  /// never repeats may meet ever new sets of closed contacts. Nothing may use a flow any more.
  void bound_memory(double most = 1e9);
  [[nodiscard]] const ContactDynamics& dynamics() const { return dynamics_; }  ///< of the scene

 private:
  const ContactDynamics& dynamics_;
  FlowForm form_;
  std::shared_ptr<SharedModes> shared_;
  std::map<std::vector<bool>, std::unique_ptr<const LinearFlow>> flows_;
};

/// The complex modes of a contact mode in all its coordinates, and of what relaxes alone (RelaxingForm), each
/// with the rate -1 / beta: what no load enters.
struct ModalBasis {
  /// \param modes  complex_modes(equations.mass_form(), ...); without entries where nothing moves
  ModalBasis(const ModeEquations& equations, ComplexModes modes);

  ComplexModes reduced;          ///< in the coordinates that are free, those that relax alone left out
  Eigen::VectorXcd mu;           ///< of all, Nm [rad/s]
  Eigen::VectorXd weight;        ///< w_k, Nm
  Eigen::MatrixXcd shapes;       ///< U, Np x Nm
  Eigen::MatrixXcd left;         ///< Nm x Ns: a = left ((u, xi, v) - forced)
  Eigen::MatrixXcd row_of_mode;  ///< outputs x Nm, w_k included
};

/// That of a contact mode; empty where complex_modes has none.
std::shared_ptr<const ModalBasis> modal_basis(const ModeEquations& equations);

/// Whether the load resonates with one of the modes, so that the periodic response and the free motion would
/// cancel in their leading digits: they cannot carry the flow then.
bool resonates(const ModeEquations& equations, const ComplexModes& modes);

/// With the complex modes (mu_k, U_k) of the structure, proportional damping or not,
///
///     (u, xi)(t) = Re sum_k w_k U_k a_k e^{mu_k (t - t0)} + Re sum_h P_h e^{i h omega t},
///
/// Im mu_k >= 0, w_k = 2 for a pair and 1 for a real mu_k (ComplexModes), P_h the periodic response to the
/// load. Evaluations allocate nothing.
class ModalFlow final : public LinearFlow {
 public:
  /// \param basis  modal_basis(equations), or that of a scene with the same structure, not resonating
  ModalFlow(ModeEquations equations, std::shared_ptr<const ModalBasis> basis);

  [[nodiscard]] std::unique_ptr<LinearArc> arc() const override;
  [[nodiscard]] Eigen::MatrixXd transition(double duration) const override;
  [[nodiscard]] TransitionFactors transition_factors(double duration) const override;
  [[nodiscard]] State response(const std::vector<Impulse>& impulses) const override;

 private:
  class Arc;

  void force_relaxing();
  [[nodiscard]] const Eigen::VectorXcd& mu() const { return basis_->mu; }         // Nm
  [[nodiscard]] const Eigen::VectorXd& weight() const { return basis_->weight; }  // w_k

  std::shared_ptr<const ModalBasis> basis_;
  Eigen::MatrixXcd forced_;  // P, Np x Nh
  /// Read row by row.
  using OutputRows = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  OutputRows row_of_harmonic_;  // outputs x Nh
};

/// The exponential of the structure augmented by the harmonic generators of the load, (cos, sin)' =
/// rate (-sin, cos), in the coordinates of the energy (EnergyForm): there no motion grows on its way, and
/// squaring the exponential loses no digits to it. Defined for every structure, resonances and critical
/// damping included; each evaluation forms an exponential.
class ExponentialFlow final : public LinearFlow {
 public:
  /// Of one contact mode.
  explicit ExponentialFlow(ModeEquations equations);

  [[nodiscard]] std::unique_ptr<LinearArc> arc() const override;
  [[nodiscard]] Eigen::MatrixXd transition(double duration) const override;
  [[nodiscard]] State response(const std::vector<Impulse>& impulses) const override;

 private:
  class Arc;

  void relax();

  // y: the coordinates of the energy, e of the position and z' of the velocity, Nr each, and what relaxes
  // alone.
  Eigen::MatrixXd position_of_y_, velocity_of_y_;  // Np and Nd rows
  Eigen::MatrixXd y_of_state_;                     // Ns columns
  Eigen::VectorXd offset_;                         // of the positions, Np
  Eigen::MatrixXd generator_;                      // of (y, cos and sin of each harmonic)
  Eigen::MatrixXd output_;                         // outputs x generator size
  double fastest_rate_ = 0.0;                      // of structure and load [rad/s]
};

}  // namespace signorini
