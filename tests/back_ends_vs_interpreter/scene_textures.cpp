#include <algorithm>
#include <cmath>
#include <epoxy/gl.h>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/random.h"
#include "gl_host.h"
#include "scene.h"

namespace arbiter::differential {

using namespace fp::ir;

unsigned textureTarget(TexTarget target) {
  switch (target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return GL_TEXTURE_1D;
  case TexTarget::Tex2D:
  case TexTarget::Shadow2D:
    return GL_TEXTURE_2D;
  case TexTarget::Tex3D:
    return GL_TEXTURE_3D;
  case TexTarget::Cube:
    return GL_TEXTURE_CUBE_MAP;
  case TexTarget::Rect:
  case TexTarget::ShadowRect:
    return GL_TEXTURE_RECTANGLE;
  }
  return 0;
}

namespace {
struct Size {
  int width, height, depth; ///< depth: slices, or the faces of a cube map
};

Size sizeOf(TexTarget target) {
  switch (target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return {8, 1, 1};
  case TexTarget::Tex2D:
  case TexTarget::Rect:
  case TexTarget::Shadow2D:
  case TexTarget::ShadowRect:
    return {8, 8, 1};
  case TexTarget::Tex3D:
    return {4, 4, 4};
  case TexTarget::Cube:
    return {4, 4, 6};
  }
  return {};
}

/// Returns a texel. Depth textures use the first component.
Vec4 texel(int unit, const Size &size, int x, int y, int z) {
  const int number = unit * 4096 + (z * size.height + y) * size.width + x;
  fp::testing::Random random(std::uint64_t(number) * 104729 + 1);
  using R = fp::testing::InputRanges;
  const auto next = [&] { return random.real(R::kTexelLow, R::kTexelHigh); };
  const float r = next(), g = next(), b = next(), a = next();
  return {r, g, b, a};
}

int wrapped(float coordinate, int size) {
  const float repeated = coordinate - std::floor(coordinate);
  return std::min(int(repeated * float(size)), size - 1);
}

int clamped(float coordinate, int size) {
  return int(std::clamp(std::floor(coordinate), 0.0f, float(size - 1)));
}

struct Texel {
  int x = 0, y = 0, z = 0;
};

/// Returns the face and its coordinates in [0,1] (table 3.21 of the GL specification). If
/// components are equal, the table leaves the axis open, and hosts take z before y before x.
Texel cubeTexel(const Vec4 &r, int size) {
  const float ax = std::fabs(r[0]), ay = std::fabs(r[1]), az = std::fabs(r[2]);
  float s = 0, t = 0, major = 0;
  int face = 0;
  if (ax > ay && ax > az) {
    face = r[0] >= 0 ? 0 : 1;
    s = r[0] >= 0 ? -r[2] : r[2];
    t = -r[1];
    major = ax;
  } else if (ay > az) {
    face = r[1] >= 0 ? 2 : 3;
    s = r[0];
    t = r[1] >= 0 ? r[2] : -r[2];
    major = ay;
  } else {
    face = r[2] >= 0 ? 4 : 5;
    s = r[2] >= 0 ? r[0] : -r[0];
    t = -r[1];
    major = az;
  }
  if (major == 0)
    return {0, 0, face};
  return {clamped((s / major + 1) / 2 * float(size), size),
          clamped((t / major + 1) / 2 * float(size), size), face};
}

Texel locate(const Sample &sample, const Size &size) {
  const Vec4 &c = sample.coordinate;
  switch (sample.target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return {wrapped(c[0], size.width), 0, 0};
  case TexTarget::Tex2D:
  case TexTarget::Shadow2D:
    return {wrapped(c[0], size.width), wrapped(c[1], size.height), 0};
  case TexTarget::Tex3D:
    return {wrapped(c[0], size.width), wrapped(c[1], size.height), wrapped(c[2], size.depth)};
  case TexTarget::Rect:
  case TexTarget::ShadowRect:
    return {clamped(c[0], size.width), clamped(c[1], size.height), 0};
  case TexTarget::Cube:
    return cubeTexel(c, size.width);
  }
  return {};
}

bool s_alphaDepths = true;

/// True if Mesa reads ALPHA depth textures as ALPHA. It takes ALPHA for RED if it believes that
/// GLSL 1.30 or later reads the texture. For an assembly program it reads that version from the
/// memory of the program's instructions, which is unpredictable in 32-bit processes.
bool readsAlphaDepths(bool assembly) { return !assembly || sizeof(void *) > 4 || layerInFront(); }

/// Returns the DEPTH_TEXTURE_MODE of each shadow target, so that all three are in use.
GLenum depthMode(TexTarget target) {
  if (target == TexTarget::Shadow1D)
    return GL_INTENSITY;
  return target == TexTarget::Shadow2D || !s_alphaDepths ? GL_LUMINANCE : GL_ALPHA;
}

Vec4 compared(TexTarget target, float reference, float depth) {
  const float d = std::clamp(reference, 0.0f, 1.0f) <= depth ? 1.0f : 0.0f;
  switch (depthMode(target)) {
  case GL_INTENSITY:
    return {d, d, d, d};
  case GL_LUMINANCE:
    return {d, d, d, 1};
  default:
    return {0, 0, 0, d};
  }
}

std::vector<float> image(int unit, TexTarget target, int firstSlice, int slices) {
  const Size size = sizeOf(target);
  std::vector<float> values;
  for (int z = firstSlice; z < firstSlice + slices; ++z)
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const Vec4 value = texel(unit, size, x, y, z);
        const auto end = isShadow(target) ? value.begin() + 1 : value.end();
        values.insert(values.end(), value.begin(), end);
      }
  return values;
}

void upload(int unit, TexTarget target) {
  const Size size = sizeOf(target);
  const GLint internal = isShadow(target) ? GL_DEPTH_COMPONENT24 : GL_RGBA32F;
  const GLenum format = isShadow(target) ? GL_DEPTH_COMPONENT : GL_RGBA;
  const GLenum name = textureTarget(target);
  if (name == GL_TEXTURE_CUBE_MAP) {
    for (int face = 0; face < 6; ++face)
      glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(face), 0, internal, size.width,
                   size.height, 0, format, GL_FLOAT, image(unit, target, face, 1).data());
    return;
  }
  const std::vector<float> values = image(unit, target, 0, size.depth);
  if (name == GL_TEXTURE_1D)
    glTexImage1D(name, 0, internal, size.width, 0, format, GL_FLOAT, values.data());
  else if (name == GL_TEXTURE_3D)
    glTexImage3D(name, 0, internal, size.width, size.height, size.depth, 0, format, GL_FLOAT,
                 values.data());
  else
    glTexImage2D(name, 0, internal, size.width, size.height, 0, format, GL_FLOAT, values.data());
}
} // namespace

