#include "util/file.h"

#include <cerrno>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace arbiter {
namespace {

/// Provides a temporary folder and removes it after the test.
class Files : public ::testing::Test {
protected:
  void SetUp() override { ASSERT_NE(mkdtemp(m_folder), nullptr); }
  void TearDown() override { ASSERT_EQ(std::system(("rm -rf " + folder()).c_str()), 0); }
  [[nodiscard]] std::string folder() const { return m_folder; }
  [[nodiscard]] std::string path(const char *name) const { return folder() + "/" + name; }
  static std::string read(const std::string &path) {
    std::string bytes;
    return readFile(path.c_str(), 1000, bytes) ? bytes : "<none>";
  }

private:
  char m_folder[32] = "/tmp/arbiter-file-XXXXXX";
};

TEST_F(Files, ReplacingIsPrivateAndLeavesNothingBeside) {
  ASSERT_TRUE(replacePrivateFile(path("a"), "one"));
  ASSERT_TRUE(replacePrivateFile(path("a"), std::string_view("t\0o", 3)));
  EXPECT_EQ(read(path("a")), std::string("t\0o", 3));
  struct stat status = {};
  ASSERT_EQ(stat(path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, mode_t(0600));
  EXPECT_NE(rmdir(folder().c_str()), 0);
  unlink(path("a").c_str());
  EXPECT_EQ(rmdir(folder().c_str()), 0) << "a temporary file was left";
  ASSERT_EQ(mkdir(folder().c_str(), 0700), 0);
}

TEST_F(Files, ALinkIsNotReplaced) {
  ASSERT_TRUE(replacePrivateFile(path("victim"), "precious"));
  ASSERT_EQ(symlink(path("victim").c_str(), path("link").c_str()), 0);
  EXPECT_FALSE(replacePrivateFile(path("link"), "gone"));
  EXPECT_EQ(read(path("victim")), "precious");
}

TEST_F(Files, CreatingKeepsWhatIsThere) {
  EXPECT_TRUE(createPrivateFile(path("a"), "one"));
  EXPECT_TRUE(createPrivateFile(path("a"), "two"));
  EXPECT_EQ(read(path("a")), "one");
  EXPECT_FALSE(createPrivateFile(path("no/such/folder"), "one"));
  EXPECT_EQ(errno, ENOENT);
}

TEST_F(Files, ReadingHasALimitAndTakesRegularFilesOnly) {
  std::string bytes;
  ASSERT_TRUE(replacePrivateFile(path("a"), std::string(1000, 'x')));
  EXPECT_TRUE(readFile(path("a").c_str(), 1000, bytes));
  EXPECT_FALSE(readFile(path("a").c_str(), 999, bytes));
  EXPECT_EQ(errno, EFBIG);
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_FALSE(readFile(path("pipe").c_str(), 1000, bytes)) << "waiting for a writer would hang";
  EXPECT_FALSE(stateOf(path("pipe").c_str()).exists);
}

TEST_F(Files, AStateTellsAnEditFromNone) {
  EXPECT_FALSE(stateOf(path("a").c_str()).exists);
  ASSERT_TRUE(replacePrivateFile(path("a"), "one"));
  const FileState first = stateOf(path("a").c_str());
  EXPECT_TRUE(first.exists);
  EXPECT_EQ(first, stateOf(path("a").c_str()));
  ASSERT_TRUE(replacePrivateFile(path("b"), "two")); // a new inode, as an editor's rename gives
  ASSERT_EQ(rename(path("b").c_str(), path("a").c_str()), 0);
  EXPECT_NE(first, stateOf(path("a").c_str()));
}

} // namespace
} // namespace arbiter
