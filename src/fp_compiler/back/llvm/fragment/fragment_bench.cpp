/// Measures the fragment functions of the demos' programs on images of 1024x1024 pixels. Whole rows
/// are spans. It uses one and two threads, and compares with a plain copy of the image.
///   fragment_bench [--size N] [program]     images of NxN pixels
///   fragment_bench --asm|--ir program       prints machine code or IR instead of times
///   ARBITER_JIT_CPU=avx2                    generates code for another processor
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>

#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

#include "fp_compiler/back/llvm/code/cpu.h"
#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/back/llvm/fragment/fragment.h"
#include "fp_compiler/back/llvm/program/emit.h"
#include "fp_compiler/back/llvm/testing/fragment_scene.h"
#include "fp_compiler/compiler.h"

using namespace arbiter;
using namespace arbiter::fp;
using namespace arbiter::fp::testing;

namespace {
int g_size = 1024; ///< size of the images, a power of two

struct Sampled {
  abi::Filter filter = abi::Filter::Nearest;
  abi::Wrap wrap = abi::Wrap::ClampToEdge;
  int width = 0, height = 0; ///< 0: size of the images
  abi::Dimension dimension = abi::Dimension::Tex2D;
  abi::Layout layout = abi::Layout::U8x4;
};
struct Workload {
  const char *program;
  std::vector<Sampled> samplers;
  std::vector<std::array<float, 4>> locals;
  std::vector<QuadInput> inputs; ///< by texture coordinate set
};

const Sampled kCells = {abi::Filter::Nearest, abi::Wrap::Repeat};
std::vector<Workload> makeWorkloads() {
  const float texel = 1.0f / float(g_size);
  return {
      {"pass_through", {{}}, {}, {{}}},
      {"brightness_contrast", {{}}, {{0.8f, 1.2f, -0.1f, 0}}, {{}}},
      {"life_naive", {kCells}, {{texel, texel, -texel, 0}}, {{}}},
      {"life_pack", {kCells}, {}, {{}, {-texel, 0, 1 - texel, 1}, {texel, 0, 1 + texel, 1}}},
      {"life_packed",
       {kCells, {abi::Filter::Nearest, abi::Wrap::ClampToEdge, 2, 16}},
       {},
       {{}, {0, texel, 1, 1 + texel}, {0, -texel, 1, 1 - texel}}},
      {"twirl",
       {{abi::Filter::Linear},
        {abi::Filter::Nearest, abi::Wrap::ClampToEdge, 0, 0, abi::Dimension::Tex2D,
         abi::Layout::U16x4}},
       {{0.2f, -0.1f, 0, 0}},
       {{}}},
      {"lighting",
       {{}, {}},
       {{0.4f, 0.6f, 0.3f, 1}, {1.0f, 0.9f, 0.8f, 9.0f}, {0.1f, 0.1f, 0.12f, 20.0f}},
       {{}}},
      {"cartoon",
       {{abi::Filter::Linear, abi::Wrap::ClampToEdge, 32, 1, abi::Dimension::Tex1D},
        {abi::Filter::Linear, abi::Wrap::ClampToEdge, 32, 1, abi::Dimension::Tex1D}},
       {{0.5f, 0.6f, 0.62f, 0}},
       {{-1, -1, 1, 1}, {-0.2f, -0.1f, 0.3f, 0.4f}}},
  };
}

/// All data that a workload's calls need.
struct Case {
  std::unique_ptr<jit::FragmentProgram> program;
  abi::FragmentKey key{};
  abi::FragmentData data{};
  abi::Primitive primitive{};
  std::vector<std::array<float, 4>> rows;
  std::vector<std::unique_ptr<SceneTexture>> textures;
  std::vector<const abi::TextureView *> views;
  SceneTarget target;
};

std::string textOf(const std::string &name) {
  std::ifstream file(std::string(DEMO_PROGRAMS) + "/" + name + ".fp");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Fills a smooth displacement map, like the demo's.
void makeSmooth(SceneTexture &texture) {
  auto *const texels = reinterpret_cast<std::uint16_t *>(texture.bytes.data() + 64);
  for (int y = 0; y < texture.height; ++y)
    for (int x = 0; x < texture.width; ++x) {
      const float u = float(x) / float(texture.width), v = float(y) / float(texture.height);
      std::uint16_t *const texel = texels + 4 * (y * texture.width + x);
      texel[0] = std::uint16_t(32768 + 20000 * (v - 0.5f) * (1 - u) * u * 4);
      texel[1] = std::uint16_t(32768 - 20000 * (u - 0.5f) * (1 - v) * v * 4);
    }
}

std::unique_ptr<Case> prepare(jit::Engine &engine, const Workload &workload) {
  auto result = std::make_unique<Case>();
  CompileOptions options;
  options.policy = LimitPolicy::Report;
  options.limits.localParameters = options.limits.envParameters = 32;
  options.limits.textureCoords = options.limits.textureUnits = 8;
  options.limits.textureImageUnits = 16;
  const CheckResult checked = checkFragmentProgram(textOf(workload.program), options);
  if (!checked.ok()) {
    std::fprintf(stderr, "%s is not a program\n", workload.program);
    return nullptr;
  }
  result->program = engine.prepareFragment(*checked.program, Numerics::Host);
  if (!result->program)
    return nullptr;
  abi::FragmentKey &key = result->key;
  key.targets[0].format.layout = abi::Layout::U8x4;
  for (std::size_t i = 0; i < workload.samplers.size(); ++i) {
    const Sampled &sampled = workload.samplers[i];
    abi::SamplerKey &sampler = key.samplers[i];
    sampler.dimension = sampled.dimension;
    sampler.format.layout = sampled.layout;
    sampler.wrap = {sampled.wrap, sampled.wrap, sampled.wrap};
    sampler.magnify = sampler.minify = sampled.filter;
    sampler.powerOfTwo = 7;
    result->textures.push_back(makeTexture(sampler, sampled.width ? sampled.width : g_size,
                                           sampled.height ? sampled.height : g_size,
                                           std::uint32_t(i + 1)));
    if (sampled.layout == abi::Layout::U16x4)
      makeSmooth(*result->textures.back());
    result->data.textures[i] = &result->textures.back()->view;
  }
  const std::vector<jit::FragmentInput> &inputs = result->program->shape().inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    key.inputs[i] = abi::Interpolation::Linear;
    setQuadInput(result->primitive, int(i), workload.inputs[inputs[i].attribute.index], g_size,
                 g_size);
  }
  result->rows = parameterRows(result->program->program(), workload.locals);
  result->data.parameters = reinterpret_cast<const float(*)[4]>(result->rows.data());
  result->target = makeTarget(key.targets[0].format, g_size, g_size, 9);
  result->data.targets[0] = {result->target.pixel(0, 0), result->target.rowStride};
  return result;
}

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

/// Returns the time of the fastest of several runs in milliseconds. The clock is the thread's own,
/// which other processes do not affect, or the wall clock.
template <typename Work> double best(clockid_t clock, Work work) {
  double least = 1e9;
  for (int i = 0; i < 25; ++i) {
    const double start = milliseconds(clock);
    work();
    least = std::min(least, milliseconds(clock) - start);
  }
  return least;
}

std::vector<abi::Span> rowsOf(int from, int to) {
  std::vector<abi::Span> spans;
  for (int y = from; y < to; ++y)
    spans.push_back({0, std::int16_t(y), std::uint16_t(g_size), 0});
  return spans;
}

void print(const char *name, double one, double two, std::size_t bytes = 0, double compiled = 0) {
  std::printf("%-22s %8.3f ms %8.3f ms %8.2f ns/16 pixels %7zu bytes, compiled in %.0f ms\n", name,
              one, two, one * 1e6 * 16 / (g_size * g_size), bytes, compiled);
}

/// Sets flush mode, in which the functions compute. The rasterizer also sets it once for many small
/// calls.
class FlushMode {
public:
#if defined(__x86_64__) || defined(__i386__)
  FlushMode() : m_before(_mm_getcsr()) { _mm_setcsr(0x9FC0); }
  ~FlushMode() { _mm_setcsr(m_before); }

private:
  unsigned m_before;
#endif
};

/// Prepares a demo's program with perspective interpolation.
std::unique_ptr<Case> preparePerspective(jit::Engine &engine, const std::string &program,
                                         abi::Lanes lanes) {
  const std::vector<Workload> workloads = makeWorkloads();
  const auto workload = std::find_if(workloads.begin(), workloads.end(),
                                     [&](const Workload &w) { return w.program == program; });
  std::unique_ptr<Case> made = prepare(engine, *workload);
  if (!made)
    return nullptr;
  made->key.lanes = lanes;
  made->key.inputs[0] = made->key.inputs[1] = abi::Interpolation::Perspective;
  made->primitive.inverseW.c = 1;
  return made;
}

/// Prepares lighting on blocks with a depth test that passes.
std::unique_ptr<Case> prepareBlocks(jit::Engine &engine) {
  std::unique_ptr<Case> made = preparePerspective(engine, "lighting", abi::Lanes::Quad);
  if (!made)
    return nullptr;
  abi::DepthStencilKey &depth = made->key.depthStencil;
  depth.layout = abi::Layout::Depth24Stencil8;
  depth.depthTest = depth.depthWrite = 1;
  depth.depthCompare = abi::Compare::LessEqual;
  return made;
}

/// Measures blocks as small triangles have them: few in each call.
int measureBlocks(jit::Engine &engine, const std::string &only) {
  if (!only.empty() && only != "blocks")
    return 0;
  const std::unique_ptr<Case> made = prepareBlocks(engine);
  if (!made)
    return 1;
  SceneTarget buffer = makeTarget({abi::Layout::Depth24Stencil8, abi::kRgba}, g_size, g_size, 3);
  made->data.depthStencil = {buffer.pixel(0, 0), buffer.rowStride};
  std::string reason;
  const auto code = engine.compile(*made->program, made->key, reason);
  if (!code) {
    std::printf("%-22s %s\n", "blocks", reason.c_str());
    return 1;
  }
  std::vector<abi::Block> blocks;
  for (int y = 0; y < g_size; y += engine.blockHeight())
    for (int x = 0; x < g_size; x += engine.blockWidth())
      blocks.push_back(
          {std::int16_t(x), std::int16_t(y), std::uint16_t((1u << engine.lanes()) - 1), 0});
  const FlushMode mode;
  for (const std::size_t batch : {std::size_t(1), std::size_t(2), std::size_t(16)}) {
    const double one = best(CLOCK_THREAD_CPUTIME_ID, [&] {
      for (std::size_t i = 0; i < blocks.size(); i += batch)
        code->function(&made->data, &made->primitive, &blocks[i], std::uint32_t(batch));
    });
    const std::string name = "lighting, " + std::to_string(batch) + " blocks";
    print(name.c_str(), one, 0, code->bytes);
  }
  return 0;
}

/// Measures packed pixels of small triangles: a few vectors in each call, from blocks of 8x8
/// pixels.
int measurePacked(jit::Engine &engine, const std::string &only) {
  if (!only.empty() && only != "packed")
    return 0;
  const std::unique_ptr<Case> made = preparePerspective(engine, "cartoon", abi::Lanes::Packed);
  std::string reason;
  const auto code = made ? engine.compile(*made->program, made->key, reason) : nullptr;
  if (!code) {
    std::printf("%-22s %s\n", "packed", reason.c_str());
    return 1;
  }
  // Each tile of 8x8 pixels is shared by as many primitives as there are columns.
  constexpr int kTile = 8, kPixels = kTile * kTile;
  std::array<abi::Pixel, kPixels> pixels;
  for (int i = 0; i < kPixels; ++i)
    pixels[std::size_t(i)] = {std::uint8_t(i % kTile), std::uint8_t(i / kTile),
                              std::uint8_t(i % engine.lanes()), 0};
  abi::PrimitiveColumns columns;
  for (int k = 0; k < abi::PrimitiveColumns::kColumns; ++k)
    columns.set(k, made->primitive);
  const auto function = reinterpret_cast<abi::PackedShadeFunction>(code->function);
  const FlushMode mode;
  for (const std::size_t vectors : {std::size_t(1), std::size_t(2), std::size_t(4)}) {
    const std::size_t batch = vectors * std::size_t(engine.lanes());
    const double one = best(CLOCK_THREAD_CPUTIME_ID, [&] {
      for (int y = 0; y < g_size; y += kTile)
        for (int x = 0; x < g_size; x += kTile) {
          columns.baseX = x;
          columns.baseY = y;
          for (std::size_t i = 0; i < kPixels; i += batch)
            function(&made->data, &columns, &pixels[i], std::uint32_t(batch));
        }
    });
    const std::string name = "cartoon, packed by " + std::to_string(batch);
    print(name.c_str(), one, 0, code->bytes);
  }
  return 0;
}

int measure(jit::Engine &engine, const std::string &only) {
  std::printf("%s\n%-22s %11s %11s\n", engine.target().c_str(), "", "one thread", "two threads");
  const std::vector<abi::Span> all = rowsOf(0, g_size);
  const std::vector<abi::Span> halves[2] = {rowsOf(0, g_size / 2), rowsOf(g_size / 2, g_size)};
  int failures = 0;
  for (const Workload &workload : makeWorkloads()) {
    if (!only.empty() && only != workload.program)
      continue;
    std::string reason = "it was refused";
    const std::unique_ptr<Case> made = prepare(engine, workload);
    const double start = milliseconds(CLOCK_THREAD_CPUTIME_ID);
    const auto code = made ? engine.compile(*made->program, made->key, reason) : nullptr;
    const double compiled = milliseconds(CLOCK_THREAD_CPUTIME_ID) - start;
    if (!code) {
      std::printf("%-22s %s\n", workload.program, reason.c_str());
      ++failures;
      continue;
    }
    const auto shade = [&](const std::vector<abi::Span> &spans) {
      code->function(&made->data, &made->primitive, spans.data(), std::uint32_t(spans.size()));
    };
    const double one = best(CLOCK_THREAD_CPUTIME_ID, [&] { shade(all); });
    const double two = best(CLOCK_MONOTONIC, [&] {
      std::thread other([&] { shade(halves[1]); });
      shade(halves[0]);
      other.join();
    });
    print(workload.program, one, two, code->bytes, compiled);
  }
  failures += measureBlocks(engine, only);
  failures += measurePacked(engine, only);
  std::vector<std::uint32_t> from(g_size * g_size, 1), to(g_size * g_size, 2);
  print(
      "memcpy",
      best(CLOCK_THREAD_CPUTIME_ID, [&] { std::memcpy(to.data(), from.data(), 4 * from.size()); }),
      0, 0);
  return failures;
}

int show(jit::Engine &engine, const llvm_back::Cpu &cpu, const std::string &name,
         llvm_back::Emit what) {
  for (const Workload &workload : makeWorkloads()) {
    if (name != workload.program && name != "blocks" && name != "packed")
      continue;
    const std::unique_ptr<Case> made =
        name == "blocks"   ? prepareBlocks(engine)
        : name == "packed" ? preparePerspective(engine, "cartoon", abi::Lanes::Packed)
                           : prepare(engine, workload);
    if (!made)
      return 1;
    std::string reason;
    const auto text = llvm_back::emit(
        cpu, 3,
        [&](llvm_back::Code &code, llvm::Function *function, std::string &why) {
          return llvm_back::writeFragment(code, function, *made->program, made->key, why);
        },
        what, reason);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return text.empty();
  }
  return 1;
}
} // namespace

int main(int argc, char **argv) {
  const char *const cpu = std::getenv("ARBITER_JIT_CPU");
  jit::EngineOptions options;
  options.cpu = cpu ? cpu : "";
  const auto engine = llvm_back::makeEngine(options);
  if (!engine) {
    std::fprintf(stderr, "no code for this processor\n");
    return 1;
  }
  std::string first = argc > 1 ? argv[1] : "";
  if (first == "--size" && argc > 2) {
    g_size = std::clamp(std::atoi(argv[2]), 64, 8192);
    first = argc > 3 ? argv[3] : "";
  }
  if (first == "--asm" || first == "--ir")
    return show(*engine, *llvm_back::chooseCpu(options.cpu), argc > 2 ? argv[2] : "",
                first == "--asm" ? llvm_back::Emit::Assembly : llvm_back::Emit::Ir);
  return measure(*engine, first);
}
