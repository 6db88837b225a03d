#include "tools/draw/renderer.h"

#include <algorithm>
#include <chrono>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "tools/draw/mesh.h"
#include "tools/draw/surface.h"

namespace arbiter::tools {

namespace {

using fp::ir::Language;

/// The calls of ATI_text_fragment_shader are those of ARB programs with a target of its own, which
/// no header of Debian's has.
constexpr GLenum kTextFragmentShaderAti = 0x8200;

struct Target {
  GLenum name;
  const char *extension;
};

Target targetOf(Language language) {
  switch (language) {
  case Language::ArbVertex:
    return {GL_VERTEX_PROGRAM_ARB, "GL_ARB_vertex_program"};
  case Language::AtiFragment:
    return {kTextFragmentShaderAti, "GL_ATI_text_fragment_shader"};
  case Language::ArbFragment:
    break;
  }
  return {GL_FRAGMENT_PROGRAM_ARB, "GL_ARB_fragment_program"};
}

int query(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

int programLimit(GLenum target, GLenum name) {
  GLint value = 0;
  glGetProgramivARB(target, name, &value);
  return value;
}

std::string beyond(const std::string &option, unsigned number, int limit, const char *what) {
  if (limit > 0 && number < unsigned(limit))
    return {};
  return option + ": there are " + std::to_string(limit) + " " + what;
}

/// A parameter of a row that the program's target lacks. An ATI shader has none at all.
std::string parametersBeyond(const Scene &scene, const SceneProgram &program) {
  const GLenum target = targetOf(program.language).name;
  struct Kind {
    const std::vector<Scene::Parameter> &given;
    GLenum limit;
    const char *what;
  };
  for (const Kind &kind :
       {Kind{scene.locals, GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB, "local parameters"},
        Kind{scene.envs, GL_MAX_PROGRAM_ENV_PARAMETERS_ARB, "environment parameters"}})
    for (const Scene::Parameter &parameter : kind.given)
      if (!parameter.language || *parameter.language == program.language)
        if (std::string fault = beyond(parameter.option, parameter.index,
                                       programLimit(target, kind.limit), kind.what);
            !fault.empty())
          return fault;
  return {};
}

/// Anything out of the limits is named here, before GL gives it a nameless error.
std::string beyondLimits(const Scene &scene) {
  const int units = query(GL_MAX_TEXTURE_IMAGE_UNITS_ARB);
  for (const Scene::Texture &texture : scene.textures)
    if (std::string fault =
            beyond((texture.option.empty() ? "--feedback " : "--texture ") +
                       (texture.option.empty() ? std::to_string(texture.unit) : texture.option),
                   texture.unit, units, "texture image units");
        !fault.empty())
      return fault;
  for (const SceneProgram &program : scene.programs)
    if (program.language != Language::AtiFragment)
      if (std::string fault = parametersBeyond(scene, program); !fault.empty())
        return fault;
  const int attribs = scene.attribs.empty() ? 0 : query(GL_MAX_VERTEX_ATTRIBS_ARB);
  for (const Scene::Parameter &attrib : scene.attribs) {
    if (attrib.index == 0)
      return attrib.option + ": attribute 0 is the position, which the mesh gives";
    if (std::string fault = beyond(attrib.option, attrib.index, attribs, "generic attributes");
        !fault.empty())
      return fault;
  }
  return {};
}

void upload(const Scene &scene, const Scene::Texture &texture) {
  GLuint name = 0;
  glActiveTexture(GL_TEXTURE0 + texture.unit);
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const bool nearest = int(texture.unit) == scene.feedback;
  const GLint filter = nearest ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.picture.width, texture.picture.height, 0,
               GL_RGBA, GL_UNSIGNED_BYTE, texture.picture.bytes.data());
  // What a unit samples is in the text of an ARB program, and not in that of an ATI shader.
  if (scene.programs.back().language == Language::AtiFragment)
    glEnable(GL_TEXTURE_2D);
}

/// Loads and enables one program, with its parameters.
bool load(const Scene &scene, std::size_t index, RenderError &error) {
  const SceneProgram &program = scene.programs[index];
  const GLenum target = targetOf(program.language).name;
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(program.text.size()),
                     program.text.data());
  if (glGetError() != GL_NO_ERROR) {
    const auto *text = reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
    error = {RenderError::Kind::Program, text == nullptr ? "" : text,
             query(GL_PROGRAM_ERROR_POSITION_ARB), index};
    return false;
  }
  const auto wants = [&](const Scene::Parameter &parameter) {
    return program.language != Language::AtiFragment &&
           (!parameter.language || *parameter.language == program.language);
  };
  for (const Scene::Parameter &parameter : scene.locals)
    if (wants(parameter))
      glProgramLocalParameter4fvARB(target, parameter.index, parameter.value.data());
  for (const Scene::Parameter &parameter : scene.envs)
    if (wants(parameter))
      glProgramEnvParameter4fvARB(target, parameter.index, parameter.value.data());
  glEnable(target);
  return true;
}

/// Programs, textures and parameters. \returns false with `error` filled.
bool prepare(const Scene &scene, RenderError &error) {
  for (const SceneProgram &program : scene.programs)
    if (const char *extension = targetOf(program.language).extension;
        !epoxy_has_gl_extension(extension)) {
      error = {RenderError::Kind::NoGl, std::string("this GL has no ") + extension};
      return false;
    }
  if (const std::string fault = beyondLimits(scene); !fault.empty()) {
    error = {RenderError::Kind::Scene, fault};
    return false;
  }
  for (std::size_t i = 0; i < scene.programs.size(); ++i)
    if (!load(scene, i, error))
      return false;
  for (const Scene::Texture &texture : scene.textures)
    upload(scene, texture);
  glMatrixMode(GL_PROJECTION);
  glOrtho(-1, 1, -1, 1, -1, 1);
  glMatrixMode(GL_MODELVIEW);
  if (scene.mesh == Mesh::Sphere)
    glEnable(GL_DEPTH_TEST);
  glViewport(0, 0, scene.width, scene.height);
  return true;
}

/// Draws the mesh, each vertex with every attribute that a program may read.
class MeshDrawer {
public:
  explicit MeshDrawer(const Scene &scene)
      : m_vertices(quadsOf(scene.mesh)), m_sets(query(GL_MAX_TEXTURE_COORDS_ARB)),
        m_generic(scene.hasVertexProgram()), m_attribs(scene.attribs) {}

