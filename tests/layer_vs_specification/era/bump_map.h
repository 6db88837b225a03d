#pragma once
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <epoxy/gl.h>

/// Random states of ATI_envmap_bumpmap as data, and the resulting picture by the specification.
namespace api::bump {

using Color = std::array<GLfloat, 4>;

/// An 8x8 texture of colors, and a 4x4 one of byte offsets.
struct Images {
  std::array<Color, 64> colors{};
  std::array<GLbyte, 32> offsets{};
};

enum class Kind : std::uint8_t { Off, Colors, Bump };

struct Unit {
  Kind kind = Kind::Off;
  GLenum environment = GL_MODULATE; ///< for colors: REPLACE, MODULATE or ADD
  int target = 0;                   ///< for units that bump
  std::array<GLfloat, 4> matrix = {1, 0, 0, 1};
  bool replacesAlpha = false; ///< for units that bump: COMBINE_ALPHA is REPLACE by the constant
  Color constant = {0, 0, 0, 0};
  /// The coordinates at the left and right, bottom and top; all are multiplied by q.
  std::array<GLfloat, 2> s = {0, 1}, t = {0, 1};
  GLfloat q = 1;
};
inline constexpr int kUnits = 4;

struct State {
  std::array<Unit, kUnits> units{};
  Color primary = {1, 1, 1, 1};
};

[[nodiscard]] Images randomImages(std::mt19937 &random);
[[nodiscard]] State randomState(std::mt19937 &random);
/// Returns the color of a pixel of the 32x32 framebuffer.
[[nodiscard]] Color colorAt(const State &state, const Images &images, int x, int y);

/// Defines the images of the textures 1 (colors) and 2 (offsets).
void define(const Images &images);
/// Sets the state, draws a rectangle over the framebuffer, and disables the units.
void draw(const State &state);
/// Returns the largest difference of the framebuffer's bytes from the expected ones.
[[nodiscard]] int difference(const State &state, const Images &images);

} // namespace api::bump
