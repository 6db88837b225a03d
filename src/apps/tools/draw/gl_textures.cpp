#include "apps/tools/draw/gl_textures.h"

#include <algorithm>

#include "apps/scene/texture/generate.h"
#include "apps/tools/draw/gl_unset.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::tools {

namespace {

using fp::ir::Language;
using fp::ir::TexTarget;
using scene::Generator;
using scene::Image;

RenderError fault(int file, fp::Span span, std::string message) {
  return {RenderError::Kind::Panel, std::move(message), std::size_t(file), -1, span};
}

/// True if the command line set it: an option has no position in a text.
bool isOption(const scene::TextureSpec &spec) { return spec.unitSpan.end == 0; }

std::string nameOf(const scene::TextureSpec &spec) {
  return (isOption(spec) ? "--texture " : "texture ") + std::to_string(spec.unit);
}

bool isRendered(Generator generator) {
  return generator == Generator::Picture || generator == Generator::DepthOf;
}

void uploadLevel(GLenum target, GLint level, const Image &image) {
  const bool wide = image.bits == 16;
  const GLint format = wide ? GL_RGBA16 : GL_RGBA8;
  std::vector<std::uint8_t> narrow;
  if (!wide)
    narrow.assign(image.texels.begin(), image.texels.end());
  const void *texels = wide ? static_cast<const void *>(image.texels.data()) : narrow.data();
  const GLenum type = wide ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE;
  if (target == GL_TEXTURE_1D)
    glTexImage1D(target, level, format, image.width, 0, GL_RGBA, type, texels);
  else
    glTexImage2D(target, level, format, image.width, image.height, 0, GL_RGBA, type, texels);
}

/// Uploads an image for a unit that samples volumes. Squares below each other are slices, the first
/// on top; any other image is one slice.
void uploadVolume(const Image &image) {
  const bool squares = image.height % image.width == 0;
  const int depth = squares ? image.height / image.width : 1, height = image.height / depth;
  const bool wide = image.bits == 16;
  glTexImage3D(GL_TEXTURE_3D, 0, wide ? GL_RGBA16 : GL_RGBA8, image.width, height, depth, 0,
               GL_RGBA, GL_UNSIGNED_SHORT, nullptr);
  const std::size_t slice = std::size_t(image.width) * std::size_t(height) * 4;
  for (int i = 0; i < depth; ++i) {
    // Rows begin at the bottom. A wide texel's unit is 1/65535, a narrow one's 1/255.
    std::vector<std::uint16_t> texels(image.texels.end() -
                                          std::ptrdiff_t(slice * std::size_t(i + 1)),
                                      image.texels.end() - std::ptrdiff_t(slice * std::size_t(i)));
    if (!wide)
      std::transform(texels.begin(), texels.end(), texels.begin(),
                     [](std::uint16_t texel) { return std::uint16_t(texel * 257); });
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, i, image.width, height, 1, GL_RGBA, GL_UNSIGNED_SHORT,
                    texels.data());
  }
}

void uploadImage(GLenum target, const Image &image, std::size_t smaller) {
  if (target == GL_TEXTURE_3D)
    return uploadVolume(image);
  uploadLevel(target, 0, image);
  for (std::size_t i = 0; i < smaller; ++i)
    uploadLevel(target, GLint(i) + 1, image.smaller[i]);
}

/// Returns the number of smaller levels that all faces have.
std::size_t smallerOf(const std::vector<Image> &images) {
  std::size_t count = images.front().smaller.size();
  for (const Image &image : images)
    count = std::min(count, image.smaller.size());
  return count;
}

GLint wrapOf(const scene::TextureSpec &spec, GLenum target) {
  if (target == GL_TEXTURE_RECTANGLE || target == GL_TEXTURE_CUBE_MAP)
    return GL_CLAMP_TO_EDGE;
  constexpr GLint kWraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
  return kWraps[std::size_t(spec.wrap.value)];
}

