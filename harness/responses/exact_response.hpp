#pragma once
// The exact response of a scene, which others are measured against, as the cases of a run share it.

#include <filesystem>
#include <string>

#include "harness/records/record.hpp"
#include "harness/responses/response_curve.hpp"

namespace signorini {

/// The exact response of the scene whose turn it is. It is computed once: DIR/exact/SCENE.json keeps its
/// record with the motions of all points, for a run that is resumed.
class ExactResponse {
 public:
  /// \param run  its folder; empty: nothing is kept in files
  explicit ExactResponse(std::filesystem::path run = {}) : run_(std::move(run)) {}

  /// Reads what the folder keeps of the case with this key. \return whether it keeps it
  bool read(const std::string& scene, const std::string& key);
  /// Keeps the branches of a record that was made `drawn_with_motions`, and takes their motions out of it.
  /// \throws UsageError if the folder cannot be written
  void take(Record& record);
  /// Without branches where there is none.
  [[nodiscard]] const ResponseCurve& curve() const { return curve_; }

 private:
  std::filesystem::path run_;
  ResponseCurve curve_ = {};
};

}  // namespace signorini
