// Checks where frames end, and which of them count as whole frames of the rasterizer.
#include "state/context/context.h"
#include "state/raster_draw/frames/frame.h"

#include <gtest/gtest.h>

#include "host/handlers.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/residency/residency.h"
#include "state/testing/real_host.h"

namespace arbiter::state {
namespace {

using testing::RealHost;

constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;

class Frame : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(m_host.valid());
    Drawable drawable;
    drawable.kind = Drawable::Kind::Memory;
    drawable.width = drawable.height = 64;
    drawable.memoryFormat = GL_RGBA;
    drawable.memoryType = GL_UNSIGNED_BYTE;
    context().drawable = drawable;
    context().software = std::make_unique<ContextState>(context());
    context().dirty = dirty::kAll;
    context().software->residency.enter(context().drawable);
  }
  RasterContext &context() { return m_host.context(); }
  ContextState &state() { return *context().software; }
  const host::HostTable &gl() { return m_host.gl(); }
  void clear(GLbitfield mask) {
    context().dirty = dirty::kAll; // the test sets state without the layer's entry points
    clearsTarget(context(), mask);
    gl().Clear(mask);
  }
  void drawn() { ++state().drawn; }
  void drawnWithDepths() {
    drawn();
    state().frame.depthsTested = true;
  }
  void drawnByHost() { ++state().frame.hostTurns; }

private:
  RealHost m_host;
};

TEST_F(Frame, ClearingTheSameTargetAgainEndsOne) {
  clear(kBoth);
  drawn();
  EXPECT_FALSE(state().history.wholeFrames);
  clear(kBoth);
  EXPECT_TRUE(state().history.wholeFrames);
  drawn();
  drawnByHost();
  clear(kBoth);
  EXPECT_FALSE(state().history.wholeFrames);
}

TEST_F(Frame, PartsOfClearsEndNone) {
  clear(kBoth);
  drawn();
  clear(GL_DEPTH_BUFFER_BIT);
  clear(GL_COLOR_BUFFER_BIT);
  gl().Enable(GL_SCISSOR_TEST);
  gl().Scissor(0, 0, 32, 64);
  clear(kBoth);
  gl().Disable(GL_SCISSOR_TEST);
  gl().DepthMask(GL_FALSE);
  clear(kBoth);
  gl().DepthMask(GL_TRUE);
  gl().ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  clear(kBoth);
  gl().ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  EXPECT_FALSE(state().history.wholeFrames);
  clear(kBoth);
  EXPECT_TRUE(state().history.wholeFrames);
}

TEST_F(Frame, AnotherTargetIsAPassOfTheSameFrame) {
  clear(kBoth);
  drawnByHost();
  GLuint framebuffer = 0, buffers[2] = {};
  gl().GenFramebuffers(1, &framebuffer);
  const auto genRenderbuffers =
      reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(testing::address("glGenRenderbuffers"));
  const auto storage =
      reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(testing::address("glRenderbufferStorage"));
  genRenderbuffers(2, buffers);
  gl().BindFramebufferEXT(GL_FRAMEBUFFER, framebuffer);
  constexpr GLenum kFormats[] = {GL_RGBA8, GL_DEPTH24_STENCIL8};
  constexpr GLenum kPlaces[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    gl().BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    storage(GL_RENDERBUFFER, kFormats[i], 64, 64);
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, kPlaces[i], GL_RENDERBUFFER, buffers[i]);
  }
  for (int i = 0; i < 3; ++i) {
    drawn();
    clear(kBoth);
    EXPECT_FALSE(state().history.wholeFrames) << "the host's turn was in this frame";
  }
  gl().BindFramebufferEXT(GL_FRAMEBUFFER, 0);
  clear(kBoth);
  EXPECT_FALSE(state().history.wholeFrames);
  drawn();
  clear(kBoth);
  EXPECT_TRUE(state().history.wholeFrames);
}

