#include <atomic>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

#include "swrast/cover/packed.h"
#include "swrast/queue/draw_queue.h"
#include "swrast/testing/canvas.h"
#include "util/processor.h"

/// Compares packed small triangles with blocks whose shading function tests depth itself.
namespace arbiter::swrast {
namespace {

using testing::Canvas;
using testing::WindowVertices;

constexpr abi::Layout kLayouts[] = {abi::Layout::None, abi::Layout::Depth16,
                                    abi::Layout::Depth24Stencil8, abi::Layout::Depth32F,
                                    abi::Layout::Depth32};

/// Tests one pixel's depth as the machine code must, written from the specification (4.1.6).
bool testReference(const DepthTest &test, const abi::FragmentData &data,
                   const abi::Primitive &primitive, int x, int y) {
  if (test.layout == abi::Layout::None)
    return true;
  const int bytes = abi::bytesOf(test.layout);
  std::uint8_t *const place = data.depthStencil.base + y * data.depthStencil.rowStride + x * bytes;
  std::uint32_t pixel = 0;
  std::memcpy(&pixel, place, std::size_t(bytes));
  const abi::DepthPlane &z = primitive.z;
  const float along = std::fma(z.dx, float(x), z.c);
  const float plane = std::fma(z.dy, float(y - data.originY), along) + z.offset;
  const float depth = std::min(std::max(plane, data.depthMinimum), data.depthMaximum);
  double incoming = depth, stored = 0;
  std::uint32_t made = 0;
  if (test.layout == abi::Layout::Depth32F) {
    float value = 0;
    std::memcpy(&value, &pixel, 4);
    stored = value;
    std::memcpy(&made, &depth, 4);
  } else if (test.layout == abi::Layout::Depth32) {
    made = depth == 1.0f ? 0xFFFFFFFFu : 2 * std::uint32_t(std::floor(std::ldexp(depth, 31)));
    incoming = made;
    stored = pixel;
  } else {
    const bool half = test.layout == abi::Layout::Depth16;
    volatile const float scaled = depth * (half ? 65535.0f : 16777215.0f);
    incoming = std::nearbyint(double(scaled));
    stored = half ? pixel : pixel >> 8;
    made = half ? std::uint32_t(incoming) : std::uint32_t(incoming) << 8 | (pixel & 255);
  }
  const bool results[] = {false,
                          incoming<stored, incoming == stored, incoming <= stored, incoming> stored,
                          incoming != stored, incoming >= stored, true};
  const bool passes = results[int(test.compare)];
  if (passes && test.write)
    std::memcpy(place, &made, std::size_t(bytes));
  return passes;
}

/// the current draw's test; global, because shading functions get no more than their data
DepthTest g_test;
bool g_quads = false;
int g_lanes = 16; ///< lanes of the packed shading function

std::atomic<std::uint32_t> g_inBlocks = 0; ///< number of pixels; threads count them

void testedBlocks(const abi::FragmentData *data, const abi::Primitive *primitive, const void *items,
                  std::uint32_t count) {
  const auto *const blocks = static_cast<const abi::Block *>(items);
  for (std::uint32_t i = 0; i < count; ++i)
    for (int bit = 0; bit < 16; ++bit) {
      const int x = blocks[i].x + bit % 4, y = blocks[i].y + bit / 4;
      if ((blocks[i].mask >> bit & 1) && testReference(g_test, *data, *primitive, x, y)) {
        Canvas::shadePixel(data, primitive, x, y);
        ++g_inBlocks;
      }
    }
}

std::atomic<std::uint32_t> g_several =
    0; ///< number of calls whose first vector has pixels of several triangles

void packedPixels(const abi::FragmentData *data, const abi::PrimitiveColumns *primitives,
                  const abi::Pixel *pixels, std::uint32_t count) {
  if (count % unsigned(g_lanes) != 0)
    __builtin_trap();
  g_several += pixels[0].column != pixels[g_lanes - 1].column ? 1 : 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Pixel &pixel = pixels[i], &first = pixels[i & ~3u];
    if (pixel.column >= g_lanes)
      __builtin_trap(); // no lane would read this column
    // The last quad may be followed by any number of padding pixels.
    const bool padding =
        (first.isHelper & (&first)[1].isHelper & (&first)[2].isHelper & (&first)[3].isHelper) != 0;
    if (g_quads && !padding &&
        (pixel.x != first.x + (i & 1) || pixel.y != first.y + (i >> 1 & 1) || first.x % 2 != 0 ||
         pixel.column != first.column))
      __builtin_trap();
    if (pixel.isHelper)
      continue;
    const abi::Primitive primitive = primitives->at(pixel.column);
    Canvas::shadePixel(data, &primitive, primitives->baseX + pixel.x, primitives->baseY + pixel.y);
  }
}

struct Picture {
  std::vector<std::uint32_t> counts;
  std::vector<float> values;
  std::vector<std::uint32_t> depth;
};

struct Case {
  DepthTest test;
  bool replaces = false, quads = false, stippled = false;
  int lanes = 16;
  Rect clip;
  std::vector<float> x, y, z;
};

constexpr int kWidth = 157, kHeight = 141;

Picture drawn(const Case &what, bool packed, bool queued = false) {
  static const std::vector<std::uint8_t> stipple(128, 0xB6);
  g_test = what.test;
  g_quads = what.quads;
  g_lanes = what.lanes;
  Canvas canvas(kWidth, kHeight);
  std::mt19937 random(7);
  std::vector<std::uint32_t> depth(std::size_t(kWidth * kHeight));
  for (std::uint32_t &pixel : depth) {
    pixel = std::uint32_t(random());
    if (what.test.layout == abi::Layout::Depth32F) {
      const float value = float(random() % 1000) / 1000.0f;
      std::memcpy(&pixel, &value, 4);
    }
  }
  canvas.data.depthStencil = {reinterpret_cast<std::uint8_t *>(depth.data()),
                              kWidth * std::max(2, abi::bytesOf(what.test.layout))};
  canvas.data.depthMinimum = 0.1f;
  canvas.useQuads(16);
  canvas.shading.quad = testedBlocks;
  if (packed) {
    canvas.shading.packed = packedPixels;
    canvas.shading.lanes = what.lanes;
    canvas.shading.depth = what.test;
    canvas.shading.packsQuads = what.quads;
    canvas.shading.replaces = what.replaces;
  }
  canvas.state.clip = what.clip;
  canvas.state.polygonStipple = what.stippled ? stipple.data() : nullptr;
  canvas.shading.inputCount = 1;
  canvas.shading.interpolation[0] = abi::Interpolation::Linear;
  canvas.shading.inputComponents[0] = 1;
  WindowVertices vertices(canvas);
  for (std::size_t i = 0; i < what.x.size(); ++i)
    vertices.add(what.x[i], what.y[i], float(i / 3 * 10) + what.z[i], 1, 2 * what.z[i] - 1);
  if (queued) {
    DrawQueue queue;
    const ShadingUse use;
    EXPECT_TRUE(queue.add(canvas.state, canvas.shading, Topology::Triangles, vertices.get(),
                          nullptr, 0, std::uint32_t(what.x.size()), use));
    queue.finish();
  } else {
    drawAll(canvas, Topology::Triangles, vertices);
  }
  return {canvas.counts, canvas.values, depth};
}

Case randomCase(std::mt19937 &random, int round) {
  Case what;
  what.test = {kLayouts[random() % 4], abi::Compare(random() % 8), random() % 4 != 0};
  what.replaces = random() % 2 != 0;
  what.quads = random() % 2 != 0;
  what.lanes = round % 2 ? 8 : 16;
  what.stippled = random() % 8 == 0;
  what.clip = random() % 3 ? Rect{0, 0, kWidth, kHeight} : Rect{13, 6, 101, 77};
  const int triangles = round % 5 == 0 ? 2000 : 150;
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < triangles; ++i) {
    // Some are too large to be small triangles, and must wait for those before them.
    const float size = i % 40 == 39 ? 150.0f : i % 3 ? 9.0f : 40.0f;
    const float thin = i % 80 == 39 ? 0.03f : 1.0f; // thin ones, which are packed as well
    const float x = unit(random) * kWidth, y = unit(random) * kHeight;
    for (int k = 0; k < 3; ++k) {
      what.x.push_back(std::clamp(x + size * thin * (unit(random) - 0.5f), 0.0f, float(kWidth)));
      what.y.push_back(std::clamp(y + size * (unit(random) - 0.5f), 0.0f, float(kHeight)));
      what.z.push_back(unit(random));
    }
  }
  return what;
}

