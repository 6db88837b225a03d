#pragma once
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <epoxy/gl.h>

/// Random states of ATI_envmap_bumpmap as data, and what they draw, computed from the
/// specification.
namespace api::bump {

using Color = std::array<GLfloat, 4>;

/// A texture of colours, 8x8, and one of offsets, 4x4 of bytes.
struct Images {
  std::array<Color, 64> colors{};
  std::array<GLbyte, 32> offsets{};
};

enum class Kind : std::uint8_t { Off, Colors, Bump };

struct Unit {
  Kind kind = Kind::Off;
  GLenum environment = GL_MODULATE; ///< of colours: REPLACE, MODULATE or ADD
  int target = 0;                   ///< of those that bump
  std::array<GLfloat, 4> matrix = {1, 0, 0, 1};
  bool replacesAlpha = false; ///< those that bump: COMBINE_ALPHA is REPLACE by the constant
  Color constant = {0, 0, 0, 0};
  /// Coordinates at the left and right, bottom and top; all times q.
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
/// Of a pixel of the 32x32 framebuffer.
[[nodiscard]] Color colorAt(const State &state, const Images &images, int x, int y);

/// Gives the images to the textures 1 (colours) and 2 (offsets).
void define(const Images &images);
/// Sets the state and draws a rectangle over the framebuffer. The units are disabled behind it.
void draw(const State &state);
/// The largest difference of the framebuffer's bytes from what they should be.
[[nodiscard]] int difference(const State &state, const Images &images);

} // namespace api::bump
