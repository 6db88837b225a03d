#pragma once
#include <cstdint>
#include <vector>

#include "swrast/rasterize.h"
#include "swrast/setup/planes.h"

/// The render target of the rasterizer's tests. It records how often each pixel was shaded, and the
/// last value of an input.
namespace arbiter::swrast::testing {

struct Canvas {
  Canvas(int w, int h) : width(w), height(h) {
    counts.resize(std::size_t(w) * std::size_t(h));
    values.resize(counts.size());
    data.targets[0] = {reinterpret_cast<std::uint8_t *>(counts.data()), w * 4};
    data.targets[1] = {reinterpret_cast<std::uint8_t *>(values.data()), w * 4};
    state.viewport[2] = float(w);
    state.viewport[3] = float(h);
    state.clip = {0, 0, w, h};
    shading.data = &data;
    shading.row = countRow;
  }
  Canvas(const Canvas &) = delete;
  Canvas &operator=(const Canvas &) = delete;

  void useQuads(int lanes) {
    shading.row = nullptr;
    shading.lanes = lanes;
    shading.blockWidth = lanes == 4 ? 2 : 4;
    shading.blockHeight = lanes == 16 ? 4 : 2;
    shading.quad = lanes == 16 ? countQuad<4, 4> : lanes == 8 ? countQuad<4, 2> : countQuad<2, 2>;
  }
  /// Flips the rows as hosts store windows: the first row in memory is the top one.
  void turn(bool upsideDown) {
    state.upsideDownHeight = upsideDown ? height : 0;
    data.originY = planesBegin(state);
  }
  [[nodiscard]] std::uint32_t &at(int x, int y) {
    return counts[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
  [[nodiscard]] float valueAt(int x, int y) const {
    return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }

  static void shadePixel(const abi::FragmentData *data, const abi::Primitive *primitive, int x,
                         int y) {
    const auto place = [&](const abi::Target &target) {
      return target.base + std::ptrdiff_t(y) * target.rowStride + std::ptrdiff_t(x) * 4;
    };
    ++*reinterpret_cast<std::uint32_t *>(place(data->targets[0]));
    const abi::Plane &plane = primitive->inputs[0][0];
    *reinterpret_cast<float *>(place(data->targets[1])) = abi::planeAt(plane, x, y - data->originY);
  }
  static void countRow(const abi::FragmentData *data, const abi::Primitive *primitive,
                       const void *items, std::uint32_t count) {
    const auto *const spans = static_cast<const abi::Span *>(items);
    for (std::uint32_t i = 0; i < count; ++i)
      for (int x = 0; x < spans[i].count; ++x)
        shadePixel(data, primitive, spans[i].x + x, spans[i].y);
  }
  template <int kWidth, int kHeight>
  static void countQuad(const abi::FragmentData *data, const abi::Primitive *primitive,
                        const void *items, std::uint32_t count) {
    const auto *const blocks = static_cast<const abi::Block *>(items);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (blocks[i].x % kWidth || blocks[i].y % kHeight)
        __builtin_trap();
      for (int bit = 0; bit < kWidth * kHeight; ++bit)
        if ((blocks[i].mask >> bit) & 1)
          shadePixel(data, primitive, blocks[i].x + bit % kWidth, blocks[i].y + bit / kWidth);
    }
  }

  int width, height;
  std::vector<std::uint32_t> counts;
  std::vector<float> values;
  abi::FragmentData data;
  RasterState state;
  Shading shading;
};

/// Declares one input with one component.
inline void addInput(Canvas &canvas, abi::Interpolation interpolation) {
  canvas.shading.inputCount = 1;
  canvas.shading.interpolation[0] = interpolation;
  canvas.shading.inputComponents[0] = 1;
}

/// Vertices given in window coordinates of a canvas, with one input of one component.
struct WindowVertices {
  explicit WindowVertices(const Canvas &canvas) : m_canvas(canvas) {}
  void add(double x, double y, float input = 0, float w = 1, float z = 0) {
    position[0].push_back(float((x / m_canvas.width * 2 - 1) * w));
    position[1].push_back(float((y / m_canvas.height * 2 - 1) * w));
    position[2].push_back(z * w);
    position[3].push_back(w);
    inputs.push_back(input);
  }
  [[nodiscard]] Vertices get() const {
    Vertices result;
    result.count = std::uint32_t(inputs.size());
    for (int i = 0; i < 4; ++i)
      result.position[i] = position[i].data();
    result.inputs[0][0] = inputs.data();
    return result;
  }
  std::vector<float> position[4], inputs;

private:
  const Canvas &m_canvas;
};

inline DrawStatistics drawAll(Canvas &canvas, Topology topology, const WindowVertices &vertices) {
  return rasterize(canvas.state, canvas.shading, topology, vertices.get(), nullptr, 0,
                   std::uint32_t(vertices.inputs.size()));
}

} // namespace arbiter::swrast::testing
