// Shows a still picture repeatedly: rasterizer-still SCENE FRAMES [two]. Records the first picture,
// and each picture that differs from the previous one, as the window shows them, because an
// application that reads its pixels may be treated differently. With `two`, two contexts draw
// frames in turns. rasterizer-still --list prints the names of the scenes.
#include <cstdlib>
#include <cstring>

#include "still_scenes.h"
#include "surface.h"

namespace software {
namespace {

constexpr int kMaxRecords = 8; // the first changes prove that a picture flickers

void drawFrame(const StillScene &scene) {
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  glClearColor(0.4F, 0.5F, 0.7F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  scene.draw();
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glPopClientAttrib();
  glPopAttrib();
}

int drawStill(const StillScene &scene, int frames, bool two) {
  Screen screen;
  if (!screen.open())
    return 1;
  const GLXDrawable window = screen.makeWindow(kStillEdge, kStillEdge);
  const GLXContext first = screen.makeContext();
  const GLXContext second = two ? screen.makeContext(first) : nullptr;
  for (const GLXContext context : {second, first})
    if (context) {
      screen.makeCurrent(window, context);
      if (scene.prepare)
        scene.prepare();
    }
  std::vector<unsigned char> shown;
  int recorded = 0;
  for (int frame = 0; frame < frames; ++frame) {
    if (two)
      screen.makeCurrent(window, frame % 2 == 0 ? first : second);
    drawFrame(scene);
    screen.swap(window);
    std::vector<unsigned char> picture = screen.grab(kStillEdge, kStillEdge);
    if (picture == shown)
      continue;
    shown = std::move(picture);
    record("frame " + std::to_string(frame), shown);
    if (++recorded == kMaxRecords)
      break;
  }
  record("errors" + takeErrors(), {});
  return 0;
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  const auto &scenes = software::stillScenes();
  const software::StillScene *const scene = software::rowNamed(scenes, argc, argv);
  const bool two = argc == 4 && !std::strcmp(argv[3], "two");
  if (!scene || (argc != 3 && !two))
    return 2;
  return software::drawStill(*scene, std::atoi(argv[2]), two);
}
