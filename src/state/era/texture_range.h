#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/share/texture_ranges.h"

namespace arbiter::state {

class Context;
struct Command;

/// APPLE_texture_range: state of textures that is kept and answered for (share/texture_ranges.h).

[[nodiscard]] constexpr bool isTextureRange(GLenum pname) {
  return pname == GL_TEXTURE_STORAGE_HINT_APPLE || pname == GL_TEXTURE_RANGE_LENGTH_APPLE;
}
/// Whether the layer has the extension here, and `pname` is a parameter of it.
[[nodiscard]] bool hasTextureRange(const Context &context, GLenum pname);

/// TextureRangeAPPLE outside of lists, and what a list has of it: of the bound texture.
void setTextureRange(Context &context, GLenum target, GLsizei length, const void *pointer);
/// TexParameter of one of the parameters; the length alone cannot be set.
void setTextureRangeParameter(Context &context, GLenum target, GLenum pname, GLenum value);
/// The same, of a command of a list.
void executeTextureRange(Context &context, const Command &command);
/// Of the texture that is bound to `target`; false, with INVALID_ENUM raised: there is no such
/// target.
[[nodiscard]] bool getTextureRange(Context &context, GLenum target, TextureRange &range);

/// What PushAttrib of TEXTURE_BIT saves of the textures that are bound.
struct SavedTextureRange {
  GLuint name = 0;
  GLenum target = 0;
  TextureRange range;
};
using SavedTextureRanges = std::vector<SavedTextureRange>;
/// Null where the layer has no such extension.
[[nodiscard]] std::shared_ptr<const SavedTextureRanges> saveTextureRanges(const Context &context);
/// After the host has bound them again.
void restoreTextureRanges(Context &context, const SavedTextureRanges &saved);

} // namespace arbiter::state
