// Draws Coin's bump maps, and a scene's own programs as ARB texts (SoShaderProgram), in a GLX
// window.
#include <GL/gl.h>
#include <GL/glx.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoSceneManager.h>
#include <Inventor/nodes/SoBumpMap.h>
#include <Inventor/nodes/SoFragmentShader.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoRotationXYZ.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShaderParameter.h>
#include <Inventor/nodes/SoShaderProgram.h>
#include <Inventor/nodes/SoVertexShader.h>
#include <X11/Xlib.h>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

namespace {

constexpr int kFrames = 16;
constexpr short kWidth = 400;
constexpr short kHeight = 200;

constexpr const char *kScene = R"(#Inventor V2.1 ascii
Separator {
  DEF camera PerspectiveCamera { position 0 0 6 nearDistance 1 farDistance 20 }
  DirectionalLight { direction -0.4 -0.5 -0.8 }
  PointLight { location 2 2 3 color 0.6 0.5 0.4 }
  Separator {
    Translation { translation -1.6 0 0 }
    DEF turn RotationXYZ { axis Y }
    Complexity { value 0.6 }
    Material { diffuseColor 0.8 0.6 0.4 specularColor 1 1 1 shininess 0.5 }
    Texture2 { image 4 4 3 0xffffff 0xffcc99 0xffffff 0x99ccff 0xffcc99 0xffffff 0x99ccff 0xffffff
                     0xffffff 0x99ccff 0xffffff 0xffcc99 0x99ccff 0xffffff 0xffcc99 0xffffff }
    DEF bumps BumpMap { }
    Cube { width 1.6 height 1.6 depth 1.6 }
  }
  Separator {
    Translation { translation 1.6 0 0 }
    Rotation { rotation 1 0 0 0.5 }
    DEF shaders ShaderProgram { }
    Complexity { value 0.6 }
    Sphere { }
  }
}
)";

constexpr const char *kVertexProgram = R"(!!ARBvp1.0
OPTION ARB_position_invariant;
PARAM turn[3] = { state.matrix.modelview.invtrans.row[0..2] };
TEMP n;
DP3 n.x, turn[0], vertex.normal;
DP3 n.y, turn[1], vertex.normal;
DP3 n.z, turn[2], vertex.normal;
MOV n.w, 1.0;
MOV result.texcoord[1], n;
MOV result.texcoord[0], vertex.texcoord[0];
END
)";

constexpr const char *kFragmentProgram = R"(!!ARBfp1.0
PARAM wave = program.local[0];
TEMP n, c;
DP3 n.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ n.w, n.w;
MUL n.xyz, fragment.texcoord[1], n.w;
MUL c.xyz, fragment.texcoord[0], 25.0;
ADD c.x, c.x, wave.x;
SIN c.x, c.x;
COS c.y, c.y;
MAD c.xyz, c, 0.25, 0.5;
MUL result.color.xyz, c, n.z;
MOV result.color.w, 1.0;
END
)";

/// Sets 32x32 heights, one byte each.
void setBumps(SoBumpMap &node) {
  constexpr short kSide = 32;
  std::vector<unsigned char> heights;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      heights.push_back(
          static_cast<unsigned char>(128 + 100 * std::sin(0.59 * x) * std::sin(0.39 * y)));
    }
  }
  node.image.setValue(SbVec2s(kSide, kSide), 1, heights.data());
}

SoShaderParameter4f *setShaders(SoShaderProgram &node) {
  auto *vertex = new SoVertexShader;
  vertex->sourceType = SoShaderObject::ARB_PROGRAM;
  vertex->sourceProgram = kVertexProgram;
  auto *fragment = new SoFragmentShader;
  fragment->sourceType = SoShaderObject::ARB_PROGRAM;
  fragment->sourceProgram = kFragmentProgram;
  auto *wave = new SoShaderParameter4f;
  wave->identifier = 0;
  fragment->parameter.set1Value(0, wave);
  node.shaderObject.set1Value(0, vertex);
  node.shaderObject.set1Value(1, fragment);
  return wave;
}

/// Opens a double-buffered window whose context is current; returns null if it cannot.
Window openWindow(Display *display) {
  int wanted[] = {GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8, GLX_DEPTH_SIZE, 24, None};
  XVisualInfo *visual = glXChooseVisual(display, DefaultScreen(display), wanted);
  if (!visual)
    return None;
  const Window root = DefaultRootWindow(display);
  XSetWindowAttributes attributes{};
  attributes.colormap = XCreateColormap(display, root, visual->visual, AllocNone);
  const Window window =
      XCreateWindow(display, root, 0, 0, kWidth, kHeight, 0, visual->depth, InputOutput,
                    visual->visual, CWColormap | CWBorderPixel, &attributes);
  XMapWindow(display, window);
  glXMakeCurrent(display, window, glXCreateContext(display, visual, nullptr, True));
  return window;
}

} // namespace

int main() {
  SoDB::init();
  Display *display = XOpenDisplay(nullptr);
  const Window window = display ? openWindow(display) : None;
  if (window == None) {
    std::fprintf(stderr, "coin: no window\n");
    return 1;
  }
  SoInput input;
  input.setBuffer(kScene, std::strlen(kScene));
  SoSeparator *scene = SoDB::readAll(&input);
  if (!scene)
    return 1;
  scene->ref();
  setBumps(*static_cast<SoBumpMap *>(SoNode::getByName("bumps")));
  SoShaderParameter4f *wave =
      setShaders(*static_cast<SoShaderProgram *>(SoNode::getByName("shaders")));
  auto *turn = static_cast<SoRotationXYZ *>(SoNode::getByName("turn"));

  SoSceneManager manager;
  manager.setViewportRegion(SbViewportRegion(kWidth, kHeight));
  manager.setBackgroundColor(SbColor(0.1F, 0.15F, 0.2F));
  manager.setSceneGraph(scene);
  glEnable(GL_DEPTH_TEST);
  for (int frame = 0; frame < kFrames; ++frame) {
    turn->angle = 0.15F * float(frame);
    wave->value = SbVec4f(0.3F * float(frame), 0, 0, 0);
    glViewport(0, 0, kWidth, kHeight);
    manager.render();
    glXSwapBuffers(display, window);
  }
  return 0;
}
