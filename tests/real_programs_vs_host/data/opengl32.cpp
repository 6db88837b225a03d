// A Windows OpenGL program in a window: it uses assembly programs through wglGetProcAddress(). Four
// tiles, one technique each, are read back and written to o.ppm.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include <windows.h>

#include <GL/gl.h>
#include <GL/glext.h>

namespace {

constexpr int kTile = 128, kTiles = 4, kSide = 64;
constexpr int kWidth = kTile * kTiles, kHeight = kTile;

constexpr char kModulate[] = "!!ARBfp1.0\n"
                             "PARAM tint = program.env[3];\n"
                             "TEMP t, u;\n"
                             "TEX t, fragment.texcoord[0], texture[0], 2D;\n"
                             "LRP u, tint.w, t, tint;\n"
                             "MUL result.color, u, fragment.color;\n"
                             "END";
// This draws a ring and kills all other fragments.
constexpr char kRing[] = "!!ARBfp1.0\n"
                         "TEMP r, d;\n"
                         "MAD r, fragment.texcoord[0], 2.0, -1.0;\n"
                         "DP3 d.x, r, r;\n"
                         "SUB d.y, 0.8, d.x;\n"
                         "SUB d.z, d.x, 0.2;\n"
                         "MOV d.w, 1.0;\n"
                         "MIN d.x, d.y, d.z;\n"
                         "KIL d.x;\n"
                         "MUL result.color, d.yzxw, 2.0;\n"
                         "END";
// The first lookup's result is the second one's coordinate.
constexpr char kDependent[] = "!!ARBfp1.0\n"
                              "PARAM scale = program.local[0];\n"
                              "TEMP t, at;\n"
                              "TEX t, fragment.texcoord[0], texture[0], 2D;\n"
                              "MAD at, t, scale, fragment.texcoord[0];\n"
                              "TEX result.color, at, texture[0], 2D;\n"
                              "END";
constexpr char kLit[] = "!!ARBfp1.0\n"
                        "TEMP n, c;\n"
                        "MAD n.xy, fragment.texcoord[0], 2.0, -1.0;\n"
                        "MOV n.z, 0.5;\n"
                        "DP3 n.w, n, n;\n"
                        "RSQ n.w, n.w;\n"
                        "MUL n.xyz, n, n.w;\n"
                        "DP3_SAT c.x, n, {0.4, 0.6, 0.693};\n"
                        "POW c.y, c.x, 8.0.x;\n"
                        "MOV result.color, fragment.color;\n"
                        "MAD result.color.xyz, c.x, fragment.color, c.y;\n"
                        "END";
constexpr char kVertex[] = "!!ARBvp1.0\n"
                           "PARAM matrix[4] = { state.matrix.mvp };\n"
                           "PARAM turn = program.local[1];\n"
                           "TEMP p;\n"
                           "MOV p, vertex.position;\n"
                           "MUL p.x, vertex.position.x, turn.x;\n"
                           "MAD p.x, vertex.position.y, -turn.y, p.x;\n"
                           "MUL p.y, vertex.position.y, turn.x;\n"
                           "MAD p.y, vertex.position.x, turn.y, p.y;\n"
                           "DP4 result.position.x, matrix[0], p;\n"
                           "DP4 result.position.y, matrix[1], p;\n"
                           "DP4 result.position.z, matrix[2], p;\n"
                           "DP4 result.position.w, matrix[3], p;\n"
                           "MOV result.color, vertex.color;\n"
                           "MOV result.texcoord[0], vertex.texcoord[0];\n"
                           "END";
constexpr const char *kFragments[kTiles] = {kModulate, kRing, kDependent, kLit};

template <typename Function> bool find(Function &function, const char *name) {
  function = reinterpret_cast<Function>(reinterpret_cast<void *>(wglGetProcAddress(name)));
  if (!function)
    std::fprintf(stderr, "no %s\n", name);
  return function != nullptr;
}

struct Programs {
  PFNGLGENPROGRAMSARBPROC generate;
  PFNGLBINDPROGRAMARBPROC bind;
  PFNGLPROGRAMSTRINGARBPROC load;
  PFNGLPROGRAMENVPARAMETER4FARBPROC env;
  PFNGLPROGRAMLOCALPARAMETER4FVARBPROC local;

