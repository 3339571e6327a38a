#pragma once
// Pieces of HTML.

#include <string>

#include "harness/table.hpp"
#include "harness/text/words.hpp"

namespace signorini {

/// Plain text as paragraphs' content, `code` between backquotes.
std::string html_text(const std::string& text);

/// Text that may be broken where a method's settings begin and where one ends.
std::string breakable(const std::string& title);

/// A name of the table of all cases, as a link to its rows there (tables.js).
std::string link_to_cases(const std::string& name);

/// The anchor of the record at this place.
std::string record_anchor(std::size_t place);

/// A table whose numbers carry their value for sorting and link to their record; names of scenes link to the
/// scene, names of methods to their rows among all cases. A column that says nothing is left out
/// (`says_nothing`); what stands in place of a number that is missing becomes a dash, its words for screen
/// readers.
std::string html_table(const Table& table, const std::string& caption);

/// Whether no cell of a column but the first holds a number or words of its own: each is empty, a dash, or
/// stands in place of a number that is missing.
bool says_nothing(const Table& table, std::size_t column);

}  // namespace signorini
