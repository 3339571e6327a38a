#pragma once
// A report is a list of sections; every format prints the same ones.

#include <string>
#include <vector>

#include "harness/report/document/figure.hpp"
#include "harness/table.hpp"

namespace signorini {

/// What the rows of a section's table are, which decides where a page shows it.
enum class SectionKind {
  overview,  ///< of methods, over scenes
  scenes,    ///< of methods on one scene, which stands in the first column
  cases,     ///< every record
  remarks    ///< records that did not go as hoped
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

}  // namespace signorini
