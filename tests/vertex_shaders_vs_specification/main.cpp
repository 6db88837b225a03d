// vertex_shaders [--first SEED] [--count N] [--verbose]: defines random shaders of
// EXT_vertex_shader and draws a point with each for every result. A fragment program reads the
// result, which is compared with the table of operations, computed in double precision. Ends with
// one line of JSON: what was drawn, what differs, what was not judged.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <epoxy/gl.h>

#include "../combiners_vs_specification/client_options.h"
#include "../combiners_vs_specification/open_context.h"
#include "issue.h"

namespace {

using namespace arbiter::fp;
using testing::VertexShaderResults;

/// Each view shows one result: coordinates, colors, fog.
constexpr int kViews = testing::kRandomTexCoords + 3;
constexpr double kTolerance = 2e-3;   ///< relative to the value, or to one if that is more
constexpr double kDisturbance = 1e-4; ///< single precision, and a host's powers and logarithms

struct Options {
  Seeds seeds;
  bool verbose = false;
};

struct Tally {
  int states = 0, different = 0;
  long cells = 0, unjudged = 0;
};

/// Makes the programs that show one result each.
void makeViews(GLuint (&programs)[kViews]) {
  glGenProgramsARB(kViews, programs);
  for (int view = 0; view < kViews; ++view) {
    const int rest = view - testing::kRandomTexCoords;
    const std::string seen = rest < 0    ? "texcoord[" + std::to_string(view) + "]"
                             : rest == 0 ? "color.primary"
                             : rest == 1 ? "color.secondary"
                                         : "fogcoord";
    const std::string text = "!!ARBfp1.0\nMOV result.color, fragment." + seen + ";\nEND";
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, programs[view]);
    glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                       text.data());
  }
}

/// Returns the expected component `c` of a view; only the first component of the fog coordinate is
/// the shader's.
double expected(const VertexShaderResults &results, int view, std::size_t c) {
  const int rest = view - testing::kRandomTexCoords;
  if (rest < 0)
    return results.texCoords[std::size_t(view)][c];
  if (rest < 2)
    return std::clamp(results.colors[std::size_t(rest)][c], 0.0, 1.0);
  return results.fog;
}

void judge(std::uint64_t seed, const testing::RandomVertexShader &made, const Options &options,
           Tally &tally) {
  GLfloat pixels[kViews][4];
  glReadPixels(0, 0, kViews, 1, GL_RGBA, GL_FLOAT, pixels);
  const VertexShaderResults exact = testing::evaluateVertexShader(made.shader, made.values);
  const VertexShaderResults other =
      testing::evaluateVertexShader(made.shader, made.values, kDisturbance);
  bool same = true;
  for (int view = 0; view < kViews; ++view)
    for (std::size_t c = 0; c < (view + 1 < kViews ? 4u : 1u); ++c) {
      const double should = expected(exact, view, c), is = double(pixels[view][c]);
      const double tolerance = kTolerance * std::max(1.0, std::abs(should));
      ++tally.cells;
      if (!other.defined || std::abs(expected(other, view, c) - should) > tolerance / 2) {
        ++tally.unjudged;
        continue;
      }
      if (std::abs(is - should) <= tolerance)
        continue;
      if (same || options.verbose)
        std::printf("seed %llu: result %d, component %zu is %g, should be %g\n",
                    static_cast<unsigned long long>(seed), view, c, is, should);
      same = false;
    }
  ++tally.states;
  tally.different += same ? 0 : 1;
}

int run(const Options &options) {
  bindTarget(kViews, 1, GL_RGBA32F);
  GLuint views[kViews];
  makeViews(views);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glEnable(GL_VERTEX_SHADER_EXT);
  Tally tally;
  for (std::uint64_t seed = options.seeds.first; seed < options.seeds.last(); ++seed) {
    testing::Random random(seed);
    const testing::RandomVertexShader made = testing::randomVertexShader(random);
    {
      vertex_shaders::Issued issued(made);
      issued.setValues(seed % 2 != 0);
      glViewport(0, 0, kViews, 1);
      glClear(GL_COLOR_BUFFER_BIT);
      for (int view = 0; view < kViews; ++view) {
        glViewport(view, 0, 1, 1);
        glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, views[view]);
        issued.draw();
      }
      judge(seed, made, options, tally);
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
      std::fprintf(stderr, "seed %llu: GL error 0x%04X\n", static_cast<unsigned long long>(seed),
                   error);
      return 1;
    }
  }
  std::printf("{\"renderer\": \"%s\", \"states\": %d, \"different\": %d, \"cells\": %ld, "
              "\"unjudged\": %ld}\n",
              reinterpret_cast<const char *>(glGetString(GL_RENDERER)), tally.states,
              tally.different, tally.cells, tally.unjudged);
  return tally.different == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
  Options options;
  if (const auto status =
          parseOptions(argc, argv, "Draws with random vertex shaders and judges each result.",
                       options.seeds, {{"--verbose", "says all that differs", options.verbose}}))
    return *status;
  if (!openContextWith("GL_EXT_vertex_shader"))
    return kSkipped;
  return run(options);
}
