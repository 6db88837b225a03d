// Draws one large thing: rasterizer-large WHAT COUNT. Draws COUNT vertices of client arrays as one
// kind of primitive, or records COUNT binds of programs in a display list and calls it. Records the
// picture, then the milliseconds that it took and the process's peak memory in KiB: "figures
// MILLISECONDS KIB".
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "../rasterizer_vs_host/surface.h"

namespace {

using software::record;

constexpr int kSide = 128;

struct Vertex {
  float x, y;
  unsigned char color[4];
};

/// The distance between the places where primitives are visible. Wherever a draw is split, at a
/// multiple of this, the primitives on both sides are large and have distinct colors. A primitive
/// that is missing, doubled, wound the other way, or has a wrong provoking vertex is then visible.
constexpr std::size_t kStep = 65536;
constexpr std::size_t kSeen = 9; ///< vertices on each side of such a place

/// Most vertices are one point, so that their primitives have no area.
constexpr Vertex kUnseen = {0.97f, -0.97f, {0, 0, 0, 255}};

/// Returns vertex `i` of a sequence.
Vertex vertexAt(std::size_t i) {
  const std::size_t place = (i + kSeen) / kStep, middle = place * kStep;
  if (i >= middle + kSeen)
    return kUnseen;
  const double x = double(place * 5 % 8) / 4 - 0.9, y = double(place * 3 % 7) / 3.5 - 0.9;
  const double angle = double(i % 6) * 1.0472 + double(i % 5) * 0.11;
  return {float(x + 0.22 * std::cos(angle)),
          float(y + 0.22 * std::sin(angle)),
          {static_cast<unsigned char>(i * 53 % 256), static_cast<unsigned char>(i * 97 % 256),
           static_cast<unsigned char>(place * 40 % 256), 255}};
}

std::vector<Vertex> sequenceOf(std::size_t count) {
  std::vector<Vertex> vertices(count, kUnseen);
  for (std::size_t middle = 0; middle <= count; middle += kStep)
    for (std::size_t i = middle < kSeen ? 0 : middle - kSeen; i < middle + kSeen && i < count; ++i)
      vertices[i] = vertexAt(i);
  return vertices;
}

/// Returns the same sequence by indices, with reordered vertices.
std::vector<unsigned> shuffle(std::vector<Vertex> &vertices) {
  const std::size_t count = vertices.size();
  std::size_t factor = 7919; // divides none of the counts that the runner uses
  std::vector<unsigned> indices(count);
  std::vector<Vertex> shuffled(count);
  for (std::size_t i = 0; i < count; ++i) {
    indices[i] = unsigned(i * factor % count);
    shuffled[indices[i]] = vertices[i];
  }
  vertices = std::move(shuffled);
  return indices;
}

long peakKib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0)
      return std::atol(line.c_str() + 6);
  return 0;
}

enum class Way { Arrays, Elements, BeginEnd, BeginMaterial };
struct Kind {
  const char *name;
  GLenum mode;
  Way way;
  bool flat;
};
constexpr Kind kKinds[] = {
    {"points", GL_POINTS, Way::Arrays, false},
    {"lines", GL_LINES, Way::Arrays, false},
    {"line-strip", GL_LINE_STRIP, Way::Arrays, true},
    {"line-loop", GL_LINE_LOOP, Way::Arrays, true},
    {"triangles", GL_TRIANGLES, Way::Arrays, false},
    {"triangle-strip", GL_TRIANGLE_STRIP, Way::Arrays, true},
    {"triangle-fan", GL_TRIANGLE_FAN, Way::Arrays, true},
    {"quads", GL_QUADS, Way::Arrays, true},
    {"quad-strip", GL_QUAD_STRIP, Way::Arrays, true},
    {"polygon", GL_POLYGON, Way::Arrays, true},
    {"elements", GL_TRIANGLES, Way::Elements, false},
    {"element-strip", GL_TRIANGLE_STRIP, Way::Elements, true},
    {"element-fan", GL_TRIANGLE_FAN, Way::Elements, true},
    {"element-loop", GL_LINE_LOOP, Way::Elements, true},
    {"begin-points", GL_POINTS, Way::BeginEnd, false},
    {"begin-line-strip", GL_LINE_STRIP, Way::BeginEnd, true},
    {"begin-triangles", GL_TRIANGLES, Way::BeginEnd, false},
    {"begin-strip", GL_TRIANGLE_STRIP, Way::BeginEnd, true},
    {"begin-fan", GL_TRIANGLE_FAN, Way::BeginEnd, true},
    {"begin-quads", GL_QUADS, Way::BeginEnd, true},
    {"begin-polygon", GL_POLYGON, Way::BeginEnd, true},
    {"begin-strip-material", GL_TRIANGLE_STRIP, Way::BeginMaterial, true},
    {"begin-fan-material", GL_TRIANGLE_FAN, Way::BeginMaterial, true},
};

/// Draws one primitive of Begin and End, whose vertices are in no array. A material among its last
/// vertices must reach the host, which draws the rest.
void beginLarge(const Kind &kind, std::size_t count) {
  const std::size_t material =
      kind.way == Way::BeginMaterial ? count * 3 / 4 / kStep * kStep : count;
  glBegin(kind.mode);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == material)
      glMaterialf(GL_FRONT, GL_SHININESS, 5);
    const Vertex vertex = vertexAt(i);
    glColor4ubv(vertex.color);
    glVertex2f(vertex.x, vertex.y);
  }
  glEnd();
}

