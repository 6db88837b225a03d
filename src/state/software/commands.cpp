#include "state/software/commands.h"

#include "host/host_table.h"
#include "state/software/replay.h"
#include "state/software/residency.h"
#include "state/software/stale.h"

namespace arbiter::state::software {

namespace {

/// Nothing of ours can be concerned: the command is an error, or is compiled, or everything is the
/// host's since the list was begun.
bool isHosts(const Context &context) { return context.insideBeginEnd || context.listMode != 0; }

bool isIndexType(GLenum type) {
  return type == GL_UNSIGNED_INT || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_BYTE;
}

} // namespace

bool draw(Context &context, const DrawCommand &command) {
  if (isHosts(context) || command.mode > GL_POLYGON || command.count <= 0 || command.first < 0 ||
      (command.indexType != 0 && !isIndexType(command.indexType)))
    return false;
  return drawArrays(context, command);
}

bool drawRange(Context &context, GLuint start, GLuint end, const DrawCommand &command) {
  return end >= start && draw(context, command);
}

bool multiDrawArrays(Context &context, GLenum mode, const GLint *first, const GLsizei *count,
                     GLsizei drawCount) {
  if (isHosts(context) || mode > GL_POLYGON || drawCount <= 0 || !first || !count)
    return false;
  for (GLsizei i = 0; i < drawCount; ++i)
    if (first[i] < 0 || count[i] < 0)
      return false;
  for (GLsizei i = 0; i < drawCount; ++i)
    if (count[i] > 0 && !drawArrays(context, {mode, first[i], count[i]}))
      context.host->DrawArrays(mode, first[i], count[i]);
  return true;
}

bool multiDrawElements(Context &context, GLenum mode, const GLsizei *count, GLenum type,
                       const void *const *indices, GLsizei drawCount, const GLint *baseVertices) {
  if (isHosts(context) || mode > GL_POLYGON || drawCount <= 0 || !count || !indices ||
      !isIndexType(type))
    return false;
  for (GLsizei i = 0; i < drawCount; ++i)
    if (count[i] < 0)
      return false;
  for (GLsizei i = 0; i < drawCount; ++i) {
    const GLint base = baseVertices ? baseVertices[i] : 0;
    if (count[i] == 0 || drawArrays(context, {mode, 0, count[i], type, indices[i], base}))
      continue;
    if (baseVertices)
      context.host->DrawElementsBaseVertex(mode, count[i], type, indices[i], base);
    else
      context.host->DrawElements(mode, count[i], type, indices[i]);
  }
  return true;
}

bool rectangle(Context &context, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  if (isHosts(context) || !begin(context, GL_POLYGON))
    return false;
  ImmediateRecorder &to = context.software->recorder;
  to.vertex(x1, y1, 0, 1); // in the order of section 2.10
  to.vertex(x2, y1, 0, 1);
  to.vertex(x2, y2, 0, 1);
  to.vertex(x1, y2, 0, 1);
  end(context);
  return true;
}

void hostReads(Context &context, const char *name) {
  if (!isHosts(context))
    synchronise(context, name);
}

void hostWrites(Context &context, const char *name) {
  if (!isHosts(context))
    hostDraws(context, name);
}

void hostDoesUnknown(Context &context, const char *name) {
  if (!isHosts(context))
    hostDoesAnything(context, name);
}

std::uint32_t staleOf(GLenum cap) {
  switch (cap) {
  case GL_ALPHA_TEST:
  case GL_BLEND:
  case GL_DEPTH_TEST:
  case GL_STENCIL_TEST:
  case GL_COLOR_LOGIC_OP:
  case GL_INDEX_LOGIC_OP:
  case GL_DITHER:
  case GL_MULTISAMPLE:
  case GL_SAMPLE_ALPHA_TO_COVERAGE:
  case GL_SAMPLE_ALPHA_TO_ONE:
  case GL_SAMPLE_COVERAGE:
  case GL_STENCIL_TEST_TWO_SIDE_EXT:
  case GL_DEPTH_BOUNDS_TEST_EXT:
    return stale::kPixelOps;
  case GL_FRAMEBUFFER_SRGB:
    return stale::kPixelOps | stale::kFramebuffer;
  case GL_SCISSOR_TEST:
    return stale::kViewport;
  case GL_CULL_FACE:
  case GL_LINE_SMOOTH:
  case GL_LINE_STIPPLE:
  case GL_POINT_SMOOTH:
  case GL_POLYGON_SMOOTH:
  case GL_POLYGON_STIPPLE:
  case GL_POLYGON_OFFSET_FILL:
  case GL_POLYGON_OFFSET_LINE:
  case GL_POLYGON_OFFSET_POINT:
  case GL_DEPTH_CLAMP:
  case GL_VERTEX_PROGRAM_POINT_SIZE:
  case GL_VERTEX_PROGRAM_TWO_SIDE:
    return stale::kRaster;
  case GL_TEXTURE_1D:
  case GL_TEXTURE_2D:
  case GL_TEXTURE_3D:
  case GL_TEXTURE_CUBE_MAP:
  case GL_TEXTURE_RECTANGLE:
    return stale::kTextureBindings;
  case GL_TEXTURE_GEN_S:
  case GL_TEXTURE_GEN_T:
  case GL_TEXTURE_GEN_R:
  case GL_TEXTURE_GEN_Q:
    return stale::kTexGen;
  case GL_POINT_SPRITE:
    return stale::kTexGen | stale::kRaster;
  case GL_FOG:
    return stale::kFog | stale::kLighting;
  case GL_COLOR_SUM:
    return stale::kFog | stale::kLighting;
  case GL_LIGHTING:
  case GL_COLOR_MATERIAL:
  case GL_LIGHT0:
  case GL_LIGHT1:
  case GL_LIGHT2:
  case GL_LIGHT3:
  case GL_LIGHT4:
  case GL_LIGHT5:
  case GL_LIGHT6:
  case GL_LIGHT7:
    return stale::kLighting;
  case GL_NORMALIZE:
  case GL_RESCALE_NORMAL:
  case GL_CLIP_PLANE0:
  case GL_CLIP_PLANE1:
  case GL_CLIP_PLANE2:
  case GL_CLIP_PLANE3:
  case GL_CLIP_PLANE4:
  case GL_CLIP_PLANE5:
    return stale::kTransform;
  case GL_FRAGMENT_PROGRAM_ARB: // the draw looks at what is in force by itself
    return 0;
  case GL_VERTEX_PROGRAM_ARB:
    return stale::kTransform | stale::kLighting | stale::kTexGen;
  default:
    return stale::kAll;
  }
}

} // namespace arbiter::state::software
