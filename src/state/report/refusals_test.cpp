/// Tests reports of programs that only the profile refuses. It is r300, the default.
#include "state/report/refusals.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "state/testing/current_context.h"
#include "util/log.h"

namespace arbiter::state {
namespace {

using testing::CurrentContext;
using testing::FakeHost;

/// A host that loads long programs.
class RoomyHost : public FakeHost {
public:
  RoomyHost() { programLimit = 4096; }
};

/// Returns a program with that many ALU instructions; `mark` makes it a different text.
std::string longText(int instructions, int mark = 0) {
  std::string text = "!!ARBfp1.0\n# " + std::to_string(mark) + "\nTEMP r;\n";
  for (int i = 1; i < instructions; ++i)
    text += "MAD r, fragment.color, fragment.color, fragment.color;\n";
  return text + "MOV result.color, r;\nEND";
}

/// Collects the lines of the log.
class Log {
public:
  Log()
      : m_path(std::filesystem::temp_directory_path() /
               ("refusals_" + std::to_string(getpid()) + ".log")) {
    configureLog(LogLevel::Warn, m_path.c_str());
  }
  ~Log() {
    configureLog(LogLevel::Warn, "");
    std::filesystem::remove(m_path);
  }
  Log(const Log &) = delete;
  Log &operator=(const Log &) = delete;

  [[nodiscard]] std::vector<std::string> lines() const {
    std::ifstream stream(m_path);
    std::vector<std::string> found;
    for (std::string line; std::getline(stream, line);)
      found.push_back(line);
    return found;
  }

private:
  std::filesystem::path m_path;
};

TEST(Refusals, AreNamedOnceATextWithTheLimitAndTheWayOut) {
  RoomyHost host;
  const CurrentContext context(host);
  const Log log;
  const std::uint64_t before = refusedTexts();
  for (int times = 0; times < 3; ++times) {
    testing::load(*context, longText(65));
    EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
  }
  ASSERT_EQ(log.lines().size(), 1u);
  const std::string line = log.lines()[0];
  for (const char *part : {"the profile r300", "line 68: more than 64 ALU instructions",
                           "--limits report", "--profile host"})
    EXPECT_NE(line.find(part), std::string::npos) << part << " is not in: " << line;
  EXPECT_EQ(refusedTexts() - before, 1u);
}

TEST(Refusals, WhatTheHostWouldRefuseTooIsTheApplicationsAffair) {
  RoomyHost host;
  host.programLimits[GL_MAX_PROGRAM_ALU_INSTRUCTIONS_ARB] = 100;
  const CurrentContext context(host);
  const Log log;
  const std::uint64_t before = refusedTexts();
  testing::load(*context, longText(64)); // loads
  testing::load(*context, longText(101));
  testing::load(*context, "!!ARBfp1.0\nMOV result.color, nothing;\nEND");
  EXPECT_TRUE(log.lines().empty());
  EXPECT_EQ(refusedTexts(), before);
}

// ARBITER_LIMITS=report does not load a number that is too high; only a profile that allows it
// does.
TEST(Refusals, NameNoWayOutThatIsNone) {
  RoomyHost host;
  const CurrentContext context(host);
  const Log log;
  testing::load(*context, "!!ARBfp1.0\nMOV result.color, program.local[100];\nEND");
  ASSERT_EQ(log.lines().size(), 1u);
  EXPECT_EQ(log.lines()[0].find("--limits"), std::string::npos) << log.lines()[0];
  EXPECT_NE(log.lines()[0].find("--profile host"), std::string::npos) << log.lines()[0];
}

TEST(Refusals, TheLogHasAFewAndTheRestIsCounted) {
  RoomyHost host;
  const CurrentContext context(host);
  const Log log;
  const std::uint64_t before = refusedTexts();
  for (int mark = 1; mark <= 100; ++mark)
    testing::load(*context, longText(70, mark));
  EXPECT_EQ(refusedTexts() - before, 100u);
  EXPECT_LE(log.lines().size(), 9u);
  EXPECT_NE(log.lines().back().find("more programs are refused"), std::string::npos);
}

} // namespace
} // namespace arbiter::state
