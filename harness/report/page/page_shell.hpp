#pragma once
// What pages of all kinds share: head, contents, dialog of records, data and scripts.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "harness/report/document/section.hpp"
#include "harness/table.hpp"
#include "harness/text/words.hpp"

namespace signorini {

/// What a page says; all of it HTML but the title and the data.
struct PageText {
  std::string title = {};
  std::string summary = {};   ///< one line below the title
  std::string contents = {};  ///< of contents_of
  std::string main = {};      ///< sections
};

/// A whole page, which needs nothing but itself. Its data are in it in packed form; only scripts of ours may
/// run (a content security policy names them).
/// \param data  {"configurations": names of methods, "cases": names of records, "records": their texts, and
///              what the figures draw}
std::string whole_page(const PageText& text, const nlohmann::ordered_json& data);

/// A record as its dialog shows it: one key a line.
std::string printed(const nlohmann::ordered_json& record);

/// How a run was made, as a section "about", and what else is to be said there. \param manifest  null if
/// there is none
std::string about_section(const nlohmann::ordered_json& manifest, const std::string& more = {});

/// The navigation of a page, of parts as list_part makes them.
std::string contents_of(const std::string& parts);
/// Links under a title, or without one; nothing where there are no links.
std::string list_part(const std::string& title, const std::string& items);
/// A link to a part of the page. \param kind  its class
std::string item(const std::string& target, const std::string& title, const char* kind = "part");
/// Links to sections; those of several contests under one matter.
std::string section_items(const std::vector<const Section*>& sections);

/// A place for a figure that the page's script draws. \param kind  which, see figures.js \param of  the key
/// of its data \param title  for screen readers
std::string chart(const std::string& kind, const std::string& of, const std::string& title,
                  const std::string& caption);

/// A place for the switches of the methods in the figures beside it.
inline constexpr const char* kMethodSwitches = "<div class=\"legend\"></div>\n";

// The style sheet of this folder, its scripts in one, and the modules of D3 that they call.
extern const std::string_view kPageStyle, kPageScript, kChartLibrary;

/// Base64 (RFC 4648) in one line.
std::string base64(std::string_view bytes);

/// A text compressed in the format of zlib (RFC 1950), as Base64: what `DecompressionStream("deflate")` of a
/// browser unpacks. No byte of the text stands in it, so that it needs no escaping.
std::string packed(std::string_view text);

/// A script as a content security policy names it: 'sha256-...' with the quotes.
std::string script_source(std::string_view script);

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
