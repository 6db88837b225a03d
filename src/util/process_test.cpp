// The effects of the environment on a process. Each test forks, as the environment is read once.
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

#include "util/flags.h"

namespace arbiter {
namespace {

/// Runs the body in a forked child with the variables set. Returns what it wrote to stderr.
template <typename Body>
std::string inChild(std::initializer_list<std::pair<const char *, const char *>> environment,
                    Body body) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    for (const auto &[name, value] : environment)
      ::setenv(name, value, 1);
    body();
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string output;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(ends[0], buffer, sizeof buffer)) > 0;)
    output.append(buffer, std::size_t(count));
  ::close(ends[0]);
  return output;
}

TEST(Process, SaysNothingUnasked) {
  EXPECT_EQ(inChild({},
                    [] {
                      (void)settings();
                      logInfo("test", "quiet");
                      logFlag(DebugFlag::Contexts, "test", "quiet");
                    }),
            "");
}

TEST(Process, WarnsOnceOfABadValue) {
  const std::string output = inChild({{"ARBITER_LIMITS", "strict"}}, [] {
    logInfo("test", "first call reads the environment");
    (void)settings();
    (void)settings();
  });
  EXPECT_NE(output.find("warn: settings: ARBITER_LIMITS: expected enforce or report, not "
                        "\"strict\"; ignored\n"),
            std::string::npos)
      << output;
  EXPECT_EQ(output.find("warn"), output.rfind("warn")) << output;
}

TEST(Process, HelpIsPrintedAndTheProgramGoesOn) {
  const std::string output = inChild({{"ARBITER_DEBUG", "help"}}, [] {
    (void)settings();
    logError("test", "still here");
  });
  EXPECT_EQ(output.rfind("ARBITER_DEBUG=FLAG", 0), 0u) << output;
  EXPECT_NE(output.find("still here"), std::string::npos);
}

TEST(Process, AFlagIsLoggedAtTheDefaultLevel) {
  const std::string output = inChild({{"ARBITER_DEBUG", "contexts"}}, [] {
    logFlag(DebugFlag::Contexts, "test", "made %d", 7);
    logFlag(DebugFlag::Errors, "test", "not asked for");
  });
  EXPECT_NE(output.find("debug: test: made 7\n"), std::string::npos) << output;
  EXPECT_EQ(output.find("not asked for"), std::string::npos);
}

TEST(Process, ALogFileThatCannotBeOpenedFallsBack) {
  const std::string output = inChild({{"ARBITER_LOG", "info:/dev/full"}}, [] {
    (void)settings();
    logInfo("test", "heard");
  });
  EXPECT_NE(output.find("ARBITER_LOG: cannot open the file"), std::string::npos) << output;
  EXPECT_NE(output.find("heard"), std::string::npos);
}

} // namespace
} // namespace arbiter
