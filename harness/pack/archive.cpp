#include "harness/pack/archive.hpp"

#include <fmt/format.h>
#define ZLIB_CONST  // next_in points to bytes that stay as they are
#include <zlib.h>

#include <charconv>
#include <set>

namespace signorini {

namespace {

constexpr std::size_t kBlock = 512;  // of a tar archive [bytes]
constexpr int kGzip = 15 + 16;       // the largest window, with header and sum of gzip

/// Where a field of a header stands [bytes].
struct Slot {
  std::size_t begin = 0, size = 0;
};

constexpr Slot kName{0, 100}, kMode{100, 8}, kOwner{108, 8}, kGroup{116, 8}, kSize{124, 12}, kTime{136, 12},
    kSum{148, 8}, kType{156, 1}, kMagic{257, 6}, kVersion{263, 2}, kPrefix{345, 155};
constexpr char kRegular = '0';
constexpr std::string_view kUstar{"ustar\0", 6};

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

/// Sum of a header's bytes, those of the sum itself taken as blanks.
unsigned sum_of(std::string_view header) {
  unsigned sum = 0;
  for (std::size_t i = 0; i < kBlock; ++i) {
    const bool own = i >= kSum.begin && i < kSum.begin + kSum.size;
    sum += static_cast<unsigned char>(own ? ' ' : header[i]);
  }
  return sum;
}

std::string header_of(const ArchivedFile& file) {
  std::string header(kBlock, '\0');
  const auto put = [&](Slot slot, std::string_view text) { header.replace(slot.begin, text.size(), text); };
  put(kName, file.name);
  put(kMode, "0000644");
  put(kOwner, "0000000");
  put(kGroup, "0000000");
  put(kSize, fmt::format("{:011o}", file.text.size()));
  put(kTime, "00000000000");
  put(kType, std::string(1, kRegular));
  put(kMagic, kUstar);
  put(kVersion, "00");
  const std::string sum = fmt::format("{:06o}", sum_of(header)) + '\0' + ' ';
  put(kSum, sum);
  return header;
}

/// Bytes up to the next whole block.
std::size_t padding(std::size_t size) { return (kBlock - size % kBlock) % kBlock; }

/// A stream that is unpacked, freed whatever happens.
class Unpacking {
 public:
  explicit Unpacking(std::string_view bytes) {
    stream_.next_in = bytes_of(bytes);
    stream_.avail_in = static_cast<uInt>(bytes.size());
    if (inflateInit2(&stream_, kGzip) != Z_OK) throw std::runtime_error("zlib refuses to unpack");
  }
  ~Unpacking() { inflateEnd(&stream_); }
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;

  /// The next bytes, in `piece`, as many as it holds at most; nothing at the end. \throws BadArchive
  std::string_view next(std::string& piece) {
    stream_.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream_.avail_out = static_cast<uInt>(piece.size());
    if (ended_) return {};
    const int status = inflate(&stream_, Z_NO_FLUSH);
    ended_ = status == Z_STREAM_END;
    const std::size_t count = piece.size() - stream_.avail_out;
    if (!ended_ && (status != Z_OK || count == 0)) throw BadArchive("must be a whole gzip stream");
    if (ended_ && stream_.avail_in > 0) throw BadArchive("must end where its gzip stream does");
    return {piece.data(), count};
  }

 private:
  z_stream stream_{};
  bool ended_ = false;
};

/// The text of a field, which ends at a zero byte or fills it.
std::string_view text_in(std::string_view header, Slot slot) {
  const std::string_view text = header.substr(slot.begin, slot.size);
  return text.substr(0, text.find('\0'));
}

/// The octal number in a field, digits that a blank or a zero byte ends. \throws BadArchive
std::size_t number_in(std::string_view header, Slot slot) {
  const std::string_view text = text_in(header, slot);
  const std::string_view digits = text.substr(0, text.find(' '));
  std::size_t number = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), number, 8);
  if (digits.empty() || failure != std::errc() || end != digits.data() + digits.size())
    throw BadArchive("must be a tar archive with sizes and sums in octal digits");
  return number;
}

/// \throws BadArchive unless the block is the header of a regular file whose name write_tar takes
void require_regular_file(std::string_view header) {
  if (header.substr(kMagic.begin, kMagic.size) != kUstar || number_in(header, kSum) != sum_of(header))
    throw BadArchive("must be a tar archive in the format ustar");
  const std::size_t name = text_in(header, kName).size();
  if (header[kType.begin] != kRegular || header[kPrefix.begin] != '\0' || name == 0 || name == kName.size)
    throw BadArchive("must hold nothing but regular files of short names");
}

}  // namespace

std::string write_tar(std::span<const ArchivedFile> files) {
  std::string text;
  for (const ArchivedFile& file : files) {
    text += header_of(file);
    text += file.text;
    text.append(padding(file.text.size()), '\0');
  }
  text.append(2 * kBlock, '\0');  // the end of an archive
  return text;
}

std::vector<ArchivedFile> read_tar(std::string_view archive) {
  std::string_view rest = archive;
  std::vector<ArchivedFile> files;
  std::set<std::string, std::less<>> names;
  while (true) {
    const std::string_view header = rest.substr(0, kBlock);
    if (header.size() < kBlock) throw BadArchive("must be a whole tar archive");
    if (header.find_first_not_of('\0') == std::string_view::npos) return files;
    require_regular_file(header);
    rest.remove_prefix(kBlock);
    const std::size_t size = number_in(header, kSize);
    if (size > rest.size() || padding(size) > rest.size() - size)
      throw BadArchive("must be a whole tar archive");
    files.push_back({.name = std::string(text_in(header, kName)), .text = std::string(rest.substr(0, size))});
    if (!names.insert(files.back().name).second) throw BadArchive("must hold each file once");
    rest.remove_prefix(size + padding(size));
  }
}

std::string gzipped(std::string_view bytes) {
  z_stream stream{};
  // With as much memory as zlib takes by itself.
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib refuses to compress");
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = bytes_of(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int end = deflate(&stream, Z_FINISH);
  packed.erase(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  if (end != Z_STREAM_END) throw std::runtime_error("zlib does not compress to the end");
  return packed;
}

std::string gunzipped(std::string_view bytes, std::size_t most) {
  Unpacking stream(bytes);
  std::string text, piece(std::size_t{1} << 16U, '\0');
  for (std::string_view next = stream.next(piece); !next.empty(); next = stream.next(piece)) {
    text += next;
    if (text.size() > most) throw BadArchive("must be at most {} MiB when unpacked", most >> 20U);
  }
  return text;
}

}  // namespace signorini