TEST_F(Frame, ThoseOfFinishAndOfWindowsEndThereAlone) {
  clear(kBoth);
  drawn();
  finishFrame(context());
  EXPECT_TRUE(state().history.wholeFrames);
  drawnByHost();
  clear(kBoth);
  drawn();
  clear(kBoth);
  drawn();
  finishFrame(context());
  EXPECT_FALSE(state().history.wholeFrames);
}

TEST_F(Frame, LacksWhatIsTheHostsForMoreThanItsLook) {
  const auto frame = [&](std::uint64_t turns, std::uint64_t looks) {
    drawn();
    state().frame.hostTurns = turns;
    state().frame.lookTurns = looks;
    finishFrame(context());
    return state().lacked;
  };
  EXPECT_FALSE(frame(0, 0));
  EXPECT_TRUE(frame(1, 0));
  EXPECT_TRUE(frame(3, 2));
  EXPECT_FALSE(frame(2, 2));
  state().history.look = {};
  state().history.look.meets(false);
  EXPECT_FALSE(frame(1, 0)) << "the host would draw looks of the rasterizer's";
}

TEST_F(Frame, MixesInVainWhereLittleIsDrawnBesideTheHost) {
  const auto frame = [&](int drawnHere, int hosts, bool moved) {
    clear(kBoth);
    finishFrame(context());
    state().drawn += std::uint64_t(drawnHere);
    for (int i = 0; i < hosts; ++i)
      state().fellBack(Fallback::Mixed);
    state().frame.hostTurns += hosts != 0 ? 1 : 0;
    if (!moved)
      state().seen.transfers = 0;
    else
      --state().seen.transfers;
    finishFrame(context());
    return state().history.mixesInVain;
  };
  EXPECT_FALSE(frame(1, 40, false)) << "nothing is moved for it";
  EXPECT_FALSE(frame(20, 40, true));
  EXPECT_TRUE(frame(1, 40, true));
  EXPECT_TRUE(frame(0, 41, false)) << "the host draws all of it now";
  EXPECT_FALSE(frame(41, 0, false)) << "a whole one";
  state().habits.drawsPlain = false;
  EXPECT_FALSE(frame(1, 40, true)) << "a program may be worth it";
}

// While machine code is compiled, the host's draws tell nothing about the frame.
TEST_F(Frame, WhatWasNotJudgedSaysNothing) {
  const auto frame = [&](bool unjudged) {
    state().fellBack(unjudged ? Fallback::Compiling : Fallback::Mixed);
    state().frame.unjudged = unjudged;
    finishFrame(context());
  };
  frame(true);
  EXPECT_FALSE(state().history.wholeFrames)
      << "what the host drew may be what the rasterizer lacks";
  frame(false);
  EXPECT_TRUE(state().history.wholeFrames);
  frame(true);
  EXPECT_TRUE(state().history.wholeFrames) << "nor does it end a row of whole ones";
  state().frame.unjudged = true;
  drawnByHost();
  finishFrame(context());
  EXPECT_FALSE(state().history.wholeFrames)
      << "a turn of the host's is one, whatever else was drawn";
}

// A client of control observes this frame, so all of its draws are the host's.
TEST_F(Frame, WhatWasObservedSaysNothing) {
  drawnWithDepths();
  finishFrame(context());
  ASSERT_TRUE(state().history.wholeFrames);
  for (int i = 0; i < 3; ++i) {
    state().fellBack(Fallback::Observed);
    state().frame.observed = true;
    drawnByHost(); // a list of the host's
    finishFrame(context());
    EXPECT_TRUE(state().history.wholeFrames);
    EXPECT_TRUE(state().mayTestDepth()) << "the frame behind it is drawn as those before";
    EXPECT_FALSE(state().frame.observed);
  }
  drawnByHost();
  finishFrame(context());
  EXPECT_FALSE(state().history.wholeFrames) << "the next one is judged again";
}

