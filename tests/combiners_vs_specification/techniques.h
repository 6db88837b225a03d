#pragma once
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include <epoxy/gl.h>

/// Techniques of games of 2002 with register combiners, and the equivalent programs of their ARB
/// paths.
namespace techniques {

inline constexpr int kSize = 256; ///< pixels on a side

using Picture = std::vector<std::uint8_t>;

/// A technique: its textures, which stay bound, and both ways to shade what it draws.
struct Technique {
  const char *name;
  void (*makeTextures)();
  void (*byCombiners)();
  void (*byProgram)();
  void (*draw)();
};
/// A glow: the sum of four equally weighted taps of a rectangle texture.
extern const Technique kGlow;
/// Bump mapping: normalisation cube maps, a specular term that a square and a bias sharpen, an
/// attenuation.
extern const Technique kBumps;

// --- Shorthands of both ---

[[nodiscard]] inline std::uint8_t byteOf(float value) {
  return std::uint8_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

inline void bindNew(GLenum target, GLint filter) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(target, name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
}

inline void input(GLenum stage, GLenum variable, GLenum source,
                  GLenum mapping = GL_UNSIGNED_IDENTITY_NV, GLenum usage = GL_RGB) {
  glCombinerInputNV(stage, GL_RGB, variable, source, mapping, usage);
}
inline void noAlpha(GLenum stage) {
  glCombinerOutputNV(stage, GL_ALPHA, GL_DISCARD_NV, GL_DISCARD_NV, GL_DISCARD_NV, GL_NONE, GL_NONE,
                     GL_FALSE, GL_FALSE, GL_FALSE);
}
inline void final(GLenum variable, GLenum source, GLenum mapping = GL_UNSIGNED_IDENTITY_NV,
                  GLenum usage = GL_RGB) {
  glFinalCombinerInputNV(variable, source, mapping, usage);
}
inline void opaque() { final(GL_VARIABLE_G_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV, GL_ALPHA); }

inline void useProgram(const char *text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(strlen(text)),
                     text);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
}

} // namespace techniques
