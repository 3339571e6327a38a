#pragma once
// A periodic orbit in closed form.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "methods/flow/event_trajectory.hpp"
#include "methods/orbit/orbit_equations.hpp"

namespace signorini {

/// What is known of a polished orbit.
struct OrbitQuality {
  double error_bar = 0.0;        ///< of the motion, relative to the displacement scale X [-]
  Eigen::VectorXcd multipliers;  ///< Floquet, 2 Nd; empty where undefined
};

/// Motion and contact force of a polished orbit, evaluated exactly (to round-off) at any instant; the
/// velocity is right-sided at impacts. Of all contacts of the scene, whether they act in the model or stay
/// open (OpenContacts); only `orbit` counts those that act.
class ExactTrajectory final : public IntegratedTrajectory {
 public:
  /// \param model  of the scene; kept alive
  /// \param arcs   m + 1 of them, arc i ending at event i; not started again afterwards
  ExactTrajectory(std::shared_ptr<OrbitModel> model, OrbitGuess orbit,
                  std::vector<std::shared_ptr<LinearArc>> arcs,
                  const std::vector<OrbitEquations::EventCrossing>& crossings);

  [[nodiscard]] int contact_count() const override { return static_cast<int>(contacts_.size()); }
  [[nodiscard]] double period() const override { return model_->period; }
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::vector<Impulse> impulses() const override { return impulses_of(events_); }
  /// Openings with their push.
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override;

  [[nodiscard]] std::optional<State> state(double time) const override { return at(time); }
  /// Empty where the motion between two events is not known as a sum of modes (FlowForm::exponential).
  [[nodiscard]] Eigen::MatrixXcd force_spectrum(int count) const override;
  /// Units of the scene's motions.
  [[nodiscard]] const MotionScales& scales() const { return model_->dynamics.scales(); }
  /// State of the coordinates with mass at any time [s].
  [[nodiscard]] State at(double time) const;
  /// Section state and events, times in (start.time, start.time + period), of the contacts that act.
  [[nodiscard]] const OrbitGuess& orbit() const { return orbit_; }
  /// The contact of the scene that is contact j of `orbit`.
  [[nodiscard]] int scene_contact(int j) const { return contacts_[static_cast<std::size_t>(j)]; }
  /// Those of all contacts of `orbit`.
  [[nodiscard]] std::vector<int> acting_contacts() const {
    return {contacts_.begin(), contacts_.begin() + model_->dynamics.contact_count()};
  }
  [[nodiscard]] const OrbitQuality& quality() const { return quality_; }  ///< as the polish left it
  /// Said once by the polish, which knows it only when the orbit is there.
  void set_quality(OrbitQuality quality) { quality_ = std::move(quality); }

 private:
  [[nodiscard]] const LinearArc& arc_at(double& time) const;
  /// The integral of a contact's force [N s], by quadrature.
  [[nodiscard]] double push(int contact, double begin, double end) const;
  /// Of the contacts that act, that which is a contact of the scene.
  [[nodiscard]] int acting(int contact) const;

  std::shared_ptr<OrbitModel> model_;
  std::vector<int> contacts_;  // of the scene: those that act, then those that stay open
  OrbitGuess orbit_;
  std::vector<std::shared_ptr<LinearArc>> arcs_;
  std::vector<ContactEvent> events_;
  OrbitQuality quality_;
};

}  // namespace signorini
