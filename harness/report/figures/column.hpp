#pragma once
// How wide figures are on paper.

namespace signorini {

/// What a figure is made for.
enum class Column {
  own,     ///< the width that suits it
  single,  ///< one column of a journal
  both     ///< a page of two columns
};

/// Widths that fit most journals [cm].
inline constexpr double kSingleColumn = 8.4, kBothColumns = 17.4;

/// Width of a figure that by itself is `usual` wide [cm].
constexpr double width_in(Column column, double usual) {
  return column == Column::own ? usual : column == Column::single ? kSingleColumn : kBothColumns;
}

/// Whether panels stand below each other and names of curves below the panel, instead of beside.
constexpr bool is_narrow(Column column) { return column == Column::single; }

}  // namespace signorini
