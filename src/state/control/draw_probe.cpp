#include "state/control/draw_probe.h"

#include <algorithm>
#include <utility>

#include "state/control/host_pixels.h"
#include "state/core/context.h"
#include "state/core/host_errors.h"
#include "state/host_draw/draw.h"
#include "state/host_draw/variants/drop_variants.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_edits.h"
#include "state/programs/program_load.h"
#include "state/programs/replacement.h"

namespace arbiter::state::remote {

namespace {

/// Names that no application makes, as those of the figures in the frame (state/hud).
constexpr GLuint kFramebuffer = 0xFFFFFFF9u, kFirstTexture = 0xFFFFFFF0u;
constexpr std::size_t kDepth = DrawProbe::kMostTargets; ///< of the textures

GLint get(const host::HostTable &host, GLenum name) {
  GLint value = 0;
  host.GetIntegerv(name, &value);
  return value;
}

/// A program stands in for the fragment program that draws use, while it lives.
class ProgramSwap {
public:
  ProgramSwap(Context &context, const DrawProbe::Wish &wish)
      : m_context(context), m_compiled(wish.program) {
    ProgramTarget &row = context.row(Target::Fragment);
    auto object = std::make_shared<ProgramObject>(0, Target::Fragment);
    object->compiled = m_compiled;
    object->locals = row.bound->locals;
    for (std::uint32_t i = 0; anyHeld() && i < object->locals.size(); ++i)
      if (const auto held = findHeld(context, row, false, i))
        object->locals[i].store(*held);
    m_valid = wish.locals.size() <= object->locals.size();
    for (std::size_t i = 0; m_valid && i < wish.locals.size(); ++i)
      object->locals[i].store(wish.locals[i]);
    m_bound = std::exchange(row.bound, std::move(object));
    for (std::size_t i = 0; i < m_enabled.size(); ++i)
      m_enabled[i] = std::exchange(context.row(kFragments[i]).enabled, i == 0);
    invalidateProgram(context);
    m_valid = m_valid && validate(context) && context.linkedProgram;
  }
  ~ProgramSwap() {
    m_context.row(Target::Fragment).bound = std::move(m_bound);
    for (std::size_t i = 0; i < m_enabled.size(); ++i)
      m_context.row(kFragments[i]).enabled = m_enabled[i];
    invalidateProgram(m_context);
    (void)validate(m_context);
    dropVariants(m_context, *m_compiled);
  }
  ProgramSwap(const ProgramSwap &) = delete;
  ProgramSwap &operator=(const ProgramSwap &) = delete;
  [[nodiscard]] bool isValid() const { return m_valid; }

private:
  static constexpr std::array kFragments = {Target::Fragment, Target::AtiText, Target::AtiApi};
  Context &m_context;
  const std::shared_ptr<const CompiledProgram> m_compiled;
  std::shared_ptr<ProgramObject> m_bound;
  std::array<bool, 3> m_enabled{};
  bool m_valid = false;
};

/// All that a repeated draw changes, but for the program.
class StateScope {
public:
  explicit StateScope(const host::HostTable &host)
      : m_host(host), m_read(get(host, GL_READ_FRAMEBUFFER_BINDING)),
        m_draw(get(host, GL_DRAW_FRAMEBUFFER_BINDING)) {
    host.PushAttrib(GL_ALL_ATTRIB_BITS);
  }
  ~StateScope() {
    m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, GLuint(m_draw));
    m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, GLuint(m_read));
    m_host.PopAttrib();
  }
  StateScope(const StateScope &) = delete;
  StateScope &operator=(const StateScope &) = delete;

private:
  const host::HostTable &m_host;
  GLint m_read, m_draw;
};