TEST_F(Frame, NotEachOfAnApplicationsFramesGoesUnjudged) {
  int unjudged = 0;
  for (; state().mayGoUnjudged() && unjudged < 100; ++unjudged) {
    state().fellBack(Fallback::Compiling);
    state().frame.unjudged = true;
    finishFrame(context());
  }
  EXPECT_EQ(unjudged, ContextState::kMaxUnjudged);
  drawn();
  finishFrame(context());
  EXPECT_TRUE(state().mayGoUnjudged());
}

TEST_F(Frame, AnApplicationThatReadsPixelsWaitsForMachineCode) {
  ASSERT_TRUE(state().mayGoUnjudged(true));
  std::uint32_t pixel = 0;
  handlers::ReadPixels(wholeOf(context()), 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_FALSE(state().mayGoUnjudged(true)) << "the next picture may be compared with this one";
  EXPECT_FALSE(state().mayGoUnjudged());
}

// A draw that turns out to be the host's only when it is tried must not make frames alternate.
TEST_F(Frame, TrialsThatFailBecomeRare) {
  int tried = 0, turns = 0;
  bool before = false;
  for (int i = 0; i < 400; ++i) {
    const bool now = state().history.wholeFrames;
    tried += now;
    turns += now && before;
    before = now;
    if (now) {
      drawnWithDepths();
      drawnByHost();
    } else {
      state().fellBack(Fallback::Mixed);
    }
    finishFrame(context());
  }
  EXPECT_EQ(turns, 0);
  EXPECT_GT(tried, 5) << "it is never tried again";
  EXPECT_LT(tried, 14) << "one of two is tried";
}

TEST_F(Frame, TrialsThatHoldForgetThoseThatFailed) {
  const auto frame = [&](bool fails) {
    if (state().history.wholeFrames)
      drawnWithDepths();
    else
      state().fellBack(Fallback::Mixed);
    if (fails)
      drawnByHost();
    finishFrame(context());
  };
  // After each failure, twice as many whole frames are needed, counted from the failed one on.
  for (int needed = 1; needed <= 8; needed *= 2) {
    for (int i = 0; i < needed; ++i) {
      EXPECT_FALSE(state().history.wholeFrames) << needed;
      frame(false);
    }
    EXPECT_TRUE(state().history.wholeFrames) << needed;
    frame(true);
  }
  for (int i = 0; i < 16 + 4; ++i)
    frame(false);
  frame(true);
  frame(false);
  EXPECT_FALSE(state().history.wholeFrames);
  frame(false);
  EXPECT_TRUE(state().history.wholeFrames);
}

TEST_F(Frame, WithoutADrawItSaysNothing) {
  drawnByHost();
  finishFrame(context());
  EXPECT_FALSE(state().history.wholeFrames);
  finishFrame(context());
  EXPECT_FALSE(state().history.wholeFrames);
}

TEST_F(Frame, AContextBeginsWithWhatTheLastOneLearnt) {
  const auto frame = [&](bool whole) {
    clear(kBoth);
    drawn();
    if (!whole)
      drawnByHost();
    clear(kBoth);
  };
  frame(false);
  EXPECT_FALSE(historyOfProcess().wholeFrames);
  frame(true);
  EXPECT_TRUE(historyOfProcess().wholeFrames);
  clear(kBoth);
  EXPECT_TRUE(historyOfProcess().wholeFrames) << "a frame without a draw says nothing";
  state().steady = true;
  frame(false);
  EXPECT_TRUE(historyOfProcess().wholeFrames) << "nor one whose rasterizer is not chosen by it";
}

TEST_F(Frame, WhatIsEngagedLaterBeginsWithIt) {
  for (const bool whole : {true, false}) {
    clear(kBoth);
    drawn();
    if (!whole)
      drawnByHost();
    clear(kBoth);
    context().software.reset();
    context().softwareRefused = false;
    context().offered = context().caps.onProcessor = true;
    engage(context());
    ASSERT_TRUE(context().software);
    EXPECT_EQ(state().history.wholeFrames, whole) << "as the last frame of the process was";
    EXPECT_EQ(state().history.backOff.statistics().trials, 0u);
  }
}

} // namespace
} // namespace arbiter::state
