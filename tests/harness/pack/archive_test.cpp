#include "harness/pack/archive.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "harness/files.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::archive_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMost = std::size_t{1} << 20U;

/// Short, empty, of one whole block, of bytes that are no text.
std::vector<ArchivedFile> files() {
  return {{"manifest.json", "{}\n"},
          {"empty", ""},
          {"plugins/block.toml", std::string(512, 'x')},
          {"bytes", std::string("\0\xff\n\0", 4) + std::string(100'000, 'y')}};
}

bool succeeds(const fs::path& folder, const std::string& command) {
  return std::system(fmt::format("cd '{}' && {} 2>/dev/null", folder.string(), command).c_str()) == 0;
}

void expect_files(const std::vector<ArchivedFile>& found) {
  ASSERT_EQ(found.size(), files().size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].name, files()[i].name);
    EXPECT_EQ(found[i].text, files()[i].text);
  }
}

std::string packed(const std::vector<ArchivedFile>& files) { return gzipped(write_tar(files)); }

std::vector<ArchivedFile> unpacked(std::string_view bytes, std::size_t most = kMost) {
  return read_tar(gunzipped(bytes, most));
}

std::string refusal(std::string_view bytes, std::size_t most = kMost) {
  try {
    static_cast<void>(unpacked(bytes, most));
    return {};
  } catch (const BadArchive& error) {
    return error.what();
  }
}

/// What `tar` makes of these words in a folder with the file `a`, a link `link` to it and a folder `sub`.
std::string made_by_tar(const std::string& words, const char* format = "ustar") {
  const fs::path folder = test::fresh_folder("archive-tar");
  write_whole(folder / "a", "text\n");
  fs::create_symlink("a", folder / "link");
  fs::create_directory(folder / "sub");
  EXPECT_TRUE(succeeds(folder, fmt::format("tar --format={} -czf made.tar.gz {}", format, words))) << words;
  return read_file(folder / "made.tar.gz");
}

TEST(Archive, IsWhatTarUnpacks) {
  const fs::path folder = test::fresh_folder("archive");
  write_whole(folder / "made.tar.gz", packed(files()));
  ASSERT_TRUE(succeeds(folder, "tar -xzf made.tar.gz"));
  for (const ArchivedFile& file : files()) EXPECT_EQ(read_file(folder / file.name), file.text) << file.name;
}

TEST(Archive, IsReadAsTarPacksIt) {
  const std::vector<ArchivedFile> found = unpacked(made_by_tar("a"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().name, "a");
  EXPECT_EQ(found.front().text, "text\n");
}

TEST(Archive, IsReadAsItWasWrittenAndTheSameAgain) {
  const std::string bytes = packed(files());
  expect_files(unpacked(bytes));
  EXPECT_EQ(packed(files()), bytes);
  EXPECT_TRUE(unpacked(packed({})).empty());
}

TEST(Archive, IsRefusedWhereItHoldsMoreThanRegularFiles) {
  const std::string regular = "must hold nothing but regular files of short names";
  EXPECT_EQ(refusal(made_by_tar("a link")), regular);
  EXPECT_EQ(refusal(made_by_tar("a sub")), regular);
  EXPECT_EQ(refusal(made_by_tar("--transform 's,a,/long/path/" + std::string(120, 'n') + "/a,' a")), regular);
  EXPECT_EQ(refusal(made_by_tar("a a --hard-dereference")), "must hold each file once");
  EXPECT_EQ(refusal(made_by_tar("a", "gnu")), "must be a tar archive in the format ustar");
}

TEST(Archive, IsRefusedWhereItIsLargerThanAllowed) {
  const std::string zeros = packed({{"zeros", std::string(2 * kMost, '\0')}});
  EXPECT_LT(zeros.size(), kMost / 100);
  EXPECT_EQ(refusal(zeros), "must be at most 1 MiB when unpacked");
  EXPECT_EQ(refusal(zeros, 4 * kMost), "");
}

// Headers have a sum, which finds each of their bytes; the texts have none here.
TEST(Tar, IsRefusedWithEachByteOfAHeaderChanged) {
  const std::vector<ArchivedFile> file{{"name", "text"}};
  const std::string archive = write_tar(file);
  constexpr std::size_t kBehindSum = 155;  // a blank that says nothing
  for (std::size_t i = 0; i < 512; ++i) {
    if (i == kBehindSum) continue;
    std::string changed = archive;
    changed[i] = static_cast<char>(changed[i] ^ 0x01);
    EXPECT_NE(refusal(gzipped(changed)), "") << i;
  }
}

// The stream has a sum of its own: a changed byte is found, or is one that says nothing, as that of the
// system which made it.
TEST(Archive, IsRefusedOrTheSameWithEachByteChanged) {
  const std::string bytes = packed(files());
  int same = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    if (!refusal(changed).empty()) continue;
    expect_files(unpacked(changed, kMost));
    ++same;
  }
  EXPECT_LE(same, 10) << "more than gzip's header";
}

TEST(Archive, IsRefusedWhereItEndsEarlyOrGoesOn) {
  const std::string bytes = packed(files());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(refusal(std::string_view(bytes).substr(0, size)), "") << size;
  EXPECT_EQ(refusal(bytes + "x"), "must end where its gzip stream does");
  EXPECT_EQ(refusal("no archive"), "must be a whole gzip stream");
}

}  // namespace
}  // namespace signorini::archive_test
