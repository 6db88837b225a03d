// Draws passes that meet at equal depths: rasterizer-meets SEED COUNT. Each seed is a scene of
// random triangles and matrices, drawn twice: first to fill the depths, then in white where depths
// are equal. The two passes transform in different ways (fixed function, a vertex program with the
// invariant option, by DP4, by DPH, by MUL and MAD) and submit their vertices in different ways.
// Half of the second passes have a scissor. Whether they meet depends on the host. The records are
// the second pass's pixels, which meets.py compares.
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "surface.h"

namespace software {
namespace {

constexpr int kEdge = 96; // of all targets, in pixels

struct Transform {
  const char *name;
  const char *statements; ///< null: fixed function
};
constexpr Transform kTransforms[] = {
    {"fixed", nullptr},
    {"invariant", "OPTION ARB_position_invariant;\n"},
    {"DP4", "PARAM m[4] = { state.matrix.mvp };\n"
            "DP4 result.position.x, m[0], vertex.position;\n"
            "DP4 result.position.y, m[1], vertex.position;\n"
            "DP4 result.position.z, vertex.position, m[2];\n"
            "DP4 result.position.w, m[3], vertex.position;\n"},
    {"DPH", "PARAM m[4] = { state.matrix.mvp };\n"
            "ATTRIB v = vertex.position;\n"
            "DPH result.position.x, v, m[0];\n"
            "DPH result.position.y, v, m[1];\n"
            "DPH result.position.z, v.xyzz, m[2];\n"
            "DPH result.position.w, v, m[3];\n"},
    {"MAD", "PARAM m[4] = { state.matrix.mvp.transpose };\n"
            "TEMP t;\n"
            "MUL t, vertex.position.x, m[0];\n"
            "MAD t, vertex.position.y, m[1], t;\n"
            "MAD t, vertex.position.z, m[2], t;\n"
            "MAD result.position, vertex.position.w, m[3], t;\n"},
    {"DP4 of a temporary", "PARAM m[4] = { state.matrix.mvp };\n"
                           "TEMP p;\n"
                           "DP4 p.x, m[0], vertex.position;\n"
                           "DP4 p.y, m[1], vertex.position;\n"
                           "DP4 p.z, m[2], vertex.position;\n"
                           "DP4 p.w, m[3], vertex.position;\n"
                           "MOV result.position, p;\n"},
    {"parameters", "PARAM m[4] = { program.local[3..6] };\n"
                   "DP4 result.position.x, m[0], vertex.position;\n"
                   "DP4 result.position.y, m[1], vertex.position;\n"
                   "DP4 result.position.z, m[2], vertex.position;\n"
                   "DP4 result.position.w, m[3], vertex.position;\n"},
};
constexpr int kTransformCount = int(std::size(kTransforms));

enum class Route { Immediate, Arrays, Indices, Buffer, List };
constexpr const char *kRoutes[] = {"Begin", "arrays", "indices", "a buffer", "a list"};
constexpr int kRouteCount = int(std::size(kRoutes));

struct Pass {
  int transform = 0;
  Route route = Route::Immediate;
  bool fragmentProgram = false;

  [[nodiscard]] std::string name() const {
    return std::string(kTransforms[transform].name) + " by " + kRoutes[int(route)] +
           (fragmentProgram ? " shaded" : "");
  }
};

class Scene {
public:
  Scene() {
    for (int i = 0; i < kTransformCount; ++i)
      if (kTransforms[i].statements)
        m_programs[std::size_t(i)] = makeProgram(
            GL_VERTEX_PROGRAM_ARB, std::string("!!ARBvp1.0\n") + kTransforms[i].statements +
                                       "MOV result.color, vertex.color;\nEND\n");
    m_shading = makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                            "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
    glGenBuffers(1, &m_buffer);
    m_list = glGenLists(1);
  }

  /// Makes a scene's geometry, matrices and state; the next one starts from its state.
  void make(std::uint64_t seed) {
    m_random = Random(seed);
    m_random.bits();
    m_boxes = Random(seed + 1000);
    m_mode = m_random.pick(kModes);
    m_corners.resize(std::size_t(m_random.between(20, 60)) * 9);
    for (float &value : m_corners)
      value = 2 * unit();
    m_indices.clear();
    for (std::size_t i = 0; i < m_corners.size() / 3; ++i)
      m_indices.push_back(GLushort(i));
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_corners.size() * sizeof(float)), m_corners.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    matrices();
    state();
    glNewList(m_list, GL_COMPILE);
    begin();
    glEndList();
  }

  /// Draws two passes and records the pixels in which they met.
  void draw(const Pass &first, const Pass &second, const std::string &name) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDepthFunc(GL_LESS);
    glColor4f(0, 0, 1, 1);
    pass(first);
    glDepthFunc(GL_EQUAL);
    glColor4f(1, 1, 1, 1);
    const bool scissored = m_boxes.once(2);
    if (scissored)
      scissor();
    pass(second);
    glDisable(GL_SCISSOR_TEST);
    record(name + (m_clipped ? "clipped, " : "") + first.name() + ", then " + second.name() +
               (scissored ? " under a scissor" : "") + takeErrors(),
           readRgba(0, 0, kEdge, kEdge));
  }

  Pass randomPass() {
    return {m_random.below(kTransformCount), Route(m_random.below(kRouteCount)), m_random.once(2)};
  }

private:
  static constexpr GLenum kModes[] = {GL_TRIANGLES,    GL_TRIANGLES, GL_TRIANGLE_STRIP,
                                      GL_TRIANGLE_FAN, GL_QUADS,     GL_LINES,
                                      GL_POINTS};

