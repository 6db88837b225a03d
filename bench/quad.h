#pragma once

namespace bench {

/// Binds five small textures to the first units, as many as generated programs sample; made once.
void bindTextures();

/// Draws a quad over the whole surface, with a color and two varying texture coordinates.
void drawQuad();

} // namespace bench
