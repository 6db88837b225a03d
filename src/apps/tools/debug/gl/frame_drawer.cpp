#include "apps/tools/debug/gl/frame_drawer.h"

#include "apps/tools/draw/gl_queries.h"

namespace arbiter::tools::debug {

namespace {

/// The limit of cached programs. Most pixels use the same programs, because their coordinates are
/// parameters.
constexpr std::size_t kMaxPrograms = 128;

/// Restores all state that a draw changes, including the framebuffer, which is in no attribute
/// group.
class Restored {
public:
  Restored() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_read);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
  }
  Restored(const Restored &) = delete;
  Restored &operator=(const Restored &) = delete;
  ~Restored() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(m_draw));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(m_read));
    glPopAttrib();
  }

private:
  GLint m_draw = 0, m_read = 0;
};

/// The target of ATI_text_fragment_shader, which Debian's headers lack.
constexpr GLenum kTextFragmentShaderAti = 0x8200;

/// Returns the target of a texture's images.
GLenum imageTarget(fp::ir::TexTarget target) {
  const GLenum bound = glTarget(target);
  return bound == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : bound;
}

/// Copies depth and stencil from the read framebuffer to the draw framebuffer.
void copyDepths(const Region &region) {
  const GLint x = region.x, y = region.y, right = x + region.width, top = y + region.height;
  glBlitFramebuffer(x, y, right, top, x, y, right, top, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                    GL_NEAREST);
}

DebugError glError(GLenum code) { return {"GL error " + std::to_string(code)}; }

} // namespace

Result<std::unique_ptr<Drawer>, DebugError> FrameDrawer::open(std::unique_ptr<Subject> subject) {
  std::unique_ptr<FrameDrawer> drawer(new FrameDrawer(std::move(subject)));
  if (auto error = drawer->m_subject->prepare())
    return *error;
  drawer->keepProgram();
  drawer->keepPicture();
  if (const GLenum code = glGetError(); code != GL_NO_ERROR)
    return glError(code);
  return std::unique_ptr<Drawer>(std::move(drawer));
}

std::string FrameDrawer::name() const {
  return reinterpret_cast<const char *>(glGetString(GL_RENDERER));
}

/// Records the bound program object, and its local parameters for programs that show values. Those
/// programs are separate objects, because hosts crash when the text of a used object is changed. An
/// ATI shader has neither a program object nor parameters.
void FrameDrawer::keepProgram() {
  GLint bound = 0, count = 0;
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_BINDING_ARB, &bound);
  if (bound == 0 || !glIsEnabled(GL_FRAGMENT_PROGRAM_ARB))
    return;
  m_document = GLuint(bound);
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB, &count);
  for (GLuint i = 0; i < GLuint(count); ++i) {
    Vec4 value = {};
    glGetProgramLocalParameterfvARB(GL_FRAGMENT_PROGRAM_ARB, i, value.data());
    if (value != Vec4{})
      m_locals.emplace_back(i, value);
  }
}

/// Saves the depths before the draw if the draw keeps them, because drawing the picture changes
/// them.
void FrameDrawer::keepDepths() {
  const auto [width, height] = size();
  const Restored restored;
  GLint source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  if (!m_before.bind(width, height, 1).empty())
    return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(source));
  copyDepths({0, 0, width, height});
}

void FrameDrawer::keepPicture() {
  const auto [width, height] = size();
  m_keepsTarget = !m_subject->clear();
  if (m_keepsTarget)
    keepDepths();
  m_subject->drawMesh();
  m_picture.resize(std::size_t(width) * std::size_t(height));
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, m_picture.data());
}

/// Binds a program with \p text, or the document's if it is empty.
/// \returns an empty string, or GL's complaint
std::string FrameDrawer::load(const std::string &text) {
  if (text.empty())
    return {};
  if (m_document == 0) {
    glDisable(kTextFragmentShaderAti);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
  }
  if (const auto known = m_programs.find(text); known != m_programs.end()) {
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, known->second);
    return {};
  }
  if (m_programs.size() >= kMaxPrograms)
    forgetPrograms();
  GLuint program = 0;
  glGenProgramsARB(1, &program);
  m_programs[text] = program;
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  for (const auto &[index, value] : m_locals)
    glProgramLocalParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, index, value.data());
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                     text.data());
  if (glGetError() == GL_NO_ERROR)
    return {};
  const auto *const words =
      reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
  const std::string fault = words ? words : "no reason";
  m_programs.erase(text);
  glDeleteProgramsARB(1, &program);
  return "a program that shows values was refused: " + fault;
}

void FrameDrawer::forgetPrograms() {
  for (const auto &[text, program] : m_programs)
    glDeleteProgramsARB(1, &program);
  m_programs.clear();
}

/// Binds the document's program again, because no attribute group reliably restores it.
void FrameDrawer::unload() {
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_document);
  if (m_document != 0)
    return;
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  glEnable(kTextFragmentShaderAti);
}

Result<std::vector<Drawer::Vec4>, DebugError> FrameDrawer::draw(const std::string &text,
                                                                std::size_t targets,
                                                                const Region &region,
                                                                const std::vector<Vec4> &locals) {
  const Restored restored;
  m_subject->setPlainState();
  if (std::string fault = load(text); !fault.empty()) {
    unload();
    return DebugError{std::move(fault)};
  }
  // The framebuffer may be smaller than the viewport; pixels beyond it are not drawn.
  for (std::size_t i = 0; i < locals.size(); ++i)
    glProgramLocalParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, GLuint(i), locals[i].data());
  const std::string fault =
      m_target.bind(region.x + region.width, region.y + region.height, targets);
  if (!fault.empty())
    return DebugError{fault};
  if (m_keepsTarget) {
    m_before.bindToRead();
    copyDepths(region);
  } else {
    m_subject->clear();
  }
  m_target.clear();
  // The scissor test starts after the clears: hosts clear a part of a framebuffer by drawing a
  // quad, for which they compile another program.
  glEnable(GL_SCISSOR_TEST);
  glScissor(region.x, region.y, region.width, region.height);
  m_subject->drawMesh();
  auto values = m_target.read(region);
  unload();
  if (const GLenum code = glGetError(); code != GL_NO_ERROR)
    return glError(code);
  return values;
}

Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
FrameDrawer::picture(const Region &region) {
  std::vector<std::array<std::uint8_t, 4>> pixels;
  const auto width = std::size_t(size()[0]);
  for (int y = region.y; y < region.y + region.height; ++y) {
    const auto row = m_picture.begin() + std::ptrdiff_t(std::size_t(y) * width) + region.x;
    pixels.insert(pixels.end(), row, row + region.width);
  }
  return pixels;
}

Result<std::array<int, 3>, DebugError> FrameDrawer::textureSize(unsigned unit,
                                                                fp::ir::TexTarget target) {
  constexpr GLenum kSides[] = {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH};
  std::array<int, 3> size = {};
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glActiveTexture(GL_TEXTURE0 + unit);
  for (std::size_t i = 0; i < 3; ++i)
    glGetTexLevelParameteriv(imageTarget(target), 0, kSides[i], &size[i]);
  glActiveTexture(GLenum(active));
  if (const GLenum code = glGetError(); code != GL_NO_ERROR)
    return glError(code);
  return size;
}

} // namespace arbiter::tools::debug
