#pragma once
// Sections as LaTeX tables.

#include <string>

#include "harness/report/document/section.hpp"

namespace signorini {

/// The table of a section, ready for \input: a `tabular` with the rules of the package booktabs, a
/// `longtable` where it is longer than a page.
std::string to_latex(const Section& section);

/// Text with the characters that TeX takes for its own, and those beyond ASCII that our tables use, spelled
/// out.
std::string latex_escaped(const std::string& text);

}  // namespace signorini
