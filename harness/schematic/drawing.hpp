#pragma once
// A line drawing as data: what a schematic consists of, before it is written in any format.

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace signorini {

/// A place on paper, x to the right and y upwards [cm].
using Place = Eigen::Vector2d;

/// What a line or a text stands for, which decides its colour.
enum class Ink { structure, contact, load, note };

/// What the inside of a closed line is filled with.
enum class Fill { none, body, paper, ink };

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

/// Resolution of pictures on a screen: 96 pixels per inch.
inline constexpr double kPixelsPerCentimetre = 96.0 / 2.54;

/// White paper around a drawing [cm].
inline constexpr double kDrawingMargin = 0.4;

/// Colours of a sheet: of each ink, of the inside of bodies, of the paper.
struct SheetColours {
  std::array<std::string_view, 4> ink;
  std::string_view body, paper;
};
/// Those on light paper. Contacts and loads as in the figures (Okabe and Ito).
inline constexpr SheetColours kDaySheet{{"#1f2328", "#c04f00", "#0067a3", "#57606a"}, "#dde7ef", "#fff"};

/// The drawing as one SVG document, with a margin around all that it holds. Each part is a group `<g
/// class="KIND">`; colours follow the reader's choice of light or dark. The same bytes each time.
std::string svg_of(const Drawing& drawing);

}  // namespace signorini