TEST(Packed, DrawsWhatBlocksDraw) {
  std::mt19937 random(1);
  for (int round = 0; round < 160; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const Case what = randomCase(random, round);
    const Picture expected = drawn(what, false), got = drawn(what, true);
    ASSERT_EQ(got.depth, expected.depth);
    ASSERT_EQ(std::memcmp(got.values.data(), expected.values.data(), got.values.size() * 4), 0);
    std::uint64_t fewer = 0;
    for (std::size_t i = 0; i < got.counts.size(); ++i) {
      ASSERT_EQ(got.counts[i] == 0, expected.counts[i] == 0);
      ASSERT_LE(got.counts[i], expected.counts[i]);
      fewer += expected.counts[i] - got.counts[i];
    }
    if (!what.replaces) {
      ASSERT_EQ(fewer, 0u) << "a fragment that counts was left out";
    } else if (round % 5 == 0 && what.test.compare == abi::Compare::Always) {
      ASSERT_GT(fewer, 0u) << "what is covered was shaded";
    }
  }
  EXPECT_GT(g_several, 1000u) << "each vector had one triangle's pixels";
}

TEST(Packed, LargeThinShapesArePackedToo) {
  std::mt19937 random(5);
  Case what = randomCase(random, 0);
  what.test = {abi::Layout::Depth24Stencil8, abi::Compare::Less, true};
  what.replaces = true;
  what.stippled = false;
  what.clip = {0, 0, kWidth, kHeight};
  what.x.clear();
  what.y.clear();
  what.z.clear();
  for (int i = 0; i < 60; ++i) {
    const float at = 3.0f + 2.4f * float(i);
    for (const float y : {2.0f, 139.0f, 70.0f}) {
      what.x.push_back(i % 2 ? y : std::min(at + (y == 70.0f ? 2.5f : 0.0f), float(kWidth)));
      what.y.push_back(i % 2 ? std::min(at + (y == 70.0f ? 2.5f : 0.0f), float(kHeight)) : y);
      what.z.push_back(0.5f);
    }
  }
  g_inBlocks = 0;
  const Picture expected = drawn(what, false);
  EXPECT_GT(g_inBlocks.load(), 0u);
  for (const bool queued : {false, true}) {
    g_inBlocks = 0;
    const Picture got = drawn(what, true, queued);
    EXPECT_EQ(got.depth, expected.depth);
    EXPECT_EQ(std::memcmp(got.values.data(), expected.values.data(), got.values.size() * 4), 0);
    EXPECT_EQ(g_inBlocks.load(), 0u);
  }
}

