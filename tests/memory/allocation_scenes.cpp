// The scenes: programs, draws, lists, copies, textures, contexts, frames shown.
#include "allocations.h"

namespace memory {

namespace {

GLuint load(GLenum target, const std::string &text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  return name;
}

/// A text that no program had before, of the same meaning.
std::string fresh(const std::string &body, const char *header, int round) {
  return std::string(header) + "\n# " + std::to_string(round) + "\n" + body + "END\n";
}
constexpr const char *kFragment = "TEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                                  "MAD t, t, program.env[1], program.local[2];\n"
                                  "MUL result.color, t, fragment.color;\n";
constexpr const char *kVertex = "PARAM m[4] = { state.matrix.mvp };\n"
                                "DP4 result.position.x, m[0], vertex.position;\n"
                                "DP4 result.position.y, m[1], vertex.position;\n"
                                "DP4 result.position.z, m[2], vertex.position;\n"
                                "DP4 result.position.w, m[3], vertex.position;\n"
                                "MUL result.color, vertex.color, program.local[0];\n"
                                "MOV result.texcoord[0], vertex.texcoord[0];\n";

void setParameters() {
  glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 1, 0.7f, 0.6f, 0.9f, 1);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 2, 0.1f, 0.2f, 0.05f, 0);
  glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 1, 0.8f, 0.9f, 1);
}

void enablePrograms() {
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glEnable(GL_VERTEX_PROGRAM_ARB);
}

std::vector<unsigned char> texelsOf(int side, int seed) {
  std::vector<unsigned char> texels(std::size_t(side) * std::size_t(side) * 4);
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = static_cast<unsigned char>(i * 37 + std::size_t(seed) * 91 + (i >> 5));
  return texels;
}

GLuint makeTexture(int side, int seed) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texelsOf(side, seed).data());
  return name;
}

/// Added to texture coordinates, so that no pixel samples where two texels meet: the host, which a
/// program is left to where memory runs out, and the rasterizer may each take another one there.
constexpr float kOff = 0.007f;

void quad(float left = -1, float right = 1) {
  glBegin(GL_QUADS);
  glColor4f(1, 0.9f, 0.8f, 1);
  glTexCoord2f(kOff, kOff), glVertex2f(left, -1);
  glTexCoord2f(1 + kOff, kOff), glVertex2f(right, -1);
  glTexCoord2f(1 + kOff, 1 + kOff), glVertex2f(right, 1);
  glTexCoord2f(kOff, 1 + kOff), glVertex2f(left, 1);
  glEnd();
}

/// What is used in all frames, made while there is memory.
struct Kept {
  GLuint fragment, vertex, texture, list, buffer;
} g_kept;

void makeKept(Surface &) {
  g_kept.fragment = load(GL_FRAGMENT_PROGRAM_ARB, fresh(kFragment, "!!ARBfp1.0", -1));
  g_kept.vertex = load(GL_VERTEX_PROGRAM_ARB, fresh(kVertex, "!!ARBvp1.0", -1));
  setParameters();
  g_kept.texture = makeTexture(16, 3);
  g_kept.list = glGenLists(1);
  glNewList(g_kept.list, GL_COMPILE);
  quad(-0.5f, 0.5f);
  glEndList();
}

void useKept() {
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, g_kept.fragment);
  glBindProgramARB(GL_VERTEX_PROGRAM_ARB, g_kept.vertex);
  glBindTexture(GL_TEXTURE_2D, g_kept.texture);
  setParameters();
  enablePrograms();
}

/// An error of this moment would be lost: the frame was refused if it says that memory ran out.
GLenum takeErrorOf(Surface &window) {
  const GLenum error = glGetError();
  window.refused = window.refused || error == GL_OUT_OF_MEMORY;
  return error;
}

