#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "problems/files/matrices/matrix_file.hpp"
#include "problems/files/toml_tree.hpp"

namespace signorini {

namespace {

std::string upper_case(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

bool is_matrix_type(const TextLines& lines) {
  const std::vector<std::string_view>& words = lines.words();
  if (words[0].size() != 3 || words.size() < 4) return false;
  const auto letter = [type = upper_case(words[0])](std::size_t i, std::string_view known) {
    return known.find(type[i]) != std::string_view::npos;
  };
  return letter(0, "RCPIQX") && letter(1, "SUHZR") && letter(2, "AE") &&
         std::all_of(words.begin() + 1, words.begin() + 4,
                     [](std::string_view word) { return number_of<std::int64_t>(word).has_value(); });
}

// "(1P,4E20.12)": four fields a line, of 20 characters.
struct FieldFormat {
  std::size_t count = 1, width = 0;
};

FieldFormat field_format(const TextLines& lines, std::size_t begin, std::size_t length) {
  const std::string_view line = lines.line();
  const std::string_view text = begin < line.size() ? line.substr(begin, length) : std::string_view();
  const auto digits_from = [&](std::size_t at) {
    std::size_t number = 0;
    for (; at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0 && number < 1000; ++at)
      number = 10 * number + static_cast<std::size_t>(text[at] - '0');
    return number;
  };
  FieldFormat format;
  const std::size_t letter = text.find_last_of("IiEeDdFfGg");
  if (letter != std::string_view::npos) {
    std::size_t after = letter + 1, before = letter;
    while (after < text.size() && std::isalpha(static_cast<unsigned char>(text[after])) != 0) ++after;
    format.width = digits_from(after);
    while (before > 0 && std::isdigit(static_cast<unsigned char>(text[before - 1])) != 0) --before;
    if (before < letter) format.count = digits_from(before);
  }
  const bool nested = text.find('(') != text.rfind('(');
  if (nested || format.count < 1 || format.width < 1)
    lines.refuse("formats", fmt::format("must have a Fortran format, such as (10I8), in columns {} to {}",
                                        begin + 1, begin + length));
  return format;
}

class HarwellBoeingReader {
 public:
  HarwellBoeingReader(std::string_view text, const std::string& name)
      : lines_(text, name), bytes_(std::ssize(text)) {}

  MatrixFile read() {
    const bool has_right_sides = read_type();
    const std::vector<std::int64_t> sizes = sizes_of_type();
    const int size = matrix_size(lines_, sizes[0], sizes[1]);
    require_entry_count(lines_, sizes[2], size, symmetry_);
    if (2 * sizes[2] > bytes_) lines_.refuse("size", "must promise entries that the file can hold");
    lines_.expect("formats", 1);
    constexpr std::size_t kShort = 16, kLong = 20;  // columns
    const FieldFormat starts = field_format(lines_, 0, kShort), rows = field_format(lines_, kShort, kShort),
                      values = field_format(lines_, 2 * kShort, kLong);
    if (has_right_sides) lines_.expect("right-hand sides", 1);
    const auto entries = static_cast<std::size_t>(sizes[2]);
    read_starts(starts, static_cast<std::size_t>(size) + 1, sizes[2]);
    read_rows(rows, entries, size);
    std::size_t at = 0;
    for_each_field(values, entries,
                   [&](std::string_view field) { entries_[at++].value = matrix_value(lines_, field); });
    return assemble_matrix(lines_, size, std::move(entries_), symmetry_);
  }

 private:
  // Whether a line about right-hand sides follows the formats: the fifth count of the second line says so.
  bool read_type() {
    bool right_sides = false;
    while (lines_.next()) {
      if (is_matrix_type(lines_)) break;
      const auto cards =
          lines_.words().size() == 5 ? number_of<std::int64_t>(lines_.words()[4]) : std::nullopt;
      right_sides = cards.value_or(0) > 0;
    }
    return right_sides;
  }

  std::vector<std::int64_t> sizes_of_type() {
    const std::string type = upper_case(lines_.words()[0]);
    if ((type[0] != 'R' && type[0] != 'I') || type[1] == 'H' || type[2] != 'A')
      lines_.refuse("type", "must be real and assembled: RSA, RUA, RZA or RRA");
    symmetry_ = type[1] == 'S' ? Symmetry::symmetric : type[1] == 'Z' ? Symmetry::skew : Symmetry::general;
    std::vector<std::int64_t> sizes;
    for (std::size_t i = 1; i <= 3; ++i) sizes.push_back(lines_.whole(i, "size", 0, kMostMatrixEntries));
    return sizes;
  }

  // Fields that blanks part are taken as they stand, whatever width is said: scipy writes them narrower than
  // it says. Others may touch.
  template <class Visit>
  void for_each_field(const FieldFormat& format, std::size_t count, Visit visit) {
    while (count > 0) {
      if (!lines_.next()) lines_.refuse("file", "its end", fmt::format("must hold {} more numbers", count));
      std::vector<std::string_view> fields = lines_.words();
      const std::size_t expected = std::min(format.count, count);
      if (fields.size() != expected) {
        fields.clear();
        std::string_view rest = lines_.line();
        for (; fields.size() < expected; rest.remove_prefix(std::min(format.width, rest.size()))) {
          const std::vector<std::string_view> words = words_of(rest.substr(0, format.width));
          if (words.empty()) break;
          if (words.size() > 1)
            lines_.refuse("entry", fmt::format("must be fields of {} characters", format.width));
          fields.push_back(words[0]);
        }
      }
      for (const std::string_view field : fields) visit(field);
      count -= fields.size();
    }
  }

  std::int64_t whole_field(std::string_view field, std::int64_t least, std::int64_t most) const {
    const auto number = number_of<std::int64_t>(field);
    if (!number || *number < least || *number > most)
      lines_.refuse("entry",
                    fmt::format("{} must be a whole number in {}..{}", one_line(field, 20), least, most));
    return *number;
  }

  // The columns of the entries, which begin in each where the file says.
  void read_starts(const FieldFormat& format, std::size_t count, std::int64_t entries) {
    std::int64_t last = 1;
    int column = -1;
    for_each_field(format, count, [&](std::string_view field) {
      const std::int64_t start = whole_field(field, last, entries + 1);
      if (column < 0 && start != 1) lines_.refuse("entry", "must begin with 1, the first start of a column");
      for (; last < start; ++last) entries_.push_back({.column = column});
      ++column;
    });
    if (last != entries + 1)
      lines_.refuse("entry", fmt::format("must end with {}, one more than the entries", entries + 1));
  }

  void read_rows(const FieldFormat& format, std::size_t count, int size) {
    std::size_t at = 0;
    for_each_field(format, count, [&](std::string_view field) {
      entries_[at].row = static_cast<int>(whole_field(field, 1, size)) - 1;
      entries_[at++].line = lines_.number();
    });
  }

  TextLines lines_;
  std::ptrdiff_t bytes_;  // of the file
  Symmetry symmetry_ = Symmetry::general;
  std::vector<MatrixEntry> entries_;
};

}  // namespace

bool is_harwell_boeing(std::string_view text, const std::string& name) {
  constexpr int kHeaderLines = 3;
  TextLines lines(text, name);
  for (int i = 0; i < kHeaderLines && lines.next(); ++i)
    if (is_matrix_type(lines)) return true;
  return false;
}

MatrixFile read_harwell_boeing(std::string_view text, const std::string& name) {
  return HarwellBoeingReader(text, name).read();
}

}  // namespace signorini
