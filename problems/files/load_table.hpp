#pragma once
// Loads that are given by samples over one period: their harmonics, and what these leave out.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// Most samples of a load: as many as 10,000 harmonics need.
inline constexpr int kMostLoadSamples = 20001;

/// A load of which only samples f_i = f(i T / N), i = 0..N-1, are known, as the sum over h = 0..H of
/// cos_h cos(h omega t) + sin_h sin(h omega t), the least squares fit at the samples.
struct SampledLoad {
  std::string field = {};        ///< of the scene file, "forcing.term[0]"
  int samples = 0;               ///< N [-]
  std::vector<double> cos = {};  ///< cos_h, H + 1, H <= (N - 1) / 2 [N]
  std::vector<double> sin = {};  ///< sin_h, H + 1 [N]
  double rms = 0.0;              ///< of the samples about their mean [N]
  double left_out_rms = 0.0;     ///< root mean square, at the samples, of what the harmonics leave out [N]
  double left_out_max = 0.0;     ///< largest of it [N]

  [[nodiscard]] int harmonics() const { return static_cast<int>(cos.size()) - 1; }  ///< H
};

/// The harmonics of samples, 3 to kMostLoadSamples finite numbers.
/// \param harmonics  H, at most (N - 1) / 2; without it the least that leaves out at most 1e-6 of `rms`, or
/// else all
SampledLoad load_of_samples(const std::vector<double>& samples, std::optional<int> harmonics);

/// The samples of a text file: a line per sample with its value, or with its instant [s] and its value,
/// separated by a comma, a semicolon or blanks; lines that begin with # and one heading are left out.
/// Instants must be equidistant, the first one 0, and fill `period` to 1e-6 of it. \throws SceneError,
/// `NAME:LINE: what = ...`
std::vector<double> parse_load_table(std::string_view text, const std::string& name, double period);

}  // namespace signorini
