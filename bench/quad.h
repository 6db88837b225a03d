#pragma once

namespace bench {

/// Five small textures on the first image units, as many as generated programs sample; made once.
void bindTextures();

/// Over the whole surface, with a colour and two texture coordinates that vary.
void drawQuad();

} // namespace bench