/// True if the pass's fragment language samples the enabled target.
bool enablesUnits(const scene::Document &document, const scene::Pass &pass) {
  const Language language = document.files[std::size_t(pass.fragment)].language;
  return language == Language::AtiFragment || isNvparse(language);
}

} // namespace

Textures::~Textures() {
  for (const Unit &unit : m_units)
    if (unit.owned)
      glDeleteTextures(1, &unit.name);
}

std::optional<RenderError> Textures::load(const scene::Document &document, const Targets &targets) {
  const int units = query(GL_MAX_TEXTURE_IMAGE_UNITS_ARB);
  std::vector<int> loaded;
  for (const scene::Pass &pass : document.passes) {
    if (std::find(loaded.begin(), loaded.end(), pass.panel) != loaded.end())
      continue;
    loaded.push_back(pass.panel);
    const auto samples = pass.fragment < 0 ? std::vector<Sampled>{}
                                           : samplesOf(document.files[std::size_t(pass.fragment)]);
    for (const scene::TextureSpec &spec : document.panelOf(pass).textures) {
      if (spec.unit >= unsigned(units))
        return fault(pass.panel, spec.unitSpan,
                     nameOf(spec) + ": there are " + std::to_string(units) +
                         " texture image units");
      if (auto error = loadUnit(document, pass, spec, samples, targets))
        return error;
    }
    addUnset(document, pass, samples, unsigned(units));
  }
  return std::nullopt;
}

/// Adds each sampled unit that no line names, with an image of its number.
void Textures::addUnset(const scene::Document &document, const scene::Pass &pass,
                        const std::vector<Sampled> &samples, unsigned units) {
  const auto &named = document.panelOf(pass).textures;
  for (const Sampled &sampled : samples) {
    const auto is = [&](const scene::TextureSpec &spec) { return spec.unit == sampled.unit; };
    if (sampled.unit >= units || std::any_of(named.begin(), named.end(), is))
      continue;
    Unit unit;
    unit.panel = pass.panel;
    unit.number = sampled.unit;
    unit.target = glTarget(sampled.target);
    unit.enabled = enablesUnits(document, pass);
    unit.name = makeUnsetTexture(sampled.unit, sampled.target, document.width(), document.height());
    m_units.push_back(unit);
  }
}

std::optional<RenderError> Textures::loadUnit(const scene::Document &document,
                                              const scene::Pass &pass,
                                              const scene::TextureSpec &spec,
                                              const std::vector<Sampled> &samples,
                                              const Targets &targets) {
  const bool cube = isCube(spec.source.generator.value);
  TexTarget sampled = cube ? TexTarget::Cube : TexTarget::Tex2D;
  for (const Sampled &each : samples)
    if (each.unit == spec.unit)
      sampled = each.target;
  Unit unit;
  unit.panel = pass.panel;
  unit.number = spec.unit;
  unit.spec = &spec;
  unit.target = glTarget(sampled);
  unit.compares = spec.compare || fp::ir::isShadow(sampled);
  unit.feedback = spec.source.generator.value == Generator::Feedback;
  unit.enabled = pass.fragment < 0 || enablesUnits(document, pass);
  const bool flat = isRendered(spec.source.generator.value) || unit.feedback;
  if ((unit.target == GL_TEXTURE_3D && flat) || cube != (unit.target == GL_TEXTURE_CUBE_MAP))
    return fault(pass.panel, spec.source.generator.span,
                 "the program samples texture[" + std::to_string(spec.unit) + "] as " +
                     fp::ir::targetText(sampled) + ", and this is a " +
                     (cube ? "cube map" : "2D image"));
  if (isRendered(spec.source.generator.value)) {
    unit.owned = false;
    const bool depth = spec.source.generator.value == Generator::DepthOf;
    unit.name = targets.texture(spec.source.target.text, depth);
    if (unit.target != GL_TEXTURE_2D)
      return fault(pass.panel, spec.source.generator.span, "what a pass draws is sampled as 2D");
    m_units.push_back(unit);
    return std::nullopt;
  }
  return upload(document, unit);
}