Vec4 sampleTexture(const Sample &sample) {
  for (const float value : sample.coordinate)
    if (!std::isfinite(value))
      return {};
  const Size size = sizeOf(sample.target);
  const Texel at = locate(sample, size);
  const Vec4 value = texel(sample.unit, size, at.x, at.y, at.z);
  return isShadow(sample.target) ? compared(sample.target, sample.coordinate[2], value[0]) : value;
}

void applyTextures(bool assembly) {
  s_alphaDepths = readsAlphaDepths(assembly);
  for (std::size_t unit = 0; unit < fp::testing::kUnitTargets.size(); ++unit) {
    const TexTarget target = fp::testing::kUnitTargets[unit];
    const GLenum name = textureTarget(target);
    const bool repeats = name != GL_TEXTURE_RECTANGLE && name != GL_TEXTURE_CUBE_MAP;
    const GLint wrap = repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(name, texture);
    glTexParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(name, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(name, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(name, GL_TEXTURE_WRAP_R, wrap);
    if (isShadow(target)) {
      glTexParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
      glTexParameteri(name, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
      glTexParameteri(name, GL_DEPTH_TEXTURE_MODE, GLint(depthMode(target)));
    }
    upload(int(unit), target);
  }
  glActiveTexture(GL_TEXTURE0);
}

} // namespace arbiter::differential