  /// Sets a scissor of more than a quarter of the picture.
  void scissor() {
    const int left = m_boxes.between(0, kEdge / 2), bottom = m_boxes.between(0, kEdge / 2);
    glScissor(left, bottom, m_boxes.between(kEdge / 2, kEdge - left),
              m_boxes.between(kEdge / 2, kEdge - bottom));
    glEnable(GL_SCISSOR_TEST);
  }

  float unit() { return float(m_random.between(-4096, 4096)) / 4096; }

  void matrices() {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    if (m_random.once(4))
      glOrtho(-2.1, 2, -2, 2.3, 1, 9.7);
    else
      glFrustum(-1.07, 1, -1, 1.03, 1.3, 17);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(unit() / 3, unit() / 3, -4.1F);
    glRotatef(180 * unit(), unit(), unit(), unit() + 2);
    glScalef(1 + unit() / 4, 1 + unit() / 4, 1 + unit() / 4);
    // Programs read these rows by parameters; the host multiplies the same matrices.
    float model[16], product[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, model);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glMultMatrixf(model);
    glGetFloatv(GL_PROJECTION_MATRIX, product);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        m_rows[std::size_t(row * 4 + column)] = product[column * 4 + row];
  }

  void state() {
    const bool planes = m_random.once(3), offset = m_random.once(4);
    m_clipped = planes;
    (planes ? glEnable : glDisable)(GL_CLIP_PLANE2);
    const double plane[] = {0.3, -0.9, 0.2, 0.4};
    glClipPlane(GL_CLIP_PLANE2, plane);
    (offset ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5F, float(m_random.between(-8, 8)));
    glDepthRange(m_random.once(4) ? 0.25 : 0, m_random.once(4) ? 0.75 : 1);
    (m_random.once(4) ? glEnable : glDisable)(GL_CULL_FACE);
    glShadeModel(m_random.once(4) ? GL_FLAT : GL_SMOOTH);
    glPolygonMode(GL_FRONT_AND_BACK, m_random.once(8) ? GL_LINE : GL_FILL);
    glPointSize(float(m_random.between(1, 9)));
  }

  void begin() const {
    glBegin(m_mode);
    for (std::size_t i = 0; i < m_corners.size(); i += 3)
      glVertex3fv(&m_corners[i]);
    glEnd();
  }

  void geometry(Route route) const {
    const auto count = GLsizei(m_indices.size());
    if (route == Route::Immediate)
      return begin();
    if (route == Route::List)
      return glCallList(m_list);
    const bool buffer = route == Route::Buffer;
    glBindBuffer(GL_ARRAY_BUFFER, buffer ? m_buffer : 0);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, buffer ? nullptr : m_corners.data());
    if (route == Route::Indices)
      glDrawElements(m_mode, count, GL_UNSIGNED_SHORT, m_indices.data());
    else
      glDrawArrays(m_mode, 0, count);
    glDisableClientState(GL_VERTEX_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }

  void pass(const Pass &pass) {
    const GLuint program = m_programs[std::size_t(pass.transform)];
    (program ? glEnable : glDisable)(GL_VERTEX_PROGRAM_ARB);
    if (program) {
      glBindProgramARB(GL_VERTEX_PROGRAM_ARB, program);
      for (std::size_t row = 0; row < 4; ++row)
        glProgramLocalParameter4fvARB(GL_VERTEX_PROGRAM_ARB, GLuint(3 + row), &m_rows[4 * row]);
    }
    (pass.fragmentProgram ? glEnable : glDisable)(GL_FRAGMENT_PROGRAM_ARB);
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_shading);
    geometry(pass.route);
  }

  Random m_random{0};
  Random m_boxes = m_random; ///< for scissors: the rest of a scene does not depend on them
  std::array<GLuint, kTransformCount> m_programs{};
  GLuint m_shading = 0, m_buffer = 0, m_list = 0;
  GLenum m_mode = GL_TRIANGLES;
  std::vector<float> m_corners; ///< x, y, z of each
  std::vector<GLushort> m_indices;
  bool m_clipped = false;
  std::array<float, 16> m_rows{}; ///< of the product of the matrices
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  software::Screen screen; // X11 has a Screen too
  if (argc != 3 || !screen.open())
    return 1;
  const GLXContext context = screen.makeContext();
  screen.makeCurrent(screen.makePbuffer(kEdge, kEdge), context);
  Scene scene;
  glViewport(0, 0, kEdge, kEdge);
  glDisable(GL_DITHER);
  glEnable(GL_DEPTH_TEST);
  const int first = std::atoi(argv[1]), count = std::atoi(argv[2]);
  // The host may make the first draws with a program, and fixed function before any program.
  scene.make(std::uint64_t(first));
  for (int i = 0; i < kTransformCount; ++i)
    scene.draw({i, Route::Arrays, true}, {i, Route::Arrays, false}, "once: ");
  for (int seed = first; seed < first + count; ++seed) {
    scene.make(std::uint64_t(seed));
    for (int i = 0; i < 12; ++i) {
      const Pass one = scene.randomPass(), two = scene.randomPass();
      scene.draw(one, two, "seed " + std::to_string(seed) + ": ");
    }
  }
  screen.destroy(context);
  return 0;
}
