#include "harness/schematic/drawing.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "harness/table.hpp"

namespace signorini {

const char* ink_name(Ink ink) {
  constexpr std::array kNames{"structure", "contact", "load", "note"};
  return kNames.at(static_cast<std::size_t>(ink));
}

const char* fill_name(Fill fill) {
  constexpr std::array kNames{"none", "body", "paper", "ink"};
  return kNames.at(static_cast<std::size_t>(fill));
}

Part& Drawing::add(std::string kind) {
  parts.push_back({.kind = std::move(kind)});
  return parts.back();
}

Box extent(const Label& label) {
  constexpr double kWidth = 0.6, kDescent = 0.3;  // of a letter, in text sizes
  const double width = kWidth * kTextSize * static_cast<double>(characters(label.words));
  const double share = label.anchor == Anchor::start ? 0.0 : label.anchor == Anchor::middle ? 0.5 : 1.0;
  const Place low = label.place - Place(share * width, kDescent * kTextSize);
  return {low, low + Place(width, (1.0 + kDescent) * kTextSize)};
}

Box extent(const Drawing& drawing) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Box box{Place::Constant(kFar), Place::Constant(-kFar)};
  const auto stretch = [&box](const Place& place) {
    box.low = box.low.cwiseMin(place);
    box.high = box.high.cwiseMax(place);
  };
  for (const Part& part : drawing.parts) {
    for (const Stroke& stroke : part.strokes)
      for (const Place& place : stroke.places) stretch(place);
    for (const Label& label : part.labels) {
      const Box own = extent(label);
      stretch(own.low);
      stretch(own.high);
    }
  }
  return box.low.x() <= box.high.x() ? box : Box();
}

}  // namespace signorini
