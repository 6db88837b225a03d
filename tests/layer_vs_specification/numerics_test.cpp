// Zero times infinity under ARBITER_NUMERICS.
#include <cstdlib>
#include <string_view>

#include "fixture.h"

namespace api {
namespace {

/// Draws green if a product of zero and infinity is zero, red if it is NaN: a comparison with NaN
/// is false. It uses parameters, so that no compiler computes it beforehand.
constexpr char kFragmentText[] = "!!ARBfp1.0\nTEMP t;\nRCP t, program.local[0].x;\n"
                                 "MUL t, t, program.local[0];\nSGE t, t, 0;\n"
                                 "LRP result.color, t, {0,1,0,1}, {1,0,0,1};\nEND";
constexpr char kVertexText[] = "!!ARBvp1.0\nTEMP t;\nMOV result.position, vertex.position;\n"
                               "RCP t, program.local[0].x;\nMUL t, t, program.local[0];\n"
                               "SGE t, t, 0;\nMAD result.color, t, {-1,1,0,0}, {1,0,0,1};\nEND";

bool zeroWins() {
  const char *const mode = std::getenv("ARBITER_NUMERICS");
  return mode && std::string_view(mode) != "host";
}

class NumericsOfPrograms : public ApiTest {};

TEST_F(NumericsOfPrograms, ZeroTimesInfinityInAFragmentProgram) {
  BARE_HOST_DIFFERS("its own programs follow no variable of the layer's");
  makeProgram(kFragmentText);
  glEnable(kFragment);
  EXPECT_EQ(drawn(), zeroWins() ? kGreenPixel : kRedPixel);
}

TEST_F(NumericsOfPrograms, ZeroTimesInfinityInAVertexProgram) {
  BARE_HOST_DIFFERS("its own programs follow no variable of the layer's");
  makeProgram(kVertexText, kVertex);
  glEnable(kVertex);
  EXPECT_EQ(drawn(), zeroWins() ? kGreenPixel : kRedPixel);
}

/// The mode only affects assembly programs: an application's own GLSL is the host's.
TEST_F(NumericsOfPrograms, AnApplicationsGlslIsLeftAlone) {
  const GLuint program = makeGlsl(nullptr, "uniform float zero;\nvoid main() {\n"
                                           "  float p = zero * (1.0 / zero);\n"
                                           "  gl_FragColor = p >= 0.0 ? vec4(0.0, 1.0, 0.0, 1.0)"
                                           " : vec4(1.0, 0.0, 0.0, 1.0);\n}\n");
  glUseProgram(program);
  EXPECT_EQ(drawn(), kRedPixel);
  glUseProgram(0);
}

} // namespace
} // namespace api
