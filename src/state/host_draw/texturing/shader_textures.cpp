#include "state/host_draw/texturing/shader_textures.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/core/texture_binding.h"
#include "state/core/texture_names.h"
#include "state/core/unit_scope.h"
#include "state/host_draw/draw_context.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "state/programs/texture_shaders/texture_shader_state.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

using fp::ir::TexTarget;
using fp::texture_shader::Base;
using fp::texture_shader::Signs;
using fp::texture_shader::Texture;

/// The texture bound to a target of the active unit.
class Bound {
public:
  Bound(DrawContext &context, TexTarget target)
      : m_context(context), m_host(*context.host), m_target(target), m_names(textureNames(target)) {
    m_host.GetIntegerv(bindingOf(m_names.level), &m_name);
    m_base = parameter(GL_TEXTURE_BASE_LEVEL);
  }

  Texture describe() {
    if (m_base < 0 || m_base > kMaxLevel || !isComplete())
      return {};
    const GLint internal = level(m_names.level, m_base, GL_TEXTURE_INTERNAL_FORMAT);
    const GLenum own = m_context.group->textureFormats.find(GLuint(m_name), m_names.level, m_base);
    const ComponentFormat *const format = own != 0 ? componentFormat(own) : nullptr;
    if (format && format->host == GLenum(internal))
      return {format->base, format->signs, false};
    return ofHost(internal);
  }

private:
  static constexpr GLint kMaxLevel = 12; ///< every host has as many levels

  GLint parameter(GLenum pname) {
    GLint value = 0;
    m_host.GetTexParameteriv(m_names.target, pname, &value);
    return value;
  }
  GLint level(GLenum image, GLint at, GLenum pname) {
    GLint value = 0;
    m_host.GetTexLevelParameteriv(image, at, pname, &value);
    return value;
  }
  GLint sampled(GLenum pname) {
    GLint sampler = 0, value = 0;
    if (m_context.caps.samplerObjects)
      m_host.GetIntegerv(GL_SAMPLER_BINDING, &sampler);
    if (sampler == 0)
      return parameter(pname);
    m_host.GetSamplerParameteriv(GLuint(sampler), pname, &value);
    return value;
  }

  bool isComplete() {
    const GLint width = level(m_names.level, m_base, GL_TEXTURE_WIDTH);
    const GLint height = level(m_names.level, m_base, GL_TEXTURE_HEIGHT);
    if (width == 0)
      return false;
    const GLint filter = m_target == TexTarget::Rect ? GL_NEAREST : sampled(GL_TEXTURE_MIN_FILTER);
    const bool pyramid = filter != GL_NEAREST && filter != GL_LINEAR;
    if (!pyramid && m_target != TexTarget::Cube)
      return true;
    const GLint format = level(m_names.level, m_base, GL_TEXTURE_INTERNAL_FORMAT);
    const GLint last = pyramid ? parameter(GL_TEXTURE_MAX_LEVEL) : m_base;
    const TextureShaderState::Whole key = {m_name, GLint(m_target), m_base, last,
                                           width,  height,          format};
    auto &known = m_context.textureShaders->wholeTextures;
    if (std::find(known.begin(), known.end(), key) != known.end())
      return true;
    if (last < m_base || !facesMatch(width, height, format, last))
      return false;
    if (known.size() >= 64)
      known.clear();
    known.push_back(key);
    return true;
  }

  bool facesMatch(GLint width, GLint height, GLint format, GLint last) {
    const int faces = m_target == TexTarget::Cube ? 6 : 1;
    if (faces == 6 && width != height)
      return false;
    for (int face = 0; face < faces; ++face) {
      const GLenum image = m_names.level + GLenum(face);
      const GLint depth = level(image, m_base, GL_TEXTURE_DEPTH);
      GLint size[] = {width, height, std::max(depth, 1)};
      for (GLint at = m_base; at <= std::min(last, kMaxLevel); ++at) {
        if (!levelIs(image, at, size, format))
          return false;
        if (std::max({size[0], size[1], size[2]}) == 1)
          break;
        for (GLint &side : size)
          side = std::max(side / 2, 1);
      }
    }
    return true;
  }

  bool levelIs(GLenum image, GLint at, const GLint *size, GLint format) {
    return level(image, at, GL_TEXTURE_WIDTH) == size[0] &&
           std::max(level(image, at, GL_TEXTURE_HEIGHT), 1) == std::max(size[1], 1) &&
           (m_target != TexTarget::Tex3D || level(image, at, GL_TEXTURE_DEPTH) == size[2]) &&
           level(image, at, GL_TEXTURE_INTERNAL_FORMAT) == format;
  }

  Texture ofHost(GLint internalFormat) {
    auto &formats = m_context.textureShaders->formats;
    const auto known = formats.find(internalFormat);
    const Texture plain = known != formats.end()
                              ? known->second
                              : formats.emplace(internalFormat, ask()).first->second;
    return plain.compares ? depth() : plain;
  }

  /// Classifies the texture by the sizes of its components. It sets `compares` for depths.
  Texture ask() {
    const auto bits = [&](GLenum pname) { return level(m_names.level, m_base, pname); };
    if (m_context.caps.shadow && bits(GL_TEXTURE_DEPTH_SIZE) != 0)
      return {Base::Luminance, Signs::Unsigned, true};
    const GLint alpha = bits(GL_TEXTURE_ALPHA_SIZE);
    Texture texture;
    GLenum type = GL_TEXTURE_RED_TYPE;
    if (bits(GL_TEXTURE_INTENSITY_SIZE) != 0) {
      texture.base = Base::Intensity;
      type = GL_TEXTURE_INTENSITY_TYPE;
    } else if (bits(GL_TEXTURE_LUMINANCE_SIZE) != 0) {
      texture.base = alpha != 0 ? Base::LuminanceAlpha : Base::Luminance;
      type = GL_TEXTURE_LUMINANCE_TYPE;
    } else if (bits(GL_TEXTURE_RED_SIZE) != 0) {
      // RED and RG are RGB with missing components
      texture.base = alpha != 0 ? Base::Rgba : Base::Rgb;
    } else {
      texture.base = Base::Alpha;
      type = GL_TEXTURE_ALPHA_TYPE;
    }
    if (bits(type) == GL_SIGNED_NORMALIZED)
      texture.signs = Signs::Signed;
    return texture;
  }

  /// Classifies a depth texture by DEPTH_TEXTURE_MODE.
  Texture depth() {
    Texture texture;
    const GLint mode = parameter(GL_DEPTH_TEXTURE_MODE);
    texture.base = mode == GL_ALPHA       ? Base::Alpha
                   : mode == GL_INTENSITY ? Base::Intensity
                                          : Base::Luminance;
    texture.compares = sampled(GL_TEXTURE_COMPARE_MODE) != GL_NONE && m_target != TexTarget::Cube;
    return texture;
  }

  DrawContext &m_context;
  const host::HostTable &m_host;
  TexTarget m_target;
  TextureNames m_names;
  GLint m_name = 0;
  GLint m_base = 0;
};

} // namespace

Texture boundTexture(DrawContext &context, int unit, TexTarget target) {
  if (target == TexTarget::Rect && !context.caps.textureRectangle)
    return {};
  const UnitScope scope(*context.host, unsigned(unit));
  return Bound(context, target).describe();
}

} // namespace arbiter::state
