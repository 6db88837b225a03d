#include "util/cache/sealed.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <thread>

#include <gtest/gtest.h>

namespace arbiter {
namespace {

using Table = std::array<void *, 700>;

/// Returns the permissions of the page at an address, as the kernel lists them ("r--p"); "" if
/// there is no page.
std::string rightsAt(const void *address) {
  const auto wanted = reinterpret_cast<unsigned long>(address);
  std::FILE *const maps = std::fopen("/proc/self/maps", "r");
  char line[512];
  std::string found;
  while (maps && std::fgets(line, sizeof line, maps)) {
    unsigned long begin = 0, end = 0;
    char rights[5] = {};
    if (std::sscanf(line, "%lx-%lx %4s", &begin, &end, rights) == 3 && begin <= wanted &&
        wanted < end)
      found = rights;
  }
  if (maps)
    std::fclose(maps);
  return found;
}

bool isReadOnly(const Table &table) {
  return rightsAt(&table.front()) == "r--p" && rightsAt(&table.back()) == "r--p";
}

constinit Sealed<Table> g_filled, g_amended, g_shared, g_fatal;
constinit std::atomic<int> g_neighbour = 0;
int g_target = 0;

TEST(Sealed, IsReadOnlyOnceItIsFilled) {
  EXPECT_FALSE(isSealed(&*g_filled));
  const Table &table = g_filled.fill([](Table &t) { t.back() = &g_target; });
  EXPECT_EQ(table.back(), &g_target);
  EXPECT_TRUE(isReadOnly(table));
  EXPECT_TRUE(isSealed(&table));
}

TEST(Sealed, IsReadOnlyAgainAfterEachWrite) {
  for (std::size_t i = 0; i < 10; ++i) {
    ASSERT_TRUE(g_amended.amend([&](Table &t) {
      EXPECT_EQ(rightsAt(&t), "rw-p");
      t[i] = &g_target;
    }));
    EXPECT_TRUE(isReadOnly(*g_amended));
    EXPECT_EQ((*g_amended)[i], &g_target);
  }
}

TEST(Sealed, SharesItsPagesWithNothing) {
  EXPECT_EQ(sizeof g_filled % kSealedPage, 0u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&g_filled) % kSealedPage, 0u);
  EXPECT_EQ(rightsAt(&g_neighbour), "rw-p");
}

/// A signal handler that interrupts a write must not wait for it.
TEST(Sealed, ASecondWriteIsRefusedAndNotWaitedFor) {
  bool inner = true;
  EXPECT_TRUE(g_amended.amend([&](Table &) { inner = g_shared.amend([](Table &) {}); }));
  EXPECT_FALSE(inner);
  EXPECT_TRUE(g_shared.amend([](Table &) {}));
}

TEST(Sealed, ThreadsWriteAndReadAtOnce) {
  std::atomic<int> kept = 0;
  const auto work = [&](std::size_t from) {
    for (std::size_t i = from; i < 600; i += 3)
      while (
          !g_shared.amend([&](Table &t) { __atomic_store_n(&t[i], &g_target, __ATOMIC_RELEASE); }))
        kept += __atomic_load_n(&(*g_shared)[i], __ATOMIC_ACQUIRE) != nullptr;
  };
  std::thread a(work, 0), b(work, 1), c(work, 2);
  a.join();
  b.join();
  c.join();
  for (std::size_t i = 0; i < 600; ++i)
    EXPECT_EQ((*g_shared)[i], &g_target) << i;
  EXPECT_EQ(kept, 0);
  EXPECT_TRUE(isReadOnly(*g_shared));
}

TEST(SealedDeathTest, AStrayWriteEndsTheProcess) {
  g_fatal.fill([](Table &t) { t[3] = &g_target; });
  EXPECT_DEATH(
      {
        volatile auto *const bytes =
            reinterpret_cast<volatile char *>(const_cast<void **>(&(*g_fatal)[3]));
        *bytes = 1;
      },
      "");
}

} // namespace
} // namespace arbiter
