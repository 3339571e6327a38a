#pragma once
// Whether rigid stops leave a structure room to move, and one law of impact.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/problem.hpp"

namespace signorini {

/// Stops that exclude or contradict each other.
struct StopConflict {
  int contact = 0;               ///< one of them, by its number
  std::string_view key = {};     ///< what of it is refused, "gap" or "restitution"
  double found = 0.0;            ///< the value of that, [m] or [-]
  std::string requirement = {};  ///< what is required of it, with the numbers of all of them
};

/// Looks for rigid stops that leave no room, where they must: the admissible set {u : w_j^T u <= g_j} has an
/// interior. Stops that cross leave no admissible displacement, stops that meet no motion. By Farkas's lemma
/// and Motzkin's theorem there is no room exactly where some y >= 0, y != 0, has sum_j y_j w_j = 0 and sum_j
/// y_j g_j <= 0: the stops with y_j > 0 exclude each other.
///
/// Stops along one line are compared with each other. Of the others, those are set aside that a coordinate
/// can always retreat from, because no stop holds it on the other side, and groups joined by coordinates
/// whose gaps are all positive. What is left, up to 200 coordinates and 3000 stops in a group, is decided by
/// least squares under y >= 0 [lawson1995, ch. 23]; larger groups are taken to leave room. Sums count as zero
/// to 1e-12 of their largest term, normals in units of their length and gaps in units of the largest of a
/// group.
///
/// Stops that are springs give way: they exclude nothing.
///
/// \return nothing where they leave room
std::optional<StopConflict> stop_conflict(std::vector<Contact> contacts);

/// Looks for rigid stops that are one stop with two restitutions: normals a w and b w with a b > 0, at
/// displacements g_a / a and g_b / b that are equal to 1e-12, both nearest to the structure along their line.
/// Each impact is one of both, and Newton's law asks for two speeds after it. Where the restitutions are
/// equal the motion is that of one of them, and only its force has no unique distribution. What stands behind
/// the nearest stop is never touched.
///
/// \return nothing where no two contradict each other
std::optional<StopConflict> restitution_conflict(const std::vector<Contact>& contacts);

}  // namespace signorini
