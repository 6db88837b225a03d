// Changes of objects' content: arrays, buffers, programs; and by lists, queries and other contexts.
#include <cstring>

#include "changes.h"

namespace software {

namespace {

/// Writes all vertices of the buffer, bound to `target`.
void fill(GLenum target, GLuint buffer, float move, bool anew) {
  const auto data = stageVertices(move, 1.0f);
  const auto bytes = GLsizeiptr(data.size() * sizeof data[0]);
  glBindBuffer(target, buffer);
  if (anew)
    glBufferData(target, bytes, data.data(), GL_DYNAMIC_DRAW);
  else
    glBufferSubData(target, 0, bytes, data.data());
}

void mapAndMove(Stage &stage, float move) {
  glBindBuffer(GL_ARRAY_BUFFER, stage.buffer);
  const auto data = stageVertices(move, 1.0f);
  if (void *const memory = glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY)) {
    std::memcpy(memory, data.data(), data.size() * sizeof data[0]);
    glUnmapBuffer(GL_ARRAY_BUFFER);
  }
}

/// Writes to a persistently mapped buffer that is drawn from, without a command; on a host without
/// such buffers, to the stage's own.
void writeMapped(Stage &stage, float move) {
  if (!epoxy_has_gl_extension("GL_ARB_buffer_storage"))
    return fill(GL_ARRAY_BUFFER, stage.buffer, move, false);
  constexpr GLbitfield kFlags = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  const auto before = stageVertices(move + 0.25f, 0.5f), after = stageVertices(move, 1.0f);
  const auto bytes = GLsizeiptr(before.size() * sizeof before[0]);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferStorage(GL_ARRAY_BUFFER, bytes, before.data(), kFlags);
  void *const memory = glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, kFlags);
  pointArrays(buffer);
  stage.draw();
  stage.draw(); // vertices that are drawn twice may be cached
  std::memcpy(memory, after.data(), std::size_t(bytes));
}

/// Returns the application's memory, which changes without a command.
std::vector<StageVertex> &clientMemory() {
  static std::vector<StageVertex> s_memory = stageVertices(0.0f, 1.0f);
  return s_memory;
}

void pointAtClient(float move) {
  const auto data = stageVertices(move, 1.0f);
  std::copy(data.begin(), data.end(), clientMemory().begin());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glVertexPointer(4, GL_FLOAT, sizeof(StageVertex), clientMemory()[0].position);
}

/// Packs pixels into the buffer of positions, so that they become vertices.
void packPixels(Stage &stage, bool packed) {
  fill(GL_ARRAY_BUFFER, stage.buffer, 0.0f, false);
  if (!packed)
    return;
  glDrawArrays(GL_TRIANGLES, 0, 18); // the layer has drawn from it in between
  glDrawArrays(GL_TRIANGLES, 0, 18);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, stage.buffer);
  glReadPixels(20, 20, 1, 1, GL_RGBA, GL_FLOAT, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void copyBuffer(Stage &stage, GLuint from) {
  glBindBuffer(GL_COPY_READ_BUFFER, from);
  glBindBuffer(GL_COPY_WRITE_BUFFER, stage.buffer);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, 18 * sizeof(StageVertex));
}

/// Runs `what` in another context of the group, and returns.
void elsewhere(Stage &stage, void (*what)(Stage &)) {
  if (!stage.other)
    stage.other = stage.screen->makeContext(stage.context);
  stage.screen->makeCurrent(stage.window, stage.other);
  what(stage);
  stage.screen->makeCurrent(stage.window, stage.context);
}

void inList(Stage &stage, bool masked) {
  glNewList(stage.list, GL_COMPILE);
  glColorMask(GL_TRUE, masked ? GL_FALSE : GL_TRUE, GL_TRUE, GL_TRUE);
  glColor4f(0.9f, masked ? 0.1f : 0.7f, 0.8f, 0.75f);
  glEndList();
  glCallList(stage.list);
}

} // namespace

