#include "util/log.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "util/file.h"

namespace arbiter {
namespace {

class LogTest : public testing::Test {
protected:
  void SetUp() override {
    char pattern[] = "/tmp/arbiter-log-XXXXXX";
    ASSERT_NE(::mkdtemp(pattern), nullptr);
    m_folder = pattern;
    m_path = m_folder + "/log";
  }
  void TearDown() override {
    configureLog(LogLevel::Warn, "");
    std::filesystem::remove_all(m_folder);
  }
  std::string content() const {
    std::ifstream file(m_path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }
  std::string m_folder;
  std::string m_path;
};

TEST_F(LogTest, WritesWhatTheLevelAllowsAndKeepsErrno) {
  ASSERT_TRUE(configureLog(LogLevel::Info, m_path.c_str()));
  errno = EDOM;
  logInfo("state", "%d programs", 3);
  EXPECT_EQ(errno, EDOM);
  logDebug("state", "not wanted");
  EXPECT_EQ(content(), "arbiter[" + std::to_string(::getpid()) + "] info: state: 3 programs\n");
}

TEST_F(LogTest, AFileThatGotTheDescriptorsNumberIsLeftAlone) {
  ASSERT_TRUE(configureLog(LogLevel::Info, m_path.c_str()));
  logInfo("state", "before");
  const std::string before = content();
  for (int i = 3; i < 64; ++i) // as daemons do
    ::close(i);
  const std::string own = m_folder + "/own";
  int descriptors[8];
  for (int &descriptor : descriptors)
    descriptor = ::open(own.c_str(), O_RDWR | O_CREAT, 0600);
  logInfo("state", "after");
  struct stat status = {};
  ASSERT_EQ(::stat(own.c_str(), &status), 0);
  EXPECT_EQ(status.st_size, 0);
  EXPECT_EQ(content(), before);
  for (const int descriptor : descriptors)
    ::close(descriptor);
}

TEST_F(LogTest, TheFileIsPrivateAndDoesNotLeakIntoChildren) {
  ASSERT_TRUE(configureLog(LogLevel::Info, m_path.c_str()));
  struct stat status = {};
  ASSERT_EQ(::stat(m_path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  const int descriptor = openPrivate(m_path.c_str(), OpenMode::Append);
  ASSERT_GE(descriptor, 0);
  EXPECT_TRUE(::fcntl(descriptor, F_GETFD) & FD_CLOEXEC);
  ::close(descriptor);
}

TEST_F(LogTest, ControlBytesCannotReachATerminal) {
  ASSERT_TRUE(configureLog(LogLevel::Debug, m_path.c_str()));
  logText(LogLevel::Debug, "state", "text", "a\x1b[2Jb\tc\r\n\x7f");
  EXPECT_NE(content().find("text\na?[2Jb\tc?\n?\n"), std::string::npos) << content();
}

TEST_F(LogTest, AListingIsWrittenAtAnyLevelButOff) {
  ASSERT_TRUE(configureLog(LogLevel::Warn, m_path.c_str()));
  logText(LogLevel::Debug, "state", "title", "body\n");
  EXPECT_NE(content().find("debug: state: title\nbody\n"), std::string::npos) << content();
  ASSERT_TRUE(configureLog(LogLevel::Off, m_path.c_str()));
  logText(LogLevel::Debug, "state", "second", "body");
  EXPECT_EQ(content().find("second"), std::string::npos);
}

TEST_F(LogTest, LongLinesAreCutNotOverrun) {
  ASSERT_TRUE(configureLog(LogLevel::Debug, m_path.c_str()));
  logDebug("state", "%s", std::string(10000, 'x').c_str());
  const std::string text = content();
  EXPECT_LT(text.size(), 3000u);
  EXPECT_NE(text.find("xx...\n"), std::string::npos);
}

TEST_F(LogTest, RefusesLinksPipesAndFolders) {
  ASSERT_EQ(::symlink("/tmp/elsewhere", m_path.c_str()), 0);
  EXPECT_FALSE(configureLog(LogLevel::Info, m_path.c_str()));
  EXPECT_FALSE(std::filesystem::exists("/tmp/elsewhere"));
  const std::string pipe = m_folder + "/pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(configureLog(LogLevel::Info, pipe.c_str()));
  EXPECT_FALSE(configureLog(LogLevel::Info, m_folder.c_str()));
}

TEST_F(LogTest, StopsAtTheCap) {
  ASSERT_TRUE(configureLog(LogLevel::Info, m_path.c_str()));
  ASSERT_EQ(::truncate(m_path.c_str(), off_t(kMaxLogBytes)), 0);
  logInfo("state", "one too many");
  EXPECT_EQ(std::filesystem::file_size(m_path), kMaxLogBytes);
}

TEST_F(LogTest, LinesOfManyThreadsStayWhole) {
  ASSERT_TRUE(configureLog(LogLevel::Info, m_path.c_str()));
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([] {
      for (int i = 0; i < 200; ++i)
        logInfo("state", "%s", "0123456789");
    });
  for (std::thread &thread : threads)
    thread.join();
  std::istringstream lines(content());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_TRUE(line.ends_with("info: state: 0123456789")) << line;
  EXPECT_EQ(count, 1600);
}

TEST_F(LogTest, WritePrivateFileReplacesAndRefusesLinks) {
  EXPECT_TRUE(writePrivateFile(m_path.c_str(), "a longer text"));
  EXPECT_TRUE(writePrivateFile(m_path.c_str(), "short"));
  EXPECT_EQ(content(), "short");
  const std::string link = m_folder + "/link";
  ASSERT_EQ(::symlink(m_path.c_str(), link.c_str()), 0);
  EXPECT_FALSE(writePrivateFile(link.c_str(), "x"));
  EXPECT_EQ(errno, ELOOP);
  EXPECT_FALSE(writePrivateFile("/dev/full", "x"));
  EXPECT_EQ(content(), "short");
}

TEST(ExpandPid, ReplacesEachMark) {
  const std::string pid = std::to_string(::getpid());
  EXPECT_EQ(expandPid("a-%p-%p.json"), "a-" + pid + "-" + pid + ".json");
  EXPECT_EQ(expandPid("100%%p%"), "100%p%");
}

} // namespace
} // namespace arbiter
