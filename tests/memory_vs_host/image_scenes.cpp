// Scenes of copies, textures, shown frames and contexts.
#include "allocation_scenes.h"

namespace memory {

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

/// Makes everything that a context makes when it first draws, shows and samples.
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

} // namespace memory
