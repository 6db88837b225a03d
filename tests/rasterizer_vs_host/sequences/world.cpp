#include "world.h"

#include <algorithm>

namespace software {

namespace {

/// The programs are exact in any arithmetic: they store a texel's value, its complement, or a
/// parameter's.
const std::array<const char *, kPrograms> kTexts = {
    "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND\n",
    "!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n",
    "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
    "MOV result.color, t.zxyw;\nEND\n",
    "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
    "SUB result.color, {1, 1, 1, 1}, t;\nEND\n",
    "!!ARBfp1.0\nTEMP a, b;\nTEX a, fragment.texcoord[0], texture[0], 2D;\n"
    "TEX b, fragment.texcoord[1], texture[1], 2D;\nMAX result.color, a, b;\nEND\n",
    "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n",
    "!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], RECT;\nEND\n",
    "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\nSUB t.x, t.x, 0.5;\n"
    "KIL t.x;\nMOV result.color, fragment.color;\nEND\n",
    // This has a pattern of the window's rows and columns, which tells upside down from upright.
    "!!ARBfp1.0\nTEMP t;\nMUL t, fragment.position, {0.5, 0.25, 0, 0};\nFRC t, t;\n"
    "SLT t.xy, t, {0.5, 0.5, 0.5, 0.5};\nMUL result.color, fragment.color, t.xyxy;\nEND\n",
};

} // namespace

bool World::open() {
  if (!m_screen.open())
    return false;
  m_drawables = {m_screen.makeWindow(kWindow, kWindow),
                 m_screen.makePbuffer(kPbufferWidth, kPbufferHeight)};
  m_contexts[0].handle = m_screen.makeContext();
  m_contexts[1].handle = m_screen.makeContext(m_contexts[0].handle);
  m_contexts[2].handle = m_screen.makeContext();
  m_contexts[2].group = 1;
  switchTo(0, 1);
  clearAll();
  switchTo(0, 0);
  clearAll();
  return true;
}

GLenum World::targetOf(int texture) {
  return texture == kRectangle ? GL_TEXTURE_RECTANGLE_ARB : GL_TEXTURE_2D;
}

void World::switchTo(int context, int drawable) {
  m_current = context;
  m_drawable = drawable;
  m_screen.makeCurrent(m_drawables[std::size_t(drawable)], this->context().handle);
  makeGroupObjects();
  makeContextObjects();
  fit();
}

void World::makeGroupObjects() {
  if (group().made)
    return;
  group().made = true;
  for (int i = 0; i < kPrograms; ++i)
    group().programs[std::size_t(i)] = makeProgram(GL_FRAGMENT_PROGRAM_ARB, kTexts[std::size_t(i)]);
  Random random(77);
  for (int i = 0; i < kTextures; ++i) {
    texture(i).name = newTexture();
    define(i, 0, i == 2 ? 7 : 32, i == 3 ? 16 : 32, GL_RGBA8, random);
  }
}

void World::makeContextObjects() {
  Context &now = context();
  if (now.made)
    return;
  now.made = true;
  glDisable(GL_DITHER);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glGenBuffers(1, &now.vertexBuffer);
  glGenBuffers(1, &now.indexBuffer);
  glGenQueries(1, &now.query);
  now.firstList = glGenLists(kLists);
  for (Framebuffer &framebuffer : now.framebuffers) {
    framebuffer.name = makeFramebuffer();
    framebuffer.color = attachBuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, kWindow, kWindow);
    framebuffer.depthStencil =
        attachBuffer(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, kWindow, kWindow);
    clearAll();
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void World::bindFramebuffer(int which) {
  context().bound = which;
  glBindFramebuffer(GL_FRAMEBUFFER,
                    which < 0 ? 0 : context().framebuffers[std::size_t(which)].name);
  fit();
}

bool World::size(int &width, int &height) {
  width = m_drawable == 0 ? kWindow : kPbufferWidth;
  height = m_drawable == 0 ? kWindow : kPbufferHeight;
  if (context().bound < 0)
    return true;
  const Framebuffer &framebuffer = context().framebuffers[std::size_t(context().bound)];
  width = height = kWindow;
  if (framebuffer.texture >= 0) {
    const Texture &attached = texture(framebuffer.texture);
    width = std::min(kWindow, attached.width[std::size_t(framebuffer.level)]);
    height = std::min(kWindow, attached.height[std::size_t(framebuffer.level)]);
  }
  return !framebuffer.orphan && width > 0 && height > 0 &&
         glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void World::fit() {
  int width = 0, height = 0;
  if (!size(width, height))
    return;
  glViewport(0, 0, width, height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glOrtho(0, width, 0, height, -1, 1);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

bool World::attached(int texture) {
  return context().bound >= 0 &&
         context().framebuffers[std::size_t(context().bound)].texture == texture;
}

void World::define(int texture, int level, int width, int height, GLenum internal, Random &random) {
  Texture &image = this->texture(texture);
  const GLenum target = targetOf(texture);
  const GLenum filter =
      random.once(3) && texture != kRectangle ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST;
  std::vector<unsigned char> texels(std::size_t(width) * std::size_t(height) * 4);
  for (unsigned char &texel : texels)
    texel = static_cast<unsigned char>(random.bits());
  glBindTexture(target, image.name);
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GLint(filter));
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  if (texture != kRectangle) {
    glTexParameteri(target, GL_TEXTURE_WRAP_S, random.once(2) ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, random.once(2) ? GL_MIRRORED_REPEAT : GL_REPEAT);
  }
  glTexImage2D(target, level, GLint(internal), width, height, 0, random.once(2) ? GL_RGBA : GL_BGRA,
               GL_UNSIGNED_BYTE, texels.data());
  image.width[std::size_t(level)] = width;
  image.height[std::size_t(level)] = height;
  image.internal = internal;
}

bool World::defineLevel1(int texture, Random &random) {
  const Texture &image = this->texture(texture);
  const bool sized = image.internal != GL_RGBA;
  if (!sized || (image.width[0] == 1 && image.height[0] == 1))
    return false;
  define(texture, 1, std::max(1, image.width[0] / 2), std::max(1, image.height[0] / 2),
         image.internal, random);
  return true;
}

void World::redefine(int texture, Random &random) {
  static constexpr int kSizes[] = {1, 7, 16, 32, 33, 64};
  static constexpr GLenum kInternal[] = {GL_RGBA8,      GL_RGBA8,  GL_RGBA8,     GL_RGB8,
                                         GL_LUMINANCE8, GL_ALPHA8, GL_INTENSITY8};
  const int width = random.pick(kSizes), height = random.pick(kSizes);
  define(texture, 0, width, height, random.pick(kInternal), random);
  dropLevel1(texture);
}

void World::dropLevel1(int texture) {
  Texture &image = this->texture(texture);
  if (image.width[1] == 0)
    return;
  glTexImage2D(targetOf(texture), 1, GL_RGBA8, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  image.width[1] = image.height[1] = 0;
}

void World::attach(int framebuffer, int texture, int level) {
  Framebuffer &target = context().framebuffers[std::size_t(framebuffer)];
  const int before = context().bound;
  glBindFramebuffer(GL_FRAMEBUFFER, target.name);
  target.texture = texture;
  target.level = level;
  target.orphan = false;
  if (texture < 0)
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.color);
  else
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           this->texture(texture).name, level);
  bindFramebuffer(before);
}

void World::orphan(int texture) {
  for (Context &other : m_contexts) {
    for (Framebuffer &framebuffer : other.framebuffers)
      framebuffer.orphan |= other.group == context().group && framebuffer.texture == texture;
  }
}

GLuint World::newTexture() {
  GLuint name = 0;
  do
    glGenTextures(1, &name);
  while (name <= group().lastName);
  return group().lastName = name;
}

void World::deleteTexture(int texture, Random &random) {
  Texture &image = this->texture(texture);
  orphan(texture);
  // A list would bind the name, and the host decides whether names are reused.
  if (texture == kRectangle)
    for (Context &other : m_contexts)
      other.lists = {};
  glDeleteTextures(1, &image.name);
  image.name = newTexture();
  image.width = image.height = {};
  redefine(texture, random);
}

void World::clearAll() {
  glPushAttrib(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_SCISSOR_BIT);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glStencilMask(~0u);
  glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glPopAttrib();
}

void World::swap(const std::string &what) {
  const int before = context().bound;
  if (m_drawable != 0)
    return;
  m_screen.swap(m_drawables[0]);
  record(what + " shown", m_screen.grab(kWindow, kWindow));
  bindFramebuffer(-1);
  clearAll(); // the back buffer's content is undefined now
  bindFramebuffer(before);
}

void World::recordAll() {
  for (int context = 0; context < 3; ++context) {
    const std::string where = "end context " + std::to_string(context);
    switchTo(context, context == 1 ? 1 : 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int i = -1; i < 2; ++i) {
      int width = 0, height = 0;
      bindFramebuffer(i);
      if (size(width, height))
        record(where + " framebuffer " + std::to_string(i), readRgba(0, 0, width, height));
    }
    for (int i = 0; i < kTextures; ++i) {
      const Texture &image = texture(i);
      for (std::size_t level = 0; level < 2; ++level) {
        if (image.width[level] == 0)
          continue;
        std::vector<unsigned char> bytes(std::size_t(image.width[level] * image.height[level]) * 4);
        glBindTexture(targetOf(i), image.name);
        glGetTexImage(targetOf(i), GLint(level), GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        record(where + " texture " + std::to_string(i) + " level " + std::to_string(level), bytes);
      }
    }
  }
}

} // namespace software
