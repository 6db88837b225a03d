#include "scene.h"

#include <cstdio>
#include <cstring>

#include <GL/osmesa.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include "swrast/testing/canvas.h"

namespace arbiter::raster_test {
namespace {

using swrast::PolygonMode;
using swrast::RasterState;
using swrast::Topology;

GLenum modeOf(PolygonMode mode) {
  return mode == PolygonMode::Point ? GL_POINT : mode == PolygonMode::Line ? GL_LINE : GL_FILL;
}

void setEnabled(GLenum what, bool on) { (on ? glEnable : glDisable)(what); }

void setState(const Scene &scene) {
  const RasterState &state = scene.state;
  glViewport(0, 0, scene.width, scene.height);
  setEnabled(GL_CULL_FACE, state.cullFront || state.cullBack);
  glCullFace(state.cullFront && state.cullBack ? GL_FRONT_AND_BACK
             : state.cullFront                 ? GL_FRONT
                                               : GL_BACK);
  glFrontFace(state.frontIsClockwise ? GL_CW : GL_CCW);
  glPolygonMode(GL_FRONT, modeOf(state.front));
  glPolygonMode(GL_BACK, modeOf(state.back));
  glLineWidth(state.lineWidth);
  glPointSize(state.pointSize);
  setEnabled(GL_LINE_STIPPLE, state.lineStippleFactor != 0);
  glLineStipple(state.lineStippleFactor ? state.lineStippleFactor : 1, state.lineStipple);
  setEnabled(GL_POLYGON_STIPPLE, state.polygonStipple != nullptr);
  if (state.polygonStipple)
    glPolygonStipple(state.polygonStipple);
  setEnabled(GL_POINT_SPRITE, state.spriteInputs != 0);
  setEnabled(GL_DEPTH_CLAMP, state.depthClamp);
  setEnabled(GL_SCISSOR_TEST, !state.clip.empty());
  for (std::size_t i = 0; i < 6; ++i) {
    setEnabled(GLenum(GL_CLIP_PLANE0 + i), i < scene.clipPlanes.size());
    if (i < scene.clipPlanes.size())
      glClipPlane(GLenum(GL_CLIP_PLANE0 + i), scene.clipPlanes[i].data());
  }
  glScissor(state.clip.x, state.clip.y, state.clip.width, state.clip.height);
}

template <typename Function> Function lookUp(const char *name) {
  return reinterpret_cast<Function>(OSMesaGetProcAddress(name));
}

/// Binds a framebuffer object with renderbuffers of that size, including depth. Without depth,
/// llvmpipe does not clip at the sides of the view volume if it knows the color format (Mesa 22.3.6
/// BGRA, 25.0.7 RGBA too). The positions of what is clipped then differ by a fraction of a
/// sub-pixel.
void bindObject(int width, int height) {
  static GLuint object, buffers[2];
  constexpr GLenum kFormats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
  constexpr GLenum kAttachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  if (object == 0) {
    lookUp<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &object);
    lookUp<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(2, buffers);
  }
  lookUp<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, object);
  for (int i = 0; i < 2; ++i) {
    lookUp<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER, buffers[i]);
    lookUp<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage")(GL_RENDERBUFFER, kFormats[i],
                                                                  width, height);
    lookUp<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(
        GL_FRAMEBUFFER, kAttachments[i], GL_RENDERBUFFER, buffers[i]);
  }
}

bool makeCurrent(std::uint8_t *pixels, int width, int height) {
  static const OSMesaContext context = [] {
    const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, 0};
    return OSMesaCreateContextAttribs(attributes, nullptr);
  }();
  return context && OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, width, height);
}

} // namespace

void Scene::add(double x, double y, double w, double z) {
  vertices.push_back(
      {float((x / width * 2 - 1) * w), float((y / height * 2 - 1) * w), float(z * w), float(w)});
}

