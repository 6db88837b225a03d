#pragma once
#include "surface.h"

/// Scenes that no careful program draws: nothing may crash, and GL's errors and defined pictures
/// must equal the bare host's.
namespace software {

inline constexpr int kSide = 64; ///< of the window

struct Hazard {
  const char *name;
  void (*run)();
};
extern const std::vector<Hazard> kVertexHazards, kTextureHazards, kCommandHazards;

/// Records the errors since the last note, and that the scene got this far.
void note(const std::string &what);
/// Records a defined picture.
void picture(const std::string &what);
/// Makes, binds and enables a fragment program; `body` has no header and END.
void useFragments(const std::string &body);
/// Draws a quad over the whole window, with the coordinates s0..s1 and t0..t1 of set 0.
void wholeQuad(float s0 = 0, float t0 = 0, float s1 = 1, float t1 = 1);
/// Makes and binds a 2D texture of width x height different texels.
GLuint smoothTexture(int width, int height, GLenum minFilter = GL_NEAREST);

} // namespace software
