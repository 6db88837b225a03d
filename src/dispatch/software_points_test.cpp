/// The entry points that exist for the rasterizer: which dirty bits they set and which commands
/// they record. If a command cannot be recorded, the host gets the whole primitive first.
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include <sys/mman.h>

#include <gtest/gtest.h>

#include "dispatch/entry_points.h"
#include "host/lazy_functions.h"
#include "state/context/context.h"
#include "state/lifecycle/lifecycle.h"
#include "state/mirror/convert.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/testing/current_context.h"
#include "state/testing/fake_host.h"

namespace arbiter::dispatch {
namespace {

namespace dirty = state::dirty;
using state::normalized;

std::vector<std::string> g_calls;
int g_lookups = 0;

void note(const std::string &call) { g_calls.push_back(call); }
std::string number(float value) {
  char text[32];
  std::snprintf(text, sizeof text, " %g", double(value));
  return text;
}

void hostBegin(GLenum mode) { note("Begin " + std::to_string(mode)); }
void hostEnd() { note("End"); }
void hostVertex2fv(const GLfloat *v) { note("Vertex2" + number(v[0]) + number(v[1])); }
void hostVertex4fv(const GLfloat *v) { note("Vertex4" + number(v[0]) + number(v[3])); }
void hostColor3fv(const GLfloat *v) { note("Color3" + number(v[0])); }
void hostColor4fv(const GLfloat *v) { note("Color4" + number(v[0])); }
void hostMultiTexCoord2fv(GLenum unit, const GLfloat *v) {
  note("TexCoord2 " + std::to_string(unit - GL_TEXTURE0) + number(v[0]));
}
void hostBlendFunc(GLenum source, GLenum) { note("BlendFunc " + std::to_string(source)); }
void hostEvalCoord1f(GLfloat u) { note("EvalCoord" + number(u)); }
void hostColor3f(GLfloat r, GLfloat, GLfloat) { note("Color3f" + number(r)); }

void *lookup(const char *name) {
  ++g_lookups;
  if (std::strcmp(name, "glBlendFunc") == 0)
    return reinterpret_cast<void *>(hostBlendFunc);
  if (std::strcmp(name, "glColor3f") == 0)
    return reinterpret_cast<void *>(hostColor3f);
  return nullptr;
}

template <typename Function> Function *entry(const char *name) {
  void *const function = find(name).function ? find(name).function : findForSoftware(name).function;
  return reinterpret_cast<Function *>(function);
}

class SoftwarePoints : public testing::Test {
protected:
  void SetUp() override {
    g_calls.clear();
    g_lookups = 0;
    m_table = *m_fake.table();
    m_table.lookup = lookup;
    m_table.Begin = hostBegin;
    m_table.EvalCoord1f = hostEvalCoord1f;
    m_table.End = hostEnd;
    m_table.Vertex2fv = hostVertex2fv;
    m_table.Vertex4fv = hostVertex4fv;
    m_table.Color3fv = hostColor3fv;
    m_table.Color4fv = hostColor4fv;
    m_table.MultiTexCoord2fv = hostMultiTexCoord2fv;
    m_context = state::createContext(state::Provider::Egl, &m_table, nullptr);
    state::makeCurrent(m_context);
    m_context->dirty = 0;
  }
  void TearDown() override {
    state::makeCurrent(nullptr);
    state::destroyContext(m_context);
  }
  /// Starts recording, as handlers::Begin does if the rasterizer takes the primitive.
  void record(GLenum mode) {
    m_context->software = std::make_unique<state::ContextState>(*m_context);
    m_context->softwarePossible = m_context->softwareListens = true;
    m_context->software->recorder.begin(mode, m_context->software->mirror.current);
    state::startRecording(*m_context);
  }

