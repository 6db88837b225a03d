// Checks what a start of a program finds of the last one. Each start is a child process.
#include "state/raster_draw/functions/start_note.h"

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "state/raster_draw/frames/frame_history.h"
#include "state/raster_draw/functions/compile_thread.h"

namespace arbiter::state {
namespace {

class StartNote : public ::testing::Test {
protected:
  void SetUp() override {
    std::string name = std::filesystem::temp_directory_path() / "arbiter-start-XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    m_folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(m_folder); }

  /// Runs a start in a child, and waits for what it writes. \return true if it succeeded
  bool start(const std::function<bool()> &run, const char *cache = "1") {
    const pid_t child = fork();
    if (child == 0) {
      setenv("XDG_CACHE_HOME", m_folder.c_str(), 1);
      setenv("ARBITER_CACHE", cache, 1);
      const bool held = run();
      awaitCompiler(std::nullopt);
      _exit(held ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  static void frames(int count, bool whole) {
    for (int i = 0; i < count; ++i)
      noteFrame(whole);
  }

  std::filesystem::path m_folder;
};

TEST_F(StartNote, WholeFramesAreBegunByTheRasterizer) {
  EXPECT_TRUE(start([] {
    const FrameHistory history = historyOfProcess();
    frames(1, true);
    return lastStart() == LastStart::Unknown && !history.wholeFrames && !history.waitsForCode;
  }));
  EXPECT_TRUE(start([] {
    const FrameHistory history = historyOfProcess();
    return lastStart() == LastStart::WholeFrames && history.wholeFrames && history.waitsForCode;
  }));
}

TEST_F(StartNote, AFrameThatIsMixedIsRememberedUntilManyAreNot) {
  EXPECT_TRUE(start([] {
    frames(10, true);
    frames(1, false);
    frames(63, true);
    return true;
  }));
  EXPECT_TRUE(start([] {
    const FrameHistory history = historyOfProcess();
    frames(1, false);
    frames(64, true);
    return lastStart() == LastStart::Engine && !history.wholeFrames && !history.waitsForCode;
  }));
  EXPECT_TRUE(start([] { return lastStart() == LastStart::WholeFrames; }));
}

TEST_F(StartNote, TheEngineAloneSaysNothingOfFrames) {
  EXPECT_TRUE(start([] {
    noteEngine();
    return true;
  }));
  EXPECT_TRUE(start([] {
    noteEngine(); // must not change what is known
    frames(1, true);
    return lastStart() == LastStart::Engine;
  }));
  EXPECT_TRUE(start([] {
    noteEngine();
    return lastStart() == LastStart::WholeFrames;
  }));
  EXPECT_TRUE(start([] { return lastStart() == LastStart::WholeFrames; }));
}

TEST_F(StartNote, WithoutACacheNothingIsLeftAndNothingFound) {
  EXPECT_TRUE(start(
      [] {
        frames(1, true);
        return lastStart() == LastStart::Unknown;
      },
      "0"));
  EXPECT_TRUE(std::filesystem::is_empty(m_folder));
  EXPECT_TRUE(start([] {
    frames(1, true);
    return true;
  }));
  EXPECT_TRUE(start([] { return lastStart() == LastStart::Unknown; }, "0"));
}

/// A process whose frames alternate must not write in each of them.
TEST_F(StartNote, FewNotesAreWritten) {
  EXPECT_TRUE(start([] {
    for (int i = 0; i < 100; ++i) {
      frames(64, true);
      frames(1, false);
    }
    return true;
  }));
  EXPECT_TRUE(start([] { return lastStart() != LastStart::Unknown; }));
}

} // namespace
} // namespace arbiter::state
