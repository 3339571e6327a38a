#pragma once
// Kept motions made ready to be drawn beside each other.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "harness/records/record.hpp"
#include "harness/report/evaluation/evaluation.hpp"

namespace signorini {

/// The contact with the largest impulse over the waveform, by its place among those kept.
std::size_t busiest_place(const Waveform& waveform);

/// A periodic motion that begins `delay` later in its period, which the waveform spans; 0 <= delay < its end.
Waveform delayed(const Waveform& waveform, double delay);

/// The answer, moved by whole forcing periods to the phase of another answer's orbit: motions of `order`
/// forcing periods are the same when they begin in another one of these. As it is where its own orbit is not
/// kept, or its waveform spans another time. \param leader  orbit whose phase is taken, at the contact of
/// this place \param kept    answer and own orbit, at the contact of that place
Waveform in_phase_with(const Waveform& leader, std::size_t place, const Waveforms& kept, std::size_t at,
                       int order);

/// Lines "x v" of a portrait: between samples a centripetal curve of Catmull and Rom [yuksel2011] in shares
/// of the ranges of x and v, straight where the motion jumps.
std::string portrait_lines(const Waveform& waveform, std::size_t contact);

/// Where the contact of this place closes [m]: under a rigid law the largest displacement of the certified
/// orbit, of a spring where the force begins. Empty where it never closes.
std::optional<double> stop_position(const Record& record, std::size_t place);

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
