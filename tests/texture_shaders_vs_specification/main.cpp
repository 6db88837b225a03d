// texture_shaders [--first SEED] [--count N] [--peer] [--fx9] [--verbose] [--reduce]: draws with
// random stages of NV_texture_shader, 2 and 3, before register combiners and before texture
// environments. It compares each pixel with the specification, computed in double precision. With
// --fx9, which ARBITER_NUMERICS must match, random combiners follow and the comparison is exact,
// with integers. With --reduce a differing state is reduced to what is needed to differ, and
// printed. Ends with one line of JSON: what was drawn, what differs, what was not judged.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <epoxy/gl.h>

#include "../combiners_vs_specification/client_options.h"
#include "../combiners_vs_specification/open_context.h"
#include "fp_compiler/texture_shader/operations.h"
#include "reduce.h"
#include "scene.h"

namespace {

using namespace arbiter::fp;
using texture_shader::Color;
using texture_shader::Evaluated;

constexpr double kTolerance = 1.0; ///< in 255ths, between a drawn byte and the specification
constexpr double kExactly = 0.01;  ///< the tolerance for whole numbers of 255ths
constexpr double kDepthTolerance = 1e-4;
/// Coordinates this near to another texel, in texels, and quotients this near to 0/0 are undecided.
constexpr double kUndetermined = 1e-3;

struct Options {
  Seeds seeds;
  bool verbose = false;
  bool peer = false; ///< the driver is NVIDIA's: its known differences are left out
  bool reduce = false;
  bool fx9 = false; ///< combiners by the integers of Numerics::Fx9
};

struct Tally {
  int states = 0, different = 0;
  long cells = 0, unjudged = 0, exact = 0, discarded = 0, depths = 0, stages = 0, inconsistent = 0;
  double worst = 0.0;
  /// Number of consistent stages of each
  std::array<long, texture_shader::kOperations> operations{};
};

void makeTarget() {
  bindTarget(shaded::kSize, shaded::kSize);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  const auto &c = shaded::kClearColor;
  glClearColor(c[0], c[1], c[2], c[3]);
  glClearDepth(double(shaded::kClearDepth));
}

struct Picture {
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(shaded::kSize * shaded::kSize * 4);
  std::vector<float> depths = std::vector<float>(shaded::kSize * shaded::kSize);

