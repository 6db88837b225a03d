#include "common/demo.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <epoxy/gl.h>
#include <iostream>

namespace demos {
namespace {

using Clock = std::chrono::steady_clock;

std::string glString(GLenum name) {
  const auto *text = reinterpret_cast<const char *>(glGetString(name));
  return text ? text : "unknown";
}

/// True if GL has recorded an error, which it prints.
bool reportGlErrors(int frame) {
  bool any = false;
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    std::fprintf(stderr, "frame %d: GL error 0x%04x\n", frame, error);
    any = true;
  }
  return any;
}

/// Compares a frame with its reference, which goes to \p file if that has a name.
bool verifyFrame(Demo &demo, const Image &picture, int frame, const std::string &file,
                 int &maxError, std::size_t &beyond) {
  const Tolerance tolerance = demo.tolerance();
  const Image reference = demo.reference(picture.width, picture.height, frame);
  const Difference difference = compare(picture, reference, tolerance);
  maxError = std::max(maxError, difference.maxError);
  beyond = std::max(beyond, difference.beyond);
  if (!difference.ok) {
    const auto [x, y] = std::pair(difference.worst.x, difference.worst.y);
    const glm::vec4 is = picture.at(x, y) * 255.0f, should = reference.at(x, y) * 255.0f;
    std::fprintf(stderr,
                 "frame %d: %zu pixels are wrong, worst at (%d, %d): (%g %g %g), not (%g %g %g)\n",
                 frame, difference.beyond, x, y, is.r, is.g, is.b, should.r, should.g, should.b);
  }
  return (file.empty() || writePng(reference, file)) && difference.ok;
}

int drawFrames(Demo &demo, Surface &surface, const Options &options) {
  const int own = options.verify ? demo.verifyFrames() : demo.pictureFrames();
  const int frames = options.frames ? options.frames : own;
  bool ok = true;
  int maxError = 0;
  std::size_t beyond = 0;
  Image picture;
  for (int frame = 0; frame < frames && ok; ++frame) {
    demo.draw(surface, frame);
    ok = !reportGlErrors(frame);
    if (options.verify || frame + 1 == frames)
      picture = surface.readPixels();
    if (options.verify)
      ok = verifyFrame(demo, picture, frame, options.reference, maxError, beyond) && ok;
    surface.present();
  }
  if (options.verify) {
    const Tolerance tolerance = demo.tolerance();
    std::printf("%s%s%s: %s, %d frame%s of %dx%d, max error %d of 255 (tolerance %d",
                demo.name().c_str(), options.form.empty() ? "" : " ", options.form.c_str(),
                ok ? "ok" : "FAILED", frames, frames == 1 ? "" : "s", surface.width(),
                surface.height(), maxError, tolerance.levels);
    if (tolerance.outliers > 0)
      std::printf(", and %g%% of the pixels beyond it; at most %zu are", 100 * tolerance.outliers,
                  beyond);
    std::printf(")\n");
  }
  if (!options.out.empty() && !writePng(picture, options.out))
    ok = false;
  return ok ? kExitOk : kExitFailed;
}

double frameMilliseconds(Demo &demo, Surface &surface, int frame) {
  const auto begin = Clock::now();
  demo.draw(surface, frame);
  if (surface.window())
    surface.present();
  glFinish();
  const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
  return time.count();
}

/// These frames are drawn before any is measured: programs are translated, textures uploaded.
constexpr int kWarmUp = 5;

/// Prints {"demo", "renderer", "width", "height", "frames", "ms_per_frame"}, the time being the
/// median.
int benchFrames(Demo &demo, Surface &surface, const Options &options) {
  const int frames = options.frames ? options.frames : 100;
  std::vector<double> times;
  for (int frame = 0; frame < frames + kWarmUp; ++frame) {
    const double time = frameMilliseconds(demo, surface, frame);
    if (frame >= kWarmUp)
      times.push_back(time);
  }
  std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
  std::printf("{\"demo\": \"%s\", \"form\": \"%s\", \"renderer\": \"%s\", \"width\": %d, "
              "\"height\": %d, \"frames\": %d, \"ms_per_frame\": %.4f}\n",
              demo.name().c_str(), options.form.c_str(), glString(GL_RENDERER).c_str(),
              surface.width(), surface.height(), frames, times[std::size_t(frames / 2)]);
  return reportGlErrors(frames) ? kExitFailed : kExitOk;
}

/// Prints {"renderer"} when it is ready. For each line of input it prints milliseconds a frame,
/// over as many frames as the line says, or one. In a window each frame is shown, which is measured
/// too.
int paceFrames(Demo &demo, Surface &surface) {
  int frame = 0;
  while (frame < kWarmUp)
    frameMilliseconds(demo, surface, frame++);
  std::printf("{\"renderer\": \"%s\"}\n", glString(GL_RENDERER).c_str());
  std::fflush(stdout);
  for (std::string order; std::getline(std::cin, order);) {
    const int count = std::max(1, std::atoi(order.c_str()));
    double sum = 0;
    for (int i = 0; i < count; ++i)
      sum += frameMilliseconds(demo, surface, frame++);
    std::printf("%.5f\n", sum / count);
    std::fflush(stdout);
  }
  return reportGlErrors(frame) ? kExitFailed : kExitOk;
}

void printInfo(const Demo &demo) {
  std::printf("{\"demo\": \"%s\", \"vendor\": \"%s\", \"renderer\": \"%s\", \"version\": \"%s\", "
              "\"programs\": [",
              demo.name().c_str(), glString(GL_VENDOR).c_str(), glString(GL_RENDERER).c_str(),
              glString(GL_VERSION).c_str());
  const char *comma = "";
  for (const std::string &counts : demo.programCounts()) {
    std::printf("%s%s", comma, counts.c_str());
    comma = ", ";
  }
  std::printf("]}\n");
}

int runOn(Demo &demo, Surface &surface, const Options &options) {
  if (!epoxy_has_gl_extension("GL_ARB_fragment_program")) {
    std::fprintf(stderr, "skipped: the host lacks it: GL_ARB_fragment_program of %s\n",
                 glString(GL_RENDERER).c_str());
    return kExitSkipped;
  }
  glViewport(0, 0, surface.width(), surface.height());
  if (!demo.start(surface, options) || reportGlErrors(-1))
    return kExitFailed;
  if (options.info)
    printInfo(demo);
  if (options.paced)
    return paceFrames(demo, surface);
  if (options.bench)
    return benchFrames(demo, surface, options);
  if (surface.window() && !options.verify && options.out.empty()) {
    runWindow(demo, surface, options.frames);
    return kExitOk;
  }
  if (options.info && !options.verify && options.out.empty())
    return kExitOk;
  return drawFrames(demo, surface, options);
}

} // namespace

int run(Demo &demo, int argc, char **argv) {
  Options options;
  int exitCode = kExitOk;
  if (!parseOptions(demo, argc, argv, options, exitCode))
    return exitCode;
  const std::unique_ptr<Surface> surface =
      options.headless ? makeHeadless(options.width, options.height, options.pbuffer)
                       : makeWindow(options.width, options.height, demo.name());
  if (!surface)
    return kExitFailed;
  exitCode = runOn(demo, *surface, options);
  demo.stop();
  return exitCode;
}

void drawQuad(const std::vector<glm::vec2> &offsets) {
  static constexpr float kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glBegin(GL_QUADS);
  for (const auto &[x, y] : kCorners) {
    for (std::size_t i = 0; i < offsets.size(); ++i)
      glMultiTexCoord2f(GLenum(GL_TEXTURE1 + i), x + offsets[i].x, y + offsets[i].y);
    glTexCoord2f(x, y);
    glVertex2f(2 * x - 1, 2 * y - 1);
  }
  glEnd();
}

} // namespace demos
