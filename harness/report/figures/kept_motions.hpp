#pragma once
// The motions that records of a scene keep, chosen to be drawn beside each other.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// An answer as it is drawn.
struct KeptAnswer {
  const CaseResult* result = nullptr;
  std::size_t place =
      0;                 ///< of the drawn contact among those that it keeps; the first if it does not keep it
  Waveform motion = {};  ///< in phase with the orbit
};

/// What is drawn of a scene, at the contact that exchanges most impulse.
struct KeptMotions {
  std::optional<Record> leader = {};  ///< whose certified orbit is drawn; it keeps one
  std::size_t place = 0;              ///< of the contact among those that it keeps
  int contact = 0;                    ///< in [0, Nc)
  std::vector<KeptAnswer> answers = {};

  /// The certified orbit.
  [[nodiscard]] const Waveform& orbit() const { return *leader->waveforms->orbit; }
};

/// Of each ranked study of a scene the coarsest answer that has an error, with a certified orbit, as far as
/// records keep motions; no answers where none does. Results point into the evaluation.
KeptMotions kept_motions(const Evaluation& evaluation, const std::string& scene);

}  // namespace signorini
