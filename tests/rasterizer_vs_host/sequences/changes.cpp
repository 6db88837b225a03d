// Draws, changes one piece of state, draws again, undoes the change and draws a third time, all in
// one context, so that stale cached state is noticed.
//   rasterizer-changes --list   the changes' names
//   rasterizer-changes NAME     one of them
// Records "<form> <name>: before", "after", "undone", and "popped" if an attribute group restores
// it.

#include "changes.h"

namespace software {

namespace {

constexpr const char *kFormNames[] = {"programs", "fixed vertices", "fixed"};

std::string fragmentText(const char *scale) {
  return std::string("!!ARBfp1.0\nTEMP t;\nPARAM fog = state.fog.color;\n"
                     "TEX t, fragment.texcoord[0], texture[0], 2D;\n"
                     "MUL t, t, fragment.color;\nMAD t, t, ") +
         scale +
         ", program.local[0];\nMAD result.color.xyz, fog, 0.125, t;\n"
         "ADD result.color.w, t.w, program.env[0].w;\nEND\n";
}

std::string vertexText(const char *scale) {
  return std::string("!!ARBvp1.0\nPARAM mvp[4] = { state.matrix.mvp };\n"
                     "PARAM tm[4] = { state.matrix.texture[0] };\nTEMP c;\n"
                     "DP4 result.position.x, mvp[0], vertex.position;\n"
                     "DP4 result.position.y, mvp[1], vertex.position;\n"
                     "DP4 result.position.z, mvp[2], vertex.position;\n"
                     "DP4 result.position.w, mvp[3], vertex.position;\n"
                     "DP4 result.texcoord[0].x, tm[0], vertex.texcoord[0];\n"
                     "DP4 result.texcoord[0].y, tm[1], vertex.texcoord[0];\n"
                     "MOV result.texcoord[0].zw, vertex.texcoord[0];\n"
                     "MUL c, vertex.color, ") +
         scale +
         ";\nMAD c, vertex.color.secondary, 0.25, c;\nADD c, c, program.local[0];\n"
         "MAD c, vertex.attrib[6], 0.125, c;\nADD result.color, c, program.env[0];\nEND\n";
}

void defineTexture(GLuint name, int from) {
  glBindTexture(GL_TEXTURE_2D, name);
  for (int level = 0, size = 8; size > 0; ++level, size /= 2) {
    std::vector<unsigned char> texels;
    for (int i = 0; i < 4 * size * size; ++i)
      texels.push_back(static_cast<unsigned char>(96 + (from + 40 * level + 37 * i) % 128));
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

} // namespace

std::vector<StageVertex> stageVertices(float move, float tint) {
  std::vector<StageVertex> vertices;
  for (int i = 0; i < 18; ++i) {
    const float column = float(i / 3 % 3), row = float(i / 9), corner = float(i % 3);
    const float x = -0.8f + 0.55f * column + (corner == 1.0f ? 0.45f : 0.0f) + move;
    const float y = -0.7f + 0.7f * row + (corner == 2.0f ? 0.55f : 0.05f * column);
    StageVertex vertex = {{x, y, -0.4f + 0.1f * float(i % 5), 1.0f},
                          {0.0f, 0.6f, 0.8f},
                          {0.3f + 0.04f * float(i) * tint, 0.8f - 0.03f * float(i), 0.5f, 0.75f},
                          {0.9f * corner, 0.4f * column + 0.2f * corner}};
    // Some are wound the other way, to be culled or lit from behind.
    vertices.push_back(vertex);
    if (i % 9 == 8)
      std::swap(vertices[std::size_t(i)], vertices[std::size_t(i - 1)]);
  }
  return vertices;
}

void pointArrays(GLuint buffer) {
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void *>(offset); };
  constexpr GLsizei kStride = sizeof(StageVertex);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glVertexPointer(4, GL_FLOAT, kStride, at(offsetof(StageVertex, position)));
  glNormalPointer(GL_FLOAT, kStride, at(offsetof(StageVertex, normal)));
  glColorPointer(4, GL_FLOAT, kStride, at(offsetof(StageVertex, color)));
  glTexCoordPointer(2, GL_FLOAT, kStride, at(offsetof(StageVertex, coordinates)));
}

void Stage::make(Form of) {
  form = of;
  fragments[1] = makeProgram(GL_FRAGMENT_PROGRAM_ARB, fragmentText("0.5"));
  fragments[0] = makeProgram(GL_FRAGMENT_PROGRAM_ARB, fragmentText("0.875"));
  vertices[1] = makeProgram(GL_VERTEX_PROGRAM_ARB, vertexText("0.5"));
  vertices[0] = makeProgram(GL_VERTEX_PROGRAM_ARB, vertexText("1.0"));
  glGenTextures(2, textures);
  defineTexture(textures[1], 50);
  defineTexture(textures[0], 0);
  GLuint buffers[3];
  glGenBuffers(3, buffers);
  buffer = buffers[0], otherBuffer = buffers[1], indices = buffers[2];
  for (const GLuint each : {otherBuffer, buffer}) {
    const auto data = stageVertices(each == buffer ? 0.0f : 0.1f, 1.0f);
    glBindBuffer(GL_ARRAY_BUFFER, each);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(data.size() * sizeof data[0]), data.data(),
                 GL_STATIC_DRAW);
  }
  pointArrays(buffer);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glGenFramebuffers(1, &framebuffer);
  glGenTextures(1, &target);
  glBindTexture(GL_TEXTURE_2D, target);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindTexture(GL_TEXTURE_2D, textures[0]);
  glGenQueries(1, &query);
  list = glGenLists(1);
  glColor4f(0.9f, 0.7f, 0.8f, 0.75f);
  glSecondaryColor3f(0.1f, 0.2f, 0.3f);
  glNormal3f(0.0f, 0.6f, 0.8f);
  glEnable(GL_TEXTURE_2D);
  if (form != Form::Fixed)
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
  if (form == Form::Programs)
    glEnable(GL_VERTEX_PROGRAM_ARB);
  if (form == Form::FixedVertices) {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
  }
}

void Stage::draw() const { glDrawArrays(GL_TRIANGLES, 0, 18); }

namespace {

class Run {
public:
  Run(Stage &stage, const Change &change) : m_stage(stage), m_change(change) {
    m_name = std::string(kFormNames[stage.form == Form::Programs        ? 0
                                    : stage.form == Form::FixedVertices ? 1
                                                                        : 2]) +
             " " + change.name;
  }