void drawLarge(const Kind &kind, std::size_t count) {
  std::vector<Vertex> vertices;
  std::vector<unsigned> indices;
  const bool begins = kind.way == Way::BeginEnd || kind.way == Way::BeginMaterial;
  if (!begins)
    vertices = sequenceOf(count);
  if (kind.way == Way::Elements)
    indices = shuffle(vertices);
  glShadeModel(kind.flat ? GL_FLAT : GL_SMOOTH);
  // Front and back sides are drawn differently.
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  for (const GLenum front : {GL_CCW, GL_CW}) {
    glFrontFace(front);
    if (begins) {
      beginLarge(kind, count);
    } else {
      glVertexPointer(2, GL_FLOAT, sizeof(Vertex), &vertices[0].x);
      glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), vertices[0].color);
      glEnableClientState(GL_VERTEX_ARRAY);
      glEnableClientState(GL_COLOR_ARRAY);
    }
    if (kind.way == Way::Elements)
      glDrawElements(kind.mode, GLsizei(count), GL_UNSIGNED_INT, indices.data());
    if (kind.way == Way::Arrays)
      glDrawArrays(kind.mode, 0, GLsizei(count));
    if (front == GL_CCW)
      glTranslatef(0.1f, 0.05f, 0);
  }
}

void quad() {
  glBegin(GL_QUADS);
  glColor3f(0.9f, 0.5f, 0.1f);
  for (const float corner : {0.0f, 1.0f, 2.0f, 3.0f})
    glVertex2f(corner == 1 || corner == 2 ? 0.8f : -0.7f, corner >= 2 ? 0.9f : -0.6f);
  glEnd();
}

void bindMany(std::size_t count, const GLuint *programs) {
  glNewList(1, GL_COMPILE);
  for (std::size_t i = 0; i < count; ++i)
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, programs[i % 2]);
  quad();
  glEndList();
  glCallList(1);
}

/// A long program made of repeated lines, each of which depends on the previous one. Its numbers do
/// not converge to zero.
struct Chain {
  const char *name;
  const char *even, *odd;
};
constexpr Chain kChains[] = {
    {"mad", "MAD u, t, -t, t;\n",
     "MAD_SAT t, u, { 3.2, 3.1, 3.3, 3.1 }, { 0.01, 0.02, 0.01, 0.1 };\n"},
    {"tex", "TEX t, t, texture[0], 2D;\n", "TEX t, t.yxzw, texture[0], 2D;\n"},
    {"pow", "POW_SAT t.x, u.y, t.x;\n", "POW_SAT u.y, t.x, u.z;\n"},
    {"mixture", "TEX t, u, texture[0], 2D;\nMAD_SAT u, t, u.yzwx, t;\n",
     "POW_SAT u.x, t.y, u.z;\nDP3_SAT t.w, u, t;\n"},
};

void makeTexture() {
  unsigned char texels[4 * 4 * 4];
  for (std::size_t i = 0; i < sizeof texels; ++i)
    texels[i] = static_cast<unsigned char>(40 + i * 37 % 200);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void drawLong(const Chain &chain, std::size_t count) {
  std::string text =
      "!!ARBfp1.0\nTEMP t, u;\nMOV t, fragment.color;\nMOV u, { 0.5, 0.25, 0.75, 1 };\n";
  const std::size_t each = std::string(chain.name) == "mixture" ? 2 : 1; // instructions in a line
  for (std::size_t i = 0; i < count / each; ++i)
    text += i % 2 ? chain.odd : chain.even;
  makeTexture();
  (void)software::makeProgram(GL_FRAGMENT_PROGRAM_ARB, text + "ADD result.color, t, u;\nEND\n");
  quad();
}

} // namespace

int main(int argc, char **argv) {
  const Kind *const kind = software::rowNamed(kKinds, argc, argv);
  const bool binds = argc == 3 && !std::strcmp(argv[1], "binds");
  const Chain *chain = nullptr;
  for (const Chain &known : kChains)
    if (argc == 3 && argv[1] == std::string("long-") + known.name)
      chain = &known;
  software::Screen screen;
  if ((!kind && !binds && !chain) || !screen.open())
    return 2;
  screen.makeCurrent(screen.makePbuffer(kSide, kSide), screen.makeContext());
  glDisable(GL_DITHER);
  const GLuint programs[] = {
      software::makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                            "!!ARBfp1.0\nMOV result.color, fragment.color.zyxw;\nEND\n"),
      software::makeProgram(
          GL_FRAGMENT_PROGRAM_ARB,
          "!!ARBfp1.0\nMUL result.color, fragment.color, { 0.9, 0.8, 1, 1 };\nEND\n")};
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glClear(GL_COLOR_BUFFER_BIT);
  quad(); // one-time objects are made here
  glFinish();
  glClear(GL_COLOR_BUFFER_BIT);
  const auto count = std::size_t(std::atoll(argv[2]));
  const auto begin = std::chrono::steady_clock::now();
  if (binds)
    bindMany(count, programs);
  else if (chain)
    drawLong(*chain, count);
  else
    drawLarge(*kind, count);
  glFinish();
  const auto time = std::chrono::steady_clock::now() - begin;
  record("picture" + software::takeErrors(), software::readRgba(0, 0, kSide, kSide));
  const long ms = long(std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
  const std::string figures = std::to_string(ms) + " " + std::to_string(peakKib());
  record("figures", {figures.begin(), figures.end()});
  return 0;
}
