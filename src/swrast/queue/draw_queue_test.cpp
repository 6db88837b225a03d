// Checks that queued draws give the pixels of immediate draws, whatever changes or is read between
// them.
#include "swrast/queue/draw_queue.h"

#include <atomic>
#include <csetjmp>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

#include "swrast/image/copy_pixels.h"
#include "swrast/testing/queue_scene.h"

namespace arbiter::swrast {
namespace {

class Queue : public testing::TestWithParam<int> {
protected:
  void SetUp() override { setThreadCount(GetParam()); }
  void TearDown() override { setThreadCount(0); }
};

TEST_P(Queue, OnlyWhatFillsThePictureWhereNothingWaitsIsDoneAtOnce) {
  const Image late = cleared(), now = cleared();
  Scene queued(late), atOnce(now);
  DrawQueue queue;
  const Mesh whole = quad(0, 0, kSize, kSize), half = quad(0, 0, kSize, kSize / 2 - 30);
  Mesh triangle;
  triangle.add(3, 3);
  triangle.add(kSize - 3, 10);
  triangle.add(90, kSize - 10);
  std::uint32_t number = 0;
  const auto draw = [&](Topology topology, const Mesh &mesh) {
    queued.setParameter(++number);
    atOnce.setParameter(number);
    drawAtOnce(atOnce, topology, mesh);
    return drawBy(queue, queued, topology, mesh);
  };
  EXPECT_FALSE(draw(Topology::Quads, whole));
  EXPECT_FALSE(draw(Topology::Triangles, triangle)); // its bounds fill the picture
  EXPECT_TRUE(draw(Topology::Quads, half));
  EXPECT_TRUE(draw(Topology::Quads, whole)); // a draw is queued already
  EXPECT_TRUE(draw(Topology::Triangles, triangle));
  queue.finish();
  EXPECT_FALSE(draw(Topology::Quads, whole));
  EXPECT_EQ(pixelsOf(late), pixelsOf(now));
}

TEST_P(Queue, DrawsAreThoseThatAreDoneAtOnce) {
  std::mt19937 random(7);
  for (int round = 0; round < 12; ++round) {
    Image late = cleared(), now = cleared();
    Scene queued(late), direct(now);
    DrawQueue queue;
    int taken = 0;
    for (int i = 0; i < 60; ++i) {
      const int kind = int(random() % 8);
      const bool isMany = kind == 7;
      const Mesh mesh = meshOf(random, isMany ? 3000 : 3 * (1 + int(random() % 40)),
                               kind == 6 ? 120
                               : isMany  ? 4
                                         : 15);
      constexpr Topology kTopologies[] = {
          Topology::Triangles,     Topology::Points, Topology::LineStrip,   Topology::Quads,
          Topology::TriangleStrip, Topology::Lines,  Topology::TriangleFan, Topology::Triangles};
      const std::uint32_t parameter = random();
      for (Scene *const scene : {&queued, &direct}) {
        scene->refer();
        if (i % 3 == 0)
          scene->state.clip = {17 + i, 9, 120, 150};
        scene->setParameter(parameter);
        scene->state.lineWidth = scene->state.pointSize = float(1 + i % 4);
        if (scene == &direct)
          drawAtOnce(*scene, kTopologies[kind], mesh);
        else
          taken += drawBy(queue, *scene, kTopologies[kind], mesh) ? 1 : 0;
      }
      if (i % 17 == 0)
        queue.post();
    }
    EXPECT_GT(taken, 40);
    ASSERT_EQ(pixelsOf(late), pixelsOf(now)) << "round " << round;
    EXPECT_TRUE(queue.isEmpty()) << "the pixels were asked for";
  }
}

TEST_P(Queue, SmallDrawsOfOneStateAreThoseThatAreDoneAtOnce) {
  constexpr Topology kTopologies[] = {Topology::Triangles,   Topology::TriangleStrip,
                                      Topology::TriangleFan, Topology::Quads,
                                      Topology::QuadStrip,   Topology::Polygon};
  std::mt19937 random(5);
  for (int round = 0; round < 8; ++round) {
    Image late = cleared(), now = cleared();
    Scene queued(late), direct(now);
    DrawQueue queue;
    for (int i = 0; i < 1500; ++i) {
      const Topology topology = kTopologies[random() % 6];
      const Mesh mesh = meshOf(random, 1 + int(random() % 12), 9);
      // Some use indices, and some of these are out of range.
      std::vector<std::uint32_t> indices(random() % 3 == 0 ? 3 + random() % 9 : 0);
      for (std::uint32_t &index : indices)
        index = std::uint32_t(random() % (mesh.count() + (random() % 8 == 0 ? 1 : 0)));
      const std::uint32_t *const named = indices.empty() ? nullptr : indices.data();
      const std::uint32_t count = named ? std::uint32_t(indices.size()) : mesh.count();
      if (random() % 100 == 0) { // changes the state now and then
        const std::uint32_t parameter = random(), kind = random() % 4;
        for (Scene *const scene : {&queued, &direct}) {
          scene->setParameter(parameter);
          scene->state.cullBack = kind == 1;
          scene->state.provokingIsFirst = kind == 2;
          scene->state.clip = {kind == 3 ? 30 : 0, 0, 150, kSize};
        }
      }
      if (!queue.add(queued.state, queued.shading, topology, mesh.get(), named, 0, count,
                     queued.use)) {
        queue.finish();
        (void)rasterize(queued.state, queued.shading, topology, mesh.get(), named, 0, count);
      }
      (void)rasterize(direct.state, direct.shading, topology, mesh.get(), named, 0, count);
      if (i % 400 == 399)
        queue.post();
    }
    ASSERT_EQ(pixelsOf(late), pixelsOf(now)) << "round " << round;
    EXPECT_TRUE(queue.isEmpty()) << "the pixels were asked for";
  }
}

TEST_P(Queue, WhatIsChangedAfterwardsChangesNothing) {
  Image image = cleared(), texture = cleared();
  Scene scene(image);
  scene.sample(texture);
  DrawQueue queue;
  std::array<std::uint8_t, 128> stipple;
  stipple.fill(0xF0);
  scene.state.polygonStipple = stipple.data();
  scene.setParameter(5);
  {
    Mesh mesh = quad(10, 10, 40, 40);
    ASSERT_TRUE(drawBy(queue, scene, Topology::Quads, mesh));
    for (std::vector<float> &values : mesh.position)
      std::fill(values.begin(), values.end(), 0.0f);
  }
  stipple.fill(0xFF);
  scene.setParameter(9);
  scene.data.targets[0] = {};
  scene.data.textures[0] = nullptr;
  scene.level = {};
  scene.view = {};
  scene.state.clip = {};
  const std::weak_ptr<int> functions = scene.kept;
  scene.kept.reset();
  scene.use.functions.reset();
  EXPECT_FALSE(functions.expired()) << "machine code lives as long as a draw waits";
  queue.finish();
  EXPECT_TRUE(functions.expired());
  const auto pixels = pixelsOf(image);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const bool isIn = x >= 10 && x < 50 && y >= 10 && y < 50 && x % 8 < 4;
      ASSERT_EQ(pixels[std::size_t(y) * kSize + std::size_t(x)], isIn ? 5u : 0u) << x << " " << y;
    }
}

TEST_P(Queue, ClearsCopiesAndDrawsKeepTheirOrder) {
  Image late = cleared(), now = cleared();
  std::mt19937 random(3);
  DrawQueue queue;
  for (int i = 0; i < 40; ++i) {
    const Mesh mesh = meshOf(random, 60, 20);
    for (Image *const image : {&late, &now}) {
      Scene scene(*image);
      scene.setParameter(std::uint32_t(i));
      if (image == &now)
        drawAtOnce(scene, Topology::Triangles, mesh);
      else
        drawBy(queue, scene, Topology::Triangles, mesh);
      if (i % 8 == 3) {
        const float rgba[4] = {0.5f, 0.25f, 0, 1};
        fill(*image, {i, 2 * i, 90, 60}, rgba, 15);
      }
      if (i % 16 == 9)
        clear(*image, 1);
      if (i % 8 == 5)
        copyPixels(*image, 100, 100, 0, *image, {0, 0, 80, 80}, 0);
    }
  }
  EXPECT_EQ(pixelsOf(late), pixelsOf(now));
}

TEST_P(Queue, WhatWasDrawnIsSampledAndWhatIsSampledIsNotDrawnToBefore) {
  std::vector<std::uint32_t> results[2];
  for (const bool isLate : {false, true}) {
    Image first = cleared(), second = cleared();
    DrawQueue queue;
    std::mt19937 random(11);
    for (int i = 0; i < 30; ++i) {
      Image &to = i % 2 == 0 ? first : second, &from = i % 2 == 0 ? second : first;
      Scene scene(to);
      scene.sample(from);
      scene.setParameter(random());
      for (int part = 0; part < 3; ++part) {
        const Mesh mesh = meshOf(random, 90, 25);
        if (isLate)
          drawBy(queue, scene, Topology::Triangles, mesh);
        else
          drawAtOnce(scene, Topology::Triangles, mesh);
      }
    }
    queue.finish();
    results[isLate ? 1 : 0] = pixelsOf(first);
    const auto other = pixelsOf(second);
    results[isLate ? 1 : 0].insert(results[isLate ? 1 : 0].end(), other.begin(), other.end());
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST_P(Queue, AStorageThatIsFreedIsDrawnToBefore) {
  DrawQueue queue;
  Image kept = cleared();
  {
    Image image = cleared();
    Scene scene(image);
    ASSERT_TRUE(drawBy(queue, scene, Topology::Quads, quad(0, 0, 50, 50)));
    Scene other(kept);
    other.sample(image);
    other.setParameter(4);
    ASSERT_TRUE(drawBy(queue, other, Topology::Quads, quad(0, 0, 50, 50)));
    EXPECT_FALSE(queue.isEmpty());
    scene.target = other.target = {};
  }
  EXPECT_TRUE(queue.isEmpty());
  EXPECT_EQ(pixelsOf(kept)[0], 4u);
}

TEST_P(Queue, LargeDrawsAreNotTaken) {
  DrawQueue queue;
  Image image = cleared();
  Scene scene(image);
  EXPECT_FALSE(drawBy(queue, scene, Topology::Quads, quad(0, 0, 190, 190)));
  EXPECT_FALSE(drawBy(queue, scene, Topology::Triangles, [] {
    Mesh mesh;
    mesh.add(-150, 0);
    mesh.add(380, 5);
    mesh.add(90, 390);
    return mesh;
  }()));
  EXPECT_TRUE(queue.isEmpty());
}

TEST_P(Queue, TwoQueuesMeetInAnImage) {
  Image late = cleared(), now = cleared();
  std::mt19937 random(5);
  DrawQueue queues[2];
  for (int i = 0; i < 20; ++i) {
    const Mesh mesh = meshOf(random, 30, 30);
    Scene queued(late), direct(now);
    queued.setParameter(std::uint32_t(i));
    direct.setParameter(std::uint32_t(i));
    drawBy(queues[i / 3 % 2], queued, Topology::Triangles, mesh);
    drawAtOnce(direct, Topology::Triangles, mesh);
  }
  EXPECT_EQ(pixelsOf(late), pixelsOf(now));
}

std::jmp_buf g_back;
std::atomic<bool> g_jumps{false};
pthread_t g_jumper;
void jumpOut(const abi::FragmentData *data, const abi::Primitive *primitive, const void *items,
             std::uint32_t count) {
  if (g_jumps && pthread_equal(pthread_self(), g_jumper)) {
    g_jumps = false;
    std::longjmp(g_back, 1);
  }
  shadeRow(data, primitive, items, count);
}

// A handler may leave the queue by siglongjmp(). No thread may read what the queue drops, and the
// queue must keep working.
TEST_P(Queue, AJumpOutOfItLeavesItEmpty) {
  DrawQueue queue;
  Image image = cleared();
  std::mt19937 random(2);
  g_jumper = pthread_self();
  static int round;
  for (round = 0; round < 5; ++round) {
    Scene scene(image);
    scene.shading.row = jumpOut;
    for (int i = 0; i < 12; ++i)
      ASSERT_TRUE(drawBy(queue, scene, Topology::Triangles, meshOf(random, i == 6 ? 3000 : 90, 6)));
    g_jumps = true;
    if (setjmp(g_back) == 0) {
      queue.finish();
      ASSERT_TRUE(GetParam() > 1 && g_jumps) << "the other threads were sooner, or nothing jumps";
      g_jumps = false;
    }
    queue.finish();
    EXPECT_TRUE(queue.isEmpty());
    EXPECT_EQ(image.storage->pendingUse().draws, nullptr);
  }
  clear(image, 0);
  Scene scene(image);
  scene.setParameter(8);
  ASSERT_TRUE(drawBy(queue, scene, Topology::Quads, quad(20, 20, 9, 9)));
  EXPECT_EQ(pixelsOf(image)[21 * kSize + 21], 8u);
}

TEST_P(Queue, AChildOfAForkFinishesWhatWaits) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "ThreadSanitizer ends a child of a process with threads that starts one";
#endif
  std::mt19937 random(13);
  Image late = cleared(), now = cleared();
  DrawQueue queue;
  for (int i = 0; i < 60; ++i) {
    const Mesh mesh = meshOf(random, 120, 20);
    Scene queued(late), direct(now);
    drawBy(queue, queued, Topology::Triangles, mesh);
    drawAtOnce(direct, Topology::Triangles, mesh);
    if (i % 20 == 10)
      queue.post();
  }
  const auto expected = pixelsOf(now);
  const pid_t child = fork();
  if (child == 0)
    _exit(pixelsOf(late) == expected ? 0 : 1);
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(pixelsOf(late), expected) << "in the parent";
}

INSTANTIATE_TEST_SUITE_P(Threads, Queue, testing::Values(1, 2, 5));

} // namespace
} // namespace arbiter::swrast
