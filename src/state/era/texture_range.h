#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/share/texture_ranges.h"

namespace arbiter::state {

struct CoreContext;
struct Command;

/// APPLE_texture_range: state of textures that the layer keeps and returns
/// (share/texture_ranges.h).

[[nodiscard]] constexpr bool isTextureRange(GLenum pname) {
  return pname == GL_TEXTURE_STORAGE_HINT_APPLE || pname == GL_TEXTURE_RANGE_LENGTH_APPLE;
}
/// True if the layer has the extension here and `pname` is one of its parameters.
[[nodiscard]] bool hasTextureRange(const CoreContext &context, GLenum pname);

/// Executes TextureRangeAPPLE, called or from a list, for the bound texture.
void setTextureRange(CoreContext &context, GLenum target, GLsizei length, const void *pointer);
/// Executes TexParameter for one of the parameters. The length alone cannot be set.
void setTextureRangeParameter(CoreContext &context, GLenum target, GLenum pname, GLenum value);
/// Executes a recorded TextureRangeAPPLE or TexParameter of a list.
void executeTextureRange(CoreContext &context, const Command &command);
/// Gets the range of the texture that is bound to `target`. Returns false and raises INVALID_ENUM
/// if there is no such target.
[[nodiscard]] bool getTextureRange(CoreContext &context, GLenum target, TextureRange &range);

/// A bound texture's range, as PushAttrib of TEXTURE_BIT saves it.
struct SavedTextureRange {
  GLuint name = 0;
  GLenum target = 0;
  TextureRange range;
};
using SavedTextureRanges = std::vector<SavedTextureRange>;
/// Saves the ranges of the bound textures. Returns null without the extension.
[[nodiscard]] std::shared_ptr<const SavedTextureRanges>
saveTextureRanges(const CoreContext &context);
/// Restores the ranges, after the host has bound the textures again.
void restoreTextureRanges(CoreContext &context, const SavedTextureRanges &saved);

} // namespace arbiter::state