/// What is written is the program's colour alone.
void setPlainState(const Context &context, const host::HostTable &host, bool alphaTest) {
  for (const GLenum capability : {GL_BLEND, GL_COLOR_LOGIC_OP, GL_DITHER})
    host.Disable(capability);
  if (!alphaTest)
    host.Disable(GL_ALPHA_TEST);
  if (context.caps.srgbFramebuffer)
    host.Disable(GL_FRAMEBUFFER_SRGB);
  host.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/// What a window's depths may be; one of them is copied from.
constexpr GLenum kDepthFormats[] = {GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32,
                                    GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT32F};

bool hasStencil(GLenum format) { return format == GL_DEPTH24_STENCIL8; }

} // namespace

const char *whyNoProbe(const Context &context) {
  if (!context.caps.framebufferObjects || !context.caps.drawBuffers)
    return "the host has no framebuffer objects of floats";
  return nullptr;
}

DrawProbe::~DrawProbe() {
  if (!m_made)
    return;
  HostErrorScope errors(m_host, m_context.pendingError);
  m_host.DeleteFramebuffers(1, &kFramebuffer);
  for (std::size_t i = 0; i <= kDepth; ++i) {
    const GLuint name = kFirstTexture + GLuint(i);
    m_host.DeleteTextures(1, &name);
  }
}

/// An image of no content under a name of the layer's; what is bound stays.
void DrawProbe::image(std::size_t index, int width, int height, GLenum format) {
  const GLint before = get(m_host, GL_TEXTURE_BINDING_2D);
  m_host.BindTexture(GL_TEXTURE_2D, kFirstTexture + GLuint(index));
  const GLenum components = index < kDepth       ? GL_RGBA
                            : hasStencil(format) ? GL_DEPTH_STENCIL
                                                 : GL_DEPTH_COMPONENT;
  const GLenum type = index < kDepth       ? GL_FLOAT
                      : hasStencil(format) ? GL_UNSIGNED_INT_24_8
                                           : GL_UNSIGNED_INT;
  m_host.TexImage2D(GL_TEXTURE_2D, 0, GLint(format), width, height, 0, components, type, nullptr);
  m_host.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  m_host.BindTexture(GL_TEXTURE_2D, GLuint(before));
}

/// The framebuffer is bound for drawing. \param depthFormat 0: without depths
bool DrawProbe::attach(const Wish &wish, GLenum depthFormat) {
  m_made = true;
  const int width = wish.region.x + wish.region.width, height = wish.region.y + wish.region.height;
  const PlainTransfer plain(m_context, PlainTransfer::Way::Unpack);
  for (std::size_t i = 0; i < wish.targets; ++i)
    image(i, width, height, GL_RGBA32F);
  if (depthFormat != 0)
    image(kDepth, width, height, depthFormat);
  m_host.BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, kFramebuffer);
  std::array<GLenum, kMostTargets> buffers{};
  for (std::size_t i = 0; i < kMostTargets; ++i) {
    const bool used = i < wish.targets;
    buffers[i] = used ? GLenum(GL_COLOR_ATTACHMENT0 + i) : GLenum(GL_NONE);
    m_host.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GLenum(GL_COLOR_ATTACHMENT0 + i),
                                GL_TEXTURE_2D, used ? kFirstTexture + GLuint(i) : 0, 0);
  }
  const GLuint depth = depthFormat != 0 ? kFirstTexture + GLuint(kDepth) : 0;
  m_host.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  m_host.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_TEXTURE_2D,
                              hasStencil(depthFormat) ? depth : 0, 0);
  m_host.DrawBuffers(GLsizei(wish.targets), buffers.data());
  return m_host.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

/// The framebuffer with what the draw finds in the window's.
std::string DrawProbe::copyDepths(const Wish &wish) {
  const Region &r = wish.region;
  for (const GLenum format : kDepthFormats) {
    HostErrorScope errors(m_host, m_context.pendingError);
    if (!attach(wish, format))
      continue;
    m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, 0);
    m_host.BlitFramebuffer(
        r.x, r.y, r.x + r.width, r.y + r.height, r.x, r.y, r.x + r.width, r.y + r.height,
        hasStencil(format) ? GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT : GL_DEPTH_BUFFER_BIT,
        GL_NEAREST);
    if (!errors.failed())
      return {};
  }
  return "the window's depths cannot be copied (is it multisampled?)";
}

