#include "common/demo.h"
#include "common/pictures.h"
#include "common/program.h"
#include "common/texture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace demos {
namespace {

/// The distance of a point from the border of its stone, and the stone's shade. The distance is the
/// difference of the distances to the two nearest points of a jittered lattice.
struct Stone {
  float border;
  float shade;
};

Stone stoneAt(glm::vec2 at) {
  const glm::vec2 cell = glm::floor(at);
  float nearest = 9, second = 9, shade = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const glm::vec2 corner = cell + glm::vec2(dx, dy);
      const glm::vec2 jitter(fractalNoise(corner * 7.0f + 0.0f, 1),
                             fractalNoise(corner * 5.0f + 90.0f, 1));
      const float distance = glm::length(corner + 0.15f + 0.7f * jitter - at);
      if (distance < nearest) {
        second = nearest;
        nearest = distance;
        shade = jitter.x;
      } else {
        second = std::min(second, distance);
      }
    }
  }
  return {second - nearest, shade};
}

float heightAt(glm::vec2 coordinate) {
  const Stone stone = stoneAt(coordinate * 9.0f);
  const float dome = glm::smoothstep(0.0f, 0.38f, stone.border);
  return 0.022f * dome + 0.010f * stone.shade * dome + 0.009f * fractalNoise(coordinate * 36.0f, 4);
}

/// Makes normals in [0,1] from the slopes of the height field.
Image makeNormals(int width, int height) {
  std::vector<float> field(std::size_t(width) * height);
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      field[std::size_t(y) * width + x] = heightAt(image.coordinate(x, y));
  const auto at = [&](int x, int y) {
    return field[std::size_t(std::clamp(y, 0, height - 1)) * width + std::clamp(x, 0, width - 1)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec3 normal =
          glm::normalize(glm::vec3((at(x - 1, y) - at(x + 1, y)) * 0.5f * float(width),
                                   (at(x, y - 1) - at(x, y + 1)) * 0.5f * float(height), 1.0f));
      image.set(x, y, glm::vec4(normal * 0.5f + 0.5f, 1.0f));
    }
  }
  return image;
}

/// Makes stone colors, with the gloss in alpha.
Image makeSurface(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec2 at = image.coordinate(x, y);
      const Stone stone = stoneAt(at * 9.0f);
      const float grain = 0.75f + 0.35f * fractalNoise(at * 60.0f, 4);
      const glm::vec3 warm(0.74f, 0.60f, 0.46f), cool(0.52f, 0.56f, 0.62f),
          mortar(0.22f, 0.2f, 0.18f);
      const float top = glm::smoothstep(0.02f, 0.14f, stone.border);
      const glm::vec3 color =
          glm::mix(mortar, glm::mix(warm, cool, glm::smoothstep(0.3f, 0.7f, stone.shade)), top) *
          grain;
      image.set(x, y, glm::vec4(color, 0.1f + 0.5f * top));
    }
  }
  return image;
}

/// Returns a color of the given hue in [0,1], pale as lamps are.
glm::vec3 lampColor(float hue) {
  const glm::vec3 phase = glm::vec3(hue) + glm::vec3(0.0f, 2.0f / 3.0f, 1.0f / 3.0f);
  return 0.65f + 0.35f * glm::cos(6.2831853f * phase);
}

/// The local parameters of lighting.fp.
struct Lamp {
  glm::vec4 position;
  glm::vec4 color;   ///< w: fall-off
  glm::vec4 ambient; ///< w: shininess
};

/// Computes lighting.fp in C++.
glm::vec4 shade(const Lamp &lamp, glm::vec4 packedNormal, glm::vec4 surface, glm::vec2 place) {
  const glm::vec3 normal = glm::normalize(glm::vec3(packedNormal) * 2.0f - 1.0f);
  const glm::vec3 ray = glm::vec3(lamp.position) - glm::vec3(place, 0.0f);
  const float fade = 1.0f / (1.0f + lamp.color.w * glm::dot(ray, ray));
  const glm::vec3 toLight = glm::normalize(ray);
  const glm::vec3 halfway = glm::normalize(toLight + glm::vec3(0, 0, 1));
  const float diffuse = std::max(glm::dot(normal, toLight), 0.0f);
  const float base = std::max(glm::dot(normal, halfway), 0.0f);
  const float specular = diffuse > 0 ? std::pow(base, lamp.ambient.w) : 0.0f;
  const glm::vec3 matt =
      (glm::vec3(lamp.color) * diffuse * fade + glm::vec3(lamp.ambient)) * glm::vec3(surface);
  return glm::vec4(glm::vec3(lamp.color) * specular * fade * surface.w + matt, 1.0f);
}

