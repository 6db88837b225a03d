#include "safety.h"

#include <array>
#include <cmath>
#include <limits>

namespace software {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr std::array<float, 9> kOdd = {kNan, kInf, -kInf, 3e38f, -3e38f, 1e20f, -1e9f, 1e-40f, 0};
constexpr std::array<GLenum, 10> kModes = {
    GL_POINTS,         GL_LINES,        GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
    GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,     GL_QUAD_STRIP, GL_POLYGON};

/// Draws every kind of primitive with odd values of x, y, z or w.
void oddPositions() {
  useFragments("MUL result.color, fragment.color, fragment.texcoord[0];\n");
  for (const GLenum mode : kModes) {
    for (const float odd : kOdd) {
      for (int component = 0; component < 4; ++component) {
        glBegin(mode);
        for (int i = 0; i < 4; ++i) {
          std::array<float, 4> position = {i == 1 || i == 2 ? 0.7f : -0.7f, i > 1 ? 0.7f : -0.7f, 0,
                                           1};
          if (i == 1)
            position[std::size_t(component)] = odd;
          glColor3f(1, 0.5f, 0.25f);
          glTexCoord2f(odd, float(i));
          glVertex4fv(position.data());
        }
        glEnd();
      }
    }
  }
  note("odd positions");
}

/// Draws odd positions from arrays, with depth and an unusual viewport.
void oddArrays() {
  useFragments("MOV result.color, fragment.texcoord[0];\n");
  glEnable(GL_DEPTH_TEST);
  std::vector<float> positions;
  for (int i = 0; i < 96; ++i)
    for (int c = 0; c < 4; ++c)
      positions.push_back(kOdd[std::size_t(i * 7 + c * 5) % kOdd.size()]);
  glVertexPointer(4, GL_FLOAT, 0, positions.data());
  glTexCoordPointer(4, GL_FLOAT, 0, positions.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  for (const GLenum mode : kModes)
    glDrawArrays(mode, 0, 96);
  note("odd arrays");
}

/// Draws far beyond any guard band; the picture is still well defined.
void hugeTriangle() {
  useFragments("MOV result.color, fragment.color;\n");
  for (const float far : {1e3f, 1e5f, 1e7f}) {
    glColor4ub(200, 100, 50, 255);
    glBegin(GL_TRIANGLES);
    glVertex2f(-far, -far);
    glVertex2f(far, -far);
    glVertex2f(0, far);
    glEnd();
  }
  picture("huge triangles");
}

void behindTheEye() {
  useFragments("MOV result.color, fragment.color;\n");
  glMatrixMode(GL_PROJECTION);
  glFrustum(-1, 1, -1, 1, 1, 10);
  glMatrixMode(GL_MODELVIEW);
  glColor4ub(250, 120, 60, 255);
  glBegin(GL_TRIANGLES);
  glVertex3f(-5, -2, -2), glVertex3f(5, -2, -2), glVertex3f(0, 4, 6); // crosses the eye's plane
  glVertex3f(-1, -1, 3), glVertex3f(1, -1, 3), glVertex3f(0, 1, 3);   // is behind it
  glVertex4f(0, 0, 0, 0), glVertex4f(0, 0, 0, 0), glVertex4f(1, 0, 0, 0);
  glEnd();
  picture("behind the eye");
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
}

void degenerate() {
  useFragments("MOV result.color, fragment.color;\n");
  glColor4ub(255, 0, 0, 255);
  for (const GLenum mode : kModes) {
    glBegin(mode);
    for (int i = 0; i < 7; ++i)
      glVertex2f(0.25f, 0.25f);
    glEnd();
    glBegin(mode);
    glEnd();
    glBegin(mode);
    glVertex2f(0, 0);
    glEnd();
  }
  note("degenerate");
}

void hugePointsAndLines() {
  useFragments("MOV result.color, fragment.texcoord[0];\n");
  for (const float size : {1e6f, 255.0f, 0.001f}) {
    glPointSize(size);
    glLineWidth(size);
    glBegin(GL_POINTS);
    glVertex2f(0, 0), glVertex2f(1, 1), glVertex2f(-3, 0);
    glEnd();
    glBegin(GL_LINES);
    glVertex2f(-50, -0.2f), glVertex2f(50, 0.3f), glVertex2f(1e6f, 1e6f), glVertex2f(-1e6f, -1e6f);
    glEnd();
  }
  glPointSize(-1);
  glLineWidth(0);
  note("sizes");
}

/// Uses arbitrary address registers.
void oddAddresses() {
  (void)makeProgram(GL_VERTEX_PROGRAM_ARB,
                    "!!ARBvp1.0\nADDRESS A;\nPARAM array[8] = { program.env[0..7] };\n"
                    "ARL A.x, vertex.texcoord[0].x;\nMOV result.color, array[A.x + 3];\n"
                    "MOV result.position, vertex.position;\nEND\n");
  glEnable(GL_VERTEX_PROGRAM_ARB);
  useFragments("MOV result.color, fragment.color;\n");
  for (const float address : {-1e9f, -4.0f, 5.0f, 90.0f, 4096.0f, 1e9f, kNan, kInf})
    wholeQuad(address, 0, address, 0);
  note("addresses");
}

/// Draws colors and depths that are NaN.
void oddResults() {
  GLuint framebuffer = 0, color = 0;
  for (const bool floats : {false, true}) {
    if (floats) {
      glGenFramebuffers(1, &framebuffer);
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      glGenTextures(1, &color);
      glBindTexture(GL_TEXTURE_2D, color);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kSide, kSide, 0, GL_RGBA, GL_FLOAT, nullptr);
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    }
    glEnable(GL_DEPTH_TEST);
    useFragments("TEMP t;\nSUB t, fragment.texcoord[0], fragment.texcoord[0];\nRCP t.x, t.x;\n"
                 "RSQ t.y, -fragment.texcoord[0].x;\nLG2 t.z, -fragment.texcoord[0].y;\n"
                 "MOV result.color, t;\nMOV result.depth.z, t.z;\n");
    wholeQuad(1, 1, 2, 2);
    glEnable(GL_BLEND);
    glBlendFunc(GL_DST_COLOR, GL_SRC_ALPHA);
    wholeQuad(1, 1, 2, 2);
    glDisable(GL_BLEND);
    note("odd results");
  }
}

void manyVertices() {
  useFragments("MOV result.color, fragment.color;\n");
  glColor4ub(0, 0, 255, 255);
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 150000; ++i) {
    const auto angle = float(i);
    glVertex2f(0.9f * std::sin(angle), 0.9f * std::cos(angle));
  }
  glEnd();
  note("many vertices");
}

} // namespace

const std::vector<Hazard> kVertexHazards = {
    {"odd-positions", oddPositions}, {"odd-arrays", oddArrays},
    {"huge-triangle", hugeTriangle}, {"behind-the-eye", behindTheEye},
    {"degenerate", degenerate},      {"huge-points-and-lines", hugePointsAndLines},
    {"odd-addresses", oddAddresses}, {"odd-results", oddResults},
    {"many-vertices", manyVertices},
};

} // namespace software