  bool get() {
    return find(generate, "glGenProgramsARB") && find(bind, "glBindProgramARB") &&
           find(load, "glProgramStringARB") && find(env, "glProgramEnvParameter4fARB") &&
           find(local, "glProgramLocalParameter4fvARB");
  }
  bool bindNew(GLenum target, const char *text) const {
    GLuint name = 0;
    generate(1, &name);
    bind(target, name);
    load(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(text)), text);
    if (glGetError() == GL_NO_ERROR)
      return true;
    std::fprintf(stderr, "refused: %s\n",
                 reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB)));
    return false;
  }
};

void makeTexture() {
  std::vector<unsigned char> texels;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto wave = static_cast<unsigned char>(127.5 + 127 * std::sin(0.2 * (x + 2 * y)));
      texels.insert(texels.end(), {wave, static_cast<unsigned char>(4 * x),
                                   static_cast<unsigned char>(4 * y), 255});
    }
  // This is nearest, as filters of bytes are implementation-dependent, and a second lookup
  // increases the difference.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
}

void drawQuad() {
  static const float kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glBegin(GL_QUADS);
  for (const auto &corner : kCorners) {
    glColor4f(1, corner[0], 1 - corner[1], 1);
    // The offset avoids edges of texels.
    glTexCoord2f(corner[0] + 0.003F, corner[1] + 0.003F);
    glVertex3f(corner[0] * 1.8F - 0.9F, corner[1] * 1.8F - 0.9F, 0);
  }
  glEnd();
}

bool draw(const Programs &programs) {
  glClearColor(0.1F, 0.2F, 0.3F, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  makeTexture();
  programs.env(GL_FRAGMENT_PROGRAM_ARB, 3, 0.9F, 0.3F, 0.2F, 0.625F);
  for (int tile = 0; tile < kTiles; ++tile) {
    glViewport(tile * kTile, 0, kTile, kTile);
    if (!programs.bindNew(GL_FRAGMENT_PROGRAM_ARB, kFragments[tile]))
      return false;
    const float scale[4] = {0.25F, 0.125F, 0, 0};
    programs.local(GL_FRAGMENT_PROGRAM_ARB, 0, scale);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    if (tile == 3) {
      if (!programs.bindNew(GL_VERTEX_PROGRAM_ARB, kVertex))
        return false;
      // It stays within the viewport, as not every host clips there.
      const float turn[4] = {0.8F * std::cos(0.3F), 0.8F * std::sin(0.3F), 0, 0};
      programs.local(GL_VERTEX_PROGRAM_ARB, 1, turn);
      glEnable(GL_VERTEX_PROGRAM_ARB);
    }
    drawQuad();
  }
  return glGetError() == GL_NO_ERROR;
}

bool write() {
  std::vector<unsigned char> pixels(std::size_t(kWidth) * kHeight * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  std::FILE *const file = std::fopen("o.ppm", "wb");
  if (!file)
    return false;
  std::fprintf(file, "P6\n%d %d\n255\n", kWidth, kHeight);
  for (int y = kHeight; y-- > 0;)
    std::fwrite(&pixels[std::size_t(y) * kWidth * 3], 3, kWidth, file);
  return std::fclose(file) == 0;
}

HDC makeCurrent() {
  WNDCLASSA kind = {};
  kind.lpfnWndProc = DefWindowProcA;
  kind.lpszClassName = "opengl32";
  kind.style = CS_OWNDC;
  RegisterClassA(&kind);
  HWND window = CreateWindowA("opengl32", "opengl32", WS_POPUP | WS_VISIBLE, 0, 0, kWidth, kHeight,
                              nullptr, nullptr, nullptr, nullptr);
  HDC device = GetDC(window);
  PIXELFORMATDESCRIPTOR format = {};
  format.nSize = sizeof format;
  format.nVersion = 1;
  format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
  format.iPixelType = PFD_TYPE_RGBA;
  format.cColorBits = 24;
  if (!SetPixelFormat(device, ChoosePixelFormat(device, &format), &format))
    return nullptr;
  HGLRC context = wglCreateContext(device);
  return context && wglMakeCurrent(device, context) ? device : nullptr;
}

} // namespace

int main() {
  const HDC device = makeCurrent();
  if (!device)
    return 1;
  Programs programs = {};
  if (!programs.get())
    return 2;
  if (!draw(programs))
    return 3;
  if (!write())
    return 4;
  SwapBuffers(device);
  return 0;
}
