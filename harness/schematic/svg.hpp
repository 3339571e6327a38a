#pragma once
// A drawing as Scalable Vector Graphics.

#include <string>

#include "harness/schematic/drawing.hpp"

namespace signorini {

/// White paper around a drawing [cm].
inline constexpr double kDrawingMargin = 0.4;

/// The drawing as one SVG document, with a margin around all that it holds. Each part is a group `<g
/// class="KIND">`; colours follow the reader's choice of light or dark. The same bytes each time.
std::string svg_of(const Drawing& drawing);

}  // namespace signorini