/// A tile in the middle of a buffer, filled with depths.
struct Tile {
  Tile(const DepthTest &test, const Rect &rect, int originY) : buffer(128 * 128) {
    std::mt19937 random(3);
    for (std::uint32_t &pixel : buffer) {
      const float value = float(random() % 4096) / 4095.0f;
      std::memcpy(&pixel, &value, 4);
      if (test.layout != abi::Layout::Depth32F)
        pixel = std::uint32_t(random());
      else if (random() % 64 == 0)
        pixel = 0x7FC00000; // NaN, which an application may write
    }
    data.depthStencil = {reinterpret_cast<std::uint8_t *>(buffer.data()),
                         128 * std::max(2, abi::bytesOf(test.layout))};
    Shading shading;
    shading.data = &data;
    shading.depth = test;
    tile->begin(rect, shading, originY);
  }
  std::vector<std::uint32_t> buffer;
  abi::FragmentData data;
  std::unique_ptr<PackedTile> tile = std::make_unique<PackedTile>();
};

/// Returns the kernels of this processor beyond the baseline.
std::vector<const PackedKernels *> otherKernels() {
  std::vector<const PackedKernels *> result;
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() >= Vectors::Avx2)
    result.push_back(&kPackedAvx2);
  if (vectors() >= Vectors::Avx512)
    result.push_back(&kPackedAvx512);
#endif
  return result;
}

class Kernels : public ::testing::TestWithParam<const PackedKernels *> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Kernels); // some processors run the baseline alone
INSTANTIATE_TEST_SUITE_P(Processors, Kernels, ::testing::ValuesIn(otherKernels()),
                         [](const auto &row) { return std::to_string(row.index); });

TEST_P(Kernels, AreTheSameOnAllInstructionSets) {
  const PackedKernels &best = *GetParam();
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-0.5f, 1.5f);
  for (int round = 0; round < 400; ++round) {
    const DepthTest test = {kLayouts[random() % 4], abi::Compare(random() % 8), random() % 2 != 0};
    const Rect rect = round % 2 ? Rect{64, 0, 64, 64} : Rect{71, 3, 50, 41};
    const int originY = int(random() % 64);
    Tile a(test, rect, originY), b(test, rect, originY);
    for (std::uint32_t owner = 1; owner < 12; ++owner) {
      std::vector<abi::Block> blocks, left(300), same(300);
      for (int y = 0; y < 64; y += 4)
        for (int x = 64; x < 128; x += 4)
          if (random() % 4 == 0)
            blocks.push_back({std::int16_t(x), std::int16_t(y), std::uint16_t(random()), 0});
      abi::DepthPlane z = {unit(random), unit(random) / 40, unit(random) / 40, unit(random) / 10};
      if (owner == 5)
        z.dx = NAN;
      const auto count = std::uint32_t(blocks.size());
      const std::uint32_t n =
          kPackedBaseline.test(test)(*a.tile, z, owner, blocks.data(), count, left.data());
      ASSERT_EQ(best.test(test)(*b.tile, z, owner, blocks.data(), count, same.data()), n);
      ASSERT_EQ(std::memcmp(left.data(), same.data(), n * sizeof(abi::Block)), 0);
      for (const bool quads : {false, true})
        for (const std::uint32_t of : {0u, owner, owner - 1}) {
          std::vector<abi::Pixel> pixels(5000), others(5000);
          const std::uint32_t m =
              kPackedBaseline.list(*a.tile, of, owner, quads, left.data(), n, pixels.data());
          ASSERT_EQ(best.list(*b.tile, of, owner, quads, left.data(), n, others.data()), m);
          ASSERT_EQ(std::memcmp(pixels.data(), others.data(), m * sizeof(abi::Pixel)), 0);
        }
    }
    a.tile->end();
    b.tile->end();
    ASSERT_EQ(a.buffer, b.buffer);
  }
}

