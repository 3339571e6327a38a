#pragma once
// One number for many scenes, failures included.

#include <array>
#include <cstddef>
#include <span>

namespace signorini {

/// Default shift of geometric means [s].
inline constexpr double kMeanShift = 0.010;
/// Shifts between which an order must not change to be one [s].
inline constexpr std::array kMeanShifts{0.001, kMeanShift, 0.100};

/// Costs that are finite.
std::size_t solved_count(std::span<const double> costs);

/// exp(mean log(cost + shift)) - shift, infinite costs taken as `failure`. The larger the shift, the less the
/// small costs matter: which shift must be said with the figure. Requires at least one cost.
double shifted_geometric_mean(std::span<const double> costs, double shift, double failure);

/// Penalised average: the mean, infinite costs taken as twice the limit. Requires at least one cost.
double par2(std::span<const double> costs, double limit);

}  // namespace signorini
