#pragma once

#include <string_view>

namespace signorini {

/// What times are set beside: time marching to six digits, as most would do it; the part of a case after the
/// scene.
inline constexpr std::string_view kTimeBaseline = "event-driven[flow=cvode,tolerance=1e-6]";

}  // namespace signorini
