// Draws one green pixel repeatedly, like ticker.cpp, by register combiners, texture shaders, or a
// shader made by ATI_fragment_shader's commands. It prints the color as "R G B" whenever it
// changes, and reports queries that do not return what was set.
//
//   state_ticker [KIND [FRAMES]]     KIND: combiners, texture_shaders or ati_fragment_api
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

#include "one_pixel.h"

namespace {

/// Shows a register as color, through a stage whose product is spare0.
void setCombiners(GLenum from) {
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 1);
  glCombinerInputNV(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, from, GL_SIGNED_IDENTITY_NV, GL_RGB);
  glCombinerInputNV(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_B_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV,
                    GL_RGB);
  glCombinerOutputNV(GL_COMBINER0_NV, GL_RGB, GL_SPARE0_NV, GL_DISCARD_NV, GL_DISCARD_NV, GL_NONE,
                     GL_NONE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (GLenum v = GL_VARIABLE_A_NV; v <= GL_VARIABLE_C_NV; ++v)
    glFinalCombinerInputNV(v, GL_ZERO, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  glFinalCombinerInputNV(GL_VARIABLE_D_NV, GL_SPARE0_NV, GL_UNSIGNED_IDENTITY_NV, GL_RGB);
  glFinalCombinerInputNV(GL_VARIABLE_G_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV, GL_ALPHA);
  glEnable(GL_REGISTER_COMBINERS_NV);
}

bool isAsSet(GLenum from) {
  GLint input = 0, stages = 0;
  glGetCombinerInputParameterivNV(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_COMBINER_INPUT_NV,
                                  &input);
  glGetIntegerv(GL_NUM_GENERAL_COMBINERS_NV, &stages);
  return GLenum(input) == from && stages == 1 && glGetError() == GL_NO_ERROR;
}

/// The state that draws. Its constant has one value during draws and another between them.
struct Kind {
  const char *name;
  void (*set)();
  void (*setConstant)(const GLfloat *color);
  bool (*isAsSet)();
};

void setCombinerConstant(const GLfloat *color) {
  glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, color);
}

/// Shows the context's first constant as color.
void setShader() {
  glBindFragmentShaderATI(glGenFragmentShadersATI(1));
  glBeginFragmentShaderATI();
  glColorFragmentOp1ATI(GL_MOV_ATI, GL_REG_0_ATI, GL_NONE, GL_NONE, GL_CON_0_ATI, GL_NONE, GL_NONE);
  glAlphaFragmentOp1ATI(GL_MOV_ATI, GL_REG_0_ATI, GL_NONE, GL_ONE, GL_NONE, GL_NONE);
  glEndFragmentShaderATI();
  glEnable(GL_FRAGMENT_SHADER_ATI);
}

void setShaderConstant(const GLfloat *color) {
  glSetFragmentShaderConstantATI(GL_CON_0_ATI, color);
}

bool isShaderAsSet() {
  GLint constants = 0;
  glGetIntegerv(GL_NUM_FRAGMENT_CONSTANTS_ATI, &constants);
  return constants == 8 && glIsEnabled(GL_FRAGMENT_SHADER_ATI) == GL_TRUE &&
         glGetError() == GL_NO_ERROR;
}

const Kind kKinds[] = {
    {"combiners", [] { setCombiners(GL_CONSTANT_COLOR0_NV); }, setCombinerConstant,
     [] { return isAsSet(GL_CONSTANT_COLOR0_NV); }},
    {"texture_shaders",
     [] {
       setCombiners(GL_TEXTURE0);
       glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, GL_PASS_THROUGH_NV);
       glEnable(GL_TEXTURE_SHADER_NV);
     },
     setCombinerConstant, [] { return isAsSet(GL_TEXTURE0); }},
    {"ati_fragment_api", setShader, setShaderConstant, isShaderAsSet},
};

bool offers(const Kind &kind) {
  if (&kind == &kKinds[2])
    return epoxy_has_gl_extension("GL_ATI_fragment_shader");
  return epoxy_has_gl_extension("GL_NV_register_combiners") &&
         (&kind == &kKinds[0] || epoxy_has_gl_extension("GL_NV_texture_shader"));
}

void tick(const Kind &kind, long frames) {
  std::array<unsigned char, 4> last{1, 2, 3, 4};
  for (long frame = 0; frame != frames; ++frame) {
    const GLfloat green[] = {0, 1, 0, 1}, other[] = {GLfloat(frame % 2), 0, 1, 1};
    kind.setConstant(green);
    glMultiTexCoord4fv(GL_TEXTURE0, green);
    glRectf(-1, -1, 1, 1);
    kind.setConstant(other); // no draw uses it
    std::array<unsigned char, 4> color{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    if (color != last)
      std::printf("%d %d %d\n", color[0], color[1], color[2]);
    if (!kind.isAsSet())
      std::puts("unlike what was set");
    std::fflush(stdout);
    last = color;
    if (frames < 0)
      usleep(10000);
  }
}

} // namespace

int main(int argc, char **argv) {
  const Kind *kind = kKinds;
  for (const Kind &each : kKinds)
    if (argc > 1 && std::strcmp(argv[1], each.name) == 0)
      kind = &each;
  if (!makeContext() || !offers(*kind)) {
    std::puts("no such context");
    return 1;
  }
  makeTarget();
  kind->set();
  tick(*kind, argc > 2 ? std::atol(argv[2]) : -1);
  return 0;
}
