#include "harness/report/page/page_shell.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/records/json_fields.hpp"
#include "harness/report/page/html.hpp"
#include "harness/text/json.hpp"

namespace signorini {

namespace {

using Json = nlohmann::ordered_json;

/// What a manifest says of the run, as a definition list.
std::string facts_of(const Json& manifest) {
  std::string facts;
  const auto add = [&](const char* name, const char* pointer) {
    const Json::json_pointer place{pointer};
    if (!manifest.contains(place)) return;
    const Json& value = manifest[place];
    facts += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", html_escaped(name),
                         html_escaped(value.is_string() ? value.get<std::string>() : json_text(value)));
  };
  add("suite", "/suite");
  add("date", "/date");
  add("commit", "/build/commit");
  add("compiler", "/build/compiler");
  add("flags", "/build/flags");
  add("processor", "/machine/cpu");
  add("processors", "/machine/processors");
  add("time limit [s]", "/limits/timeout_s");
  return facts.empty() ? "<p>The run has no manifest.</p>\n" : "<dl>" + facts + "</dl>\n";
}

std::string head_of(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; "
      "form-action 'none'; img-src data:; style-src 'unsafe-inline'; script-src {} {}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{} - signorini</title>\n<style>\n{}</style></head>\n",
      script_source(kChartLibrary), script_source(kPageScript), html_escaped(title), kPageStyle);
}

constexpr const char* kPageEnd = R"(</main>
<dialog id="record" aria-labelledby="record-title"><h2 id="record-title"></h2><p id="record-facts"></p>
<pre tabindex="0" aria-label="The record as it is kept"></pre><button type="button">Close</button></dialog>
<div id="hint" aria-hidden="true" hidden></div>
)";

}  // namespace

std::string whole_page(const PageText& text, const Json& data) {
  return head_of(text.title) + "<body>\n<a class=\"skip\" href=\"#main\">Skip to the content</a>\n" +
         text.contents +
         fmt::format(
             "<main id=\"main\" tabindex=\"-1\">\n<header><p class=\"brand\">signorini</p><h1>{}</h1>\n"
             "<p>{}</p></header>\n<noscript><p class=\"note\">Figures and records need JavaScript here; all "
             "tables are complete without it. The records are in the .jsonl file beside this "
             "page.</p></noscript>\n",
             html_escaped(text.title), text.summary) +
         text.main + kPageEnd +
         fmt::format(
             "<script type=\"application/octet-stream\" id=\"data\">{}</script>\n"
             "<script>{}</script>\n<script>{}</script>\n</body></html>\n",
             packed(json_line(data)), kChartLibrary, kPageScript);
}

std::string printed(const Json& record) {
  std::string text = "{\n";
  for (const auto& [key, value] : record.items())
    text += fmt::format("  \"{}\": {},\n", key, json_line(value));
  text.erase(text.size() - 2, 1);  // the last comma
  return text + "}";
}

std::string about_section(const Json& manifest, const std::string& more) {
  return "<section id=\"about\"><h2>How this run was made</h2>\n" + facts_of(manifest) + more +
         "</section>\n";
}

std::string contents_of(const std::string& parts) {
  return "<nav aria-label=\"Contents\"><details open><summary>Contents</summary>\n" + parts +
         "</details></nav>\n";
}

std::string list_part(const std::string& title, const std::string& items) {
  if (items.empty()) return "";
  return (title.empty() ? "" : fmt::format("<h2>{}</h2>\n", html_escaped(title))) + "<ul>\n" + items +
         "</ul>\n";
}

std::string item(const std::string& target, const std::string& title, const char* kind) {
  return fmt::format("<li class=\"{}\"><a href=\"#{}\">{}</a></li>\n", kind, html_escaped(target),
                     html_escaped(title));
}

std::string section_items(const std::vector<const Section*>& sections) {
  std::string text, matter;
  for (const Section* section : sections) {
    const std::size_t colon = section->title.find(": ");
    const std::string first = section->title.substr(0, colon);
    if (colon == std::string::npos) {
      text += item(section->id, section->title);
      continue;
    }
    if (first != matter) text += fmt::format("<li class=\"matter\">{}</li>\n", html_escaped(first));
    matter = first;
    text += item(section->id, section->title.substr(colon + 2), "contest");
  }
  return text;
}

std::string chart(const std::string& kind, const std::string& of, const std::string& title,
                  const std::string& caption) {
  return fmt::format(
      "<figure class=\"chart {0}\" data-kind=\"{0}\" data-of=\"{1}\" data-title=\"{2}\"><figcaption>{3}"
      "</figcaption></figure>\n",
      kind, html_escaped(of), html_escaped(title), html_escaped(caption));
}

}  // namespace signorini
