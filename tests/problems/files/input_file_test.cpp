#include "problems/files/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/problems/temporary_folder.hpp"

namespace signorini::test::input_file_test {
namespace {

namespace fs = std::filesystem;

std::string complaint(const fs::path& path, std::size_t most = 100) {
  try {
    read_input_file(path, most);
    return "none";
  } catch (const UnreadableFile& error) {
    return error.what();
  }
}

TEST(InputFile, IsReadWholeUpToItsLimit) {
  const TemporaryFolder folder;
  const std::string text = std::string("a\0b\n", 4) + std::string(96, 'x');
  EXPECT_EQ(read_input_file(folder.write("full", text), 100), text);
  EXPECT_EQ(read_input_file(folder.write("empty", ""), 100), "");
  const std::string large(3U << 20U, 'y');
  EXPECT_EQ(read_input_file(folder.write("large", large), large.size()), large);
  EXPECT_EQ(complaint(folder.write("longer", text + "z")),
            "more than 100 bytes (must be a file of at most 100 bytes)");
  EXPECT_EQ(complaint(folder.path() / "large", 1U << 20U),
            "more than 1 MiB (must be a file of at most 1 MiB)");
}

TEST(InputFile, MustBeARegularFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint(folder.path() / "absent"), "missing (must exist)");
  EXPECT_EQ(complaint(folder.path()), "a folder (must be a file)");
  for (const char* device : {"/dev/zero", "/dev/full", "/dev/null", "/dev/urandom"})
    EXPECT_EQ(complaint(device), "no regular file (must be one)") << device;
  // Opening a pipe that nobody writes to would wait for ever.
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(complaint(pipe), "no regular file (must be one)");
  fs::create_symlink("/dev/zero", folder.path() / "link");
  EXPECT_EQ(complaint(folder.path() / "link"), "no regular file (must be one)");
}

TEST(InputFile, ThatHidesItsSizeIsReadNoFurtherThanItsLimit) {
  // /proc says 0 bytes of all its files.
  EXPECT_EQ(complaint("/proc/cpuinfo", 10), "more than 10 bytes (must be a file of at most 10 bytes)");
  EXPECT_GT(read_input_file("/proc/cpuinfo", 1U << 24U).size(), 10U);
  EXPECT_EQ(complaint("/proc/self/mem"), "unreadable (must be a file that may be read)");
}

TEST(InputFile, OfTenGigabytesThatAreNotThereIsRefusedAtOnce) {
  const TemporaryFolder folder;
  const fs::path sparse = folder.write("sparse", "x");
  fs::resize_file(sparse, std::uintmax_t{10} << 30U);
  EXPECT_EQ(complaint(sparse), "more than 100 bytes (must be a file of at most 100 bytes)");
}

}  // namespace
}  // namespace signorini::test::input_file_test