  void read() {
    glReadPixels(0, 0, shaded::kSize, shaded::kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glReadPixels(0, 0, shaded::kSize, shaded::kSize, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  }

  /// Returns the index of a cell's first pixel in `pixels`.
  static std::size_t at(int cell) {
    return (std::size_t(cell / shaded::kCells) * shaded::kSize +
            std::size_t(cell % shaded::kCells)) *
           shaded::kCellSize * 4;
  }
};

/// Returns the largest difference of a cell's pixels from the expected color, in steps of a byte;
/// 1000 if a depth exceeds its tolerance.
double distanceOf(const Picture &picture, int cell, const Color &color, const double *depth) {
  double worst = 0.0;
  const int x0 = cell % shaded::kCells * shaded::kCellSize,
            y0 = cell / shaded::kCells * shaded::kCellSize;
  for (int y = y0; y < y0 + shaded::kCellSize; ++y)
    for (int x = x0; x < x0 + shaded::kCellSize; ++x) {
      const std::size_t at = std::size_t(y) * shaded::kSize + std::size_t(x);
      for (std::size_t c = 0; c < 4; ++c)
        worst = std::max(worst, std::abs(double(picture.pixels[at * 4 + c]) -
                                         std::clamp(color[c], 0.0, 1.0) * 255.0));

      if (depth && std::abs(double(picture.depths[at]) - *depth) > kDepthTolerance)
        worst = std::max(worst, 1000.0);
    }
  return worst;
}

void report(std::uint64_t seed, const shaded::Scene &scene, int cell, double distance,
            const Evaluated &expected, const Color &color) {
  std::printf("seed %llu, cell %d: %.2f steps of 255 away; (%.4f %.4f %.4f %.4f) by the "
              "specification%s%s, by %s%s; stages",
              static_cast<unsigned long long>(seed), cell, distance, color[0], color[1], color[2],
              color[3], expected.discarded ? ", discarded" : "",
              expected.replacesDepth ? ", a depth" : "",
              scene.combines() ? "combiners" : "environments",
              scene.state().conventional ? ", conventional" : "");
  for (std::size_t unit = 0; unit < scene.state().units; ++unit)
    std::printf(" %d(%d,%d)%s", int(scene.state().stages[unit].operation),
                int(scene.state().textures[unit].base), int(scene.state().textures[unit].signs),
                expected.consistent[unit] ? "" : "!");
  if (expected.replacesDepth)
    std::printf("; depth %.7f, margin %.5f", expected.depth, expected.margin);
  std::printf("\n");
}

/// A cell's expected result, and the drawn difference from it.
struct Cell {
  Evaluated expected;
  shaded::Colored drawn; ///< the expected color
  bool judged = false;
  double distance = 0.0;
  bool same = true;
};

Cell look(const shaded::Scene &scene, const Options &options, const Picture &picture, int index) {
  Cell cell;
  const Evaluated &expected = cell.expected = scene.evaluate(index);
  const auto &clear = shaded::kClearColor;
  cell.drawn = expected.discarded ? shaded::Colored{{double(clear[0]), double(clear[1]),
                                                     double(clear[2]), double(clear[3])}}
                                  : scene.colorOf(index, expected);
  // NVIDIA's driver draws a fragment whose depth is out of range.
  cell.judged = std::min(expected.margin, cell.drawn.margin) >= kUndetermined &&
                !(options.peer && expected.depthOutOfRange);
  if (!cell.judged)
    return cell;
  const double depth = expected.discarded ? double(shaded::kClearDepth) : expected.depth;
  cell.distance = distanceOf(picture, index, cell.drawn.color,
                             expected.discarded || expected.replacesDepth ? &depth : nullptr);
  cell.same = cell.distance <= (cell.drawn.isExact ? kExactly : kTolerance);
  return cell;
}

Picture drawnBy(const shaded::Scene &scene) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  scene.draw();
  Picture picture;
  picture.read();
  return picture;
}

/// Judges the cells. \return true if no cell differs
bool judge(std::uint64_t seed, const shaded::Scene &scene, const Options &options, Tally &tally) {
  const Picture picture = drawnBy(scene);
  bool same = true;
  for (int index = 0; index < shaded::kCells * shaded::kCells; ++index) {
    const Cell cell = look(scene, options, picture, index);
    const Evaluated &expected = cell.expected;
    if (index == 0)
      for (std::size_t unit = 0; unit < scene.state().units; ++unit) {
        ++tally.stages;
        tally.inconsistent += expected.consistent[unit] ? 0 : 1;
        tally.operations[std::size_t(scene.state().stages[unit].operation)] +=
            expected.consistent[unit] ? 1 : 0;
      }
    ++tally.cells;
    if (!cell.judged) {
      ++tally.unjudged;
      continue;
    }
    tally.discarded += expected.discarded ? 1 : 0;
    tally.depths += expected.replacesDepth && !expected.discarded ? 1 : 0;
    tally.exact += cell.drawn.isExact ? 1 : 0;
    tally.worst = std::max(tally.worst, cell.distance);
    if (!cell.same && (same || options.verbose))
      report(seed, scene, index, cell.distance, expected, cell.drawn.color);
    same = same && cell.same;
  }
  ++tally.states;
  return same;
}

/// Returns the first unit whose SHADER_CONSISTENT_NV violates the specification; -1: none.
int otherwiseConsistent(const shaded::Scene &scene) {
  if (scene.state().conventional)
    return -1;
  const Evaluated expected = scene.evaluate(0);
  for (unsigned unit = 0; unit < scene.state().units; ++unit) {
    GLint told = -1;
    glActiveTexture(GL_TEXTURE0 + unit);
    glGetTexEnviv(GL_TEXTURE_SHADER_NV, GL_SHADER_CONSISTENT_NV, &told);
    if (told != GLint(expected.consistent[unit]))
      return int(unit);
  }
  return -1;
}

/// Returns the first cell that differs; -1: none.
int differentCell(const shaded::Scene &scene, const Options &options) {
  const Picture picture = drawnBy(scene);
  for (int index = 0; index < shaded::kCells * shaded::kCells; ++index)
    if (!look(scene, options, picture, index).same)
      return index;
  return -1;
}

/// Reduces a state as long as it differs in the same way, and prints the result.
void reduce(shaded::Scene &scene, const Options &options, bool byConsistency) {
  const auto differs = [&] {
    return byConsistency ? otherwiseConsistent(scene) >= 0 : differentCell(scene, options) >= 0;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int part = 0; part < shaded::partsOf(scene.kept().state); ++part) {
      const shaded::Kept before = scene.kept();
      shaded::Kept simpler = before;
      if (!shaded::simplify(simpler, part))
        continue;
      scene.restore(simpler);
      if (differs())
        changed = true;
      else
        scene.restore(before);
    }
  }
  const int index = std::max(0, differentCell(scene, options));
  Picture picture;
  picture.read();
  const Cell cell = look(scene, options, picture, index);
  const std::size_t at = picture.at(index);
  std::printf("  cut down: cell %d is (%.4f %.4f %.4f %.4f), by the specification (%.4f %.4f %.4f "
              "%.4f)%s\n",
              index, picture.pixels[at] / 255.0, picture.pixels[at + 1] / 255.0,
              picture.pixels[at + 2] / 255.0, picture.pixels[at + 3] / 255.0, cell.drawn.color[0],
              cell.drawn.color[1], cell.drawn.color[2], cell.drawn.color[3],
              cell.expected.discarded ? ", discarded" : "");
  scene.describe(index);
}

int run(const Options &options) {
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_UNITS, &units);
  units = std::min(units, GLint(texture_shader::kUnits));
  makeTarget();
  shaded::Scene scene(options.peer, options.fx9);
  Tally tally;
  for (std::uint64_t seed = options.seeds.first; seed < options.seeds.last(); ++seed) {
    testing::Random random(seed);
    scene.arrange(random, units);
    const bool same = judge(seed, scene, options, tally);
    const int unit = otherwiseConsistent(scene);
    if (unit >= 0)
      std::printf("seed %llu, unit %d: SHADER_CONSISTENT_NV is otherwise\n",
                  static_cast<unsigned long long>(seed), unit);
    tally.different += same && unit < 0 ? 0 : 1;
    if (options.reduce && !(same && unit < 0))
      reduce(scene, options, unit >= 0);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
      std::fprintf(stderr, "seed %llu: GL error 0x%04X\n", static_cast<unsigned long long>(seed),
                   error);
      return 1;
    }
  }
  long least = tally.stages;
  for (std::size_t i = 1; i < tally.operations.size(); ++i)
    least = std::min(least, tally.operations[i]);
  std::printf(
      "{\"renderer\": \"%s\", \"units\": %d, \"states\": %d, \"different\": %d, "
      "\"cells\": %ld, \"unjudged\": %ld, \"exact\": %ld, \"discarded\": %ld, \"depths\": %ld, "
      "\"stages\": %ld, \"inconsistent\": %ld, \"least_of_an_operation\": %ld, "
      "\"worst_steps\": %.3f}\n",
      reinterpret_cast<const char *>(glGetString(GL_RENDERER)), units, tally.states,
      tally.different, tally.cells, tally.unjudged, tally.exact, tally.discarded, tally.depths,
      tally.stages, tally.inconsistent, least, tally.worst);
  return tally.different == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
  Options options;
  if (const auto status = parseOptions(
          argc, argv, "Draws random texture shaders and judges each pixel.", options.seeds,
          {{"--reduce", "cuts states down that differ", options.reduce},
           {"--verbose", "says what differs", options.verbose},
           {"--fx9", "random combiners behind, by the integers of the numerics fx9", options.fx9},
           {"--peer", "leaves out what NVIDIA's driver does otherwise", options.peer}}))
    return *status;
  if (!openContextWith("GL_NV_texture_shader3"))
    return kSkipped;
  return run(options);
}