bool hostCutsLinesAsEdges() {
  static const bool cuts = [] {
    std::uint8_t pixel[4];
    int year = 0, number = 0;
    if (!makeCurrent(pixel, 1, 1))
      return false;
    const auto *const version = reinterpret_cast<const char *>(glGetString(GL_VERSION));
    const char *const mesa = std::strstr(version, "Mesa ");
    return mesa && std::sscanf(mesa, "Mesa %d.%d", &year, &number) == 2 &&
           100 * year + number >= 2302;
  }();
  return cuts;
}

Counts drawByHost(const Scene &scene, Target target) {
  std::vector<std::uint8_t> pixels(std::size_t(scene.width) * std::size_t(scene.height) * 4);
  if (!makeCurrent(pixels.data(), scene.width, scene.height))
    return {};
  if (target == Target::FramebufferObject)
    bindObject(scene.width, scene.height);
  constexpr GLenum kModes[] = {GL_POINTS,     GL_LINES,          GL_LINE_LOOP,    GL_LINE_STRIP,
                               GL_TRIANGLES,  GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                               GL_QUAD_STRIP, GL_POLYGON};
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glColor4f(1 / 255.0f, 0, 0, 0);
  setState(scene);
  glBegin(kModes[int(scene.topology)]);
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    glEdgeFlag(scene.edgeFlags.empty() || scene.edgeFlags[i] ? GL_TRUE : GL_FALSE);
    glVertex4fv(scene.vertices[i].data());
  }
  glEnd();
  glFinish();
  if (target == Target::FramebufferObject) {
    glReadPixels(0, 0, scene.width, scene.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    lookUp<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, 0);
  }
  Counts result(std::size_t(scene.width) * std::size_t(scene.height));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = pixels[4 * i];
  return result;
}

Counts drawByUs(const Scene &scene, Target target, int lanes) {
  swrast::testing::Canvas canvas(scene.width, scene.height);
  if (lanes)
    canvas.useQuads(lanes);
  const RasterState own = canvas.state;
  canvas.state = scene.state;
  canvas.state.upsideDownHeight = target == Target::Window ? scene.height : 0;
  std::copy(own.viewport, own.viewport + 4, canvas.state.viewport);
  canvas.state.clip = scene.state.clip.empty() ? own.clip : intersect(own.clip, scene.state.clip);
  std::vector<float> positions[4];
  for (const std::array<float, 4> &vertex : scene.vertices)
    for (std::size_t c = 0; c < 4; ++c)
      positions[c].push_back(vertex[c]);
  swrast::Vertices vertices;
  vertices.count = std::uint32_t(scene.vertices.size());
  for (int c = 0; c < 4; ++c)
    vertices.position[c] = positions[c].data();
  std::vector<float> distances[6];
  for (std::size_t i = 0; i < scene.clipPlanes.size(); ++i) {
    for (const std::array<float, 4> &vertex : scene.vertices) {
      float distance = 0;
      for (std::size_t c = 0; c < 4; ++c)
        distance += vertex[c] * float(scene.clipPlanes[i][c]);
      distances[i].push_back(distance);
    }
    vertices.clipDistance[i] = distances[i].data();
  }
  if (!scene.edgeFlags.empty())
    vertices.edgeFlags = scene.edgeFlags.data();
  (void)rasterize(canvas.state, canvas.shading, scene.topology, vertices, nullptr, 0,
                  vertices.count);
  return canvas.counts;
}

Difference compare(const Scene &scene, const Counts &host, const Counts &drawn) {
  Difference result;
  for (std::size_t i = 0; i < host.size(); ++i) {
    result.covered += host[i] != 0;
    if (host[i] == drawn[i])
      continue;
    if (++result.pixels <= 6)
      result.text += "(" + std::to_string(i % std::size_t(scene.width)) + ", " +
                     std::to_string(i / std::size_t(scene.width)) + "): host " +
                     std::to_string(host[i]) + ", rasterizer " + std::to_string(drawn[i]) + "; ";
  }
  return result;
}

} // namespace arbiter::raster_test