  void draw() const {
    glBegin(GL_QUADS);
    for (const MeshVertex &vertex : m_vertices)
      emit(vertex);
    glEnd();
  }

private:
  void emit(const MeshVertex &vertex) const {
    const float coordinate[] = {vertex.s, vertex.t, 0, 1};
    const float normal[] = {vertex.normal[0], vertex.normal[1], vertex.normal[2], 1};
    glColor4fv(coordinate);
    glNormal3fv(normal);
    for (int set = 0; set < m_sets; ++set)
      glMultiTexCoord4fv(GL_TEXTURE0 + GLenum(set), coordinate);
    if (m_generic) {
      constexpr GLuint kNormal = 2, kColor = 3, kFirstSet = 8;
      glVertexAttrib4fvARB(kNormal, normal);
      glVertexAttrib4fvARB(kColor, coordinate);
      for (int set = 0; set < std::min(m_sets, 8); ++set)
        glVertexAttrib4fvARB(kFirstSet + GLuint(set), coordinate);
      for (const Scene::Parameter &attrib : m_attribs)
        glVertexAttrib4fvARB(attrib.index, attrib.value.data());
    }
    glVertex3fv(vertex.position.data());
  }

  std::vector<MeshVertex> m_vertices;
  int m_sets;
  bool m_generic;
  const std::vector<Scene::Parameter> &m_attribs;
};

void drawFrame(const Scene &scene, const MeshDrawer &mesh) {
  glClear(GL_COLOR_BUFFER_BIT | (scene.mesh == Mesh::Sphere ? GL_DEPTH_BUFFER_BIT : 0));
  mesh.draw();
  if (scene.feedback >= 0) {
    glActiveTexture(GL_TEXTURE0 + GLenum(scene.feedback));
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, scene.width, scene.height);
  }
}

/// \returns milliseconds a frame, without the first one of several.
double drawFrames(const Scene &scene) {
  const MeshDrawer mesh(scene);
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin = Clock::now();
  for (int frame = 0; frame < scene.frames; ++frame) {
    drawFrame(scene, mesh);
    if (frame == 0 && scene.frames > 1) {
      glFinish();
      begin = Clock::now();
    }
  }
  glFinish();
  const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
  return took.count() / std::max(1, scene.frames - 1);
}

} // namespace

Result<Rendering, RenderError> render(const Scene &scene) {
  Surface surface;
  if (const char *step = surface.open(scene.width, scene.height))
    return RenderError{RenderError::Kind::NoGl,
                       std::string(step) + " (EGL error " + std::to_string(eglGetError()) + ")"};
  RenderError error;
  if (!prepare(scene, error))
    return error;
  Rendering rendering;
  rendering.renderer = reinterpret_cast<const char *>(glGetString(GL_RENDERER));
  rendering.millisecondsPerFrame = drawFrames(scene);
  rendering.picture.width = scene.width;
  rendering.picture.height = scene.height;
  rendering.picture.bytes.resize(std::size_t(4) * scene.width * scene.height);
  glReadPixels(0, 0, scene.width, scene.height, GL_RGBA, GL_UNSIGNED_BYTE,
               rendering.picture.bytes.data());
  if (const GLenum code = glGetError(); code != GL_NO_ERROR)
    return RenderError{RenderError::Kind::NoGl, "GL error " + std::to_string(code)};
  return rendering;
}

} // namespace arbiter::tools