/// Triangles of several draws, with the values that their planes come from.
struct Group {
  static constexpr int kVertices = 60;
  static constexpr int kWindow = 20; ///< number of vertices with a position
  Group(std::mt19937 &random, int count) {
    std::uniform_real_distribution<float> unit(-1, 1);
    state.upsideDownHeight = random() % 2 ? 64 : 0;
    for (WindowVertex &vertex : window) {
      vertex = {40 * unit(random), 40 * unit(random), 0, 1 + 0.5f * unit(random), 0, 0, 0};
      snapVertex(vertex, state.upsideDownHeight);
    }
    for (float &value : values)
      value = random() % 9 == 0 ? 0.5f : unit(random); // equal values, for constant planes
    for (PlanePlan &plan : plans) {
      plan.wantsW = random() % 4 != 0;
      for (plan.count = 0; plan.count < 9; ++plan.count) {
        const float *const front = values + random() % 40, *const back = values + random() % 40;
        const bool isConstant = random() % 5 == 0, hasSides = random() % 2 != 0;
        const std::uint32_t mask = isConstant ? 0 : ~0u;
        plan.sources[plan.count] = {{front, hasSides ? back : front},
                                    {mask, mask},
                                    std::uint8_t(plan.count / 4),
                                    std::uint8_t(plan.count % 4)};
      }
      plan.linearFrom = 3;
      plan.flatFrom = 6;
    }
    std::size_t plan = 0;
    for (int k = 0; k < count; ++k) {
      PackedTriangle &each = triangles[k];
      SmallTriangle &own = small[k];
      plan = random() % 6 == 0 ? (plan + 1) % 2 : plan;
      each.plan = &plans[plan];
      each.small = &own;
      each.window = window;
      for (std::uint32_t &vertex : own.vertex)
        vertex = std::uint32_t(random() % kWindow);
      if (k % 7 == 3) // makes it degenerate
        own.vertex[2] = own.vertex[1];
      own.provokingAndFace = own.vertex[random() % 3] << 1 | (random() & 1);
      own.originX = std::int16_t(random() % 64);
      own.originY = std::int16_t(random() % 64);
      each.depth = {unit(random), unit(random), unit(random), unit(random)};
      each.made = nullptr;
      if (k % 5 == 2) { // gives it ready-made planes, as a shape has
        makePlanes(state, *each.plan, own, window, made[k]);
        each.made = &made[k];
        each.inputs = abi::kMaxInputs;
      }
      pointers[k] = &each;
    }
  }
  float values[kVertices];
  PlanePlan plans[2];
  RasterState state;
  WindowVertex window[kWindow];
  SmallTriangle small[abi::PrimitiveColumns::kColumns];
  PackedTriangle triangles[abi::PrimitiveColumns::kColumns];
  abi::Primitive made[abi::PrimitiveColumns::kColumns] = {};
  const PackedTriangle *pointers[abi::PrimitiveColumns::kColumns];
};

/// All kernels must compute the planes of makePlanes(), bit for bit.
TEST(Packed, ColumnsAreThePlanesOfEachTriangle) {
  std::vector<const PackedKernels *> all = otherKernels();
  all.push_back(&kPackedBaseline);
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const int count = 1 + round % abi::PrimitiveColumns::kColumns;
    const Group group(random, count);
    for (const PackedKernels *const kernels : all) {
      auto columns = std::make_unique<abi::PrimitiveColumns>();
      std::memset(columns->rows, 0, sizeof columns->rows);
      kernels->columns(group.state, group.pointers, count, *columns);
      for (int k = 0; k < count; ++k) {
        const PackedTriangle &each = group.triangles[k];
        abi::Primitive expected = {};
        makePlanes(group.state, *each.plan, *each.small, each.window, expected);
        expected.z = each.depth;
        abi::Primitive got = columns->at(k);
        if (!each.plan->wantsW)
          got.inverseW = {};
        ASSERT_EQ(std::memcmp(&got, &expected, sizeof got), 0) << "column " << k;
      }
    }
  }
}

} // namespace
} // namespace arbiter::swrast