Pixels programs(Surface &window, int round) {
  reset();
  const GLuint fragment = load(GL_FRAGMENT_PROGRAM_ARB, fresh(kFragment, "!!ARBfp1.0", round));
  const GLuint vertex = load(GL_VERTEX_PROGRAM_ARB, fresh(kVertex, "!!ARBvp1.0", round));
  setParameters();
  glBindTexture(GL_TEXTURE_2D, g_kept.texture);
  enablePrograms();
  quad();
  Pixels picture = readPixels();
  // A mistake has a text; a text is read back.
  (void)load(GL_FRAGMENT_PROGRAM_ARB, fresh("MOV result.color, wrong;\n", "!!ARBfp1.0", round));
  if (takeErrorOf(window) == GL_INVALID_OPERATION)
    (void)glGetString(GL_PROGRAM_ERROR_STRING_ARB);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, fragment);
  GLint length = 0;
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_LENGTH_ARB, &length);
  std::vector<char> text(std::size_t(length < 0 ? 0 : length) + 1);
  glGetProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_STRING_ARB, text.data());
  GLint native = 0;
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB, &native);
  const GLuint names[] = {fragment, vertex};
  glDeleteProgramsARB(2, names);
  return picture;
}

/// A program whose machine code is not there yet: what it compares with is another number each
/// time. The picture is not.
Pixels compiles(Surface &window, int round) {
  reset();
  const std::string body = "TEMP t, u;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                           "SLT u, fragment.texcoord[0], { -" +
                           std::to_string(round + 2) +
                           " };\nMAD t, t, program.env[1], program.local[2];\n"
                           "ADD_SAT result.color, t, u;\n";
  const GLuint fragment = load(GL_FRAGMENT_PROGRAM_ARB, fresh(body, "!!ARBfp1.0", round));
  setParameters();
  glBindTexture(GL_TEXTURE_2D, g_kept.texture);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  quad(-1, 0.4f);
  glFinish();
  quad(-0.2f, 0.8f);
  takeErrorOf(window);
  Pixels picture = readPixels();
  glDeleteProgramsARB(1, &fragment);
  return picture;
}

Pixels draws(Surface &, int) {
  static constexpr float kArray[] = {-1,       -1,       kOff, 1 + kOff, -1,       1,
                                     1 + kOff, 1 + kOff, 1,    -1,       1 + kOff, kOff};
  static constexpr GLushort kIndices[] = {0, 1, 2};
  reset();
  useKept();
  quad(-1, -0.2f);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof kArray, kArray, GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  const auto point = [](const float *at) {
    glVertexPointer(2, GL_FLOAT, 16, at);
    glTexCoordPointer(2, GL_FLOAT, 16, reinterpret_cast<const char *>(at) + 8);
  };
  point(kArray);
  glScissor(0, 0, kSide, kSide / 2);
  glEnable(GL_SCISSOR_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_SCISSOR_TEST);
  glDrawElements(GL_LINE_LOOP, 3, GL_UNSIGNED_SHORT, kIndices);
  glPointSize(5);
  glDrawArrays(GL_POINTS, 0, 3);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  point(nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glRotatef(30, 0, 0, 1);
  for (int i = 0; i < 3; ++i)
    glDrawArrays(GL_TRIANGLES, 0, 3);
  const GLint firsts[] = {0, 0};
  const GLsizei counts[] = {3, 3};
  glRotatef(30, 0, 0, 1);
  glMultiDrawArrays(GL_TRIANGLES, firsts, counts, 2);
  glDeleteBuffers(1, &buffer);
  // Fixed function's vertices, then its fragments.
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_VERTEX_PROGRAM_ARB);
  glRectf(0.2f, 0.2f, 0.6f, 0.9f);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  glColor3f(0.2f, 0.9f, 0.4f);
  glRectf(0.5f, -0.9f, 0.9f, -0.1f);
  return readPixels();
}

Pixels manyTriangles(Surface &, int round) {
  reset();
  useKept();
  const int count = 300 + round % 5 * 200;
  std::vector<float> vertices;
  for (int i = 0; i < 3 * count; ++i) {
    const float step = float(i / 3 % 300) / 150 - 1;
    vertices.push_back(step + (i % 3 == 1 ? 0.3f : 0.0f));
    vertices.push_back(float(i * 7 % 19) / 10 - 0.9f);
  }
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, vertices.data());
  glDrawArrays(GL_TRIANGLES, 0, 3 * count);
  // The number is another one each time, so that arrays grow; the picture is not.
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, 900);
  glTranslatef(5, 0, 0); // clipped, all of it
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 900);
  return readPixels();
}

