#pragma once
// A line drawing as data: what a schematic consists of, before it is written in any format.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace signorini {

/// A place on paper, x to the right and y upwards [cm].
using Place = Eigen::Vector2d;

/// What a line or a text stands for, which decides its colour.
enum class Ink { structure, contact, load, note };
/// "structure" and so on.
const char* ink_name(Ink ink);

/// What the inside of a closed line is filled with.
enum class Fill { none, body, paper, ink };
/// "none" and so on.
const char* fill_name(Fill fill);

/// One line through some places.
struct Stroke {
  std::vector<Place> places = {};
  Ink ink = Ink::structure;
  Fill fill = Fill::none;
  bool closed = false;
  bool dashed = false;
  double width = 0.035;  ///< [cm]
};

/// Which part of a text is at its place.
enum class Anchor { start, middle, end };

/// Height of the letters of all labels [cm].
inline constexpr double kTextSize = 0.34;

/// A line of text; its place is on the base line.
struct Label {
  Place place = Place::Zero();
  std::string words = {};
  Anchor anchor = Anchor::middle;
  Ink ink = Ink::structure;
};

/// Lines and labels that show one thing: a spring, a stop, a gap.
struct Part {
  std::string kind = {};  ///< "spring"
  std::vector<Stroke> strokes = {};
  std::vector<Label> labels = {};
};

struct Drawing {
  std::string title = {};
  std::vector<Part> parts = {};  ///< later ones above earlier ones
  bool damped_stops = false;     ///< stops with springs have dampers beside them

  /// Begins a part, which takes the lines and labels that follow.
  Part& add(std::string kind);
};

/// A rectangle with sides along x and y [cm].
struct Box {
  Place low = Place::Zero(), high = Place::Zero();
  [[nodiscard]] Place size() const { return high - low; }
};

/// Where a label stands, by the width of wide letters: an upper bound in common fonts without serifs.
Box extent(const Label& label);
/// The least box around all strokes and labels; of an empty drawing, the origin.
Box extent(const Drawing& drawing);

}  // namespace signorini
