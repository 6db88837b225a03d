#include "bump_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace api::bump {

namespace {

constexpr GLuint kColors = 1, kOffsets = 2; ///< names of textures

GLfloat between(std::mt19937 &random, GLfloat low, GLfloat high) {
  return low + (high - low) * GLfloat(random() % 65536u) / 65535.0f;
}

/// Samples with linear filtering and REPEAT (OpenGL 1.4, 3.8.8).
Color sampleColors(const Images &images, GLfloat s, GLfloat t) {
  const GLfloat u = s * 8 - 0.5f, v = t * 8 - 0.5f;
  const GLfloat left = std::floor(u), bottom = std::floor(v), a = u - left, b = v - bottom;
  const auto texel = [&](int dx, int dy) -> const Color & {
    const int i = (int(left) + dx) & 7, j = (int(bottom) + dy) & 7;
    return images.colors[std::size_t(j * 8 + i)];
  };
  Color color{};
  for (std::size_t c = 0; c < 4; ++c)
    color[c] = (1 - b) * ((1 - a) * texel(0, 0)[c] + a * texel(1, 0)[c]) +
               b * ((1 - a) * texel(0, 1)[c] + a * texel(1, 1)[c]);
  return color;
}

/// Samples the nearest texel, with CLAMP_TO_EDGE: (du, dv).
std::array<GLfloat, 2> sampleOffsets(const Images &images, GLfloat s, GLfloat t) {
  const auto texel = [](GLfloat c) { return std::clamp(int(std::floor(c * 4)), 0, 3); };
  const auto at = std::size_t(2 * (texel(t) * 4 + texel(s)));
  const auto value = [](GLbyte byte) { return std::max(GLfloat(byte) / 127, -1.0f); };
  return {value(images.offsets[at]), value(images.offsets[at + 1])};
}

Color environmentOf(GLenum environment, const Color &color, const Color &texel) {
  Color result = texel;
  if (environment == GL_REPLACE)
    return result;
  for (std::size_t c = 0; c < 4; ++c)
    result[c] =
        environment == GL_ADD && c < 3 ? std::min(color[c] + texel[c], 1.0f) : color[c] * texel[c];
  return result;
}

GLfloat mix(const std::array<GLfloat, 2> &ends, int at) {
  return ends[0] + (ends[1] - ends[0]) * (GLfloat(at) + 0.5f) / 32;
}

void setUnit(const Unit &unit, int number) {
  glActiveTexture(GL_TEXTURE0 + GLenum(number));
  if (unit.kind == Kind::Off)
    return glDisable(GL_TEXTURE_2D);
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, unit.kind == Kind::Bump ? kOffsets : kColors);
  if (unit.kind == Kind::Colors)
    return glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GLint(unit.environment));
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_BUMP_ENVMAP_ATI);
  glTexEnvi(GL_TEXTURE_ENV, GL_BUMP_TARGET_ATI, GL_TEXTURE0 + unit.target);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, unit.replacesAlpha ? GL_REPLACE : GL_MODULATE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA, unit.replacesAlpha ? GL_CONSTANT : GL_TEXTURE);
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, unit.constant.data());
  glTexBumpParameterfvATI(GL_BUMP_ROT_MATRIX_ATI, unit.matrix.data());
}

void define(GLuint name, GLint filter, GLint wrap) {
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

} // namespace

Images randomImages(std::mt19937 &random) {
  Images images;
  for (Color &color : images.colors)
    for (GLfloat &part : color)
      part = GLfloat(random() % 256u) / 255;
  for (GLbyte &offset : images.offsets)
    offset = GLbyte(random() % 256u);
  return images;
}