  state::testing::FakeHost m_fake;
  host::HostTable m_table;
  state::Context *m_context = nullptr;
};

TEST_F(SoftwarePoints, StateIsNotedAndPassedOn) {
  entry<void(GLenum, GLenum)>("glBlendFunc")(GL_ONE, GL_ZERO);
  entry<void(GLenum, GLenum)>("glBlendFunc")(GL_ZERO, GL_ZERO);
  EXPECT_EQ(m_context->dirty, dirty::kPixelOps);
  EXPECT_EQ(g_calls, (std::vector<std::string>{"BlendFunc 1", "BlendFunc 0"}));
  EXPECT_EQ(g_lookups, 1) << "the host's function is looked for once";
}

TEST_F(SoftwarePoints, AFunctionThatTheHostLacksDoesNothing) {
  entry<void(GLfloat)>("glPointSize")(2.0f);
  entry<void(GLfloat)>("glPointSize")(2.0f);
  EXPECT_EQ(m_context->dirty, dirty::kRaster | dirty::kProgramState);
  EXPECT_TRUE(g_calls.empty());
}

TEST_F(SoftwarePoints, WhatMovesTheRasterPositionIsNoted) {
  entry<void(GLfloat, GLfloat)>("glRasterPos2f")(1, 0);
  EXPECT_EQ(m_context->dirty, dirty::kRasterPosition);
  m_context->dirty = 0;
  entry<void(GLfloat, GLfloat)>("glWindowPos2fMESA")(1, 0);
  EXPECT_EQ(m_context->dirty, dirty::kRasterPosition);
  m_context->dirty = 0;
  entry<void(GLsizei, GLsizei, GLfloat, GLfloat, GLfloat, GLfloat, const GLubyte *)>("glBitmap")(
      0, 0, 0, 0, 1, 0, nullptr);
  EXPECT_EQ(m_context->dirty, dirty::kRasterPosition);
}

/// A command that reads pixels may compare them, even if the host drew them. A command that only
/// waits does not.
TEST_F(SoftwarePoints, WhatReadsPixelsIsNoted) {
  record(GL_POINTS);
  state::stopRecording(*m_context);
  m_context->insideBeginEnd = false;
  entry<GLsync(GLenum, GLbitfield)>("glFenceSync")(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  EXPECT_FALSE(m_context->software->habits.readsPixels);
  entry<void(GLuint, GLint, GLenum, GLenum, GLsizei, void *)>("glGetTextureImage")(
      0, 0, GL_RGBA, GL_FLOAT, 0, nullptr);
  EXPECT_TRUE(m_context->software->habits.readsPixels);
}

TEST_F(SoftwarePoints, AnUnknownCommandMakesEverythingOld) {
  entry<void(GLenum)>("glPixelTexGenSGIX")(0);
  EXPECT_EQ(m_context->dirty, dirty::kAll);
}

TEST_F(SoftwarePoints, AttributesGoToTheHostWhereNothingIsRecorded) {
  entry<void(GLfloat, GLfloat, GLfloat)>("glColor3f")(0.5f, 0, 0);
  EXPECT_EQ(m_context->dirty, dirty::kCurrent);
  EXPECT_EQ(g_calls, (std::vector<std::string>{"Color3f 0.5"}));
}

TEST_F(SoftwarePoints, APrimitiveIsRecordedWithoutACall) {
  record(GL_TRIANGLES);
  entry<void(GLfloat, GLfloat)>("glVertex2f")(1, 2);
  entry<void(GLubyte, GLubyte, GLubyte, GLubyte)>("glColor4ub")(255, 0, 51, 0);
  entry<void(GLenum, GLfloat, GLfloat)>("glMultiTexCoord2f")(GL_TEXTURE3, 7, 8);
  entry<void(GLuint, GLfloat, GLfloat, GLfloat)>("glVertexAttrib3f")(0, 3, 4, 5);
  EXPECT_TRUE(g_calls.empty());
  state::stopRecording(*m_context);
  EXPECT_EQ(m_context->host, &m_table);

  using namespace state;
  const VertexSource source = m_context->software->recorder.end();
  EXPECT_EQ(source.count, 2u);
  const auto at = [&](int slot, int vertex) {
    const VertexSource::Array &array = source.arrays[std::size_t(slot)];
    return reinterpret_cast<const float *>(static_cast<const char *>(array.base) +
                                           std::size_t(vertex) * array.stride);
  };
  EXPECT_EQ(std::vector<float>(at(kPosition, 0), at(kPosition, 0) + 4),
            (std::vector<float>{1, 2, 0, 1}));
  EXPECT_EQ(std::vector<float>(at(kPosition, 1), at(kPosition, 1) + 4),
            (std::vector<float>{3, 4, 5, 1}));
  EXPECT_EQ(at(kColor, 0)[0], 0.0f) << "what was current at Begin";
  EXPECT_EQ(at(kColor, 1)[0], 1.0f);
  EXPECT_EQ(at(kColor, 1)[2], normalized(GLubyte(51)));
  EXPECT_EQ(at(kTexCoord0 + 3, 1)[1], 8.0f);
  EXPECT_EQ(source.arrays[kNormal].base, nullptr);
}

TEST_F(SoftwarePoints, ACommandThatAPrimitiveCannotTakeGivesItToTheHost) {
  record(GL_LINES);
  entry<void(GLfloat, GLfloat)>("glVertex2f")(1, 0);
  entry<void(GLfloat, GLfloat, GLfloat)>("glColor3f")(0.25f, 0, 0);
  entry<void(GLfloat)>("glEvalCoord1f")(6);
  const std::vector<std::string> wanted = {"Begin 1", "Vertex2 1 0", "Color3 0.25", "EvalCoord 6"};
  EXPECT_EQ(g_calls, wanted);
  EXPECT_EQ(m_context->recorder, nullptr);
  EXPECT_TRUE(m_context->insideBeginEnd);
  // The host gets the commands that follow.
  entry<void(GLfloat, GLfloat, GLfloat)>("glColor3f")(0.75f, 0, 0);
  entry<void()>("glEnd")();
  EXPECT_EQ(g_calls.back(), "End");
  EXPECT_EQ(g_calls[g_calls.size() - 2], "Color3f 0.75");
  EXPECT_FALSE(m_context->insideBeginEnd);
}

/// Hosts compile vertex code for the number of components that they are given.
TEST_F(SoftwarePoints, TheHostGetsAsManyComponentsAsThePrimitiveWasGiven) {
  record(GL_LINES);
  entry<void(GLenum, GLfloat, GLfloat)>("glMultiTexCoord2f")(GL_TEXTURE3, 7, 8);
  entry<void(GLfloat, GLfloat, GLfloat)>("glColor3f")(0.25f, 0, 0);
  entry<void(GLfloat, GLfloat)>("glVertex2f")(1, 0);
  entry<void(GLubyte, GLubyte, GLubyte, GLubyte)>("glColor4ub")(255, 0, 51, 255);
  entry<void(GLfloat, GLfloat, GLfloat, GLfloat)>("glVertex4f")(2, 0, 0, 1);
  entry<void(GLfloat)>("glEvalCoord1f")(6);
  // All vertices of a primitive have one size, which is the largest.
  const std::vector<std::string> wanted = {
      "Begin 1",  "TexCoord2 3 7", "Color4 0.25", "Vertex4 1 1",   "TexCoord2 3 7",
      "Color4 1", "Vertex4 2 1",   "Color4 1",    "TexCoord2 3 7", "EvalCoord 6"};
  EXPECT_EQ(g_calls, wanted);
}

TEST_F(SoftwarePoints, ACommandOfTheLayersOwnDoesSoToo) {
  record(GL_POINTS);
  entry<void(GLfloat, GLfloat)>("glVertex2f")(1, 0);
  entry<GLenum()>("glGetError")(); // the host raises an error here
  ASSERT_EQ(g_calls.size(), 2u);
  EXPECT_EQ(g_calls[0], "Begin 0");
  EXPECT_EQ(g_calls[1], "Vertex2 1 0");
  EXPECT_EQ(m_context->host, &m_table);
}

/// State set between Begin and End is an error (OpenGL 2.1, 2.6.3), and the primitive continues.
TEST_F(SoftwarePoints, AnErrorBetweenBeginAndEndLeavesThePrimitiveRecorded) {
  record(GL_LINES);
  entry<void(GLfloat, GLfloat)>("glVertex2f")(1, 0);
  entry<void(GLenum, GLenum)>("glBlendFunc")(GL_ONE, GL_ZERO);
  entry<void(GLenum)>("glBegin")(GL_LINES);
  EXPECT_TRUE(g_calls.empty()) << "neither the command nor the primitive went to the host";
  EXPECT_EQ(m_context->errors.pending, GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(m_context->dirty, 0u) << "no state has changed";
  EXPECT_TRUE(m_context->insideBeginEnd);
  EXPECT_EQ(m_context->recorder->count(), 1u);
}

TEST_F(SoftwarePoints, TheHostTellsOfTheErrorWhereItsMessagesAreListenedTo) {
  m_fake.enabled.insert(GL_DEBUG_OUTPUT);
  record(GL_LINES);
  entry<void(GLfloat, GLfloat)>("glVertex2f")(1, 0);
  entry<void(GLenum, GLenum)>("glBlendFunc")(GL_ONE, GL_ZERO);
  EXPECT_EQ(g_calls, (std::vector<std::string>{"Begin 1", "Vertex2 1 0", "BlendFunc 1"}));
  EXPECT_EQ(m_context->errors.pending, GLenum(GL_NO_ERROR));
  EXPECT_EQ(m_context->recorder, nullptr);
}

TEST_F(SoftwarePoints, AVeryLongPrimitiveIsKeptWhole) {
  record(GL_POINTS);
  auto *const vertex = entry<void(GLfloat, GLfloat)>("glVertex2f");
  auto *const texture = entry<void(GLfloat, GLfloat)>("glTexCoord2f");
  constexpr int kVertices = 100000;
  for (int i = 0; i < kVertices; ++i) {
    if (i >= 50000)
      texture(float(i), 0);
    vertex(float(i), 0);
  }
  const state::ImmediateRecorder &recorder = m_context->software->recorder;
  ASSERT_EQ(recorder.count(), unsigned(kVertices));
  EXPECT_FALSE(recorder.failed());
  for (const int i : {0, 49999, 50000, kVertices - 1})
    recorder.read(unsigned(i), [&](int slot, const float *value) {
      const bool set = slot == state::kPosition || i >= 50000;
      EXPECT_EQ(value[0], set ? float(i) : 0.0f) << "slot " << slot;
    });
}

TEST(Convert, FollowsTheTable) {
  EXPECT_EQ(normalized(GLubyte(255)), 1.0f);
  EXPECT_EQ(normalized(GLbyte(127)), 1.0f);
  EXPECT_EQ(normalized(GLbyte(-128)), -1.0f);
  EXPECT_EQ(normalized(GLbyte(0)), 1.0f / 255.0f);
  EXPECT_EQ(normalized(GLushort(65535)), 1.0f);
  EXPECT_EQ(normalized(GLint(-2147483647 - 1)), -1.0f);
  EXPECT_EQ(normalized(GLuint(4294967295u)), 1.0f);
}

/// A display list being compiled has many such calls.
TEST(LazyCall, ATableThatStandsInWritesNothingOnceTheFunctionIsKnown) {
  using host::HostTable;
  static HostTable *table = nullptr;
  void *const pages =
      mmap(nullptr, sizeof(HostTable), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(pages, MAP_FAILED);
  table = new (pages) HostTable;
  table->lookup = lookup;
  void *const known = reinterpret_cast<void *>(hostBlendFunc);
  table->lazy[0] = known;
  ASSERT_EQ(mprotect(pages, sizeof(HostTable), PROT_READ), 0);
  HostTable standsIn;
  standsIn.instead = [] { return static_cast<const HostTable *>(table); };
  EXPECT_EQ(host::LazyCall(standsIn, 0).function(), known);
  munmap(pages, sizeof(HostTable));
}

} // namespace
} // namespace arbiter::dispatch
