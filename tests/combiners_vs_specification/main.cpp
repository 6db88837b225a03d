// combiners [--first SEED] [--count N] [--unsigned] [--fx9] [--verbose]: draws with random states
// of NV_register_combiners and 2, and compares each pixel with the equations of section 3.8.12,
// computed in double precision. With --fx9, which ARBITER_NUMERICS must match, the comparison is
// exact, with integers. Ends with one line of JSON: what was drawn, what differs, what was not
// judged.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <epoxy/gl.h>

#include "client_options.h"
#include "open_context.h"
#include "scene.h"

namespace {

using namespace arbiter::fp;
using combiners::Evaluated;

constexpr double kTolerance = 1.0;     ///< in 255ths, between a drawn byte and the equations
constexpr double kExactly = 0.01;      ///< the tolerance for whole numbers of 255ths
constexpr double kUndetermined = 1e-3; ///< a mux nearer to its other choice is undecided

struct Options {
  Seeds seeds;
  bool verbose = false;
  bool isUnsigned = false; ///< no texels below zero
  bool fx9 = false;        ///< compares with the integers of Numerics::Fx9
};

struct Tally {
  int states = 0, different = 0;
  long cells = 0, unjudged = 0;
  double worst = 0.0;
};

using Pixels = std::vector<std::uint8_t>;

/// Returns the largest difference of a cell's pixels from the expected color, in steps of a byte.
double distanceOf(const Pixels &pixels, int cell, const combiners::Color &color) {
  double worst = 0.0;
  const int x0 = cell % combined::kCells * combined::kCellSize,
            y0 = cell / combined::kCells * combined::kCellSize;
  for (int y = y0; y < y0 + combined::kCellSize; ++y)
    for (int x = x0; x < x0 + combined::kCellSize; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const std::size_t at = (std::size_t(y) * combined::kSize + std::size_t(x)) * 4 + c;
        worst =
            std::max(worst, std::abs(double(pixels[at]) - std::clamp(color[c], 0.0, 1.0) * 255.0));
      }
  return worst;
}

const char *nameOf(combiners::Register name) {
  constexpr const char *kNames[] = {
      "zero", "const0", "const1", "fog",  "col0", "col1", "spare0", "spare1",      "tex0",   "tex1",
      "tex2", "tex3",   "tex4",   "tex5", "tex6", "tex7", "E*F",    "spare0+col1", "discard"};
  return kNames[std::size_t(name)];
}

void print(const combiners::Input &input) {
  constexpr const char *kMappings[] = {"unsigned",  "unsigned_invert", "expand", "-expand",
                                       "half_bias", "-half_bias",      "signed", "-signed"};
  constexpr const char *kUsages[] = {"rgb", "a", "b"};
  std::printf(" %s(%s.%s)", kMappings[std::size_t(input.mapping)], nameOf(input.source),
              kUsages[std::size_t(input.usage)]);
}

void print(const char *half, const combiners::Portion &portion) {
  constexpr const char *kScales[] = {"", " *2", " *4", " /2"};
  std::printf("    %s:", half);
  for (const combiners::Input &input : portion.inputs)
    print(input);
  std::printf(" -> AB%s %s, CD%s %s, %s %s%s%s\n", portion.abDot ? "(dot)" : "", nameOf(portion.ab),
              portion.cdDot ? "(dot)" : "", nameOf(portion.cd), portion.mux ? "mux" : "sum",
              nameOf(portion.sum), portion.bias ? " -0.5" : "",
              kScales[std::size_t(portion.scale)]);
}

void report(std::uint64_t seed, const combined::Scene &scene, int cell, double distance,
            const Evaluated &expected) {
  const auto &c = expected.color;
  std::printf("seed %llu, cell %d: %.2f steps of 255 away; (%.4f %.4f %.4f %.4f) by the "
              "equations, %d stages\n",
              static_cast<unsigned long long>(seed), cell, distance, c[0], c[1], c[2], c[3],
              int(scene.state().count));
  for (std::size_t i = 0; i < scene.state().count; ++i) {
    std::printf("  stage %zu\n", i);
    print("rgb", scene.state().stages[i].rgb);
    print("alpha", scene.state().stages[i].alpha);
  }
  std::printf("  final:");
  for (const combiners::Input &input : scene.state().finals)
    print(input);
  std::printf("\n");
}

void judge(std::uint64_t seed, const combined::Scene &scene, const Options &options, Tally &tally) {
  Pixels pixels(combined::kSize * combined::kSize * 4);
  glReadPixels(0, 0, combined::kSize, combined::kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  bool same = true;
  for (int cell = 0; cell < combined::kCells * combined::kCells; ++cell) {
    const Evaluated expected = scene.evaluate(cell);
    ++tally.cells;
    if (expected.margin < kUndetermined) {
      ++tally.unjudged;
      continue;
    }
    const double distance = distanceOf(pixels, cell, expected.color);
    tally.worst = std::max(tally.worst, distance);
    if (distance <= (options.fx9 ? kExactly : kTolerance))
      continue;
    if (same || options.verbose)
      report(seed, scene, cell, distance, expected);
    same = false;
  }
  ++tally.states;
  tally.different += same ? 0 : 1;
}

int run(const Options &options) {
  GLint units = 0, stages = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  glGetIntegerv(GL_MAX_GENERAL_COMBINERS_NV, &stages);
  units = std::min(units, GLint(combiners::kTextures));
  stages = std::min(stages, GLint(combiners::kStages));
  bindTarget(combined::kSize, combined::kSize);
  combined::Scene scene(units, !options.isUnsigned, options.fx9);
  Tally tally;
  for (std::uint64_t seed = options.seeds.first; seed < options.seeds.last(); ++seed) {
    testing::Random random(seed);
    scene.arrange(random, {.stages = stages, .units = units});
    glClear(GL_COLOR_BUFFER_BIT);
    scene.draw();
    judge(seed, scene, options, tally);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
      std::fprintf(stderr, "seed %llu: GL error 0x%04X\n", static_cast<unsigned long long>(seed),
                   error);
      return 1;
    }
  }
  std::printf("{\"renderer\": \"%s\", \"units\": %d, \"stages\": %d, \"states\": %d, "
              "\"different\": %d, \"cells\": %ld, \"unjudged\": %ld, \"worst_steps\": %.3f}\n",
              reinterpret_cast<const char *>(glGetString(GL_RENDERER)), units, stages, tally.states,
              tally.different, tally.cells, tally.unjudged, tally.worst);
  return tally.different == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
  Options options;
  if (const auto status = parseOptions(
          argc, argv, "Draws random states of register combiners and judges each pixel.",
          options.seeds,
          {{"--verbose", "says what differs", options.verbose},
           {"--unsigned", "no texels below zero", options.isUnsigned},
           {"--fx9", "by the integers of the numerics fx9", options.fx9}}))
    return *status;
  if (!openContextWith("GL_NV_register_combiners2"))
    return kSkipped;
  return run(options);
}
