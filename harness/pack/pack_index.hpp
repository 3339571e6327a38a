#pragma once
// An archive of packs: a list of them with a hash of each, as sha256sum writes it, and the packs beside it;
// in a folder or on a plain web server.

#include <cstddef>
#include <string>
#include <vector>

namespace signorini {

/// A line of an index.
struct IndexedPack {
  std::string sha256 = {};  ///< of the file, 64 lower-case hexadecimal digits
  std::string file = {};    ///< its name beside the index, no path
};

/// The bytes at a place that anybody may have filled: a URL of http or https, which the program curl fetches,
/// or the path of a regular file. \throws UsageError where there are none, or more than `most`
std::string bytes_at(const std::string& place, std::size_t most);

/// The packs that an index lists, in its order; an index is what `sha256sum *.tar.gz` prints. \param place of
/// the index, as bytes_at takes it \throws UsageError, one line, for any other text
std::vector<IndexedPack> read_pack_index(const std::string& place);

/// The bytes of a pack that lies beside the index. \throws UsageError where they are not of the hash that the
/// index states
std::string pack_beside(const std::string& index, const IndexedPack& pack);

}  // namespace signorini
