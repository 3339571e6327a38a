#pragma once
// Tables as text.

#include <string>
#include <string_view>
#include <vector>

namespace signorini {

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header
};

/// Markdown with aligned columns; pipes in cells are escaped.
std::string to_markdown(const Table& table);

/// RFC 4180: cells with commas, quotes or line breaks are quoted. Lines end in a line feed.
std::string to_csv(const Table& table);

/// True if a comes before b, runs of digits compared as numbers.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace signorini
