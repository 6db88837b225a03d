#include "textures.h"

#include <algorithm>
#include <cmath>

namespace shaded {

using arbiter::fp::testing::Random;
using arbiter::fp::texture_shader::Base;
using arbiter::fp::texture_shader::Color;
using arbiter::fp::texture_shader::Sampled;
using arbiter::fp::texture_shader::Signs;

namespace {

/// A format of pixel data: components of a type, each in steps of its greatest integer.
struct Format {
  GLenum internal;
  GLenum external;
  GLenum type;
  Base base;
  Signs signs;
  std::array<int, 4> steps; ///< for each component; negative: signed; 0: none
};

constexpr Format kFormats[] = {
    {GL_RGBA8, GL_RGBA, GL_FLOAT, Base::Rgba, Signs::Unsigned, {255, 255, 255, 255}},
    {GL_RGB8, GL_RGBA, GL_FLOAT, Base::Rgb, Signs::Unsigned, {255, 255, 255, 255}},
    {GL_ALPHA8, GL_RGBA, GL_FLOAT, Base::Alpha, Signs::Unsigned, {255, 255, 255, 255}},
    {GL_LUMINANCE8, GL_RGBA, GL_FLOAT, Base::Luminance, Signs::Unsigned, {255, 255, 255, 255}},
    {GL_LUMINANCE8_ALPHA8,
     GL_RGBA,
     GL_FLOAT,
     Base::LuminanceAlpha,
     Signs::Unsigned,
     {255, 255, 255, 255}},
    {GL_INTENSITY8, GL_RGBA, GL_FLOAT, Base::Intensity, Signs::Unsigned, {255, 255, 255, 255}},
    {GL_SIGNED_RGBA8_NV, GL_RGBA, GL_FLOAT, Base::Rgba, Signs::Signed, {-127, -127, -127, -127}},
    {GL_SIGNED_RGB_NV, GL_RGBA, GL_FLOAT, Base::Rgb, Signs::Signed, {-127, -127, -127, -127}},
    {GL_SIGNED_ALPHA8_NV, GL_RGBA, GL_FLOAT, Base::Alpha, Signs::Signed, {-127, -127, -127, -127}},
    {GL_SIGNED_LUMINANCE8_NV,
     GL_RGBA,
     GL_FLOAT,
     Base::Luminance,
     Signs::Signed,
     {-127, -127, -127, -127}},
    {GL_SIGNED_LUMINANCE8_ALPHA8_NV,
     GL_RGBA,
     GL_FLOAT,
     Base::LuminanceAlpha,
     Signs::Signed,
     {-127, -127, -127, -127}},
    {GL_SIGNED_INTENSITY8_NV,
     GL_RGBA,
     GL_FLOAT,
     Base::Intensity,
     Signs::Signed,
     {-127, -127, -127, -127}},
    {GL_SIGNED_RGB8_UNSIGNED_ALPHA8_NV,
     GL_RGBA,
     GL_FLOAT,
     Base::Rgba,
     Signs::SignedRgb,
     {-127, -127, -127, 255}},
    {GL_HILO16_NV, GL_HILO_NV, GL_UNSIGNED_SHORT, Base::Hilo, Signs::Unsigned, {65535, 65535}},
    {GL_HILO8_NV, GL_HILO_NV, GL_UNSIGNED_BYTE, Base::Hilo, Signs::Unsigned, {255, 255}},
    {GL_SIGNED_HILO_NV, GL_HILO_NV, GL_SHORT, Base::Hilo, Signs::Signed, {-32767, -32767}},
    {GL_SIGNED_HILO8_NV, GL_HILO_NV, GL_BYTE, Base::Hilo, Signs::Signed, {-127, -127}},
    {GL_DSDT8_NV, GL_DSDT_NV, GL_BYTE, Base::Dsdt, Signs::Signed, {-127, -127}},
    {GL_DSDT8_MAG8_NV, GL_DSDT_MAG_NV, GL_FLOAT, Base::DsdtMag, Signs::Signed, {-127, -127, 255}},
    {GL_DSDT_MAG_INTENSITY_NV,
     GL_DSDT_MAG_VIB_NV,
     GL_UNSIGNED_INT_S8_S8_8_8_NV,
     Base::DsdtMagIntensity,
     Signs::Signed,
     {-127, -127, 255, 255}},
};

/// Returns what is stored of a pixel (table 3.15).
Color stored(Base base, const Color &c) {
  switch (base) {
  case Base::Alpha:
    return {0, 0, 0, c[3]};
  case Base::Luminance:
    return {c[0], c[0], c[0], 1};
  case Base::LuminanceAlpha:
    return {c[0], c[0], c[0], c[3]};
  case Base::Intensity:
    return {c[0], c[0], c[0], c[0]};
  case Base::Rgb:
    return {c[0], c[1], c[2], 1};
  default:
    return c;
  }
}

template <typename T> void append(std::vector<std::uint8_t> &bytes, T value) {
  const auto *const at = reinterpret_cast<const std::uint8_t *>(&value);
  bytes.insert(bytes.end(), at, at + sizeof value);
}

/// Returns random pixels of the format in memory layout, and their values in `values`.
/// \param peer converts signed bytes to floats as NVIDIA's driver does
std::vector<std::uint8_t> pixelsOf(Random &random, const Format &format, std::size_t count,
                                   bool peer, std::vector<Color> &values) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < count; ++i) {
    Color value{};
    std::uint32_t word = 0;
    for (std::size_t c = 0; c < 4 && format.steps[c] != 0; ++c) {
      const int steps = std::abs(format.steps[c]);
      const int number =
          format.steps[c] < 0 ? random.below(2 * steps + 1) - steps : random.below(steps + 1);
      value[c] = double(number) / steps;
      switch (format.type) {
      case GL_FLOAT:
        append(bytes, float(value[c]));
        if (peer && format.steps[c] == -127)
          value[c] = std::max(-1.0, std::floor(value[c] * 127.5) / 127.0);
        break;
      case GL_BYTE:
      case GL_UNSIGNED_BYTE:
        append(bytes, std::uint8_t(number));
        break;
      case GL_SHORT:
      case GL_UNSIGNED_SHORT:
        append(bytes, std::uint16_t(number));
        break;
      default:
        word |= std::uint32_t(std::uint8_t(number)) << (24 - 8 * c);
      }
    }
    if (format.type == GL_UNSIGNED_INT_S8_S8_8_8_NV)
      append(bytes, word);
    values.push_back(stored(format.base, value));
  }
  return bytes;
}

