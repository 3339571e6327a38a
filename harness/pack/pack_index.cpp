#include "harness/pack/pack_index.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "harness/isolation/child_process.hpp"
#include "harness/pack/run_pack.hpp"
#include "harness/text/words.hpp"

namespace signorini {

namespace {

/// Largest index [bytes]: some ten thousand packs.
constexpr std::size_t kLargestIndex = std::size_t{1} << 20U;

bool is_url(std::string_view place) { return place.starts_with("http://") || place.starts_with("https://"); }

/// What curl fetches of a URL: over http and https alone, also where the server sends it elsewhere. Its
/// complaint comes last in what it prints.
std::string downloaded(const std::string& url, std::size_t most) {
  constexpr const char *kProtocols = "=http,https", *kLongest = "600";  // [s]
  ProgramEnd end =
      run_to_end({"curl", "--disable", "--fail", "--silent", "--show-error", "--stderr", "-", "--location",
                  "--proto", kProtocols, "--proto-redir", kProtocols, "--max-time", kLongest, "--url", url},
                 most);
  if (end.missing()) throw UsageError("a URL needs curl, which is not there (install the package curl)");
  if (end.output.size() > most) throw UsageError("url = {} (must give at most {} MiB)", url, most >> 20U);
  if (end.code != 0) throw UsageError("url = {} (could not be fetched: {})", url, last_line(end.output));
  return std::move(end.output);
}

/// "HASH  NAME" or "HASH *NAME", which sha256sum prints of a binary file. \throws UsageError
IndexedPack pack_of(const std::string& line, const std::string& place) {
  constexpr std::size_t kDigits = 64, kName = kDigits + 2;
  constexpr std::size_t kLongest = 99;  // [bytes], a name in a folder
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  const auto is_plain = [](char c) {
    return c > ' ' && c < '\x7f' && std::string_view("/\\?#%").find(c) == std::string_view::npos;
  };
  if (line.size() > kName && line.size() <= kName + kLongest &&
      std::all_of(line.begin(), line.begin() + kDigits, is_digit) && line[kDigits] == ' ' &&
      (line[kDigits + 1] == ' ' || line[kDigits + 1] == '*') && line[kName] != '.' &&
      std::all_of(line.begin() + kName, line.end(), is_plain))
    return {.sha256 = line.substr(0, kDigits), .file = line.substr(kName)};
  throw UsageError("index = {} (must hold lines as `sha256sum NAME.tar.gz` prints them, of files beside it)",
                   place);
}

}  // namespace

std::string bytes_at(const std::string& place, std::size_t most) {
  return is_url(place) ? downloaded(place, most) : read_file(place, most);
}

std::vector<IndexedPack> read_pack_index(const std::string& place) {
  std::vector<IndexedPack> packs;
  for (std::string line : split(bytes_at(place, kLargestIndex), '\n')) {
    if (line.ends_with('\r')) line.pop_back();
    if (!line.empty()) packs.push_back(pack_of(line, place));
  }
  return packs;
}

std::string pack_beside(const std::string& index, const IndexedPack& pack) {
  const std::size_t folder = index.rfind('/') + 1;  // 0 where there is none
  const std::string place = index.substr(0, folder) + pack.file;
  std::string bytes = bytes_at(place, kLargestPack);
  if (sha256(bytes) != pack.sha256)
    throw UsageError("pack = {} (its SHA-256 must be {}, which the index states, and is {})", place,
                     pack.sha256, sha256(bytes));
  return bytes;
}

}  // namespace signorini
