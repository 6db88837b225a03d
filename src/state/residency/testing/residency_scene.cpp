#include "state/residency/testing/residency_scene.h"

#include <dlfcn.h>

#include "state/context/context.h"
#include "state/lifecycle/lifecycle.h"
#include "swrast/image/copy_pixels.h"
#include "swrast/image/image.h"

namespace arbiter::state::residency_scene {

namespace {

struct OsMesa {
  decltype(&OSMesaCreateContextExt) create = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaDestroyContext) destroy = nullptr;
  decltype(&OSMesaGetProcAddress) address = nullptr;
};
const OsMesa &osMesa() {
  static const OsMesa s_real = [] {
    OsMesa real;
    if (void *const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL)) {
      const auto get = [&](auto &function, const char *name) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
      };
      get(real.create, "OSMesaCreateContextExt");
      get(real.makeCurrent, "OSMesaMakeCurrent");
      get(real.destroy, "OSMesaDestroyContext");
      get(real.address, "OSMesaGetProcAddress");
    }
    return real;
  }();
  return s_real;
}

const host::HostTable &table() {
  static const host::HostTable s_table = [] {
    host::HostTable made;
    (void)host::loadHostTable(
        made, [](const char *name) { return reinterpret_cast<void *>(osMesa().address(name)); });
    return made;
  }();
  return s_table;
}

} // namespace

void *hostFunction(const char *name) { return reinterpret_cast<void *>(osMesa().address(name)); }

void Residency::SetUp() {
  ASSERT_NE(osMesa().create, nullptr) << "the test is built where OSMesa is";
  m_osmesa = osMesa().create(OSMESA_RGBA, 24, 8, 0, nullptr);
  m_memory.resize(std::size_t(kWidth) * kHeight * 4);
  ASSERT_TRUE(osMesa().makeCurrent(m_osmesa, m_memory.data(), GL_UNSIGNED_BYTE, kWidth, kHeight));
  m_context = createContext(Provider::OsMesa, &table(), nullptr);
  Drawable drawable;
  drawable.kind = Drawable::Kind::Memory;
  drawable.width = kWidth;
  drawable.height = kHeight;
  drawable.memory = m_memory.data();
  drawable.memoryFormat = GL_RGBA;
  drawable.memoryType = GL_UNSIGNED_BYTE;
  makeCurrent(m_context, &drawable);
  if (!m_context->software)
    m_context->software = std::make_unique<ContextState>(*m_context);
  m_context->dirty = dirty::kAll;
  residency().enter(m_context->drawable);
}

RasterContext &Residency::context() { return *m_context; }

void Residency::TearDown() {
  if (!m_context)
    return;
  EXPECT_EQ(gl().GetError(), GLenum(GL_NO_ERROR));
  EXPECT_EQ(m_context->errors.pending, GLenum(GL_NO_ERROR));
  destroyContext(m_context);
  makeCurrent(nullptr);
  osMesa().destroy(m_osmesa);
}

GLuint Residency::texture(GLenum internalFormat, int width, int height, const void *rgba) {
  GLuint name = 0;
  gl().GenTextures(1, &name);
  gl().BindTexture(GL_TEXTURE_2D, name);
  gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl().TexImage2D(GL_TEXTURE_2D, 0, GLint(internalFormat), width, height, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, rgba);
  changed();
  return name;
}

GLuint Residency::framebufferOf(GLuint name) {
  GLuint framebuffer = 0;
  gl().GenFramebuffers(1, &framebuffer);
  gl().BindFramebufferEXT(GL_FRAMEBUFFER, framebuffer);
  gl().FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
  changed();
  return framebuffer;
}

void Residency::inNeighbour(const std::function<void()> &calls) {
  const OSMesaContext neighbour = osMesa().create(OSMESA_RGBA, 24, 8, 0, m_osmesa);
  std::uint32_t pixel = 0;
  ASSERT_TRUE(osMesa().makeCurrent(neighbour, &pixel, GL_UNSIGNED_BYTE, 1, 1));
  calls();
  gl().Finish();
  ASSERT_TRUE(osMesa().makeCurrent(m_osmesa, m_memory.data(), GL_UNSIGNED_BYTE, kWidth, kHeight));
  osMesa().destroy(neighbour);
}

void Residency::bindFramebuffer(GLuint name) {
  gl().BindFramebufferEXT(GL_FRAMEBUFFER, name);
  changed(dirty::kFramebuffer);
}

void Residency::draw(const swrast::Rect &rect, std::uint32_t rgba) {
  const char *reason = nullptr;
  const DrawTargets *const targets = residency().describeTargets(reason);
  ASSERT_NE(targets, nullptr) << reason;
  ASSERT_TRUE(residency().acquireTargets(rect, false, false));
  float color[4];
  for (int i = 0; i < 4; ++i)
    color[i] = float(rgba >> (24 - 8 * i) & 0xFF) / 255.0f;
  ASSERT_NE(targets->color[0], nullptr);
  swrast::fill(*targets->color[0], rect, color);
}

std::uint32_t Residency::hostPixel(int x, int y) {
  residency().synchronise("a test reads");
  EXPECT_FALSE(context().hostIsBehind);
  return directPixel(x, y);
}

std::uint32_t Residency::directPixel(int x, int y) {
  std::uint8_t bytes[4] = {};
  gl().ReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  return packed(bytes);
}

std::uint32_t Residency::shadowPixel(int x, int y) {
  std::uint8_t bytes[4] = {};
  EXPECT_TRUE(residency().readPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes));
  return packed(bytes);
}

std::uint32_t Residency::hostTexel(int x, int y, int width, int height) {
  residency().synchronise("a test reads");
  Bytes all(std::size_t(width) * std::size_t(height) * 4);
  gl().GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
  return packed(&all[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * 4]);
}

GLuint Residency::boundTexture() {
  GLint name = 0;
  gl().GetIntegerv(GL_TEXTURE_BINDING_2D, &name);
  return GLuint(name);
}

bool Residency::copy(int destX, int destY, int x, int y, int width, int height) {
  CopyToTexture command;
  command.texture = boundTexture();
  command.target = GL_TEXTURE_2D;
  command.destX = destX;
  command.destY = destY;
  command.x = x;
  command.y = y;
  command.width = width;
  command.height = height;
  return residency().copyToTexture(command);
}

std::uint32_t Residency::sampled(GLuint name, int x, int y) {
  const char *reason = nullptr;
  const TextureImages *const images =
      residency().acquireTexture(name, abi::Dimension::Tex2D, {}, false, reason);
  if (!images || !images->complete) {
    ADD_FAILURE() << (reason ? reason : "incomplete");
    return 0;
  }
  const abi::TextureLevel &level = images->view.levels[0];
  const std::uint8_t *const texel =
      level.base + y * level.rowStride + x * abi::bytesOf(images->format.layout);
  std::uint32_t result = 0;
  for (const abi::From from : images->format.swizzle)
    result = result << 8 | (from == abi::From::One    ? 255u
                            : from == abi::From::Zero ? 0u
                                                      : texel[int(from)]);
  return result;
}

} // namespace arbiter::state::residency_scene