Pixels lists(Surface &, int round) {
  reset();
  useKept();
  const GLuint list = glGenLists(2);
  if (list == 0)
    return readPixels();
  glNewList(list, GL_COMPILE);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, g_kept.fragment);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 2, 0.3f, 0.1f, 0.0f, 0);
  quad(-1, 0);
  glPushAttrib(GL_ENABLE_BIT);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glScalef(0.5f, 0.5f, 1);
  quad(0, 1);
  quad(-1, -0.5f);
  glPopAttrib();
  glCallList(g_kept.list);
  glEndList();
  glNewList(list + 1, round % 2 ? GL_COMPILE : GL_COMPILE_AND_EXECUTE);
  glDisable(GL_VERTEX_PROGRAM_ARB);
  quad(0.7f, 0.9f);
  glEnable(GL_VERTEX_PROGRAM_ARB);
  glEndList();
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(list);
  const GLubyte names[] = {0, 1};
  glLoadIdentity();
  glListBase(list);
  glCallLists(2, GL_UNSIGNED_BYTE, names);
  glDeleteLists(list, 2);
  return readPixels();
}

Pixels copies(Surface &, int) {
  reset();
  useKept();
  const GLuint target = makeTexture(kSide, 9);
  for (int i = 0; i < 3; ++i) {
    glBindTexture(GL_TEXTURE_2D, i == 0 ? g_kept.texture : target);
    quad();
    glBindTexture(GL_TEXTURE_2D, target);
    if (i == 1)
      glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, kSide, kSide, 0);
    else
      glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kSide, kSide);
  }
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLuint image = makeTexture(kSide, 11);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image, 0);
  glBindTexture(GL_TEXTURE_2D, target);
  quad(-1, 0.5f);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, image);
  quad();
  Pixels picture = readPixels();
  glDeleteFramebuffers(1, &framebuffer);
  const GLuint names[] = {target, image};
  glDeleteTextures(2, names);
  return picture;
}

Pixels textures(Surface &, int round) {
  reset();
  useKept();
  const GLuint texture = makeTexture(16, 5);
  quad();
  glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 8, 8, GL_BGRA, GL_UNSIGNED_BYTE, texelsOf(8, 1).data());
  quad();
  std::vector<unsigned char> texels(16 * 16 * 4);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glRasterPos2f(-0.5f, -0.5f);
  glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, texelsOf(8, 2).data());
  quad(0.5f, 1);
  glCopyPixels(0, 0, 8, 8, GL_COLOR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texelsOf(4, 7).data());
  quad(-1, -0.4f);
  (void)round;
  Pixels picture = readPixels();
  glDeleteTextures(1, &texture);
  return picture;
}

