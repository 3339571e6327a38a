#pragma once
// A report is a list of sections, each with its table and its figures; every format prints the same ones.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "harness/table.hpp"

namespace signorini {

/// One figure. The script sets neither terminal nor output; its data are in `NAME.dat` beside it.
struct Figure {
  std::string name = {};  ///< lower-kebab-case: NAME.gp, NAME.dat, NAME.svg, NAME.pdf
  std::string caption = {};
  std::string script = {};
  std::string data = {};               ///< blocks parted by two blank lines, gnuplot's `index`
  double width = 16.0, height = 10.0;  ///< [cm]
};

/// What the rows of a section's table are, which decides where a page shows it.
enum class SectionKind {
  overview,   ///< of methods, over scenes
  scenes,     ///< of methods on one scene, which stands in the first column
  responses,  ///< of methods on the response of one scene, which stands in the first column
  cases,      ///< every record
  remarks,    ///< records that did not go as hoped
  origin      ///< of how the run was made, which a page shows last
};

/// One table with its words and figures. Text is plain, `code` between backquotes.
struct Section {
  std::string id = {};  ///< lower-kebab-case: names of files, anchors, markers in other documents
  SectionKind kind = SectionKind::overview;
  std::string title = {};  ///< without a full stop
  std::string text = {};   ///< above the table
  Table table = {};
  std::string note = {};  ///< below it
  std::vector<Figure> figures = {};
};

/// Rows that a table has at most where it has one per case or study: more are read by programs alone, which
/// have files of comma separated values, and would fill the memory.
inline constexpr std::size_t kMostRows = 20'000;

/// Fills the table of a section with rows of which there may be very many.
class Rows {
 public:
  /// \param elsewhere  where the rows are that find no room, a clause for the note of the section
  Rows(Section& section, std::string elsewhere) : section_(section), elsewhere_(std::move(elsewhere)) {}

  /// Adds the row that `make` returns, which is not asked where the table is full.
  template <class Make>
  void add(const Make& make) {
    if (section_.table.rows.size() < kMostRows) section_.table.rows.push_back(make());
    ++count_;
  }

  /// Says in the note of the section how many rows found no room, if any.
  void close() {
    if (count_ <= kMostRows) return;
    const std::string which = std::to_string(kMostRows) + " of " + std::to_string(count_);
    section_.note = "These are the first " + which + " rows; " + elsewhere_ + "." +
                    (section_.note.empty() ? "" : " " + section_.note);
  }

 private:
  Section& section_;
  std::string elsewhere_;
  std::size_t count_ = 0;
};

}  // namespace signorini
