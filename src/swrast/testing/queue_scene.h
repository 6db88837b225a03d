#pragma once
#include <cstdint>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "swrast/image/copy_pixels.h"
#include "swrast/image/image.h"
#include "swrast/queue/draw_queue.h"
#include "swrast/rasterize.h"

/// Helpers for tests of queued draws: a target, meshes, and a shading function whose pixels tell
/// how often, and in which order, it ran.
namespace arbiter::swrast {

inline constexpr int kSize = 200;
inline constexpr abi::Format kWord = {abi::Layout::U8x4, abi::kRgba, 0};

/// Shades a pixel: pixel = 3 * pixel + parameter. The result depends on the order and number of
/// draws. If a texture is bound, its texel is added.
inline void shadePixel(const abi::FragmentData *data, int x, int y) {
  std::uint32_t add = 0;
  std::memcpy(&add, data->parameters[0], sizeof add);
  const auto place = [&](const std::uint8_t *base, std::int64_t stride) {
    return base + y * stride + std::ptrdiff_t(x) * 4;
  };
  if (const abi::TextureView *const texture = data->textures[0]) {
    std::uint32_t texel = 0;
    // Samples the opposite side of the image, which another thread's tile contains.
    const abi::TextureLevel &level = texture->levels[0];
    std::memcpy(&texel,
                level.base + (level.height - 1 - y) * level.rowStride +
                    std::ptrdiff_t(level.width - 1 - x) * 4,
                sizeof texel);
    add += texel;
  }
  auto *const pixel =
      const_cast<std::uint8_t *>(place(data->targets[0].base, data->targets[0].rowStride));
  std::uint32_t value = 0;
  std::memcpy(&value, pixel, sizeof value);
  value = 3 * value + add;
  std::memcpy(pixel, &value, sizeof value);
}
inline void shadeRow(const abi::FragmentData *data, const abi::Primitive *, const void *items,
                     std::uint32_t count) {
  const auto *const spans = static_cast<const abi::Span *>(items);
  for (std::uint32_t i = 0; i < count; ++i)
    for (int x = 0; x < spans[i].count; ++x)
      shadePixel(data, spans[i].x + x, spans[i].y);
}

/// A target, with the state and the shading for draws to it.
struct Scene {
  explicit Scene(const Image &image) : target(image) { refer(); }
  Scene(const Scene &) = delete;
  Scene &operator=(const Scene &) = delete;

  void refer() {
    state.viewport[2] = state.viewport[3] = float(kSize);
    state.clip = {0, 0, kSize, kSize};
    state.clears = {};
    state.clears.add(target.storage->pendingClear());
    data.parameters = &parameter;
    data.targets[0] = {target.placeOf(0, 0), target.rowStride};
    shading.data = &data;
    shading.row = shadeRow;
    shading.readsDepth = shading.readsW = false;
    storages[0] = target.storage.get();
    use.targets = {storages, 1};
    use.parameterRows = 1;
    use.functions = kept;
  }
  void setParameter(std::uint32_t value) { std::memcpy(parameter, &value, sizeof value); }
  void sample(const Image &image) {
    if (image.storage->pendingClear())
      image.complete();
    level = {image.placeOf(0, 0), image.rowStride, 0, image.width, image.height, 1, 0};
    view.levels = &level;
    view.levelCount = 1;
    data.textures[0] = &view;
    storages[1] = image.storage.get();
    use.textures = {storages + 1, 1};
    use.imageCount[0] = 1;
  }

  Image target;
  RasterState state;
  Shading shading;
  abi::FragmentData data;
  float parameter[4] = {};
  abi::TextureLevel level;
  abi::TextureView view;
  Storage *storages[2] = {};
  ShadingUse use;
  std::shared_ptr<int> kept = std::make_shared<int>(0);
};

struct Mesh {
  void add(double x, double y) {
    position[0].push_back(float(x / kSize * 2 - 1));
    position[1].push_back(float(y / kSize * 2 - 1));
    position[2].push_back(0);
    position[3].push_back(1);
  }
  [[nodiscard]] Vertices get() const {
    Vertices vertices;
    vertices.count = std::uint32_t(position[0].size());
    for (int i = 0; i < 4; ++i)
      vertices.position[i] = position[i].data();
    return vertices;
  }
  [[nodiscard]] std::uint32_t count() const { return std::uint32_t(position[0].size()); }
  std::vector<float> position[4];
};

inline Mesh meshOf(std::mt19937 &random, int vertices, double size) {
  std::uniform_real_distribution<double> place(-20, kSize + 20), offset(-size, size);
  Mesh mesh;
  double x = 0, y = 0;
  for (int i = 0; i < vertices; ++i) {
    if (i % 3 == 0) {
      x = place(random);
      y = place(random);
    }
    mesh.add(x + offset(random), y + offset(random));
  }
  return mesh;
}
inline Mesh quad(double x, double y, double width, double height) {
  Mesh mesh;
  mesh.add(x, y);
  mesh.add(x + width, y);
  mesh.add(x + width, y + height);
  mesh.add(x, y + height);
  return mesh;
}

inline void clear(Image &image, float value) {
  const float rgba[4] = {value, value, value, value};
  fill(image, {0, 0, image.width, image.height}, rgba, 15);
}
inline Image cleared(float value = 0) {
  Image image = makeImage(kWord, kSize, kSize);
  clear(image, value);
  return image;
}
inline std::vector<std::uint32_t> pixelsOf(const Image &image) {
  std::vector<std::uint32_t> pixels;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::uint32_t value = 0;
      std::memcpy(&value, image.pixel(x, y), sizeof value);
      pixels.push_back(value);
    }
  return pixels;
}

/// Draws through the queue, or at once if the queue refuses the draw.
inline bool drawBy(DrawQueue &queue, Scene &scene, Topology topology, const Mesh &mesh) {
  const Vertices vertices = mesh.get();
  if (queue.add(scene.state, scene.shading, topology, vertices, nullptr, 0, mesh.count(),
                scene.use))
    return true;
  queue.finish();
  (void)rasterize(scene.state, scene.shading, topology, vertices, nullptr, 0, mesh.count());
  return false;
}
inline void drawAtOnce(Scene &scene, Topology topology, const Mesh &mesh) {
  (void)rasterize(scene.state, scene.shading, topology, mesh.get(), nullptr, 0, mesh.count());
}

} // namespace arbiter::swrast
