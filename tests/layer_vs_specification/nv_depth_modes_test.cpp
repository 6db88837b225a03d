// DEPTH_TEXTURE_MODE with a vertex program that writes clip distances. Hosts only support those in
// GLSL 1.30, in which they ignore the mode. Needs a profile that has the languages (nv40).
#include <string>

#include "nv_commands.h"

namespace api::nv {
namespace {

constexpr char kClipped[] =
    "!!ARBvp1.0\nOPTION NV_vertex_program2;\nMOV result.position, vertex.position;\n"
    "MOV result.clip[0].x, vertex.position.w;\nEND";
constexpr char kSampling[] =
    "!!ARBfp1.0\nTEX result.color, {0.5,0.5,0.5,0.5}, texture[0], 2D;\nEND";
constexpr char kComparing[] = "!!ARBfp1.0\nOPTION ARB_fragment_program_shadow;\n"
                              "TEX result.color, {0.5,0.5,0.25,0.5}, texture[0], SHADOW2D;\nEND";

constexpr std::uint8_t kDepth = 153;
struct Row {
  GLenum mode;
  Pixel sampled;
  Pixel compared; ///< 0.25 <= 0.6
};
constexpr Row kRows[] = {
    {GL_LUMINANCE, {kDepth, kDepth, kDepth, 255}, {255, 255, 255, 255}},
    {GL_INTENSITY, {kDepth, kDepth, kDepth, kDepth}, {255, 255, 255, 255}},
    {GL_ALPHA, {0, 0, 0, kDepth}, {0, 0, 0, 255}},
    {GL_RED, {kDepth, 0, 0, 255}, {255, 0, 0, 255}},
};

class DepthModes : public NvTest {
protected:
  void SetUp() override {
    NvTest::SetUp();
    if (IsSkipped())
      return;
    glGenTextures(2, m_textures);
    glBindTexture(GL_TEXTURE_2D, m_textures[1]);
    constexpr std::uint8_t kColor[4] = {10, 20, 30, 40};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kColor);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, m_textures[0]);
    constexpr GLfloat kValue = 0.6f;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 &kValue);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  void TearDown() override {
    glDeleteTextures(2, m_textures);
    NvTest::TearDown();
  }

  static void expectQuad(const Pixel &expected, const std::string &what) {
    clear();
    glRectf(-1, -1, 1, 1);
    const Pixel drawn = readPixel();
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(drawn[i], expected[i], 1) << what << ", component " << i;
  }

  GLuint m_textures[2] = {};
};

TEST_F(DepthModes, AreFollowedWhileAPlaneIsEnabled) {
  use(kVertexNv, 1, kClipped);
  for (const bool compares : {false, true}) {
    makeProgram(compares ? kComparing : kSampling);
    glEnable(kFragment);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                    compares ? GL_COMPARE_R_TO_TEXTURE : GL_NONE);
    for (const bool clips : {false, true, true, false}) {
      (clips ? glEnable : glDisable)(GL_CLIP_PLANE0);
      for (const Row &row : kRows) {
        glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GLint(row.mode));
        expectQuad(compares ? row.compared : row.sampled,
                   std::to_string(row.mode) + (compares ? " compared" : " sampled") +
                       (clips ? ", clipped" : ""));
      }
    }
  }
}

TEST_F(DepthModes, FollowTheImageThatIsBound) {
  use(kVertexNv, 3, kClipped);
  makeProgram(kSampling);
  glEnable(kFragment);
  glEnable(GL_CLIP_PLANE0);
  for (int turn = 0; turn < 3; ++turn) {
    glBindTexture(GL_TEXTURE_2D, m_textures[0]);
    expectQuad(kRows[0].sampled, "depth");
    glBindTexture(GL_TEXTURE_2D, m_textures[1]);
    expectQuad({10, 20, 30, 40}, "colour");
  }
}

TEST_F(DepthModes, FollowAnotherContextsChange) {
  use(kVertexNv, 6, kClipped);
  makeProgram(kSampling);
  glEnable(kFragment);
  glEnable(GL_CLIP_PLANE0);
  expectQuad(kRows[0].sampled, "before");
  const GlContext other(&m_context);
  for (const Row &row : {kRows[2], kRows[1], kRows[2]}) {
    other.makeCurrent();
    glBindTexture(GL_TEXTURE_2D, m_textures[0]);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GLint(row.mode));
    m_context.makeCurrent();
    glBindTexture(GL_TEXTURE_2D, m_textures[0]);
    expectQuad(row.sampled, std::to_string(row.mode) + ", set in another context");
  }
}

TEST_F(DepthModes, OfVertexProgramsToo) {
  use(kVertexNv, 5,
      "!!ARBvp1.0\nOPTION NV_vertex_program3;\nTEMP t;\nMOV result.position, vertex.position;\n"
      "MOV result.clip[0].x, vertex.position.w;\n"
      "TEX t, {0.5,0.5,0.5,0}, texture[0], 2D;\nMOV result.color, t;\nEND");
  glEnable(GL_CLIP_PLANE0);
  for (const Row &row : kRows) {
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GLint(row.mode));
    expectQuad(row.sampled, std::to_string(row.mode));
  }
}

} // namespace
} // namespace api::nv
