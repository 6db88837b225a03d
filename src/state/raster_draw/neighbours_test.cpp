#include "state/raster_draw/neighbours.h"

#include <gtest/gtest.h>

#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using testing::FakeHost;

Drawable windowOf(const int &handle) {
  Drawable drawable;
  drawable.kind = Drawable::Kind::Window;
  drawable.draw = &handle;
  return drawable;
}

/// A context that is destroyed with the test and starts out current nowhere. All contexts are
/// "current" on the test's one thread: only the table is told, not the thread.
class Made {
public:
  explicit Made(FakeHost &host, const Made *share = nullptr)
      : m_context(createContext(Provider::Egl, host.table(), share ? share->m_context : nullptr)) {}
  ~Made() { destroyContext(m_context); }
  Made(const Made &) = delete;
  Made &operator=(const Made &) = delete;

  void become(const Drawable &drawable = {}) { becomesCurrent(*m_context, drawable); }
  void cease() { ceasesToBeCurrent(*m_context); }
  [[nodiscard]] std::uint64_t epoch() const { return m_context->neighbours.epoch(); }
  [[nodiscard]] bool isCrowded() const { return NeighbourEpoch::isCrowded(epoch()); }
  [[nodiscard]] const Context &operator*() const { return *m_context; }

private:
  Context *m_context;
};

TEST(Neighbours, AContextAloneKeepsItsEpoch) {
  FakeHost host;
  Made alone(host);
  const std::uint64_t before = alone.epoch();
  EXPECT_NE(before, 0u);
  alone.become();
  alone.cease();
  alone.become();
  EXPECT_EQ(alone.epoch(), before);
  EXPECT_FALSE((*alone).group->contexts > 1);
  alone.cease();
}

TEST(Neighbours, OneOfTheGroupCrowdsWhileItIsCurrentAndMovesTheEpochBeforeAndAfter) {
  FakeHost host;
  Made here(host), there(host, &here);
  EXPECT_TRUE((*here).group->contexts > 1);
  here.become();
  const std::uint64_t alone = here.epoch();
  EXPECT_FALSE(here.isCrowded());
  there.become();
  const std::uint64_t during = here.epoch();
  EXPECT_NE(during, alone);
  EXPECT_TRUE(here.isCrowded());
  EXPECT_TRUE(there.isCrowded());
  there.cease();
  EXPECT_NE(here.epoch(), during);
  EXPECT_NE(here.epoch(), alone) << "what was kept before is not good again";
  EXPECT_FALSE(here.isCrowded());
  here.cease();
}

TEST(Neighbours, OneOfTheGroupThatWasCurrentInBetweenIsNoticedLater) {
  FakeHost host;
  Made here(host), there(host, &here);
  here.become();
  const std::uint64_t before = here.epoch();
  here.cease();
  there.become();
  there.cease();
  here.become();
  EXPECT_NE(here.epoch(), before);
  EXPECT_FALSE(here.isCrowded());
  here.cease();
}

TEST(Neighbours, ContextsOfOneDrawableAreNeighboursWhileBothHaveIt) {
  FakeHost host;
  const int first = 0, second = 0;
  Made here(host), there(host);
  here.become(windowOf(first));
  const std::uint64_t before = here.epoch();
  there.become(windowOf(second));
  EXPECT_EQ(here.epoch(), before) << "another window, another group";
  there.cease();
  there.become(windowOf(first));
  EXPECT_NE(here.epoch(), before);
  EXPECT_TRUE(here.isCrowded());
  there.cease();
  EXPECT_FALSE(here.isCrowded());
  here.cease();
}

TEST(Neighbours, SurfacelessContextsAreNoNeighboursByTheirDrawable) {
  FakeHost host;
  Made here(host), there(host);
  here.become();
  there.become();
  EXPECT_FALSE(here.isCrowded());
  there.cease();
  here.cease();
}

TEST(Neighbours, AContextThatIsFreedCrowdsNoLonger) {
  FakeHost host;
  Made here(host);
  here.become();
  {
    Made there(host, &here);
    there.become();
    EXPECT_TRUE(here.isCrowded());
  }
  EXPECT_FALSE(here.isCrowded());
  EXPECT_FALSE((*here).group->contexts > 1);
  here.cease();
}

} // namespace
} // namespace arbiter::state
