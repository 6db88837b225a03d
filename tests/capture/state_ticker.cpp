// As ticker.cpp, of register combiners and texture shaders: draws one green pixel again and again
// by their state and prints its colour as "R G B" whenever it changed, and says so where a query
// does not answer what was set.
//
//   state_ticker [KIND [FRAMES]]     KIND: combiners or texture-shaders
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

#include "one_pixel.h"

namespace {

/// The register as colour, through a stage whose product is spare0.
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

void tick(GLenum from, long frames) {
  std::array<unsigned char, 4> last{1, 2, 3, 4};
  for (long frame = 0; frame != frames; ++frame) {
    const GLfloat green[] = {0, 1, 0, 1}, other[] = {GLfloat(frame % 2), 0, 1, 1};
    glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, green);
    glMultiTexCoord4fv(GL_TEXTURE0, green);
    glRectf(-1, -1, 1, 1);
    glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, other); // of no draw
    std::array<unsigned char, 4> colour{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, colour.data());
    if (colour != last)
      std::printf("%d %d %d\n", colour[0], colour[1], colour[2]);
    if (!isAsSet(from))
      std::puts("unlike what was set");
    std::fflush(stdout);
    last = colour;
    if (frames < 0)
      usleep(10000);
  }
}

} // namespace

int main(int argc, char **argv) {
  const bool shaders = argc > 1 && std::strcmp(argv[1], "texture-shaders") == 0;
  if (!makeContext() || !epoxy_has_gl_extension("GL_NV_register_combiners") ||
      (shaders && !epoxy_has_gl_extension("GL_NV_texture_shader"))) {
    std::puts("no such context");
    return 1;
  }
  makeTarget();
  const GLenum from = shaders ? GL_TEXTURE0 : GL_CONSTANT_COLOR0_NV;
  setCombiners(from);
  if (shaders) {
    glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, GL_PASS_THROUGH_NV);
    glEnable(GL_TEXTURE_SHADER_NV);
  }
  tick(from, argc > 2 ? std::atol(argv[2]) : -1);
  return 0;
}
