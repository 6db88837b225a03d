#pragma once
#include "apps/scene/texture/image.h"

namespace arbiter::scene {

/// Makes the image of a texture unit for which a document names none: a repeated tile of 64x64
/// texels with the unit's number in white. The squares are purple and dark grey, eight texels wide.
/// The number is upright if t points up, and the image is opaque. A single row (height 1) has the
/// squares without the number.
/// \param unit 0 to 99
[[nodiscard]] Image makeUnset(unsigned unit, int width, int height);

} // namespace arbiter::scene
