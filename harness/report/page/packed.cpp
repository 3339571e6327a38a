#include <fmt/format.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <stdexcept>

#include "harness/files.hpp"
#include "harness/report/page/page_shell.hpp"

namespace signorini {

std::string base64(std::string_view bytes) {
  constexpr std::size_t kIn = 3, kOut = 4;
  std::string text(kOut * ((bytes.size() + kIn - 1) / kIn) + 1, '\0');  // and a closing zero
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string packed(std::string_view text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::string bytes(size, '\0');
  const int status =
      compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                static_cast<uLong>(text.size()), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw std::runtime_error(fmt::format("zlib: {}", zError(status)));
  bytes.resize(size);
  return base64(bytes);
}

std::string script_source(std::string_view script) {
  const std::string digits = sha256(script);
  std::string digest;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    digest += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return fmt::format("'sha256-{}'", base64(digest));
}

}  // namespace signorini
