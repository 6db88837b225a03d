#include "control/frames.h"

#include <cstring>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

namespace arbiter::control {
namespace {

TEST(Frames, AreSeenByTheReader) {
  const auto ring = FrameRing::make(33, 7);
  ASSERT_TRUE(ring);
  const int slot = ring->take();
  std::memset(ring->pixels(slot), 0xA5, ring->layout().stride * 7);
  const auto view = FrameView::map(ring->share(), ring->layout());
  ASSERT_TRUE(view);
  EXPECT_EQ(view->pixels(slot)[0], 0xA5);
  EXPECT_EQ(view->pixels(slot)[ring->layout().stride * 7 - 1], 0xA5);
  EXPECT_EQ(view->pixels(kFrameSlots), nullptr);
  EXPECT_EQ(view->pixels(-1), nullptr);
}

TEST(Frames, ThreeAreLentAndNoMore) {
  const auto ring = FrameRing::make(4, 4);
  EXPECT_FALSE(ring->isFull());
  EXPECT_NE(ring->take(), -1);
  const int second = ring->take();
  EXPECT_NE(ring->take(), -1);
  EXPECT_TRUE(ring->isFull());
  EXPECT_EQ(ring->take(), -1);
  EXPECT_TRUE(ring->giveBack(second));
  EXPECT_FALSE(ring->giveBack(second)) << "given back twice";
  EXPECT_EQ(ring->take(), second);
  for (const int wrong : {-1, 3, 1 << 30})
    EXPECT_FALSE(ring->giveBack(wrong));
}

/// Accessing a page that the reader cut off would kill the writer's process.
TEST(Frames, TheReaderCannotResizeThem) {
  const auto ring = FrameRing::make(64, 64);
  const Descriptor other = ring->share();
  EXPECT_NE(ftruncate(other.get(), 0), 0);
  EXPECT_NE(ftruncate(other.get(), off_t(ring->layout().bytes() * 2)), 0);
  EXPECT_NE(fcntl(other.get(), F_ADD_SEALS, F_SEAL_WRITE), 0) << "seals are sealed";
  // This needs Linux 5.1 or later.
  void *const writable = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, other.get(), 0);
  EXPECT_EQ(writable, MAP_FAILED);
}

TEST(Frames, TheReaderTakesNoMemoryThatMayShrink) {
  const FrameLayout layout = *layoutOf(16, 16);
  Descriptor plain(memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ASSERT_EQ(ftruncate(plain.get(), off_t(layout.bytes())), 0);
  EXPECT_FALSE(FrameView::map(std::move(plain), layout));
  Descriptor small(memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  ASSERT_EQ(ftruncate(small.get(), off_t(layout.bytes() - 1)), 0);
  fcntl(small.get(), F_ADD_SEALS, F_SEAL_SHRINK);
  EXPECT_FALSE(FrameView::map(std::move(small), layout));
  EXPECT_FALSE(FrameView::map(Descriptor(open("/dev/null", O_RDONLY | O_CLOEXEC)), layout));
  EXPECT_FALSE(FrameView::map({}, layout));
}

TEST(Frames, HaveASize) {
  EXPECT_FALSE(layoutOf(0, 4));
  EXPECT_FALSE(layoutOf(4, -1));
  EXPECT_FALSE(layoutOf(kMaxFrameSide + 1, 1));
  EXPECT_FALSE(FrameRing::make(0, 0));
  FrameLayout wrong = *layoutOf(8, 8);
  wrong.stride = 1 << 20;
  EXPECT_FALSE(FrameView::map(FrameRing::make(8, 8)->share(), wrong));
}

} // namespace
} // namespace arbiter::control
