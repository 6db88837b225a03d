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

/// Sets a cache folder for this process, before the settings are read.
struct Folder {
  Folder() {
    char pattern[] = "/tmp/arbiter-programs-XXXXXX";
    path = ::mkdtemp(pattern);
    ::setenv("XDG_CACHE_HOME", path.c_str(), 1);
    ::unsetenv("ARBITER_CACHE");
  }
  ~Folder() { fs::remove_all(path); }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto &entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file() && entry.path().filename() != "key") // the folder's secret
        found.push_back(entry.path());
    return found;
  }
  std::string path;
} const g_folder;

constexpr const char *kText = "!!ARBfp1.0\nPARAM p = program.env[1];\n"
                              "MAD result.color, fragment.color, p, p;\nEND\n";

fp::CompilationInput input() {
  fp::CompilationInput input;
  input.options.limits.api = {96, 64, 32, 4, 32, 32, 10, 0};
  input.options.limits.native = input.options.limits.api;
  input.options.limits.envParameters = input.options.limits.localParameters = 32;
  return input;
}

TEST(ProgramCache, TheSecondTimeAProgramIsRead) {
  const ProgramCacheCounters before = programCacheCounters();
  const fp::Compilation first = compileCached(input(), kText);
  const fp::Compilation second = compileCached(input(), kText);
  ASSERT_TRUE(first.check.ok()) << first.check.errorString(kText);
  EXPECT_EQ(programCacheCounters().misses, before.misses + 1);
  EXPECT_EQ(programCacheCounters().stored, before.stored + 1);
  EXPECT_EQ(programCacheCounters().hits, before.hits + 1);
  EXPECT_EQ(fp::serialise(first), fp::serialise(second));
  EXPECT_EQ(second.glsl.text, fp::compile(input(), kText).glsl.text);
}

TEST(ProgramCache, ARefusedProgramIsRefusedTheSameWay) {
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

TEST(ProgramCache, OtherLimitsAreAnotherEntry) {
  (void)compileCached(input(), kText);
  fp::CompilationInput tight = input();
  tight.options.limits.api.instructions = 0;
  const std::uint64_t misses = programCacheCounters().misses;
  EXPECT_FALSE(compileCached(tight, kText).check.ok());
  EXPECT_EQ(programCacheCounters().misses, misses + 1);
  EXPECT_TRUE(compileCached(input(), kText).check.ok());
}

TEST(ProgramCache, ADamagedFileIsCompiledAnew) {
  (void)compileCached(input(), kText);
  for (const fs::path &file : g_folder.files())
    std::ofstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(60) << "damage";
  const ProgramCacheCounters before = programCacheCounters();
  EXPECT_TRUE(compileCached(input(), kText).check.ok());
  EXPECT_EQ(programCacheCounters().misses, before.misses + 1);
  EXPECT_TRUE(compileCached(input(), kText).check.ok());
  EXPECT_EQ(programCacheCounters().hits, before.hits + 1);
}

TEST(ProgramCache, ADrawCannotTellWhereItsProgramCameFrom) {
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
