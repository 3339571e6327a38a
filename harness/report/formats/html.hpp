#pragma once
// Pieces of HTML.

#include <string>

#include "harness/report/document/section.hpp"

namespace signorini {

/// Text as it stands between tags and in quoted attributes.
std::string html_escaped(std::string text);

/// Plain text as paragraphs' content, `code` between backquotes.
std::string html_text(const std::string& text);

/// The anchor of the record at this place.
std::string record_anchor(std::size_t place);

/// A table whose numbers carry their value for sorting and link to their record; names of scenes link to the
/// scene, names of methods to their rows among all cases.
std::string html_table(const Table& table);

/// A figure with its caption, the drawing held in the page itself.
std::string html_figure(const Figure& figure, const std::string& svg);

}  // namespace signorini
