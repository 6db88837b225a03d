#include "world.h"

#include <algorithm>
#include <cstdio>

namespace sharing {

bool g_wholeRecords = false;

void record(const std::string &what, const std::vector<unsigned char> &bytes) {
  if (g_wholeRecords)
    return software::record(what, bytes);
  std::uint64_t hash = 1469598103934665603u; // FNV-1a
  for (const unsigned char byte : bytes)
    hash = (hash ^ byte) * 1099511628211u;
  std::printf("%s\t%zu %016llx\n", what.c_str(), bytes.size(),
              static_cast<unsigned long long>(hash));
}

const char *fragmentText(int text) {
  static constexpr const char *kTexts[kFragmentTexts] = {
      "!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND\n",
      "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
      "MOV result.color, t.zxyw;\nEND\n",
      "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
      "SUB result.color, {1, 1, 1, 1}, t;\nEND\n",
      "!!ARBfp1.0\nMOV result.color, program.local[0];\nEND\n",
      "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n",
      "!!ARBfp1.0\nMOV result.color, program.env[1];\nEND\n",
  };
  return kTexts[text];
}

const char *vertexText(int text) {
  static constexpr const char *kTexts[kVertexTexts] = {
      "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, vertex.color;\n"
      "MOV result.texcoord[0], vertex.texcoord[0];\nEND\n",
      "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, program.local[0];\n"
      "MOV result.texcoord[0], vertex.texcoord[0];\nEND\n",
      "!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, vertex.color.zxyw;\n"
      "MOV result.texcoord[0], vertex.texcoord[0];\nEND\n",
  };
  return kTexts[text];
}

void World::open(Random &random) {
  m_count = random.once(2) ? 2 : random.between(2, kContexts);
  const int groups = m_count > 2 && random.once(3) ? 2 : 1;
  for (int i = 0; i < m_count; ++i) {
    Context &context = m_contexts[std::size_t(i)];
    context.group = i % groups;
    context.loads = i >= groups && random.once(2);
    context.drawable = i;
    context.handle =
        m_platform.makeContext(i < groups ? nullptr : m_contexts[std::size_t(i - groups)].handle);
    m_drawables[std::size_t(i)] = {m_platform.makeDrawable({64, 32}), {64, 32}};
  }
  m_current = 0;
  m_contexts[0].thread = 0;
  here([this] { makeCurrentHere(0); });
}

void World::close() {
  for (int i = 0; i < m_count; ++i) {
    Context &context = m_contexts[std::size_t(i)];
    if (context.thread >= 0)
      m_workers.run(context.thread, [&] { m_platform.makeCurrent(nullptr, nullptr); });
    m_platform.destroyContext(context.handle);
  }
  for (int i = 0; i < m_count; ++i)
    m_platform.destroyDrawable(m_drawables[std::size_t(i)].handle);
}

void World::makeCurrentHere(int context) {
  Context &now = m_contexts[std::size_t(context)];
  Drawable &target = m_drawables[std::size_t(now.drawable)];
  m_platform.makeCurrent(target.handle, now.handle);
  makeObjects();
  if (!now.made)
    makeContextObjects();
  if (target.undefined || now.bound < 0)
    bindFramebuffer(now.bound);
  if (target.undefined) {
    const int before = now.bound;
    bindFramebuffer(-1);
    clearAll();
    bindFramebuffer(before);
    target.undefined = false;
  }
}

void World::makeObjects() {
  Group &now = group();
  if (now.made)
    return;
  now.made = true;
  Random random(77);
  for (Texture &texture : now.textures) {
    glGenTextures(1, &texture.name);
    define(texture, 32, 32, GL_RGBA8, random);
  }
  for (int i = 0; i < kBuffers; ++i) {
    glGenBuffers(1, &now.buffers[std::size_t(i)].name);
    defineBuffer(i, 2, random);
  }
  int text = 0;
  for (Program &program : now.fragments)
    load(program, GL_FRAGMENT_PROGRAM_ARB, text++, random);
  text = 0;
  for (Program &program : now.vertices)
    load(program, GL_VERTEX_PROGRAM_ARB, text++, random);
}

void World::makeContextObjects() {
  Context &now = context();
  now.made = true;
  glDisable(GL_DITHER);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGenFramebuffers(1, &now.scratch);
  for (int i = 0; i < kRenderbuffers; ++i)
    for (const bool depth : {false, true}) {
      Renderbuffer &renderbuffer = (depth ? group().depths : group().colors)[std::size_t(i)];
      if (renderbuffer.name != 0)
        continue;
      glGenRenderbuffers(1, &renderbuffer.name);
      defineRenderbuffer(renderbuffer, depth ? GL_DEPTH24_STENCIL8 : GL_RGBA8, 64, 32);
    }
  for (int i = 0; i < kFramebuffers; ++i) {
    Framebuffer &framebuffer = now.framebuffers[std::size_t(i)];
    glGenFramebuffers(1, &framebuffer.name);
    attach(framebuffer, false, i == 1, i);
    if (i == 0)
      attach(framebuffer, true, false, i);
  }
  bindFramebuffer(-1);
}

Object *World::objectOf(const Attachment &attachment, bool depth) {
  const auto at = std::size_t(attachment.index);
  if (attachment.isTexture)
    return &group().textures[at];
  return depth ? &group().depths[at] : &group().colors[at];
}

Size World::sizeOf(const Attachment &attachment, bool depth) {
  if (attachment.orphan)
    return {attachment.width, attachment.height};
  const auto at = std::size_t(attachment.index);
  if (attachment.isTexture)
    return {group().textures[at].width, group().textures[at].height};
  const Renderbuffer &renderbuffer = (depth ? group().depths : group().colors)[at];
  return {renderbuffer.width, renderbuffer.height};
}

void World::attach(Framebuffer &framebuffer, bool depth, bool isTexture, int index) {
  Attachment &attachment = depth ? framebuffer.depth : framebuffer.color;
  attachment = {isTexture, index};
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name);
  // A depth buffer replaces the depth attachment only; the stencil attachment must then be empty.
  if (index < 0 || depth)
    glFramebufferRenderbuffer(GL_FRAMEBUFFER,
                              depth ? GL_DEPTH_STENCIL_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                              GL_RENDERBUFFER, 0);
  if (index >= 0) {
    const Object &object = *objectOf(attachment, depth);
    if (isTexture)
      glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, object.name, 0);
    else
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, static_cast<const Renderbuffer &>(object).point(),
                                GL_RENDERBUFFER, object.name);
    attachment.version = object.version;
    attachment.width = sizeOf(attachment, depth).width;
    attachment.height = sizeOf(attachment, depth).height;
  }
  const int bound = context().bound;
  glBindFramebuffer(GL_FRAMEBUFFER,
                    bound < 0 ? 0 : context().framebuffers[std::size_t(bound)].name);
}

