#include "state/control/draw_probe.h"

#include <utility>

#include "state/control/host_pixels.h"
#include "state/core/host_errors.h"
#include "state/host_draw/draw.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_edits.h"
#include "state/programs/program_load.h"
#include "state/programs/replacement.h"
#include "state/programs/variants/drop_variants.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

namespace {

/// Replaces the fragment program that draws use, while it lives.
class ProgramSwap {
public:
  ProgramSwap(RasterContext &context, const DrawProbe::Wish &wish)
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
    m_valid = m_valid && validate(context) && context.effective.linkedProgram;
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
  static constexpr std::array kFragments = {Target::Fragment, Target::AtiText, Target::AtiApi,
                                            Target::Combiners, Target::TextureShaders};
  RasterContext &m_context;
  const std::shared_ptr<const CompiledProgram> m_compiled;
  std::shared_ptr<ProgramObject> m_bound;
  std::array<bool, kFragments.size()> m_enabled{};
  bool m_valid = false;
};

/// Turns off what would change the program's colour before it is written.
void setPlainState(const RasterContext &context, const host::HostTable &host, bool alphaTest) {
  for (const GLenum capability : {GL_BLEND, GL_COLOR_LOGIC_OP, GL_DITHER})
    host.Disable(capability);
  if (!alphaTest)
    host.Disable(GL_ALPHA_TEST);
  if (context.caps.srgbFramebuffer)
    host.Disable(GL_FRAMEBUFFER_SRGB);
  host.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace

const char *whyNoProbe(const RasterContext &context) {
  if (!context.caps.framebufferObjects || !context.caps.drawBuffers)
    return "the host has no framebuffer objects of floats";
  return nullptr;
}

/// Binds the target for drawing, with the depths and stencils that the draw tests.
std::string DrawProbe::bindTarget(const Wish &wish) {
  const HasDepths has(m_host);
  bool tests = false;
  for (const auto &[test, isThere] :
       {std::pair(GL_DEPTH_TEST, has.depth), std::pair(GL_STENCIL_TEST, has.stencil)}) {
    const bool enabled = m_host.IsEnabled(GLenum(test)) != 0;
    tests = tests || (enabled && isThere);
    if (enabled && !isThere) // without the buffer the test passes, but it might fail with the
                             // object's
      m_host.Disable(GLenum(test));
  }
  const GLboolean scissored = m_host.IsEnabled(GL_SCISSOR_TEST);
  m_host.Disable(GL_SCISSOR_TEST);
  std::string why;
  if (tests)
    why = m_target.attachDepthsOf(wish.depths, wish.targets, wish.region);
  else if (!m_target.attach(wish.targets, wish.region))
    why = "the host draws to no framebuffer of floats";
  if (!why.empty())
    return why;
  setPlainState(m_context, m_host, wish.alphaTest);
  m_host.ClearColor(wish.clear[0], wish.clear[1], wish.clear[2], wish.clear[3]);
  m_host.Clear(GL_COLOR_BUFFER_BIT);
  if (scissored)
    m_host.Enable(GL_SCISSOR_TEST);
  return {};
}

Result<std::vector<Vec4>, std::string> DrawProbe::draw(const Redraw &redraw, const Wish &wish) {
  HostErrorScope errors(m_host, m_context.errors.pending);
  const TargetScope state(m_host);
  const Region &r = wish.region;
  std::vector<Vec4> values(wish.targets * std::size_t(r.width) * std::size_t(r.height), wish.clear);
  if (std::string why = bindTarget(wish); !why.empty())
    return why;
  if (!limitTo(m_host, r))
    return values;
  if (wish.program) {
    const ProgramSwap swap(m_context, wish);
    if (!swap.isValid())
      return std::string("the host refuses a program that shows values");
    redraw(m_host);
  } else {
    redraw(m_host);
  }
  m_host.BindFramebufferEXT(GL_READ_FRAMEBUFFER, m_target.name());
  const PlainTransfer plain(m_context, PixelStore::Pack);
  const std::size_t pixels = std::size_t(r.width) * std::size_t(r.height);
  for (std::size_t i = 0; i < wish.targets; ++i) {
    m_host.ReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + i));
    m_host.ReadPixels(r.x, r.y, r.width, r.height, GL_RGBA, GL_FLOAT, values[i * pixels].data());
  }
  if (errors.failed())
    return std::string("the host raised an error while a draw was repeated");
  return values;
}

Result<std::shared_ptr<const CompiledProgram>, std::string>
compileProbe(const RasterContext &context, const std::string &text) {
  fp::CompileOptions options = compileOptions(context.row(Target::Fragment));
  options.policy = fp::LimitPolicy::Report;
  const Replacement probe = {text,
                             fp::checkProgram(infoOf(Target::Fragment).language, text, options)};
  if (!probe.result.ok())
    return fp::renderAll("text", text, probe.result.diagnostics);
  return compileProgram(context, Target::Fragment, text, {}, &probe);
}

} // namespace arbiter::state::control