/// Lights each pixel from a normal map: diffuse and specular light of a moving lamp.
class Lighting final : public Demo {
public:
  [[nodiscard]] std::string name() const override { return "lighting"; }
  [[nodiscard]] std::string summary() const override {
    return "Lights a bumpy surface pixel by pixel from a normal map.";
  }
  [[nodiscard]] std::string controls() const override {
    return "  Mouse drag  moves the lamp, which then stops circling    C  circle again\n";
  }
  [[nodiscard]] std::vector<Slider *> sliders() override {
    return {&m_brightness, &m_hue, &m_height, &m_x, &m_y};
  }
  // RSQ, POW and RCP are approximations.
  [[nodiscard]] Tolerance tolerance() const override { return {3}; }
  [[nodiscard]] int verifyFrames() const override { return 2; }

  [[nodiscard]] bool start(const Surface &surface, const Options &options) override {
    m_normals = makeNormals(surface.width(), surface.height());
    m_surface = makeSurface(surface.width(), surface.height());
    m_gl.emplace();
    m_gl->normals.create2d(m_normals, Filter::Nearest, Wrap::Clamp);
    m_gl->surface.create2d(m_surface, Filter::Nearest, Wrap::Clamp);
    return m_gl->program.load("lighting.fp", options.program);
  }
  void draw(const Surface &, int frame) override {
    const Lamp now = lamp(frame);
    m_gl->normals.bind(0);
    m_gl->surface.bind(1);
    m_gl->program.use();
    m_gl->program.local(0, now.position);
    m_gl->program.local(1, now.color);
    m_gl->program.local(2, now.ambient);
    drawQuad();
    Program::disable();
  }
  [[nodiscard]] Image reference(int width, int height, int frame) override {
    const Lamp now = lamp(frame);
    Image image(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        image.set(x, y, shade(now, m_normals.at(x, y), m_surface.at(x, y), image.coordinate(x, y)));
    return image;
  }
  void stop() override { m_gl.reset(); }
  [[nodiscard]] std::vector<std::string> programCounts() const override {
    return {m_gl->program.countsAsJson()};
  }
  void pointer(glm::vec2 at) override {
    m_circles = false;
    m_x.value = at.x;
    m_y.value = at.y;
  }
  void key(char letter) override { m_circles |= letter == 'C'; }

private:
  [[nodiscard]] Lamp lamp(int frame) const {
    const float angle = 2.2f + float(frame) * 0.02f;
    const float orbit = m_circles ? 0.22f : 0.0f;
    const glm::vec3 color = lampColor(m_hue.value) * m_brightness.value;
    return {{m_x.value + orbit * std::cos(angle), m_y.value + orbit * std::sin(angle),
             m_height.value, 0},
            glm::vec4(color, 9.0f),
            {0.07f, 0.08f, 0.11f, 24.0f}};
  }

  struct Objects {
    Texture normals;
    Texture surface;
    Program program;
  };
  Slider m_brightness{"brightness", "of the lamp", 1.7f, 0.0f, 4.0f, 0.1f};
  Slider m_hue{"hue", "of the lamp: 0 red, 1/3 green, 2/3 blue", 0.08f, 0.0f, 1.0f, 0.02f};
  Slider m_height{"height", "of the lamp over the surface", 0.16f, 0.02f, 1.0f, 0.02f};
  Slider m_x{"light-x", "of the lamp, or of the centre of its circle", 0.5f, 0.0f, 1.0f, 0.02f};
  Slider m_y{"light-y", "of the lamp, or of the centre of its circle", 0.5f, 0.0f, 1.0f, 0.02f};
  bool m_circles = true;
  Image m_normals;
  Image m_surface;
  std::optional<Objects> m_gl;
};

} // namespace
} // namespace demos

int main(int argc, char **argv) {
  demos::Lighting demo;
  return demos::run(demo, argc, argv);
}
