#pragma once
#include "scene/texture/image.h"

namespace arbiter::scene {

/// What a texture image unit samples for which a document names no image: a checker of 64x64 texels
/// with the unit's number in white, over and over. The squares are purple and dark grey, and eight
/// texels wide; the number is upright where t points up. Opaque. A row of it alone (height 1) has
/// the squares without the number.
/// \param unit 0 to 99
[[nodiscard]] Image makeUnset(unsigned unit, int width, int height);

} // namespace arbiter::scene