const std::vector<Change> kObjectChanges = {
    {"BufferSubData", kAllForms, 0, [](Stage &s) { fill(GL_ARRAY_BUFFER, s.buffer, 0.1f, false); },
     [](Stage &s) { fill(GL_ARRAY_BUFFER, s.buffer, 0.0f, false); }},
    {"a persistent mapping", kAllForms, 0, [](Stage &s) { writeMapped(s, 0.1f); },
     [](Stage &s) { pointArrays(s.buffer); }},
    {"BufferData", kAllForms, 0, [](Stage &s) { fill(GL_ARRAY_BUFFER, s.buffer, 0.1f, true); },
     [](Stage &s) { fill(GL_ARRAY_BUFFER, s.buffer, 0.0f, true); }},
    {"BufferData by another target", kAllForms, 0,
     [](Stage &s) {
       fill(GL_PIXEL_UNPACK_BUFFER, s.buffer, 0.1f, true);
       glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
     },
     [](Stage &s) {
       fill(GL_PIXEL_UNPACK_BUFFER, s.buffer, 0.0f, true);
       glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
     }},
    {"MapBuffer", kAllForms, 0, [](Stage &s) { mapAndMove(s, 0.1f); },
     [](Stage &s) { mapAndMove(s, 0.0f); }},
    {"CopyBufferSubData", kAllForms, 0, [](Stage &s) { copyBuffer(s, s.otherBuffer); },
     [](Stage &s) { fill(GL_ARRAY_BUFFER, s.buffer, 0.0f, false); }},
    {"ReadPixels to a buffer", kAllForms, 0, [](Stage &s) { packPixels(s, true); },
     [](Stage &s) { packPixels(s, false); }},
    {"VertexPointer", kAllForms, 0, [](Stage &s) { pointArrays(s.otherBuffer); },
     [](Stage &s) { pointArrays(s.buffer); }},
    {"client memory", kAllForms, 0, [](Stage &) { pointAtClient(0.1f); },
     [](Stage &) { pointAtClient(0.0f); }},
    {"client memory, without a command", kAllForms, 0,
     [](Stage &s) {
       pointAtClient(0.0f);
       s.draw();
       s.draw();
       const auto data = stageVertices(0.1f, 1.0f);
       std::copy(data.begin(), data.end(), clientMemory().begin());
     },
     [](Stage &s) { pointArrays(s.buffer); }},
    {"colour array", kAllForms & ~unsigned(Form::FixedVertices), 0,
     [](Stage &) { glEnableClientState(GL_COLOR_ARRAY); },
     [](Stage &) {
       glDisableClientState(GL_COLOR_ARRAY);
       glColor4f(0.9f, 0.7f, 0.8f, 0.75f);
     }},
    {"arrays popped", kAllForms, 0,
     [](Stage &s) {
       glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
       pointArrays(s.otherBuffer);
       s.draw();
       glPopClientAttrib();
       glDisableClientState(GL_TEXTURE_COORD_ARRAY);
     },
     [](Stage &) { glEnableClientState(GL_TEXTURE_COORD_ARRAY); }},
    {"a list", kAllForms, 0, [](Stage &s) { inList(s, true); }, [](Stage &s) { inList(s, false); }},
    {"a query", kAllForms, 0,
     [](Stage &s) {
       glBeginQuery(GL_SAMPLES_PASSED, s.query);
       glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
     },
     [](Stage &) {
       glEndQuery(GL_SAMPLES_PASSED);
       glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
     }},
    {"a clear under a condition", kAllForms, 0,
     [](Stage &s) {
       s.draw();
       glBeginQuery(GL_SAMPLES_PASSED, s.query);
       glEndQuery(GL_SAMPLES_PASSED); // no sample passed
       glClearColor(1.0f, 0.5f, 0.0f, 1.0f);
       glEnable(GL_SCISSOR_TEST);
       glScissor(0, 0, 8, 8);
       glClear(GL_COLOR_BUFFER_BIT); // this one is visible
       glDisable(GL_SCISSOR_TEST);
       glBeginConditionalRender(s.query, GL_QUERY_WAIT);
       glClear(GL_COLOR_BUFFER_BIT);
       glEndConditionalRender();
     },
     [](Stage &) { glClearColor(0.2f, 0.1f, 0.4f, 1.0f); }},
    {"a buffer, by another context", kAllForms, 0,
     [](Stage &s) { elsewhere(s, [](Stage &o) { fill(GL_ARRAY_BUFFER, o.buffer, 0.1f, false); }); },
     [](Stage &s) {
       elsewhere(s, [](Stage &o) { fill(GL_ARRAY_BUFFER, o.buffer, 0.0f, false); });
     }},
    {"a texture, by another context", kAllForms, 0,
     [](Stage &s) {
       elsewhere(s, [](Stage &o) {
         const std::vector<unsigned char> bytes(256, 240);
         glBindTexture(GL_TEXTURE_2D, o.textures[0]);
         glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
       });
       glBindTexture(GL_TEXTURE_2D, s.textures[0]);
     },
     [](Stage &s) {
       elsewhere(s, [](Stage &o) {
         glBindTexture(GL_TEXTURE_2D, o.textures[0]);
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
       });
       glBindTexture(GL_TEXTURE_2D, s.textures[0]);
     }},
};

} // namespace software
