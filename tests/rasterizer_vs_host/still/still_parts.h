#pragma once
#include <epoxy/gl.h>

/// The parts of still scenes.
namespace software {

extern const char *const kTexturedText; ///< a fragment program: texture 0 times the color

/// Makes a checkered texture of 64x64 texels with mipmaps and a sloping alpha, which stays bound.
void makeTexture();
[[nodiscard]] GLuint boundTexture();
/// Sets a view of a floor below the eye, with depth test.
void floorView();
void floorQuads();
/// Draws a rectangle in one plane, with coordinates from 0 to 1.
void flatQuad(float x, float y, float width, float height, float z);
void gradientTriangle(float turn, float alpha = 1);
void ball();
void enableLight();
void enableFog(GLenum mode);
/// Enables blending by alpha, as smooth primitives need.
void enableSmooth();
/// Draws eight vertices of several colors, as points or lines.
void strokes(GLenum mode);

} // namespace software
