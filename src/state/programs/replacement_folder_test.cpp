#include "state/programs/replacement_folder.h"

#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace arbiter::state {
namespace {

class Replacing : public ::testing::Test {
protected:
  void SetUp() override { ASSERT_NE(mkdtemp(m_path), nullptr); }
  void TearDown() override { ASSERT_EQ(std::system(("rm -rf " + std::string(m_path)).c_str()), 0); }
  void put(const char *name, const char *text) {
    ASSERT_TRUE(replacePrivateFile(std::string(m_path) + "/" + name, text));
  }
  void drop(const char *name) { unlink((std::string(m_path) + "/" + name).c_str()); }
  /// Polls as frames would, until a change is seen or a generous time has passed.
  static bool sees(ReplacementFolder &folder, const char *name, std::uint64_t since,
                   int milliseconds = 500) {
    for (int i = 0; i < milliseconds / 10; ++i) {
      folder.poll();
      if (folder.changedSince(name, since))
        return true;
      usleep(10000);
    }
    return false;
  }
  char m_path[40] = "/tmp/arbiter-replacement-XXXXXX";
};

TEST_F(Replacing, AFileThatAppearsChangesAndGoesIsSeen) {
  ReplacementFolder folder(m_path);
  std::string text;
  EXPECT_FALSE(folder.read("a.fp", text)); // the file is watched from now on
  std::uint64_t seen = folder.generation();
  EXPECT_FALSE(sees(folder, "a.fp", seen, 50));

  put("a.fp", "one");
  EXPECT_TRUE(sees(folder, "a.fp", seen));
  EXPECT_GT(folder.generation(), seen);
  ASSERT_TRUE(folder.read("a.fp", text));
  EXPECT_EQ(text, "one");

  seen = folder.generation();
  EXPECT_FALSE(sees(folder, "a.fp", seen, 50)) << "the same change again";
  put("a.fp", "two");
  EXPECT_TRUE(sees(folder, "a.fp", seen));

  seen = folder.generation();
  drop("a.fp");
  EXPECT_TRUE(sees(folder, "a.fp", seen));
  EXPECT_FALSE(folder.read("a.fp", text));
}

TEST_F(Replacing, AnEmptyFileIsAnEditorThatHasNotYetWritten) {
  put("a.fp", "one");
  ReplacementFolder folder(m_path);
  std::string text;
  ASSERT_TRUE(folder.read("a.fp", text));
  const std::uint64_t seen = folder.generation();
  put("a.fp", "");
  EXPECT_FALSE(sees(folder, "a.fp", seen, 100));
  put("a.fp", "two");
  EXPECT_TRUE(sees(folder, "a.fp", seen));
}

TEST_F(Replacing, OnlyTheChangedFileIsChanged) {
  put("a.fp", "one");
  put("b.fp", "one");
  ReplacementFolder folder(m_path);
  std::string text;
  ASSERT_TRUE(folder.read("a.fp", text));
  ASSERT_TRUE(folder.read("b.fp", text));
  const std::uint64_t seen = folder.generation();
  put("b.fp", "two");
  EXPECT_TRUE(sees(folder, "b.fp", seen));
  EXPECT_FALSE(folder.changedSince("a.fp", seen));
}

TEST_F(Replacing, WithoutInotifyTheFilesAreLookedAt) {
  // does not exist, so inotify cannot watch it
  const std::string later = std::string(m_path) + "/later";
  ReplacementFolder folder(later);
  std::string text;
  EXPECT_FALSE(folder.read("a.fp", text));
  const std::uint64_t seen = folder.generation();
  ASSERT_EQ(std::system(("mkdir " + later).c_str()), 0);
  put("later/a.fp", "one");
  EXPECT_TRUE(sees(folder, "a.fp", seen, 3000));
  ASSERT_TRUE(folder.read("a.fp", text));
  EXPECT_EQ(text, "one");
}

} // namespace
} // namespace arbiter::state
