// Scenes of programs, draws and lists.
#include "allocation_scenes.h"

namespace memory {

Pixels programs(Surface &window, int round) {
  reset();
  const GLuint fragment = load(GL_FRAGMENT_PROGRAM_ARB, fresh(kFragment, "!!ARBfp1.0", round));
  const GLuint vertex = load(GL_VERTEX_PROGRAM_ARB, fresh(kVertex, "!!ARBvp1.0", round));
  setParameters();
  glBindTexture(GL_TEXTURE_2D, g_kept.texture);
  enablePrograms();
  quad();
  Pixels picture = readPixels();
  // A mistake has an error string, which is read back.
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

/// Draws with a program whose machine code does not exist yet: a comparison's constant differs each
/// time, but the picture does not.
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
  // This draws with fixed-function vertices, then with fixed-function fragments.
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
  // The count differs each time, so that arrays grow, but the picture does not.
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, 900);
  glTranslatef(5, 0, 0); // everything is clipped
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

} // namespace memory
