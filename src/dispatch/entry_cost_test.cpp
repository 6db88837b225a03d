/// What a passed-on call costs: the entry point against the host's function called straight, both
/// by pointer, as libglvnd calls them.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include <gtest/gtest.h>

#include "dispatch/entry_points.h"
#include "host/host_table.h"
#include "state/current.h"

namespace arbiter::dispatch {
namespace {

/// Nanoseconds that an entry point may add to the host's call, and what a machine that does other
/// work may add to that: less than a lock or a thread-local by function call would. The code itself
/// is looked at by the client tests' disassembly.
constexpr double kAllowed = 0.6;
constexpr double kNoise = 1.9;
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool kTimed = true;
#else
constexpr bool kTimed = false;
#endif
constexpr int kCalls = 20'000;
constexpr int kRounds = 1'500;

// They do nothing that could hide the entry point's own work behind it.
[[gnu::noipa]] void hostDrawArrays(GLenum, GLint, GLsizei) {}
[[gnu::noipa]] void hostUniform4fv(GLint, GLsizei, const GLfloat *) {}
[[gnu::noipa]] void hostRasterPos2f(GLfloat, GLfloat) {}

template <typename Call> double nanoseconds(Call call) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < kCalls; ++i)
    call();
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - begin;
  return spent.count() / kCalls;
}

/// The least of many rounds, in turns, so that other work on the machine hits both alike.
template <typename Direct, typename Entry>
double added(const char *name, Direct direct, Entry entry) {
  double directBest = 1e9, entryBest = 1e9;
  for (int round = 0; round < kRounds; ++round) {
    directBest = std::min(directBest, nanoseconds(direct));
    entryBest = std::min(entryBest, nanoseconds(entry));
  }
  std::printf("%-12s host %.2f ns, entry %.2f ns, added %.2f ns\n", name, directBest, entryBest,
              entryBest - directBest);
  return entryBest - directBest;
}

void expectCheap(double cost) {
  if (kTimed)
    EXPECT_LE(cost, kAllowed + kNoise);
}

class EntryCost : public testing::Test {
protected:
  void SetUp() override {
    m_table.DrawArrays = hostDrawArrays;
    m_table.Uniform4fv = hostUniform4fv;
    m_table.RasterPos2f = hostRasterPos2f;
    m_hot.host = &m_table;
    m_hot.drawCounter = &m_draws;
    m_before = state::t_current;
    state::t_current = &m_hot;
  }
  void TearDown() override { state::t_current = m_before; }

  template <typename Function> Function *entry(Function *, const char *name) {
    return reinterpret_cast<Function *>(find(name).function);
  }

  host::HostTable m_table;
  state::ContextHot m_hot;
  state::ContextHot *m_before = nullptr;
  std::uint64_t m_draws = 0;
};

TEST_F(EntryCost, DrawIsCountedAndPassedOn) {
  void (*volatile direct)(GLenum, GLint, GLsizei) = hostDrawArrays;
  void (*volatile ours)(GLenum, GLint, GLsizei) = entry(hostDrawArrays, "glDrawArrays");
  ASSERT_NE(ours, nullptr);
  const double cost = added(
      "DrawArrays", [&] { direct(GL_POINTS, 0, 1); }, [&] { ours(GL_POINTS, 0, 1); });
  EXPECT_EQ(m_draws, std::uint64_t(kCalls) * kRounds);
  expectCheap(cost);
}

TEST_F(EntryCost, ObserverPassesOn) {
  const GLfloat value[4] = {};
  void (*volatile direct)(GLint, GLsizei, const GLfloat *) = hostUniform4fv;
  void (*volatile ours)(GLint, GLsizei, const GLfloat *) = entry(hostUniform4fv, "glUniform4fvARB");
  ASSERT_NE(ours, nullptr);
  expectCheap(added(
      "Uniform4fv", [&] { direct(0, 1, value); }, [&] { ours(0, 1, value); }));
}

TEST_F(EntryCost, ValidatorPassesOn) {
  void (*volatile direct)(GLfloat, GLfloat) = hostRasterPos2f;
  void (*volatile ours)(GLfloat, GLfloat) = entry(hostRasterPos2f, "glRasterPos2f");
  ASSERT_NE(ours, nullptr);
  expectCheap(added(
      "RasterPos2f", [&] { direct(0, 0); }, [&] { ours(0, 0); }));
}

TEST(EntryTable, HasEachNameOfAnAliasGroup) {
  EXPECT_NE(find("glDrawArrays").function, nullptr);
  EXPECT_EQ(find("glDrawArrays").function, find("glDrawArraysEXT").function);
  EXPECT_EQ(find("glUseProgram").function, find("glUseProgramObjectARB").function);
  EXPECT_EQ(find("glBindProgramARB").function, find("glBindProgramNV").function);
  EXPECT_TRUE(find("glProgramStringARB").provided);
  EXPECT_FALSE(find("glDrawArrays").provided);
}

TEST(EntryTable, HasNothingElse) {
  // Alike in name, and not aliases: NV attributes and parameters mean other things.
  for (const char *name : {"glVertexAttrib4fNV", "glLoadProgramNV", "glGetProgramivNV", "glClear",
                           "glVertex3f", "", "gl", "glzzz"})
    EXPECT_EQ(find(name).function, nullptr) << name;
}

TEST(EntryTable, KnowsItsOwn) {
  EXPECT_TRUE(isOurs(find("glEnable").function));
  EXPECT_FALSE(isOurs(reinterpret_cast<const void *>(&hostDrawArrays)));
  EXPECT_FALSE(isOurs(nullptr));
}

} // namespace
} // namespace arbiter::dispatch