  void all() {
    // There are several draws, as later ones use what a draw caches.
    for (int i = 0; i < 3; ++i)
      m_stage.draw();
    draw("before");
    clear(); // while no mask and no test is set
    m_change.apply(m_stage);
    show("after");
    m_change.undo(m_stage);
    draw("undone");
    if (m_change.group == 0)
      return;
    clear();
    glPushAttrib(m_change.group);
    m_change.apply(m_stage);
    show("pushed");
    glPopAttrib();
    draw("popped");
  }

private:
  void draw(const char *when) {
    clear();
    show(when);
  }

  void show(const char *when) {
    m_stage.draw();
    record(m_name + ": " + when, readRgba(0, 0, kSide, kSide));
    const std::string errors = takeErrors();
    if (!errors.empty())
      record(m_name + ": errors" + errors + ": " + when, {});
  }

  static void clear() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }

  Stage &m_stage;
  const Change &m_change;
  std::string m_name;
};

/// Makes a context for each change, so that none depends on earlier ones.
void run(Screen &screen, GLXDrawable window, const Change &change, Form form) {
  Stage stage;
  stage.screen = &screen;
  stage.window = window;
  stage.context = screen.makeContext();
  screen.makeCurrent(window, stage.context);
  glViewport(0, 0, kSide, kSide);
  glClearColor(0.2f, 0.1f, 0.4f, 1.0f);
  stage.make(form);
  Run(stage, change).all();
  if (stage.other)
    screen.destroy(stage.other);
  screen.destroy(stage.context);
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  std::vector<Change> all = kPixelChanges;
  for (const std::vector<Change> *const part : {&kVertexChanges, &kObjectChanges})
    all.insert(all.end(), part->begin(), part->end());
  const Change *const change = rowNamed(all, argc, argv);
  software::Screen screen;
  if (!change || !screen.open())
    return change ? 77 : 2;
  const GLXDrawable window = screen.makeWindow(kSide, kSide);
  for (const Form form : {Form::Programs, Form::FixedVertices, Form::Fixed})
    if ((change->forms & unsigned(form)) != 0)
      run(screen, window, *change, form);
  return 0;
}