State randomState(std::mt19937 &random) {
  State state;
  constexpr std::array<GLenum, 3> kEnvironments = {GL_REPLACE, GL_MODULATE, GL_ADD};
  for (GLfloat &part : state.primary)
    part = between(random, 0, 1);
  for (Unit &unit : state.units) {
    unit.kind = Kind(random() % 3u);
    unit.environment = kEnvironments[random() % 3u];
    unit.target = int(random() % unsigned(kUnits));
    for (GLfloat &entry : unit.matrix)
      entry = between(random, -0.5f, 0.5f);
    unit.replacesAlpha = random() % 2u != 0;
    for (GLfloat &part : unit.constant)
      part = between(random, 0, 1);
    unit.q = random() % 3u == 0 ? between(random, 0.5f, 2) : 1.0f;
    if (unit.kind == Kind::Colors) { // in others no texel's edge is near a pixel's middle
      unit.s = {between(random, -1, 1), between(random, 0, 2)};
      unit.t = {between(random, -1, 1), between(random, 0, 2)};
    }
  }
  return state;
}

Color colorAt(const State &state, const Images &images, int x, int y) {
  std::array<std::array<GLfloat, 2>, kUnits> at{};
  for (std::size_t unit = 0; unit < kUnits; ++unit)
    at[unit] = {mix(state.units[unit].s, x), mix(state.units[unit].t, y)};
  for (std::size_t from = 0; from < kUnits; ++from) {
    const Unit &unit = state.units[from];
    const auto to = std::size_t(unit.target);
    if (unit.kind != Kind::Bump || to == from)
      continue;
    if (state.units[to].kind == Kind::Bump && to < from)
      continue; // it has sampled already
    const auto d = sampleOffsets(images, at[from][0], at[from][1]);
    at[to][0] += d[0] * unit.matrix[0] + d[1] * unit.matrix[1];
    at[to][1] += d[0] * unit.matrix[2] + d[1] * unit.matrix[3];
  }
  Color color = state.primary;
  for (std::size_t i = 0; i < kUnits; ++i) {
    const Unit &unit = state.units[i];
    if (unit.kind == Kind::Colors)
      color = environmentOf(unit.environment, color, sampleColors(images, at[i][0], at[i][1]));
    else if (unit.kind == Kind::Bump && unit.replacesAlpha)
      color[3] = unit.constant[3];
  }
  return color;
}

void define(const Images &images) {
  std::vector<GLubyte> bytes;
  for (const Color &color : images.colors)
    for (const GLfloat part : color)
      bytes.push_back(GLubyte(std::lround(part * 255)));
  define(kColors, GL_LINEAR, GL_REPEAT);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  define(kOffsets, GL_NEAREST, GL_CLAMP_TO_EDGE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DU8DV8_ATI, 4, 4, 0, GL_DUDV_ATI, GL_BYTE,
               images.offsets.data());
}

void draw(const State &state) {
  for (int unit = 0; unit < kUnits; ++unit)
    setUnit(state.units[std::size_t(unit)], unit);
  glColor4fv(state.primary.data());
  glBegin(GL_QUADS);
  for (const int corner : {0, 1, 3, 2}) {
    const auto i = std::size_t(corner & 1), j = std::size_t(corner >> 1);
    for (int unit = 0; unit < kUnits; ++unit) {
      const Unit &of = state.units[std::size_t(unit)];
      glMultiTexCoord4f(GL_TEXTURE0 + GLenum(unit), of.s[i] * of.q, of.t[j] * of.q, 0, of.q);
    }
    glVertex2f(i != 0 ? 1.0f : -1.0f, j != 0 ? 1.0f : -1.0f);
  }
  glEnd();
  for (int unit = kUnits - 1; unit >= 0; --unit) {
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glDisable(GL_TEXTURE_2D);
  }
}

int difference(const State &state, const Images &images) {
  std::vector<std::array<GLubyte, 4>> pixels(32 * 32);
  glReadPixels(0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  int largest = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const Color want = colorAt(state, images, x, y);
      for (std::size_t c = 0; c < 4; ++c) {
        const int byte = int(std::lround(std::clamp(want[c], 0.0f, 1.0f) * 255));
        largest = std::max(largest, std::abs(byte - int(pixels[std::size_t(y * 32 + x)][c])));
      }
    }
  return largest;
}

} // namespace api::bump