void World::bindFramebuffer(int which) {
  context().bound = which;
  glBindFramebuffer(GL_FRAMEBUFFER,
                    which < 0 ? 0 : context().framebuffers[std::size_t(which)].name);
  int width = 0, height = 0;
  if (ready(width, height))
    glViewport(0, 0, width, height);
}

bool World::ready(int &width, int &height) {
  if (context().bound < 0) {
    width = drawable().size.width;
    height = drawable().size.height;
    return true;
  }
  Framebuffer &framebuffer = context().framebuffers[std::size_t(context().bound)];
  width = height = 1 << 20;
  bool changed = false;
  for (const bool depth : {false, true}) {
    const Attachment &attachment = depth ? framebuffer.depth : framebuffer.color;
    if (attachment.index < 0)
      continue;
    if (!attachment.orphan && attachment.version != objectOf(attachment, depth)->version) {
      attach(framebuffer, depth, attachment.isTexture, attachment.index);
      changed = true;
    }
    const Size size = sizeOf(attachment, depth);
    width = std::min(width, size.width);
    height = std::min(height, size.height);
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return false;
  if (changed)
    glViewport(0, 0, width, height);
  return true;
}

bool World::isAttached(int texture) {
  if (context().bound < 0)
    return false;
  const Attachment &color = context().framebuffers[std::size_t(context().bound)].color;
  return color.isTexture && color.index == texture && !color.orphan;
}

void World::orphan(bool isTexture, const Object *object) {
  for (int i = 0; i < m_count; ++i) {
    Context &other = m_contexts[std::size_t(i)];
    if (other.group != context().group)
      continue;
    if (const Texture &kept = texture(kKept); object == &kept) {
      if (&other == &context()) // its own deletions unbind
        other.kept = {};
      else if (other.kept.bound && !other.kept.orphan)
        other.kept = {true, true, kept.width, kept.height};
    }
    for (int f = 0; f < kFramebuffers; ++f)
      for (const bool depth : {false, true}) {
        Framebuffer &framebuffer = other.framebuffers[std::size_t(f)];
        Attachment &attachment = depth ? framebuffer.depth : framebuffer.color;
        if (attachment.index < 0 || attachment.orphan || attachment.isTexture != isTexture ||
            objectOf(attachment, depth) != object)
          continue;
        // Deleting it detaches it from the bound framebuffer (4.4.2).
        if (&other == &context() && other.bound == f)
          attachment = {};
        else
          attachment.orphan = true;
      }
  }
}

void World::clearAll() {
  glPushAttrib(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_SCISSOR_BIT);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glPopAttrib();
}

void World::recordAll(const std::string &what) {
  for (int i = -1; i < kFramebuffers; ++i) {
    int width = 0, height = 0;
    bindFramebuffer(i);
    if (ready(width, height))
      record(what + " framebuffer " + std::to_string(i), software::readRgba(0, 0, width, height));
  }
  for (int i = 0; i < kTextures; ++i) {
    const Texture &image = texture(i);
    std::vector<unsigned char> bytes(std::size_t(image.width * image.height) * 4);
    bindTexture(image.name);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    record(what + " texture " + std::to_string(i), bytes);
  }
}

} // namespace sharing
