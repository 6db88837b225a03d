#pragma once
#include "surface.h"

/// Scenes that no careful program draws: nothing may crash, GL's errors are the bare host's, and so
/// are the pictures where they are defined.
namespace software {

inline constexpr int kSide = 64; ///< of the window

struct Hazard {
  const char *name;
  void (*run)();
};
extern const std::vector<Hazard> kVertexHazards, kTextureHazards, kCommandHazards;

/// Errors since the last note, and that the scene came so far.
void note(const std::string &what);
/// A picture that is defined.
void picture(const std::string &what);
/// A fragment program, bound and enabled; `body` without header and END.
void useFragments(const std::string &body);
/// Over the whole window, with the coordinates s0..s1 and t0..t1 of set 0.
void wholeQuad(float s0 = 0, float t0 = 0, float s1 = 1, float t1 = 1);
/// A 2D texture of width x height that differs from texel to texel, bound.
GLuint smoothTexture(int width, int height, GLenum minFilter = GL_NEAREST);

} // namespace software
