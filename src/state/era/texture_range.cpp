#include "state/era/texture_range.h"

#include <algorithm>
#include <cstring>

#include "host/host_table.h"
#include "state/core/core_context.h"
#include "state/core/errors.h"
#include "state/core/unit_scope.h"
#include "state/era/era_state.h"
#include "state/objects/display_list.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

struct TextureTarget {
  GLenum target, binding;
};
constexpr TextureTarget kTargets[] = {
    {GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D},
    {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
    {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
    {GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE},
};

bool isThere(const CoreContext &context, const TextureTarget &target) {
  return target.target != GL_TEXTURE_RECTANGLE || context.caps.textureRectangle;
}

TextureRanges::Key boundTo(const CoreContext &context, const TextureTarget &target) {
  GLint name = 0;
  context.host->GetIntegerv(target.binding, &name);
  return {GLuint(name), target.target};
}

/// Returns the row of a target. Raises INVALID_ENUM and returns null if there is none.
const TextureTarget *targetOf(CoreContext &context, GLenum name) {
  for (const TextureTarget &target : kTargets)
    if (target.target == name && isThere(context, target))
      return &target;
  raise(context, GL_INVALID_ENUM, "a texture range's target");
  return nullptr;
}

template <typename F> void change(CoreContext &context, GLenum target, F function) {
  const TextureTarget *const row = targetOf(context, target);
  if (!row)
    return;
  const TextureRanges::Key key = boundTo(context, *row);
  TextureRanges &ranges = context.group->textureRanges;
  TextureRange range = ranges.find(key);
  function(range);
  ranges.set(key, range);
}

/// Runs `function(key)` for each texture that is bound to a unit of fixed function.
template <typename F> void eachBound(const CoreContext &context, F function) {
  for (GLint unit = 0; unit < context.caps.maxTextureUnits; ++unit) {
    const UnitScope scope(*context.host, GLuint(unit));
    for (const TextureTarget &target : kTargets)
      if (isThere(context, target))
        function(boundTo(context, target));
  }
}

} // namespace

bool hasTextureRange(const CoreContext &context, GLenum pname) {
  return isTextureRange(pname) && context.era && context.era->offered.textureRange;
}

void setTextureRange(CoreContext &context, GLenum target, GLsizei length, const void *pointer) {
  if (length < 0)
    return raise(context, GL_INVALID_VALUE, "TextureRange: length is negative");
  change(context, target, [&](TextureRange &range) {
    range.length = length;
    range.pointer = pointer;
  });
}

void setTextureRangeParameter(CoreContext &context, GLenum target, GLenum pname, GLenum value) {
  if (pname != GL_TEXTURE_STORAGE_HINT_APPLE ||
      (value != GL_STORAGE_PRIVATE_APPLE && value != GL_STORAGE_CACHED_APPLE &&
       value != GL_STORAGE_SHARED_APPLE))
    return raise(context, GL_INVALID_ENUM, "TexParameter: a texture range's pname or param");
  change(context, target, [&](TextureRange &range) { range.storageHint = value; });
}

void executeTextureRange(CoreContext &context, const Command &command) {
  if (command.name != 0)
    return setTextureRangeParameter(context, command.target, command.name, command.format);
  const void *pointer = nullptr;
  std::memcpy(&pointer, command.bytes.data(), sizeof pointer);
  setTextureRange(context, command.target, command.count, pointer);
}

bool getTextureRange(CoreContext &context, GLenum target, TextureRange &range) {
  const TextureTarget *const row = targetOf(context, target);
  if (!row)
    return false;
  range = context.group->textureRanges.find(boundTo(context, *row));
  return true;
}

std::shared_ptr<const SavedTextureRanges> saveTextureRanges(const CoreContext &context) {
  if (!context.era || !context.era->offered.textureRange)
    return nullptr;
  auto saved = std::make_shared<SavedTextureRanges>();
  TextureRanges &ranges = context.group->textureRanges;
  if (ranges.any())
    eachBound(context, [&](TextureRanges::Key key) {
      if (const TextureRange range = ranges.find(key); !(range == TextureRange{}))
        saved->push_back({key.name, key.target, range});
    });
  return saved;
}

void restoreTextureRanges(CoreContext &context, const SavedTextureRanges &saved) {
  TextureRanges &ranges = context.group->textureRanges;
  if (!ranges.any())
    return;
  eachBound(context, [&](TextureRanges::Key key) {
    const auto found =
        std::find_if(saved.begin(), saved.end(), [&](const SavedTextureRange &texture) {
          return texture.name == key.name && (key.name != 0 || texture.target == key.target);
        });
    ranges.set(key, found == saved.end() ? TextureRange{} : found->range);
  });
}

} // namespace arbiter::state
