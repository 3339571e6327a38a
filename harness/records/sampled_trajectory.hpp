#pragma once
// A trajectory kept as samples: how motions travel between processes, files and runs.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/records/record.hpp"
#include "methods/solution.hpp"

namespace signorini {

/// Equidistant samples of one period. At a count that divides the stored one the samples come back bit
/// by bit; elsewhere x is interpolated by cubics through values and velocities, velocity and force by
/// straight lines. Up to an impulse or event between two instants and from there on they go on as beside it;
/// a jump that is not listed, or has another within a step, is spread over one step.
class SampledTrajectory final : public Trajectory {
 public:
  struct Data {
    double period = 1.0;                                   ///< [s]
    Samples samples;                                       ///< at least one instant
    std::vector<Impulse> impulses;                         ///< within one period
    std::optional<int> bandwidth;                          ///< harmonics that the source resolves
    std::optional<std::vector<ContactEvent>> events = {};  ///< as the source lists them
  };

  /// \throws std::invalid_argument unless sizes agree, numbers are finite and the period is positive
  explicit SampledTrajectory(Data data);
  /// Samples another trajectory, without its events: what is known of them has the source's accuracy, not
  /// that of the samples.
  SampledTrajectory(const Trajectory& source, int count);

  [[nodiscard]] int contact_count() const override { return static_cast<int>(data_.samples.x.cols()); }
  [[nodiscard]] double period() const override { return data_.period; }
  [[nodiscard]] Samples sample(int count) const override;
  [[nodiscard]] std::vector<Impulse> impulses() const override { return data_.impulses; }
  [[nodiscard]] std::optional<int> bandwidth() const override { return data_.bandwidth; }
  [[nodiscard]] std::optional<std::vector<ContactEvent>> events() const override { return data_.events; }
  [[nodiscard]] const Data& data() const { return data_; }

 private:
  Data data_;
};

/// The same motion, late by a share of its period in [0, 1), rounded to whole samples.
SampledTrajectory delayed(const SampledTrajectory& motion, double share);

/// The same motion with `periods` >= 1 of its periods taken for one.
SampledTrajectory repeated(const SampledTrajectory& motion, int periods);

/// What is wrong with a trajectory as an answer on `contacts` contacts before it is sampled: another number
/// of contacts, a period that is not a whole multiple of `forcing_period` (to 1e-6 relative), impulses or
/// events outside the period or at no contact, events out of order. Empty if nothing is.
std::string trajectory_defect(const Trajectory& trajectory, int contacts, double forcing_period);

/// What is wrong with samples of `contacts` contacts at `count` instants: wrong sizes, values that are not
/// finite. Empty if nothing is.
std::string samples_defect(const Samples& samples, Eigen::Index count, Eigen::Index contacts);

/// Sixteen hexadecimal digits of the SHA-256 of an answer's bytes: period, x, velocity and force at 64
/// instants, and impulses. Equal for answers that agree there bit by bit.
std::string answer_digest(const Trajectory& answer);

/// One period at `count` instants.
TrajectorySamples samples_of(const Trajectory& trajectory, int count);

/// \throws BadRecord if the lists do not fit together
std::shared_ptr<const SampledTrajectory> trajectory_of(double period, const TrajectorySamples& samples);

/// The trajectory in what `solve --json --samples N` printed.
/// \throws UsageError `file` and what is wrong with it
std::shared_ptr<const SampledTrajectory> start_from_file(const std::string& path);

}  // namespace signorini
