#pragma once
// Bytes as a page holds them.

#include <string>
#include <string_view>

namespace signorini {

/// Base64 (RFC 4648) in one line.
std::string base64(std::string_view bytes);

/// A text compressed in the format of zlib (RFC 1950), as Base64: what `DecompressionStream("deflate")` of a
/// browser unpacks. No byte of the text stands in it, so that it needs no escaping.
std::string packed(std::string_view text);

/// A script as a content security policy names it: 'sha256-...' with the quotes.
std::string script_source(std::string_view script);

}  // namespace signorini
