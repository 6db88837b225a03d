/// Tests the registry against a fake state tracker that notes its calls.
#include "interposer/registry.h"

#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "host/host_table.h"

namespace arbiter::state {

class Context {
public:
  Context *share = nullptr;
  const host::HostTable *table = nullptr;
  bool destroyed = false;
  bool enabled = false;
};

namespace {
std::vector<std::unique_ptr<Context>> g_made;
thread_local Context *t_now = nullptr;
int g_unbinds = 0;
} // namespace

Context *createContext(Provider, const host::HostTable *table, Context *share, bool) {
  g_made.push_back(std::make_unique<Context>(Context{share, table, false, false}));
  return g_made.back().get();
}
void makeCurrent(Context *context, const Drawable *) {
  if (!context && t_now)
    ++g_unbinds;
  t_now = context;
}
Context *currentContext() { return t_now; }
void destroyContext(Context *context) { context->destroyed = true; }
void copyContext(const Context &from, Context &to, std::uint32_t mask) {
  if (mask & GL_ENABLE_BIT)
    to.enabled = from.enabled;
}

} // namespace arbiter::state

namespace arbiter::interposer::registry {
namespace {

using state::g_made;
using state::t_now;

const host::HostTable kTable{};
int g_display, g_otherDisplay;

void create(const Key &key, const host::HostTable &table, const void *share) {
  EXPECT_TRUE(created(key, table, share));
}

void makeCurrent(const Key &key, const host::HostTable &table) {
  EXPECT_TRUE(madeCurrent(key, table));
}

class Registry : public testing::Test {
protected:
  void TearDown() override {
    for (const Provider provider : {Provider::Glx, Provider::Egl, Provider::OsMesa}) {
      makeCurrent({provider, &g_display, nullptr}, kTable);
      for (const void *display :
           {static_cast<void *>(&g_display), static_cast<void *>(&g_otherDisplay),
            static_cast<void *>(nullptr)})
        displayClosed(provider, display);
    }
    g_made.clear();
  }
  /// Returns a handle; any address serves, as the registry only compares them.
  const void *handle(int i) { return &m_handles[i]; }
  Key glx(int i) { return {Provider::Glx, &g_display, handle(i)}; }
  Key egl(int i) { return {Provider::Egl, &g_display, handle(i)}; }
  char m_handles[8] = {};
};

TEST_F(Registry, FindsTheContextThatWasMade) {
  create(glx(0), kTable, nullptr);
  create(glx(1), kTable, nullptr);
  makeCurrent(glx(1), kTable);
  EXPECT_EQ(t_now, g_made[1].get());
  EXPECT_TRUE(isCurrent(Provider::Glx));
  EXPECT_FALSE(isCurrent(Provider::Egl));
}

TEST_F(Registry, HandsOnTheShareGroup) {
  create(glx(0), kTable, nullptr);
  create(glx(1), kTable, handle(0));
  EXPECT_EQ(g_made[1]->share, g_made[0].get());
}

TEST_F(Registry, AdoptsAContextItNeverSaw) {
  makeCurrent(egl(3), kTable);
  ASSERT_EQ(g_made.size(), 1u);
  EXPECT_EQ(t_now, g_made[0].get());
  makeCurrent(egl(3), kTable);
  EXPECT_EQ(g_made.size(), 1u);
}

TEST_F(Registry, ReusedHandleIsANewContext) {
  create(glx(0), kTable, nullptr);
  makeCurrent(glx(0), kTable);
  destroyed(glx(0));
  EXPECT_TRUE(g_made[0]->destroyed);
  EXPECT_EQ(t_now, g_made[0].get()) << "destroyed, but current: still in use";
  create(glx(0), kTable, nullptr);
  makeCurrent(glx(0), kTable);
  EXPECT_EQ(t_now, g_made[1].get());
}

TEST_F(Registry, TakesOverAHandleWhoseDestructionItMissed) {
  create(egl(0), kTable, nullptr);
  create(egl(0), kTable, nullptr);
  EXPECT_TRUE(g_made[0]->destroyed);
  makeCurrent(egl(0), kTable);
  EXPECT_EQ(t_now, g_made[1].get());
}

TEST_F(Registry, ProvidersAndEglDisplaysDoNotMix) {
  const Key otherEgl{Provider::Egl, &g_otherDisplay, handle(0)};
  create(glx(0), kTable, nullptr);
  create(egl(0), kTable, nullptr);
  create(otherEgl, kTable, nullptr);
  makeCurrent(otherEgl, kTable);
  EXPECT_EQ(t_now, g_made[2].get());
  makeCurrent(glx(0), kTable);
  EXPECT_EQ(t_now, g_made[0].get());
}

TEST_F(Registry, GlxContextIsFoundOverAnotherConnection) {
  create(glx(0), kTable, nullptr);
  makeCurrent({Provider::Glx, &g_otherDisplay, handle(0)}, kTable);
  EXPECT_EQ(t_now, g_made[0].get());
}

TEST_F(Registry, UnbindingOfAnotherProviderLeavesTheCurrentOne) {
  create({Provider::OsMesa, nullptr, handle(0)}, kTable, nullptr);
  makeCurrent({Provider::OsMesa, nullptr, handle(0)}, kTable);
  makeCurrent({Provider::Glx, &g_display, nullptr}, kTable);
  EXPECT_EQ(t_now, g_made[0].get());
  makeCurrent({Provider::OsMesa, nullptr, nullptr}, kTable);
  EXPECT_EQ(t_now, nullptr);
}

TEST_F(Registry, ClosedDisplayTakesItsContextsAlong) {
  create(egl(0), kTable, nullptr);
  create({Provider::Egl, &g_otherDisplay, handle(1)}, kTable, nullptr);
  create(egl(2), kTable, nullptr);
  displayClosed(Provider::Egl, &g_display);
  EXPECT_TRUE(g_made[0]->destroyed);
  EXPECT_FALSE(g_made[1]->destroyed);
  EXPECT_TRUE(g_made[2]->destroyed);
  makeCurrent(egl(0), kTable);
  EXPECT_EQ(t_now, g_made[3].get()) << "a handle of the closed display means another context now";
}

TEST_F(Registry, CopiesBetweenContextsThatItKnows) {
  create(glx(0), kTable, nullptr);
  create(glx(1), kTable, nullptr);
  g_made[0]->enabled = true;
  copied(glx(0), glx(1), GL_LIGHTING_BIT);
  EXPECT_FALSE(g_made[1]->enabled);
  copied(glx(0), glx(5), GL_ENABLE_BIT);
  copied(glx(0), glx(1), GL_ENABLE_BIT);
  EXPECT_TRUE(g_made[1]->enabled);
}

TEST_F(Registry, ThreadThatEndsUnbinds) {
  create(egl(0), kTable, nullptr);
  const int before = state::g_unbinds;
  std::thread([&] { makeCurrent(egl(0), kTable); }).join();
  EXPECT_EQ(state::g_unbinds, before + 1);
}

} // namespace
} // namespace arbiter::interposer::registry
