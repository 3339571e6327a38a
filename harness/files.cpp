#include "harness/files.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "harness/failure.hpp"
#include "problems/files/input_file.hpp"

namespace signorini {

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  try {
    return read_input_file(path, most);
  } catch (const UnreadableFile& error) {
    throw UsageError(
        fmt::format("file = {} (must be a readable file; it is {})", path.string(), error.found));
  }
}

std::string first_line(const std::filesystem::path& path) {
  try {
    const std::string text = read_input_file(path, kLargestFile);
    return text.substr(0, text.find('\n'));
  } catch (const UnreadableFile&) {
    return {};
  }
}

void write_whole(const std::filesystem::path& file, std::string_view text) {
  write_whole(file, [&](const TextSink& sink) { sink(text); });
}

void write_whole(const std::filesystem::path& file, const std::function<void(const TextSink&)>& write) {
  const std::filesystem::path draft = file.string() + ".new";
  errno = 0;
  std::ofstream stream(draft, std::ios::binary);
  int reason = stream ? 0 : errno;
  write([&](std::string_view piece) {
    if (!stream) return;
    errno = 0;
    stream << piece;
    if (!stream) reason = errno;  // streams keep that of the system
  });
  if (stream) {
    errno = 0;
    stream.close();
    if (!stream) reason = errno;
  }
  std::error_code failure;
  if (stream) std::filesystem::rename(draft, file, failure);
  if (!stream) failure = std::error_code(reason, std::generic_category());
  if (!stream || failure) {
    throw UsageError(fmt::format("out = {} (must be in a folder that can be written: {})", file.string(),
                                 failure.message()));
  }
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("OpenSSL refuses to compute SHA-256");
  }
  std::string text;
  for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

std::string sha256_of_file(const std::filesystem::path& path) { return sha256(read_file(path)); }

}  // namespace signorini
