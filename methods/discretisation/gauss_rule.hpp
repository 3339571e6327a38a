#pragma once
// Gauss' rule of eight nodes.

#include <array>

namespace signorini {

/// The positive nodes of Gauss' rule of eight nodes on [-1, 1], rising; the others are their mirror images.
/// Exact for polynomials of degree 15.
inline constexpr std::array<double, 4> kGaussNodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                   0.9602898564975363};
/// The weight of each of them, and of its mirror image.
inline constexpr std::array<double, 4> kGaussWeights{0.3626837833783620, 0.3137066458778873,
                                                     0.2223810344533745, 0.1012285362903763};

}  // namespace signorini
