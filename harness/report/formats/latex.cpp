#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "harness/report/document/lines.hpp"
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

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_word(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// The first place from `at` on that no digit stands at.
std::size_t after_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// A number as 1.2e-03 is one, from `begin` to `end`.
struct PowerOfTen {
  std::string_view mantissa, sign, exponent;
  std::size_t end = 0;
};

/// The number that begins at `begin` and is no part of a word.
std::optional<PowerOfTen> power_of_ten(std::string_view text, std::size_t begin) {
  if (!is_digit(text[begin]) || (begin > 0 && is_word(text[begin - 1]))) return std::nullopt;
  std::size_t e = begin + 1;
  if (text.substr(e).starts_with('.') && after_digits(text, e + 1) > e + 1) e = after_digits(text, e + 1);
  if (!text.substr(e).starts_with("e+") && !text.substr(e).starts_with("e-")) return std::nullopt;
  const std::size_t end = after_digits(text, e + 2);
  if (end == e + 2 || (end < text.size() && is_word(text[end]))) return std::nullopt;
  const std::size_t first = std::min(text.find_first_not_of('0', e + 2), end - 1);
  return PowerOfTen{.mantissa = text.substr(begin, e - begin),
                    .sign = text[e + 1] == '-' ? "-" : "",
                    .exponent = text.substr(first, end - first),
                    .end = end};
}

/// A cell as journals print it: 1.2e-03 as a power of ten, us as microseconds. Names of settings stay as they
/// are typed.
std::string latex_cell(const std::string& text) {
  if (text.find_first_of("[]=") != std::string::npos) return latex_escaped(text);
  const std::string spelled = latex_escaped(with_unit_signs(text));
  std::string written;
  for (std::size_t i = 0; i < spelled.size();) {
    if (const auto number = power_of_ten(spelled, i)) {
      written += number->exponent == "0"
                     ? std::string(number->mantissa)
                     : fmt::format("${}\\cdot10^{{{}{}}}$", number->mantissa, number->sign, number->exponent);
      i = number->end;
    } else {
      written += spelled[i++];
    }
  }
  return written;
}

}  // namespace

std::string latex_escaped(const std::string& text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kSpelled{
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
       {"µ", "$\\mu$"},
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
