#include "states.h"

#include <algorithm>
#include <cmath>

namespace software {

namespace {

/// Returns texels that change gradually, so that a sample on the other side of a texel's border
/// differs little. They differ in all components, levels and layers.
std::vector<float> texels(int width, int height, int layer, int level) {
  std::vector<float> values;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float s = (float(x) + 0.5f) / float(width), t = (float(y) + 0.5f) / float(height);
      const float shift = 0.13f * float(layer) + 0.07f * float(level);
      values.push_back(0.5f + 0.5f * std::sin(5.0f * s + 2.0f * t + shift));
      values.push_back(0.5f + 0.5f * std::cos(3.0f * t - 4.0f * s + shift));
      values.push_back(s * t + 0.1f * float(layer % 3));
      values.push_back(0.5f + 0.45f * std::cos(6.0f * s + 5.0f * t));
    }
  }
  return values;
}

std::vector<float> depths(int width, int height) {
  std::vector<float> values;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      values.push_back(0.2f + 0.6f * float((x * 3 + y * 5) % 16) / 16.0f);
  return values;
}

bool isDepth(const Scene &scene) {
  const GLenum format = scene.token("format");
  return (format >= GL_DEPTH_COMPONENT16 && format <= GL_DEPTH_COMPONENT32) ||
         format == GL_DEPTH_COMPONENT32F;
}

void defineLevel(GLenum target, const Scene &scene, int level, int width, int height, int depth) {
  const GLint internal = scene.choice("format");
  std::vector<float> all;
  for (int layer = 0; layer < depth; ++layer) {
    const int face =
        target >= GL_TEXTURE_CUBE_MAP_POSITIVE_X && target <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z
            ? int(target - GL_TEXTURE_CUBE_MAP_POSITIVE_X)
            : 0;
    const std::vector<float> part = texels(width, height, layer + face, level);
    all.insert(all.end(), part.begin(), part.end());
  }
  GLenum format = GL_RGBA;
  if (isDepth(scene)) {
    format = GL_DEPTH_COMPONENT;
    all = depths(width, height);
  }
  if (target == GL_TEXTURE_1D)
    glTexImage1D(target, level, internal, width, 0, format, GL_FLOAT, all.data());
  else if (target == GL_TEXTURE_3D)
    glTexImage3D(target, level, internal, width, height, depth, 0, format, GL_FLOAT, all.data());
  else
    glTexImage2D(target, level, internal, width, height, 0, format, GL_FLOAT, all.data());
}

void setParameters(GLenum target, const Scene &scene) {
  const auto set = [&](GLenum name, double value) {
    glTexParameterf(target, name, GLfloat(value));
  };
  set(GL_TEXTURE_MIN_FILTER, scene.number("min_filter"));
  set(GL_TEXTURE_MAG_FILTER, scene.number("mag_filter"));
  set(GL_TEXTURE_WRAP_S, scene.number("wrap_s"));
  if (target != GL_TEXTURE_1D)
    set(GL_TEXTURE_WRAP_T, scene.number("wrap_t"));
  if (target == GL_TEXTURE_3D || target == GL_TEXTURE_CUBE_MAP)
    set(GL_TEXTURE_WRAP_R, scene.number("wrap_r"));
  if (scene.choice("border") != 0) {
    static constexpr float kBorder[4] = {0.9f, 0.2f, 0.7f, 0.6f};
    glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, kBorder);
  }
  set(GL_TEXTURE_SRGB_DECODE_EXT, scene.number("srgb_decode"));
  if (target == GL_TEXTURE_RECTANGLE_ARB)
    return;
  set(GL_TEXTURE_LOD_BIAS, scene.number("lod_bias"));
  set(GL_TEXTURE_MAX_ANISOTROPY_EXT, scene.number("anisotropy"));
  switch (scene.choice("levels")) {
  case 1:
    return set(GL_TEXTURE_MAX_LOD, 1.0);
  case 2:
    return set(GL_TEXTURE_BASE_LEVEL, 1.0);
  case 3:
    // This is not a half: GL takes the lower of two equally near levels (3.8.8), the host the
    // higher.
    return set(GL_TEXTURE_MIN_LOD, 1.6);
  default:
    return;
  }
}

} // namespace

void makeSceneTexture(const Scene &scene) {
  static constexpr int kSizes[4][2] = {{32, 32}, {64, 16}, {20, 28}, {1, 1}};
  const GLenum target = scene.token("texture");
  const int *size = kSizes[scene.choice("size")];
  const int width = size[0];
  const int height = target == GL_TEXTURE_1D ? 1 : target == GL_TEXTURE_CUBE_MAP ? width : size[1];
  const int depth = target == GL_TEXTURE_3D ? std::max(1, width / 4) : 1;
  GLuint name = 0;
  glGenTextures(1, &name);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(target, name);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const bool single = target == GL_TEXTURE_RECTANGLE_ARB;
  for (int level = 0;; ++level) {
    const int w = std::max(1, width >> level), h = std::max(1, height >> level),
              d = std::max(1, depth >> level);
    if (target == GL_TEXTURE_CUBE_MAP) {
      for (GLenum face = 0; face < 6; ++face)
        defineLevel(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, scene, level, w, h, 1);
    } else {
      defineLevel(target, scene, level, w, h, d);
    }
    if (single || (w == 1 && h == 1 && d == 1))
      break;
  }
  setParameters(target, scene);
  if (scene.choice("swizzle") != 0) {
    static constexpr GLint kOrder[4] = {GL_GREEN, GL_ALPHA, GL_RED, GL_ONE};
    glTexParameteriv(target, GL_TEXTURE_SWIZZLE_RGBA, kOrder);
  }
  if (isDepth(scene)) {
    glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, scene.choice("depth_mode"));
    if (scene.choice("compare") != 0) {
      glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
      glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, scene.choice("compare"));
    }
  }
}

} // namespace software
