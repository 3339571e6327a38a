#include "harness/files.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <csignal>
#include <string>

#include "harness/failure.hpp"
#include "tests/harness/fake_method.hpp"

namespace signorini::files_test {
namespace {

TEST(Files, HaveTheDigestsOfTheStandard) {
  // FIPS 180-2, appendix B.1 and B.2, and the digest of no bytes.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Files, ComeBackByteByByte) {
  const std::filesystem::path file = test::fresh_folder("files") / "bytes";
  const std::string bytes("a\r\n\0\xff\n", 6);
  write_whole(file, bytes);
  EXPECT_EQ(read_file(file), bytes);
  EXPECT_EQ(sha256_of_file(file), sha256(bytes));
}

TEST(Files, AreReplacedWholeAndLeaveNoDraft) {
  const std::filesystem::path folder = test::fresh_folder("files");
  write_whole(folder / "file", "a long first text");
  write_whole(folder / "file", "short");
  EXPECT_EQ(read_file(folder / "file"), "short");
  const std::filesystem::directory_iterator entries(folder);
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

TEST(Files, OfTheUserAreNotReachedByLinks) {
  const std::filesystem::path folder = test::fresh_folder("files");
  write_whole(folder / "own", "precious");
  for (const char* link : {"file", "file.new"}) std::filesystem::create_symlink("own", folder / link);
  write_whole(folder / "file", "text");
  EXPECT_EQ(read_file(folder / "own"), "precious");
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "file"));
  EXPECT_EQ(read_file(folder / "file"), "text");
  ASSERT_EQ(mkfifo((folder / "file.new").c_str(), 0600),
            0);  // opened to be written it would wait for a reader
  write_whole(folder / "file", "other");
  EXPECT_EQ(read_file(folder / "file"), "other");
}

TEST(Files, GoIntoTheFolderThatWasThereAtTheirBeginning) {
  namespace fs = std::filesystem;
  const fs::path folder = test::fresh_folder("files"), own = folder / "own", others = folder / "others";
  fs::create_directory(own);
  fs::create_directory(others);
  write_whole(own / "file", [&](const TextSink& sink) {
    fs::rename(own, folder / "moved");
    fs::create_directory_symlink(others, own);
    sink("text");
  });
  EXPECT_EQ(read_file(folder / "moved" / "file"), "text");
  EXPECT_TRUE(fs::is_empty(others));
}

TEST(Files, DoNotTakeThePlaceOfDevices) {
  const std::filesystem::path null = test::fresh_folder("files") / "null";
  constexpr unsigned kMemory = 1, kNull = 3;                                 // numbers of /dev/null
  if (mknod(null.c_str(), S_IFCHR | 0600U, makedev(kMemory, kNull)) == 0) {  // nobody but root may
    EXPECT_THROW(write_whole(null, "text"), UsageError);
    EXPECT_TRUE(std::filesystem::is_character_file(null));
  }
  EXPECT_THROW(write_whole("/dev/no-such-device", "text"), UsageError);
  EXPECT_FALSE(std::filesystem::exists("/dev/no-such-device"));
}

TEST(RequireOwnFile, TakesAFileWithOneNameOrNone) {
  const std::filesystem::path folder = test::fresh_folder("files");
  write_whole(folder / "own", "precious");
  EXPECT_NO_THROW(require_own_file(folder / "own"));
  EXPECT_NO_THROW(require_own_file(folder / "none"));
  std::filesystem::create_symlink("own", folder / "link");
  std::filesystem::create_hard_link(folder / "own", folder / "second-name");
  for (const char* name : {"link", "own", "second-name", "."})
    EXPECT_THROW(require_own_file(folder / name), UsageError);
}

TEST(FolderInside, IsMadeAndIsNoLink) {
  const std::filesystem::path folder = test::fresh_folder("files");
  EXPECT_TRUE(std::filesystem::is_directory(folder_inside(folder, "a")));
  EXPECT_EQ(folder_inside(folder, "a"), folder / "a");
  std::filesystem::create_directory_symlink("a", folder / "link");
  write_whole(folder / "file", "");
  for (const char* name : {"link", "file"}) EXPECT_THROW(folder_inside(folder, name), UsageError);
}

TEST(Files, ThatCannotBeReadOrWrittenAreRefused) {
  const std::filesystem::path folder = test::fresh_folder("files");
  EXPECT_THROW(read_file(folder / "absent"), UsageError);
  EXPECT_THROW(read_file(folder), UsageError) << "a folder is no file";
  EXPECT_THROW(write_whole(folder / "absent" / "file", "text"), UsageError);
}

std::string complaint_of_writing(const std::filesystem::path& file, const std::string& text) {
  try {
    write_whole(file, text);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(Files, ThatFindNoFolderOrNoRoomAreRefusedWithTheReason) {
  const std::filesystem::path folder = test::fresh_folder("files");
  EXPECT_NE(complaint_of_writing(folder / "absent" / "file", "text").find("No such file"), std::string::npos);
  write_whole(folder / "file", "before");
  rlimit unlimited{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &unlimited), 0);
  const rlimit limited{.rlim_cur = 1000, .rlim_max = unlimited.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limited), 0);
  const std::string complaint = complaint_of_writing(folder / "file", std::string(100000, 'x'));
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &unlimited), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(complaint.find("File too large"), std::string::npos) << complaint;
  EXPECT_EQ(read_file(folder / "file"), "before");
}

}  // namespace
}  // namespace signorini::files_test
