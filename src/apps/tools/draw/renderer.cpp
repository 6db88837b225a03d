#include "apps/tools/draw/renderer.h"

#include <algorithm>
#include <chrono>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "apps/tools/draw/gl_mesh.h"
#include "apps/tools/draw/gl_programs.h"
#include "apps/tools/draw/gl_targets.h"
#include "apps/tools/draw/gl_textures.h"
#include "apps/tools/draw/surface.h"

namespace arbiter::tools {

using scene::Document;
using scene::Pass;

struct Renderer::Parts {
  explicit Parts(const Document &drawn) : document(drawn) {}

  std::optional<RenderError> load();
  std::optional<RenderError> loadMesh(const Pass &pass);
  void bindTarget(std::size_t index) const;
  void setPass(std::size_t index, double seconds) const;
  void drawPass(std::size_t index, double seconds) const;
  void drawMesh(std::size_t index) const;

  const Document &document;
  Targets targets; ///< must outlive the textures, which bind its textures
  Textures textures;
  Programs programs;
  std::vector<std::unique_ptr<GlMesh>> meshes; ///< one per pass
};

namespace {

void setEnabled(GLenum capability, bool on) {
  if (on)
    glEnable(capability);
  else
    glDisable(capability);
}

void setBlend(scene::Blend blend) {
  setEnabled(GL_BLEND, blend != scene::Blend::Off);
  switch (blend) {
  case scene::Blend::Off:
    break;
  case scene::Blend::Alpha:
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    break;
  case scene::Blend::Premultiplied:
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    break;
  case scene::Blend::Add:
    glBlendFunc(GL_ONE, GL_ONE);
    break;
  case scene::Blend::Multiply:
    glBlendFunc(GL_DST_COLOR, GL_ZERO);
    break;
  }
}

void setDepth(scene::Depth depth, bool write) {
  setEnabled(GL_DEPTH_TEST, depth != scene::Depth::Off);
  constexpr GLenum kTests[] = {GL_ALWAYS, GL_LESS, GL_LEQUAL, GL_EQUAL};
  glDepthFunc(kTests[std::size_t(depth)]);
  glDepthMask(GLboolean(write));
}

void setStencil(scene::Stencil stencil) {
  setEnabled(GL_STENCIL_TEST, stencil != scene::Stencil::Off);
  constexpr GLenum kTests[] = {GL_ALWAYS, GL_ALWAYS, GL_EQUAL, GL_NOTEQUAL};
  glStencilFunc(kTests[std::size_t(stencil)], 0, ~0u);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
}

void setCull(scene::Cull cull) {
  setEnabled(GL_CULL_FACE, cull != scene::Cull::None);
  glCullFace(cull == scene::Cull::Front ? GL_FRONT : GL_BACK);
}

void clear(const scene::State &state) {
  const auto component = [&](std::size_t i) { return float(state.clear[i].value); };
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glStencilMask(~0u);
  glClearColor(component(0), component(1), component(2), component(3));
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

template <typename Enum> Enum valueOf(const std::optional<scene::Chosen<Enum>> &chosen) {
  return chosen ? chosen->value : Enum();
}

void setMatrices(const scene::View &view) {
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(glm::value_ptr(view.projection));
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(glm::value_ptr(view.modelView));
}

} // namespace

std::optional<RenderError> Renderer::Parts::load() {
  if (auto error = programs.load(document))
    return error;
  if (auto error = targets.load(document))
    return error;
  if (auto error = textures.load(document, targets))
    return error;
  for (const Pass &pass : document.passes)
    if (auto error = loadMesh(pass))
      return error;
  return std::nullopt;
}

std::optional<RenderError> Renderer::Parts::loadMesh(const Pass &pass) {
  const auto mesh = scene::buildMesh(document.meshOf(pass), document.folder);
  if (!mesh)
    return RenderError{RenderError::Kind::Panel, mesh.error().message, std::size_t(pass.panel), -1,
                       mesh.error().span};
  const scene::Panel &panel = document.panelOf(pass);
  std::vector<unsigned> attribs;
  for (const scene::Parameter &parameter : panel.parameters)
    if (parameter.space == scene::Setting::Attrib)
      attribs.push_back(parameter.first);
  meshes.push_back(
      std::make_unique<GlMesh>(mesh.value(), panel.coordinates, pass.vertex >= 0, attribs));
  return std::nullopt;
}

/// Draws a pass's mesh. To count with a stencil, front faces count up and back faces down in two
/// draws, because two-sided stencils are not core in GL 1.5.
void Renderer::Parts::drawMesh(std::size_t index) const {
  const scene::State &state = document.panelOf(document.passes[index]).state;
  if (valueOf(state.stencil) != scene::Stencil::Count) {
    meshes[index]->draw();
    return;
  }
  glEnable(GL_CULL_FACE);
  for (const auto &[face, operation] :
       {std::pair(GL_BACK, GL_INCR_WRAP), {GL_FRONT, GL_DECR_WRAP}}) {
    glCullFace(GLenum(face));
    glStencilOp(GL_KEEP, GL_KEEP, GLenum(operation));
    meshes[index]->draw();
  }
}

void Renderer::Parts::bindTarget(std::size_t index) const {
  const Pass &pass = document.passes[index];
  const scene::Panel &panel = document.panelOf(pass);
  targets.bind(panel.target ? panel.target->name.text : std::string());
  const auto [width, height] = document.sizeOf(pass);
  glViewport(0, 0, width, height);
}

void Renderer::Parts::setPass(std::size_t index, double seconds) const {
  const Pass &pass = document.passes[index];
  const scene::State &state = document.panelOf(pass).state;
  setBlend(valueOf(state.blend));
  setDepth(document.depthOf(pass), state.depthWrite);
  setCull(valueOf(state.cull));
  setStencil(valueOf(state.stencil));
  const auto color = GLboolean(state.colorWrite);
  glColorMask(color, color, color, color);
  setMatrices(document.viewOf(pass));
  textures.bind(pass.panel);
  programs.use(document, pass, seconds);
}

void Renderer::Parts::drawPass(std::size_t index, double seconds) const {
  const Pass &pass = document.passes[index];
  bindTarget(index);
  if (document.clears(index))
    clear(document.panelOf(pass).state);
  setPass(index, seconds);
  drawMesh(index);
  Programs::disable(document);
  textures.release(pass.panel);
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : m_parts(std::move(parts)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>, RenderError> Renderer::make(const Document &document) {
  auto parts = std::make_unique<Parts>(document);
  if (auto error = parts->load())
    return *error;
  return std::unique_ptr<Renderer>(new Renderer(std::move(parts)));
}

void Renderer::draw(int frame) {
  const Document &document = m_parts->document;
  for (std::size_t pass = 0; pass < document.passes.size(); ++pass)
    m_parts->drawPass(pass, document.secondsOf(frame));
  m_parts->targets.bind({});
  m_parts->textures.feed(document.width(), document.height());
}

void Renderer::stopBefore(int frame, std::size_t pass) {
  const double seconds = m_parts->document.secondsOf(frame);
  for (std::size_t before = 0; before < pass; ++before)
    m_parts->drawPass(before, seconds);
  m_parts->bindTarget(pass);
  m_parts->setPass(pass, seconds);
}

void Renderer::clearTarget(std::size_t pass) const {
  const Document &document = m_parts->document;
  glPushAttrib(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  clear(document.panelOf(document.passes[pass]).state);
  glPopAttrib();
}

void Renderer::drawMesh(std::size_t pass) const { m_parts->drawMesh(pass); }

scene::Picture Renderer::read() const {
  const Document &document = m_parts->document;
  scene::Picture picture{document.width(), document.height(), {}};
  picture.bytes.resize(std::size_t(4) * std::size_t(picture.width) * std::size_t(picture.height));
  glReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE,
               picture.bytes.data());
  return picture;
}

Result<Rendering, RenderError> render(const Document &document, int first, int last) {
  Surface surface;
  if (const char *step = surface.open(document.width(), document.height()))
    return RenderError{RenderError::Kind::NoGl,
                       std::string(step) + " (EGL error " + std::to_string(eglGetError()) + ")"};
  auto made = Renderer::make(document);
  if (!made)
    return made.error();
  Renderer &renderer = *made.value();
  Rendering rendering;
  rendering.renderer = reinterpret_cast<const char *>(glGetString(GL_RENDERER));
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin = Clock::now();
  for (int frame = first; frame <= last; ++frame) {
    renderer.draw(frame);
    if (frame == first && first < last) {
      glFinish();
      begin = Clock::now();
    }
  }
  glFinish();
  const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
  rendering.millisecondsPerFrame = took.count() / std::max(1, last - first);
  rendering.picture = renderer.read();
  if (const GLenum code = glGetError(); code != GL_NO_ERROR)
    return RenderError{RenderError::Kind::NoGl, "GL error " + std::to_string(code)};
  return rendering;
}

} // namespace arbiter::tools