std::optional<RenderError> Textures::upload(const scene::Document &document, Unit &unit) {
  const auto images =
      scene::generate(unit.spec->source, document.folder, document.width(), document.height());
  if (!images)
    return fault(unit.panel, images.error().span,
                 isOption(*unit.spec) ? nameOf(*unit.spec) + ": " + images.error().message
                                      : images.error().message);
  const Image &first = images.value().front();
  if (unit.target == GL_TEXTURE_1D && first.height != 1)
    return fault(unit.panel, unit.spec->source.generator.span,
                 "the program samples texture[" + std::to_string(unit.number) +
                     "] as 1D: write a size of height 1, as in 'gradient 256 1'");
  glGenTextures(1, &unit.name);
  m_units.push_back(unit);
  glActiveTexture(GL_TEXTURE0 + unit.number);
  glBindTexture(unit.target, unit.name);
  setParameters(unit);
  const bool mipmaps =
      unit.spec->filter.value == scene::Filter::Mipmap && unit.target != GL_TEXTURE_RECTANGLE;
  const std::size_t smaller =
      mipmaps && unit.target != GL_TEXTURE_3D ? smallerOf(images.value()) : 0;
  for (std::size_t i = 0; i < images.value().size(); ++i)
    uploadImage(unit.target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + GLenum(i)
                                                   : unit.target,
                images.value()[i], smaller);
  // A file may contain only some of the smaller levels.
  if (smaller > 0)
    glTexParameteri(unit.target, GL_TEXTURE_MAX_LEVEL, GLint(smaller));
  else if (mipmaps)
    glGenerateMipmap(unit.target);
  glBindTexture(unit.target, 0);
  return std::nullopt;
}

void Textures::setParameters(const Unit &unit) {
  const scene::Filter filter = unit.spec->filter.value;
  const GLint nearer = filter == scene::Filter::Nearest ? GL_NEAREST : GL_LINEAR;
  const bool mipmaps =
      filter == scene::Filter::Mipmap && unit.owned && unit.target != GL_TEXTURE_RECTANGLE;
  glTexParameteri(unit.target, GL_TEXTURE_MIN_FILTER, mipmaps ? GL_LINEAR_MIPMAP_LINEAR : nearer);
  glTexParameteri(unit.target, GL_TEXTURE_MAG_FILTER, nearer);
  const GLint wrap = wrapOf(*unit.spec, unit.target);
  glTexParameteri(unit.target, GL_TEXTURE_WRAP_S, wrap);
  if (unit.target != GL_TEXTURE_1D)
    glTexParameteri(unit.target, GL_TEXTURE_WRAP_T, wrap);
  if (unit.target == GL_TEXTURE_3D)
    glTexParameteri(unit.target, GL_TEXTURE_WRAP_R, wrap);
  if (unit.spec->source.generator.value == Generator::DepthOf)
    glTexParameteri(unit.target, GL_TEXTURE_COMPARE_MODE,
                    unit.compares ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
}

void Textures::bind(int panel) const {
  for (const Unit &unit : m_units) {
    if (unit.panel != panel)
      continue;
    glActiveTexture(GL_TEXTURE0 + unit.number);
    glBindTexture(unit.target, unit.name);
    // Passes may sample a target's texture with different parameters.
    if (!unit.owned)
      setParameters(unit);
    if (unit.enabled)
      glEnable(unit.target);
  }
}

void Textures::release(int panel) const {
  for (const Unit &unit : m_units) {
    if (unit.panel != panel)
      continue;
    glActiveTexture(GL_TEXTURE0 + unit.number);
    if (unit.enabled)
      glDisable(unit.target);
    glBindTexture(unit.target, 0);
  }
}

void Textures::feed(int width, int height) const {
  for (const Unit &unit : m_units) {
    if (!unit.feedback)
      continue;
    glActiveTexture(GL_TEXTURE0 + unit.number);
    glBindTexture(unit.target, unit.name);
    glCopyTexSubImage2D(unit.target, 0, 0, 0, 0, 0, width, height);
    glBindTexture(unit.target, 0);
  }
}

} // namespace arbiter::tools
