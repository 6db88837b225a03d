#include "common/demo.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cstdio>

namespace demos {
namespace {

/// The data that GLFW callbacks reach through the window's user pointer.
struct Session {
  Demo *demo;
  bool paused = false;
  bool titleDirty = true;
};

Session &session(GLFWwindow *window) {
  return *static_cast<Session *>(glfwGetWindowUserPointer(window));
}

struct SliderKeys {
  int less;
  int more;
};
constexpr SliderKeys kSliderKeys[] = {{GLFW_KEY_LEFT, GLFW_KEY_RIGHT},
                                      {GLFW_KEY_DOWN, GLFW_KEY_UP},
                                      {GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET},
                                      {GLFW_KEY_COMMA, GLFW_KEY_PERIOD},
                                      {GLFW_KEY_MINUS, GLFW_KEY_EQUAL}};

bool moveSlider(Demo &demo, int key) {
  const std::vector<Slider *> sliders = demo.sliders();
  for (std::size_t i = 0; i < sliders.size() && i < std::size(kSliderKeys); ++i) {
    const int direction = int(key == kSliderKeys[i].more) - int(key == kSliderKeys[i].less);
    if (direction == 0)
      continue;
    Slider &slider = *sliders[i];
    slider.value =
        std::clamp(slider.value + float(direction) * slider.step, slider.low, slider.high);
    return true;
  }
  return false;
}

void onKey(GLFWwindow *window, int key, int, int action, int) {
  if (action == GLFW_RELEASE)
    return;
  Session &s = session(window);
  if (key == GLFW_KEY_ESCAPE)
    glfwSetWindowShouldClose(window, GLFW_TRUE);
  else if (key == GLFW_KEY_SPACE)
    s.paused = !s.paused;
  else if (!moveSlider(*s.demo, key) && key >= GLFW_KEY_A && key <= GLFW_KEY_Z)
    s.demo->key(char('A' + key - GLFW_KEY_A));
  s.titleDirty = true;
}

void onPointer(GLFWwindow *window, double x, double y) {
  if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) != GLFW_PRESS)
    return;
  int width = 1, height = 1;
  glfwGetWindowSize(window, &width, &height);
  session(window).demo->pointer({float(x) / float(width), 1.0f - float(y) / float(height)});
}

void showTitle(GLFWwindow *window, Session &s) {
  std::string title = s.demo->name();
  for (const Slider *slider : s.demo->sliders()) {
    char value[64];
    std::snprintf(value, sizeof value, "  %s %.2f", slider->name.c_str(), slider->value);
    title += value;
  }
  glfwSetWindowTitle(window, (title + (s.paused ? "  (paused)" : "")).c_str());
  s.titleDirty = false;
}

} // namespace

void runWindow(Demo &demo, Surface &surface, int frames) {
  Session s{&demo};
  GLFWwindow *window = surface.window();
  glfwSetWindowUserPointer(window, &s);
  glfwSetKeyCallback(window, onKey);
  glfwSetCursorPosCallback(window, onPointer);
  int frame = 0;
  while (!glfwWindowShouldClose(window) && (frames == 0 || frame < frames)) {
    if (s.titleDirty)
      showTitle(window, s);
    if (s.paused) {
      // A slider may have moved, so that the frame is drawn again under its number.
      glfwWaitEventsTimeout(0.1);
      if (!demo.redrawsWhilePaused())
        continue;
    }
    demo.draw(surface, frame);
    frame += s.paused ? 0 : 1;
    surface.present();
  }
}

} // namespace demos
