#pragma once
// The case whose time the times of others are divided by in tables.

#include <string_view>

namespace signorini {

/// Time marching to six digits, the usual way to solve such problems. This is the part of the case's name
/// after the scene.
inline constexpr std::string_view kTimeBaseline = "event-driven[flow=cvode,tolerance=1e-6]";

}  // namespace signorini
