/// Checks that cached programs are read from disk, and that draws cannot tell.
#include "state/programs/program_cache.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using testing::CurrentContext;
using testing::FakeHost;
using testing::kFragment;

namespace fs = std::filesystem;

class ProgramCache : public ::testing::Test {
protected:
  /// Sets a cache folder for this process, before the settings are read.
  static void SetUpTestSuite() {
    char pattern[] = "/tmp/arbiter-programs-XXXXXX";
    s_folder = ::mkdtemp(pattern);
    ::setenv("XDG_CACHE_HOME", s_folder.c_str(), 1);
    ::unsetenv("ARBITER_CACHE");
  }
  static void TearDownTestSuite() { fs::remove_all(s_folder); }
  static std::vector<fs::path> files() {
    std::vector<fs::path> found;
    for (const auto &entry : fs::recursive_directory_iterator(s_folder))
      if (entry.is_regular_file() && entry.path().filename() != "key") // the folder's secret
        found.push_back(entry.path());
    return found;
  }
  static std::string s_folder;
};
std::string ProgramCache::s_folder;

constexpr const char *kCachedText = "!!ARBfp1.0\nPARAM p = program.env[1];\n"
                                    "MAD result.color, fragment.color, p, p;\nEND\n";

fp::CompilationInput input() {
  fp::CompilationInput input;
  input.options.limits.api = {96, 64, 32, 4, 32, 32, 10, 0};
  input.options.limits.native = input.options.limits.api;
  input.options.limits.envParameters = input.options.limits.localParameters = 32;
  return input;
}

TEST_F(ProgramCache, TheSecondTimeAProgramIsRead) {
  const ProgramCacheCounters before = programCacheCounters();
  const fp::Compilation first = compileCached(input(), kCachedText);
  const fp::Compilation second = compileCached(input(), kCachedText);
  ASSERT_TRUE(first.check.ok()) << first.check.errorString(kCachedText);
  EXPECT_EQ(programCacheCounters().misses, before.misses + 1);
  EXPECT_EQ(programCacheCounters().stored, before.stored + 1);
  EXPECT_EQ(programCacheCounters().hits, before.hits + 1);
  EXPECT_EQ(fp::serialise(first), fp::serialise(second));
  EXPECT_EQ(second.glsl.text, fp::compile(input(), kCachedText).glsl.text);
}

TEST_F(ProgramCache, ARefusedProgramIsRefusedTheSameWay) {
  const char *const bad = "!!ARBfp1.0\nMOV result.color, nothing;\nEND\n";
  const fp::Compilation first = compileCached(input(), bad);
  const std::uint64_t hits = programCacheCounters().hits;
  const fp::Compilation second = compileCached(input(), bad);
  EXPECT_EQ(programCacheCounters().hits, hits + 1);
  EXPECT_FALSE(second.check.ok());
  EXPECT_EQ(first.check.errorPosition(), second.check.errorPosition());
  EXPECT_EQ(first.check.errorString(bad), second.check.errorString(bad));
  EXPECT_NE(second.check.errorString(bad), "");
}

TEST_F(ProgramCache, OtherLimitsAreAnotherEntry) {
  (void)compileCached(input(), kCachedText);
  fp::CompilationInput tight = input();
  tight.options.limits.api.instructions = 0;
  const std::uint64_t misses = programCacheCounters().misses;
  EXPECT_FALSE(compileCached(tight, kCachedText).check.ok());
  EXPECT_EQ(programCacheCounters().misses, misses + 1);
  EXPECT_TRUE(compileCached(input(), kCachedText).check.ok());
}

TEST_F(ProgramCache, ADamagedFileIsCompiledAnew) {
  (void)compileCached(input(), kCachedText);
  for (const fs::path &file : files())
    std::ofstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(60) << "damage";
  const ProgramCacheCounters before = programCacheCounters();
  EXPECT_TRUE(compileCached(input(), kCachedText).check.ok());
  EXPECT_EQ(programCacheCounters().misses, before.misses + 1);
  EXPECT_TRUE(compileCached(input(), kCachedText).check.ok());
  EXPECT_EQ(programCacheCounters().hits, before.hits + 1);
}

TEST_F(ProgramCache, ADrawCannotTellWhereItsProgramCameFrom) {
  GLint counts[2][2] = {};
  for (int round = 0; round < 2; ++round) {
    FakeHost host;
    CurrentContext context(host);
    const std::uint64_t hits = programCacheCounters().hits;
    testing::use(*context,
                 "!!ARBfp1.0\nMUL result.color, fragment.color, program.local[2];\nEND\n");
    EXPECT_EQ(programCacheCounters().hits, hits + std::uint64_t(round));
    EXPECT_EQ(handlers::GetError(*context), GLenum(GL_NO_ERROR));
    handlers::GetProgramivARB(*context, kFragment, GL_PROGRAM_INSTRUCTIONS_ARB, &counts[round][0]);
    handlers::GetProgramivARB(*context, kFragment, GL_PROGRAM_PARAMETERS_ARB, &counts[round][1]);
    EXPECT_TRUE(testing::draw(*context));
    EXPECT_EQ(testing::drawsBy(*context, Path::HostGlsl), 1u);
  }
  EXPECT_EQ(counts[0][0], 1);
  EXPECT_EQ(counts[0][0], counts[1][0]);
  EXPECT_EQ(counts[0][1], counts[1][1]);
}

} // namespace
} // namespace arbiter::state
