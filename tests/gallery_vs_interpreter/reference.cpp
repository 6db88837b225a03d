#include "reference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/common.hpp>

#include "apps/scene/texture/generate.h"

namespace gallery {

namespace {

using scene::Generator;

constexpr double kDepths = 16777215; ///< levels of 24 bits

std::uint8_t level(float value) {
  return std::uint8_t(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

template <typename Enum> Enum valueOf(const std::optional<scene::Chosen<Enum>> &chosen) {
  return chosen ? chosen->value : Enum();
}

template <typename T> T orFail(arbiter::Result<T, scene::TextureError> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    std::exit(1);
  }
  return std::move(result).value();
}

scene::Image imageOf(const Surface &surface) {
  return scene::Image(scene::Picture{surface.width, surface.height, surface.color});
}

/// The fixed functions of one pass after the fragment program.
class Raster {
public:
  Raster(Surface &surface, const scene::State &state, scene::Depth depth)
      : m_surface(surface), m_state(state), m_depth(depth), m_stencil(valueOf(state.stencil)),
        m_blend(valueOf(state.blend)) {}

  [[nodiscard]] bool culled(bool front) const {
    const scene::Cull cull = valueOf(m_state.cull);
    return cull == (front ? scene::Cull::Front : scene::Cull::Back);
  }

  /// Makes the stencil and depth tests; the stencil counts if the depth test passes.
  bool passes(const Fragment &fragment) {
    const std::size_t at = index(fragment);
    std::uint8_t &count = m_surface.stencil[at];
    if ((m_stencil == scene::Stencil::Lit && count != 0) ||
        (m_stencil == scene::Stencil::Shadowed && count == 0))
      return false;
    const auto depth = std::uint32_t(std::llround(std::clamp(fragment.depth, 0.0, 1.0) * kDepths));
    std::uint32_t &there = m_surface.depth[at];
    if ((m_depth == scene::Depth::Less && depth >= there) ||
        (m_depth == scene::Depth::Lequal && depth > there) ||
        (m_depth == scene::Depth::Equal && depth != there))
      return false;
    if (m_stencil == scene::Stencil::Count)
      count = std::uint8_t(count + (fragment.front ? 1 : 255));
    if (m_state.depthWrite && m_depth != scene::Depth::Off)
      there = depth;
    return true;
  }

  [[nodiscard]] bool writesColor() const { return m_state.colorWrite; }

  void write(const Fragment &fragment, const glm::vec4 &color) {
    std::uint8_t *const there = &m_surface.color[4 * index(fragment)];
    glm::vec4 old;
    for (int i = 0; i < 4; ++i)
      old[i] = float(there[i]) / 255.0f;
    const glm::vec4 mixed = blended(glm::clamp(color, 0.0f, 1.0f), old);
    for (int i = 0; i < 4; ++i)
      there[i] = level(mixed[i]);
  }

private:
  [[nodiscard]] std::size_t index(const Fragment &fragment) const {
    return std::size_t(fragment.y) * std::size_t(m_surface.width) + std::size_t(fragment.x);
  }
  [[nodiscard]] glm::vec4 blended(const glm::vec4 &color, const glm::vec4 &old) const {
    switch (m_blend) {
    case scene::Blend::Off:
      return color;
    case scene::Blend::Alpha:
      return color * color.a + old * (1 - color.a);
    case scene::Blend::Premultiplied:
      return color + old * (1 - color.a);
    case scene::Blend::Add:
      return color + old;
    case scene::Blend::Multiply:
      return color * old;
    }
    return color;
  }

  Surface &m_surface;
  const scene::State &m_state;
  scene::Depth m_depth;
  scene::Stencil m_stencil;
  scene::Blend m_blend;
};

void clear(Surface &surface, const scene::State &state) {
  for (std::size_t i = 0; i < surface.color.size(); ++i)
    surface.color[i] = level(float(state.clear[i % 4].value));
  std::fill(surface.depth.begin(), surface.depth.end(), std::uint32_t(kDepths));
  std::fill(surface.stencil.begin(), surface.stencil.end(), std::uint8_t(0));
}

} // namespace

Surface::Surface(int columns, int rows)
    : width(columns), height(rows), color(4 * std::size_t(columns) * std::size_t(rows)),
      depth(std::size_t(columns) * std::size_t(rows)), stencil(depth.size()) {}

Reference::Reference(const scene::Document &document) : m_document(document) {
  for (const scene::Pass &pass : document.passes) {
    const auto [width, height] = document.sizeOf(pass);
    targetOf(pass) = Surface(width, height);
  }
  m_targets.try_emplace("", document.width(), document.height());
}

Surface &Reference::targetOf(const scene::Pass &pass) {
  const auto &target = m_document.panelOf(pass).target;
  return m_targets[target ? target->name.text : std::string()];
}

Texture Reference::textureOf(const scene::TextureSpec &spec) {
  const Generator generator = spec.source.generator.value;
  const bool rendered = generator == Generator::Picture || generator == Generator::DepthOf;
  const bool feedback = generator == Generator::Feedback && m_fed;
  Texture &texture = m_textures[&spec];
  if (rendered || feedback) {
    const Surface &surface = m_targets.at(rendered ? spec.source.target.text : std::string());
    if (rendered || texture.images.empty())
      texture.images = {imageOf(surface)};
    if (generator == Generator::DepthOf) {
      texture.depths.clear();
      for (const std::uint32_t depth : surface.depth)
        texture.depths.push_back(float(depth / kDepths));
    }
  } else if (texture.images.empty()) {
    texture.images = orFail(
        scene::generate(spec.source, m_document.folder, m_document.width(), m_document.height()));
  }
  texture.nearest = spec.filter.value == scene::Filter::Nearest;
  texture.wrap = spec.wrap.value;
  return texture;
}

void Reference::drawPass(std::size_t index, double seconds) {
  const scene::Pass &pass = m_document.passes[index];
  const scene::Panel &panel = m_document.panelOf(pass);
  Surface &surface = targetOf(pass);
  if (m_document.clears(index))
    clear(surface, panel.state);
  const auto mesh = scene::buildMesh(m_document.meshOf(pass), m_document.folder);
  const VertexStage vertexStage(m_document, pass, seconds);
  FragmentStage fragmentStage(m_document, pass, seconds);
  for (const scene::TextureSpec &spec : panel.textures)
    fragmentStage.setTexture(spec.unit, textureOf(spec));
  std::vector<Vertex> vertices;
  for (const scene::MeshVertex &vertex : mesh.value().vertices)
    vertices.push_back(vertexStage.run(vertex));
  Raster raster(surface, panel.state, m_document.depthOf(pass));
  const bool kills = fragmentStage.kills();
  const auto shade = [&](const Fragment &fragment) {
    if (raster.culled(fragment.front))
      return;
    const auto killed = kills ? fragmentStage.run(fragment) : std::optional(glm::vec4(0.0f));
    if (!killed || !raster.passes(fragment) || !raster.writesColor())
      return;
    raster.write(fragment, kills ? *killed : *fragmentStage.run(fragment));
  };
  const auto &indices = mesh.value().indices;
  for (std::size_t i = 0; i < indices.size(); i += 3)
    rasterize(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]],
              surface.width, surface.height, fragmentStage.used(), shade);
}

void Reference::draw(int frame) {
  for (std::size_t pass = 0; pass < m_document.passes.size(); ++pass)
    drawPass(pass, m_document.secondsOf(frame));
  m_fed = true;
  for (auto &[spec, texture] : m_textures)
    if (spec->source.generator.value == Generator::Feedback)
      texture.images = {imageOf(m_targets.at(""))};
}

scene::Picture Reference::picture() const {
  const Surface &surface = m_targets.at("");
  return {surface.width, surface.height, surface.color};
}

} // namespace gallery
