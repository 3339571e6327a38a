#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <string>
#include <string_view>
#include <utility>

#include "harness/report/formats/formats.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

constexpr std::size_t kPage = 45;  // rows

std::string row_of(const std::vector<std::string>& cells) {
  return fmt::format("{} \\\\\n", joined(cells, " & "));
}

std::string columns_of(const Table& table) {
  std::string columns;
  for (std::size_t c = 0; c < table.header.size(); ++c) columns += table.is_numeric(c) ? 'r' : 'l';
  return columns;
}

/// A cell as journals print it: 1.2e-03 as a power of ten, us as microseconds. Names of settings stay as they
/// are typed.
std::string latex_cell(const std::string& text) {
  static const std::regex power(R"(\b(\d(?:\.\d+)?)e([+-])0*(\d+)\b)"), micro(" us\\b");
  const std::string spelled = latex_escaped(text);
  if (text.find_first_of("[]=") != std::string::npos) return spelled;
  std::string written;
  std::size_t from = 0;
  for (std::sregex_iterator at(spelled.begin(), spelled.end(), power), end; at != end; ++at) {
    const auto place = static_cast<std::size_t>(at->position());
    written += spelled.substr(from, place - from);
    written += at->str(3) == "0" ? at->str(1)
                                 : fmt::format("${}\\cdot10^{{{}{}}}$", at->str(1),
                                               at->str(2) == "-" ? "-" : "", at->str(3));
    from = place + static_cast<std::size_t>(at->length());
  }
  return std::regex_replace(written + spelled.substr(from), micro, " $$\\mu$$s");
}

}  // namespace

std::string latex_escaped(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 16> kSpelled{
      {{"\\", "\\textbackslash{}"},
       {"{", "\\{"},
       {"}", "\\}"},
       {"&", "\\&"},
       {"%", "\\%"},
       {"$", "\\$"},
       {"#", "\\#"},
       {"_", "\\_"},
       {"^", "\\textasciicircum{}"},
       {"~", "\\textasciitilde{}"},
       {"<", "$<$"},
       {">", "$>$"},
       {"[", "{[}"},
       {"≠", "$\\neq$"},
       {"·", "$\\cdot$"},
       {"\n", " "}}};
  std::string escaped;
  for (std::size_t i = 0; i < text.size();) {
    const auto spelled = std::ranges::find_if(
        kSpelled, [&](const auto& pair) { return text.compare(i, pair.first.size(), pair.first) == 0; });
    if (spelled != kSpelled.end()) {
      escaped += spelled->second;
      i += spelled->first.size();
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[i++]);
    constexpr unsigned char kBeyondAscii = 0x80, kContinuation = 0xC0;
    if (byte < kBeyondAscii) {
      escaped += static_cast<char>(byte);
    } else if (byte >= kContinuation) {
      escaped += '?';  // once for all bytes of a character
    }
  }
  return escaped;
}

std::string to_latex(const Section& section) {
  const Table& table = section.table;
  const bool is_long = table.rows.size() > kPage;
  std::vector<std::string> header;
  for (const std::string& title : table.header) header.push_back(latex_escaped(title));
  std::string text =
      fmt::format("% {}\n% needs \\usepackage{{booktabs{}}}\n\\begin{{{}}}{{{}}}\n\\toprule\n{}\\midrule\n",
                  latex_escaped(section.title), is_long ? ",longtable" : "",
                  is_long ? "longtable" : "tabular", columns_of(table), row_of(header));
  if (is_long) text += "\\endhead\n\\bottomrule\n\\endfoot\n";
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const Cell& cell : row) cells.push_back(latex_cell(cell.text));
    text += row_of(cells);
  }
  return text + (is_long ? "\\end{longtable}\n" : "\\bottomrule\n\\end{tabular}\n");
}

}  // namespace signorini