/// Of the region what the application lets be drawn. False: nothing.
bool DrawProbe::scissor(const Region &region) {
  GLint box[4] = {region.x, region.y, region.x + region.width, region.y + region.height};
  if (m_host.IsEnabled(GL_SCISSOR_TEST)) {
    GLint theirs[4] = {};
    m_host.GetIntegerv(GL_SCISSOR_BOX, theirs);
    for (std::size_t i = 0; i < 2; ++i) {
      box[i] = std::max(box[i], theirs[i]);
      box[i + 2] = std::min(box[i + 2], theirs[i] + theirs[i + 2]);
    }
  }
  m_host.Enable(GL_SCISSOR_TEST);
  m_host.Scissor(box[0], box[1], std::max(box[2] - box[0], 0), std::max(box[3] - box[1], 0));
  return box[2] > box[0] && box[3] > box[1];
}

Result<std::vector<Vec4>, std::string> DrawProbe::draw(const Redraw &redraw, const Wish &wish) {
  HostErrorScope errors(m_host, m_context.pendingError);
  const StateScope state(m_host);
  const Region &r = wish.region;
  std::vector<Vec4> values(wish.targets * std::size_t(r.width) * std::size_t(r.height), wish.clear);
  const bool tests = m_host.IsEnabled(GL_DEPTH_TEST) != 0 || m_host.IsEnabled(GL_STENCIL_TEST) != 0;
  GLint box[4] = {};
  m_host.GetIntegerv(GL_SCISSOR_BOX, box);
  const GLboolean scissored = m_host.IsEnabled(GL_SCISSOR_TEST);
  m_host.Disable(GL_SCISSOR_TEST);
  if (tests) {
    if (std::string why = copyDepths(wish); !why.empty())
      return why;
  } else if (!attach(wish, 0)) {
    return std::string("the host draws to no framebuffer of floats");
  }
  setPlainState(m_context, m_host, wish.alphaTest);
  m_host.ClearColor(wish.clear[0], wish.clear[1], wish.clear[2], wish.clear[3]);
  m_host.Clear(GL_COLOR_BUFFER_BIT);
  if (scissored)
    m_host.Enable(GL_SCISSOR_TEST);
  if (!scissor(r))
    return values;
  if (wish.program) {
    const ProgramSwap swap(m_context, wish);
    if (!swap.isValid())
      return std::string("the host refuses a program that shows values");
    redraw(m_host);
  } else {
    redraw(m_host);
  }
  m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, kFramebuffer);
  const PlainTransfer plain(m_context, PlainTransfer::Way::Pack);
  const std::size_t pixels = std::size_t(r.width) * std::size_t(r.height);
  for (std::size_t i = 0; i < wish.targets; ++i) {
    m_host.ReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + i));
    m_host.ReadPixels(r.x, r.y, r.width, r.height, GL_RGBA, GL_FLOAT, values[i * pixels].data());
  }
  if (errors.failed())
    return std::string("the host raised an error while a draw was repeated");
  return values;
}

Result<std::shared_ptr<const CompiledProgram>, std::string> compileProbe(const Context &context,
                                                                         const std::string &text) {
  fp::CompileOptions options = compileOptions(context.row(Target::Fragment));
  options.policy = fp::LimitPolicy::Report;
  const Replacement probe = {text,
                             fp::checkProgram(infoOf(Target::Fragment).language, text, options)};
  if (!probe.result.ok())
    return fp::renderAll("text", text, probe.result.diagnostics);
  return compileProgram(context, Target::Fragment, text, {}, &probe);
}

} // namespace arbiter::state::remote
