#pragma once
// The flows of a scene's contact modes.

#include <map>
#include <memory>
#include <vector>

#include "methods/linear_flow/contact_dynamics.hpp"
#include "methods/linear_flow/linear_flow.hpp"

namespace signorini {

/// How a flow is represented.
enum class FlowForm {
  automatic,    ///< complex modes; where they fail, the exponential
  exponential,  ///< the matrix exponential of structure and load together: slow, always defined
};

/// Coordinates that a closed-form flow takes: its matrices are dense [-]
inline constexpr int kMostInDenseFlow = 300;

/// The flow of a mode. \throws std::runtime_error if the structure has more coordinates than kMostInDenseFlow
std::unique_ptr<const LinearFlow> linear_flow(const ContactDynamics& dynamics, ContactMode mode,
                                              FlowForm form = FlowForm::automatic);

/// The flows of a scene's contact modes, each made when first asked for.
class LinearFlows {
 public:
  explicit LinearFlows(const ContactDynamics& dynamics, FlowForm form = FlowForm::automatic)
      : dynamics_(dynamics), form_(form) {}
  /// The flow in which exactly the contacts with closed[j] are closed. \throws std::runtime_error
  const LinearFlow& of(const std::vector<bool>& closed);
  [[nodiscard]] const ContactDynamics& dynamics() const { return dynamics_; }

 private:
  const ContactDynamics& dynamics_;
  FlowForm form_;
  std::map<std::vector<bool>, std::unique_ptr<const LinearFlow>> flows_;
};

}  // namespace signorini
