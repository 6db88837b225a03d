// Who has the newest pixels. What is not written yet is the host's: nothing is ever pending.
#include "state/software/residency.h"

#include "state/context.h"

namespace arbiter::state::software {

const DrawTargets *describeTargets(Context &, const char *&reason) {
  reason = "target";
  return nullptr;
}
bool acquireTargets(Context &, const swrast::Rect &, bool, bool) { return false; }
const TextureImages *acquireTexture(Context &, GLuint, abi::Dimension, bool, const char *&reason) {
  reason = "texture";
  return nullptr;
}
bool copyToTexture(Context &, const CopyToTexture &) { return false; }
bool clear(Context &, GLbitfield) { return false; }
bool readPixels(Context &, GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *) { return false; }
bool getTexImage(Context &, GLenum, GLint, GLenum, GLenum, void *) { return false; }
void texSubImage(Context &, GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum,
                 GLenum, const void *) {}
void textureRedefined(Context &, GLenum) {}
void texturesDeleted(Context &, GLsizei, const GLuint *) {}
void synchronise(Context &, const char *) {}
void hostDraws(Context &, const char *) {}
void hostDoesAnything(Context &, const char *) {}
void present(Context &) {}
void leave(Context &) {}
void enter(Context &) {}
void setDrawable(Context &, const Drawable &) {}
void drawableMayHaveChanged(Context &) {}
bool aloneInGroup(const Context &) { return false; }
void flush(Context &) {}
ResidencyStatistics residencyStatistics(const Context &) { return {}; }

} // namespace arbiter::state::software
