// Checks how a primitive's vertices are recorded, and what remains after some were drawn early.
#include "state/primitives/recorder.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

/// A vertex as the host would get it: its number, stored in the position's x, and the slots that
/// are set.
struct Told {
  float number = -1;
  std::map<int, float> slots; ///< x of each slot
  bool operator==(const Told &) const = default;
};

std::vector<Told> toldOf(const ImmediateRecorder &recorder) {
  std::vector<Told> all;
  for (std::uint32_t i = 0; i < recorder.count(); ++i) {
    Told told;
    recorder.read(i, [&](int slot, const float *value) {
      if (slot == int(kPosition))
        told.number = value[0];
      else
        told.slots[slot] = value[0];
    });
    all.push_back(told);
  }
  return all;
}

void record(ImmediateRecorder &recorder, std::uint32_t from, std::uint32_t to) {
  for (std::uint32_t i = from; i < to; ++i)
    recorder.vertex(float(i), 0, 0, 1);
}

TEST(Immediate, WhatIsForgottenLeavesTheOthersAsTheyWere) {
  for (const std::uint32_t first : {0u, 1u, 3u})
    for (const std::uint32_t count : {0u, 2u, 6u}) {
      ImmediateRecorder recorder;
      recorder.begin(GL_TRIANGLE_FAN, {});
      recorder.set(kColor, 0.5f, 0, 0, 1); // set from the first vertex on
      record(recorder, 0, 4);
      recorder.set(kNormal, 0.25f, 0, 1, 0); // set from the fifth
      record(recorder, 4, 7);
      recorder.set(kColor, 0.75f, 0, 0, 1);
      record(recorder, 7, 9);
      recorder.set(kTexCoord0, 7, 0, 0, 1); // set from the tenth
      record(recorder, 9, 12);
      std::vector<Told> expected = toldOf(recorder);
      expected.erase(expected.begin() + first, expected.begin() + first + count);
      recorder.forget(first, count);
      EXPECT_EQ(recorder.count(), 12 - count);
      EXPECT_EQ(toldOf(recorder), expected) << count << " from " << first;
      record(recorder, 12, 13);
      EXPECT_EQ(toldOf(recorder).back(),
                (Told{12, {{kColor, 0.75f}, {kNormal, 0.25f}, {kTexCoord0, 7}}}));
    }
}

/// Takes the recorded vertices whenever the recorder is full.
struct Taker {
  ImmediateRecorder recorder;
  std::vector<float> taken;
  std::uint32_t calls = 0, most = 0;

  static bool takeAll(void *owner, const float *) {
    auto &taker = *static_cast<Taker *>(owner);
    EXPECT_EQ(taker.recorder.count(), taker.most) << "called before it is full, or too late";
    for (const Told &told : toldOf(taker.recorder))
      taker.taken.push_back(told.number);
    taker.recorder.forget(0, taker.recorder.count());
    taker.most = 64;
    taker.recorder.limit(64, takeAll, owner);
    ++taker.calls;
    return true;
  }
};

TEST(Immediate, NoMoreThanTheLimitIsKept) {
  Taker taker;
  taker.recorder.begin(GL_POINTS, {});
  taker.most = 2000;
  taker.recorder.limit(2000, Taker::takeAll, &taker);
  record(taker.recorder, 0, 1500);
  taker.recorder.set(kColor, 1, 0, 0, 1); // this makes vertices larger
  record(taker.recorder, 1500, 5000);
  EXPECT_EQ(taker.calls, 1 + (5000u - 2000 - 1) / 64);
  for (const Told &told : toldOf(taker.recorder))
    taker.taken.push_back(told.number);
  ASSERT_EQ(taker.taken.size(), 5000u);
  for (std::uint32_t i = 0; i < 5000; ++i)
    ASSERT_EQ(taker.taken[i], float(i));
  // The next primitive must have no limit.
  taker.recorder.begin(GL_POINTS, {});
  record(taker.recorder, 0, 5000);
  EXPECT_EQ(taker.recorder.count(), 5000u);
}

TEST(Immediate, AVertexThatIsTakenOverIsNotRecorded) {
  ImmediateRecorder recorder;
  recorder.begin(GL_POINTS, {});
  std::vector<float> others;
  recorder.limit(
      10,
      [](void *owner, const float *position) {
        static_cast<std::vector<float> *>(owner)->push_back(position[0]);
        return false;
      },
      &others);
  record(recorder, 0, 12);
  EXPECT_EQ(recorder.count(), 10u);
  EXPECT_EQ(others, (std::vector<float>{10, 11}));
}

} // namespace
} // namespace arbiter::state