void define(Random &random, Texture &texture, const Format &format, bool peer) {
  const auto internal = GLint(format.internal);
  const auto pixels = [&](int count) {
    return pixelsOf(random, format, std::size_t(count), peer, texture.texels);
  };
  switch (texture.target) {
  case GL_TEXTURE_1D:
    texture.width = 8;
    glTexImage1D(texture.target, 0, internal, 8, 0, format.external, format.type, pixels(8).data());
    return;
  case GL_TEXTURE_3D:
    texture.width = texture.height = texture.depth = 4;
    glTexImage3D(texture.target, 0, internal, 4, 4, 4, 0, format.external, format.type,
                 pixels(64).data());
    return;
  case GL_TEXTURE_CUBE_MAP:
    texture.depth = 6;
    for (GLenum face = 0; face < 6; ++face)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, internal, 1, 1, 0, format.external,
                   format.type, pixels(1).data());
    return;
  default:
    texture.width = texture.height = 8;
    glTexImage2D(texture.target, 0, internal, 8, 8, 0, format.external, format.type,
                 pixels(64).data());
  }
}

Texture begin(GLenum target) {
  Texture texture;
  texture.target = target;
  glGenTextures(1, &texture.name);
  glBindTexture(target, texture.name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
  return texture;
}

/// Returns the texel of a coordinate along one side; both are in texels.
int texelOf(double coordinate, int side, double &margin) {
  const double nearest = std::round(coordinate);
  if (nearest > 0.0 && nearest < side)
    margin = std::min(margin, std::abs(coordinate - nearest));
  return std::clamp(int(std::floor(std::clamp(coordinate, -1.0, side + 1.0))), 0, side - 1);
}

int faceOf(const std::array<double, 3> &at, double &margin) {
  std::size_t major = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(at[i]) > std::abs(at[major]))
      major = i;
  const double size = std::abs(at[major]);
  for (std::size_t i = 0; i < 3; ++i)
    if (i != major)
      margin = std::min(margin, size < 1e-3 ? 0.0 : (size - std::abs(at[i])) / size);
  return int(major) * 2 + (at[major] < 0.0 ? 1 : 0);
}

} // namespace

Sampled Texture::at(const std::array<double, 3> &coordinate) const {
  Sampled sampled;
  int index = 0;
  if (target == GL_TEXTURE_CUBE_MAP) {
    index = faceOf(coordinate, sampled.margin);
  } else {
    const bool inTexels = target == GL_TEXTURE_RECTANGLE;
    const int sides[] = {width, height, depth};
    for (int i = 2; i >= 0; --i)
      index = index * sides[i] +
              (sides[i] == 1 ? 0
                             : texelOf(coordinate[std::size_t(i)] * (inTexels ? 1 : sides[i]),
                                       sides[i], sampled.margin));
  }
  sampled.texel = texels[std::size_t(index)];
  return sampled;
}

std::vector<Texture> makeTextures(bool peer) {
  Random random(18);
  std::vector<Texture> textures;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (const GLenum target :
       {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP}) {
    for (const Format &format : kFormats) {
      Texture texture = begin(target);
      texture.kind = {format.base, format.signs, false};
      texture.format = format.internal;
      define(random, texture, format, peer);
      textures.push_back(std::move(texture));
    }
    textures.push_back(begin(target)); // without an image
  }
  return textures;
}

} // namespace shaded
