#pragma once
#include <epoxy/gl.h>

/// The parts of still scenes.
namespace software {

extern const char *const kTexturedText; ///< a fragment program: texture 0 times the colour

/// A checkered texture of 64x64 texels with mipmaps and a sloping alpha, which stays bound.
void makeTexture();
[[nodiscard]] GLuint boundTexture();
/// A floor below the eye, whose depths are tested.
void floorView();
void floorQuads();
/// A rectangle in one plane, with coordinates from 0 to 1.
void flatQuad(float x, float y, float width, float height, float z);
void gradientTriangle(float turn, float alpha = 1);
void ball();
void enableLight();
void enableFog(GLenum mode);
/// Blending by alpha, as smooth primitives want.
void enableSmooth();
/// Eight vertices of several colours, as primitives of points or lines.
void strokes(GLenum mode);

} // namespace software
