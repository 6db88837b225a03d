#include "states.h"

#include <array>

namespace software {

namespace {

void quad(float x0, float y0, float x1, float y1, float z) {
  glBegin(GL_QUADS);
  glVertex3f(x0, y0, z);
  glVertex3f(x1, y0, z);
  glVertex3f(x1, y1, z);
  glVertex3f(x0, y1, z);
  glEnd();
}

void enable(GLenum what, bool on) {
  if (on)
    glEnable(what);
}

} // namespace

void drawBackground() {
  glClearColor(0.25f, 0.5f, 0.75f, 0.5f);
  glClearDepth(0.75);
  glClearStencil(2);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE);
  glStencilFunc(GL_ALWAYS, 5, ~0u);
  glColor4ub(200, 40, 90, 180);
  quad(-1, -1, 0, 0.25f, -0.6f);
  glStencilFunc(GL_ALWAYS, 255, ~0u);
  glColor4ub(30, 220, 130, 60);
  quad(0.25f, -0.5f, 0.8f, 1, 0.1f);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
}

void setRasterState(const Scene &scene) {
  glShadeModel(scene.token("shade"));
  glProvokingVertex(scene.token("provoking"));
  enable(GL_CULL_FACE, scene.choice("cull") != 0);
  if (scene.choice("cull") != 0)
    glCullFace(scene.token("cull"));
  glFrontFace(scene.token("front_face"));
  glPolygonMode(GL_FRONT, scene.token("mode_front"));
  glPolygonMode(GL_BACK, scene.token("mode_back"));
  for (const GLenum mode :
       {GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT})
    enable(mode, scene.choice("offset") != 0);
  glPolygonOffset(-2.0f, -4000.0f);
  glLineWidth(float(scene.number("width")));
  glPointSize(float(scene.number("point_size")));
  enable(GL_LINE_SMOOTH, scene.choice("antialias") != 0);
  enable(GL_POINT_SMOOTH, scene.choice("antialias") != 0);
  enable(GL_POLYGON_SMOOTH, scene.choice("antialias") != 0);
  enable(GL_LINE_STIPPLE, scene.choice("stipple") == 1);
  glLineStipple(2, 0x5b3d);
  enable(GL_POLYGON_STIPPLE, scene.choice("stipple") == 2);
  std::array<GLubyte, 128> stipple{};
  for (std::size_t i = 0; i < stipple.size(); ++i)
    stipple[i] = static_cast<GLubyte>(i * 37 + 11);
  glPolygonStipple(stipple.data());
  enable(GL_SCISSOR_TEST, scene.choice("scissor") != 0);
  glScissor(5, 9, kEdge - 14, kEdge - 12);
  static constexpr int kViewports[3][4] = {
      {0, 0, kEdge, kEdge}, {-9, 6, kEdge + 5, kEdge - 1}, {7, 3, kEdge / 2, kEdge / 3}};
  glViewport(kViewports[scene.choice("viewport")][0], kViewports[scene.choice("viewport")][1],
             kViewports[scene.choice("viewport")][2], kViewports[scene.choice("viewport")][3]);
  static constexpr double kRanges[3][2] = {{0, 1}, {1, 0}, {0.25, 0.7}};
  glDepthRange(kRanges[scene.choice("depth_range")][0], kRanges[scene.choice("depth_range")][1]);
}

void setPixelState(const Scene &scene) {
  enable(GL_ALPHA_TEST, scene.choice("alpha_test") != 0);
  if (scene.choice("alpha_test") != 0)
    glAlphaFunc(scene.token("alpha_test"), 0.45f);
  enable(GL_STENCIL_TEST, scene.choice("stencil") != 0);
  glStencilFunc(scene.token("stencil_func"), 4, 7);
  glStencilOp(scene.token("stencil_fail"), scene.token("stencil_zfail"),
              scene.token("stencil_zpass"));
  if (scene.choice("stencil") == 2) {
    glStencilFuncSeparate(GL_BACK, scene.token("stencil_back_func"), 3, 6);
    glStencilOpSeparate(GL_BACK, scene.token("stencil_zpass"), scene.token("stencil_fail"),
                        scene.token("stencil_back_zpass"));
  }
  glStencilMask(GLuint(scene.choice("stencil_mask")));
  enable(GL_DEPTH_TEST, scene.choice("depth_test") != 0);
  if (scene.choice("depth_test") != 0)
    glDepthFunc(scene.token("depth_test"));
  glDepthMask(GLboolean(scene.choice("depth_mask")));
  enable(GL_BLEND, scene.choice("blend") != 0);
  glBlendFuncSeparate(scene.token("blend_src"), scene.token("blend_dst"),
                      scene.token("blend_src_alpha"), scene.token("blend_dst_alpha"));
  glBlendEquationSeparate(scene.token("equation"), scene.token("equation_alpha"));
  glBlendColor(0.8f, 0.3f, 0.6f, 0.4f);
  enable(GL_FRAMEBUFFER_SRGB, scene.choice("encode") == 1);
  enable(GL_COLOR_LOGIC_OP, scene.choice("logic_op") != 0);
  if (scene.choice("logic_op") != 0)
    glLogicOp(scene.token("logic_op"));
  const int mask = scene.choice("color_mask");
  glColorMask((mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0, (mask & 8) != 0);
}

} // namespace software
