// Indexes of packs that anybody may have written, and packs beside them.

#include "harness/pack/pack_index.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "harness/failure.hpp"
#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::pack_index_test {
namespace {

namespace fs = std::filesystem;

/// A folder with one file and an index that states the hash of `hashed`.
fs::path archive_of(const std::string& name, const std::string& bytes, const std::string& hashed) {
  const fs::path folder = test::fresh_folder(name);
  write_whole(folder / "one.tar.gz", bytes);
  write_whole(folder / "SHA256SUMS", fmt::format("{}  one.tar.gz\n", sha256(hashed)));
  return folder;
}

TEST(PackIndex, GivesThePackOfItsHash) {
  const std::string index = archive_of("pack-index", "bytes", "bytes") / "SHA256SUMS";
  const auto packs = read_pack_index(index);
  ASSERT_EQ(packs.size(), 1U);
  EXPECT_EQ(packs.front().file, "one.tar.gz");
  EXPECT_EQ(packs.front().sha256, "277089d91c0bdf4f2e6862ba7e4a07605119431f5d13f726dd352b06f1b206a9");
  EXPECT_EQ(pack_beside(index, packs.front()), "bytes");
}

TEST(PackIndex, RefusesBytesOfAnotherHash) {
  const std::string index = archive_of("pack-index-other", "bytes", "others") / "SHA256SUMS";
  EXPECT_THROW(pack_beside(index, read_pack_index(index).front()), UsageError);
}

TEST(PackIndex, RefusesWhatSha256sumDoesNotPrint) {
  const fs::path index = test::fresh_folder("pack-index-bad") / "SHA256SUMS";
  const std::string hash(64, 'a');
  for (const std::string& line :
       {std::string("a  one.tar.gz"), hash, hash + "  ", hash + "  ../one.tar.gz", hash + "  /etc/passwd",
        hash + "  .hidden", hash + "  a b", hash + "   one", std::string(64, 'g') + "  one",
        hash + "  " + std::string(100, 'n'), hash + "\tone", hash + "  one?two#three"}) {
    write_whole(index, line + "\n");
    EXPECT_THROW(read_pack_index(index), UsageError) << line;
  }
  write_whole(index, hash + " *one\r\n\n");
  EXPECT_EQ(read_pack_index(index).size(), 1U);
}

}  // namespace
}  // namespace signorini::pack_index_test