Pixels shown(Surface &window, int round) {
  reset();
  useKept();
  for (int i = 0; i < 3; ++i) {
    quad(i == 2 ? -1 : -0.3f, 1);
    if (i < 2)
      glXSwapBuffers(window.display, window.drawable);
  }
  Pixels picture = readPixels();
  glXSwapBuffers(window.display, window.drawable);
  glXWaitGL();
  XSync(window.display, False);
  XImage *const image = XGetImage(window.display, window.x, 0, 0, kSide, kSide, AllPlanes, ZPixmap);
  for (int y = 0; image && y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (const int shift : {16, 8, 0})
        picture.push_back(static_cast<unsigned char>(XGetPixel(image, x, y) >> shift));
  if (image)
    XDestroyImage(image);
  (void)round;
  return picture;
}

Pixels contexts(Surface &window, int) {
  const GLXContext second =
      glXCreateNewContext(window.display, window.config, GLX_RGBA_TYPE, window.context, True);
  const GLXContext third =
      glXCreateNewContext(window.display, window.config, GLX_RGBA_TYPE, nullptr, True);
  const int size[] = {GLX_PBUFFER_WIDTH, kSide, GLX_PBUFFER_HEIGHT, kSide, None};
  const GLXPbuffer pbuffer = glXCreatePbuffer(window.display, window.config, size);
  window.refused = !second || !third;
  Pixels picture;
  if (second && window.use(pbuffer, second)) {
    reset();
    useKept();
    quad();
    picture = readPixels();
    takeErrorOf(window);
  }
  if (third && window.use(pbuffer, third)) {
    reset();
    const GLuint own = load(GL_FRAGMENT_PROGRAM_ARB,
                            "!!ARBfp1.0\nMOV result.color, { 0.25, 0.5, 0.75, 1 };\nEND\n");
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    quad(-0.7f, 0.3f);
    glDeleteProgramsARB(1, &own);
    const Pixels more = readPixels();
    takeErrorOf(window);
    picture.insert(picture.end(), more.begin(), more.end());
  }
  for (int tries = 0; tries < 3 && !window.use(window.drawable, window.context); ++tries) {
  }
  for (const GLXContext each : {second, third})
    if (each)
      glXDestroyContext(window.display, each);
  glXDestroyPbuffer(window.display, pbuffer);
  reset();
  useKept();
  quad();
  const Pixels last = readPixels();
  picture.insert(picture.end(), last.begin(), last.end());
  return picture;
}

/// All that a context makes when it first draws, shows and samples.
Pixels firstDraws(Surface &window, int round) {
  const Kept kept = g_kept;
  Surface own = window;
  own.context = glXCreateNewContext(window.display, window.config, GLX_RGBA_TYPE, nullptr, True);
  window.refused = !own.context;
  Pixels picture;
  if (own.context && own.use(own.drawable, own.context)) {
    makeKept(own);
    reset();
    for (Pixels (*const each)(Surface &, int) : {draws, manyTriangles, copies, textures, lists}) {
      const Pixels part = each(own, round);
      picture.insert(picture.end(), part.begin(), part.end());
    }
    while (takeErrorOf(window) != GL_NO_ERROR) {
    }
  }
  window.refused = window.refused || own.refused;
  for (int tries = 0; tries < 3 && !window.use(window.drawable, window.context); ++tries) {
  }
  if (own.context)
    glXDestroyContext(window.display, own.context);
  g_kept = kept;
  return picture;
}

Pixels fragmentShaders(Surface &, int) {
  reset();
  glBindTexture(GL_TEXTURE_2D, g_kept.texture);
  const GLuint shader = glGenFragmentShadersATI(1);
  glBindFragmentShaderATI(shader);
  glBeginFragmentShaderATI();
  glSampleMapATI(GL_REG_0_ATI, GL_TEXTURE0, GL_SWIZZLE_STR_ATI);
  glColorFragmentOp2ATI(GL_MUL_ATI, GL_REG_0_ATI, GL_NONE, GL_NONE, GL_REG_0_ATI, GL_NONE, GL_NONE,
                        GL_CON_0_ATI, GL_NONE, GL_NONE);
  glEndFragmentShaderATI();
  constexpr float kConstant[] = {0.9f, 0.5f, 0.7f, 1};
  glSetFragmentShaderConstantATI(GL_CON_0_ATI, kConstant);
  glEnable(GL_FRAGMENT_SHADER_ATI);
  glEnable(GL_TEXTURE_2D);
  quad();
  glDisable(GL_TEXTURE_2D);
  glDisable(GL_FRAGMENT_SHADER_ATI);
  glBindFragmentShaderATI(0);
  glDeleteFragmentShaderATI(shader);
  return readPixels();
}

Pixels named(Surface &, int round) {
  reset();
  useKept();
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  const std::string text = fresh(kFragment, "!!ARBfp1.0", round);
  glNamedProgramStringEXT(name, GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                          GLsizei(text.size()), text.data());
  glNamedProgramLocalParameter4fEXT(name, GL_FRAGMENT_PROGRAM_ARB, 2, 0.2f, 0.3f, 0.1f, 0);
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
  quad(-1, 0.2f);
  glPopAttrib();
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, g_kept.fragment);
  constexpr float kRow[] = {0.5f, 0.5f, 0.5f, 0.5f};
  glProgramLocalParameters4fvEXT(GL_FRAGMENT_PROGRAM_ARB, 0, 1, kRow);
  quad(0.4f, 0.8f);
  glDeleteProgramsARB(1, &name);
  return readPixels();
}

} // namespace

const std::vector<Scene> kScenes = {
    {"programs", makeKept, programs},
    {"compiles", makeKept, compiles},
    {"draws", makeKept, draws},
    {"triangles", makeKept, manyTriangles},
    {"lists", makeKept, lists},
    {"copies", makeKept, copies},
    {"textures", makeKept, textures},
    {"shown", makeKept, shown},
    {"contexts", makeKept, contexts},
    {"first-draws", makeKept, firstDraws},
    {"shaders", makeKept, fragmentShaders},
    {"named", makeKept, named},
};

} // namespace memory
