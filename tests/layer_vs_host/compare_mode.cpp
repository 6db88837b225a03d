// TEXTURE_COMPARE_MODE counts as NONE without a SHADOW target (AFP 4051-4057), however it was set.
#include <functional>

#include "harness.h"

namespace paths {

namespace {

constexpr char kPlain[] = "!!ARBfp1.0\nTEMP t;\nTEX t, {0.5,0.5,0.25,1}, texture[0], 2D;\n"
                          "MOV result.color, t;\nMOV result.color.w, 1;\nEND";
constexpr Pixel kHalf = {128, 128, 128, 255};

GLuint depthTexture() {
  GLuint name = 0;
  const GLfloat half = 0.5f;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               &half);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return name;
}

void expectPlain(Recorder &r, const std::string &what) {
  glClear(GL_COLOR_BUFFER_BIT);
  glRectf(-1, -1, 1, 1);
  r.pixel(what, 32, 32, kHalf);
  r.check(integer(GL_SAMPLER_BINDING) == 0, what + ": a sampler shows");
}

/// Tests each setter in a context of its own, so that one that goes unnoticed is not hidden by
/// another.
void everySetter(Recorder &r) {
  const GLint mode = GL_COMPARE_R_TO_TEXTURE;
  const auto unsignedMode = GLuint(mode);
  const auto floatMode = GLfloat(mode);
  constexpr GLenum kTarget = GL_TEXTURE_2D, kName = GL_TEXTURE_COMPARE_MODE;
  const bool direct = epoxy_has_gl_extension("GL_EXT_direct_state_access");
  using Setter = std::function<void(GLuint texture)>;
  std::vector<std::pair<std::string, Setter>> setters = {
      {"TexParameteri", [&](GLuint) { glTexParameteri(kTarget, kName, mode); }},
      {"TexParameterf", [&](GLuint) { glTexParameterf(kTarget, kName, floatMode); }},
      {"TexParameteriv", [&](GLuint) { glTexParameteriv(kTarget, kName, &mode); }},
      {"TexParameterfv", [&](GLuint) { glTexParameterfv(kTarget, kName, &floatMode); }},
      {"TexParameterIiv", [&](GLuint) { glTexParameterIiv(kTarget, kName, &mode); }},
      {"TexParameterIuiv", [&](GLuint) { glTexParameterIuiv(kTarget, kName, &unsignedMode); }},
  };
  const std::vector<std::pair<std::string, Setter>> named = {
      {"TextureParameteriEXT", [&](GLuint t) { glTextureParameteriEXT(t, kTarget, kName, mode); }},
      {"TextureParameterfEXT",
       [&](GLuint t) { glTextureParameterfEXT(t, kTarget, kName, floatMode); }},
      {"TextureParameterivEXT",
       [&](GLuint t) { glTextureParameterivEXT(t, kTarget, kName, &mode); }},
      {"TextureParameterfvEXT",
       [&](GLuint t) { glTextureParameterfvEXT(t, kTarget, kName, &floatMode); }},
      {"TextureParameterIivEXT",
       [&](GLuint t) { glTextureParameterIivEXT(t, kTarget, kName, &mode); }},
      {"TextureParameterIuivEXT",
       [&](GLuint t) { glTextureParameterIuivEXT(t, kTarget, kName, &unsignedMode); }},
      {"MultiTexParameteriEXT",
       [&](GLuint) { glMultiTexParameteriEXT(GL_TEXTURE0, kTarget, kName, mode); }},
      {"MultiTexParameterfEXT",
       [&](GLuint) { glMultiTexParameterfEXT(GL_TEXTURE0, kTarget, kName, floatMode); }},
      {"MultiTexParameterivEXT",
       [&](GLuint) { glMultiTexParameterivEXT(GL_TEXTURE0, kTarget, kName, &mode); }},
      {"MultiTexParameterfvEXT",
       [&](GLuint) { glMultiTexParameterfvEXT(GL_TEXTURE0, kTarget, kName, &floatMode); }},
      {"MultiTexParameterIivEXT",
       [&](GLuint) { glMultiTexParameterIivEXT(GL_TEXTURE0, kTarget, kName, &mode); }},
      {"MultiTexParameterIuivEXT",
       [&](GLuint) { glMultiTexParameterIuivEXT(GL_TEXTURE0, kTarget, kName, &unsignedMode); }},
  };
  if (direct)
    setters.insert(setters.end(), named.begin(), named.end());
  for (const auto &[what, set] : setters) {
    const GLXContext context = createContext();
    makeCurrent(context);
    glViewport(0, 0, kSize, kSize);
    const GLuint texture = depthTexture();
    makeProgram(kPlain);
    glEnable(kFragment);
    expectPlain(r, what + " before");
    set(texture);
    expectPlain(r, what);
    makeCurrent(mainContext());
    destroyContext(context);
  }
}

/// Tests the setters of sampler objects.
void samplers(Recorder &r) {
  const GLint mode = GL_COMPARE_R_TO_TEXTURE;
  const auto unsignedMode = GLuint(mode);
  const auto floatMode = GLfloat(mode);
  constexpr GLenum kName = GL_TEXTURE_COMPARE_MODE;
  const std::vector<std::pair<std::string, std::function<void(GLuint)>>> setters = {
      {"SamplerParameteri", [&](GLuint s) { glSamplerParameteri(s, kName, mode); }},
      {"SamplerParameterf", [&](GLuint s) { glSamplerParameterf(s, kName, floatMode); }},
      {"SamplerParameteriv", [&](GLuint s) { glSamplerParameteriv(s, kName, &mode); }},
      {"SamplerParameterfv", [&](GLuint s) { glSamplerParameterfv(s, kName, &floatMode); }},
      {"SamplerParameterIiv", [&](GLuint s) { glSamplerParameterIiv(s, kName, &mode); }},
      {"SamplerParameterIuiv", [&](GLuint s) { glSamplerParameterIuiv(s, kName, &unsignedMode); }},
  };
  for (const auto &[what, set] : setters) {
    const GLXContext context = createContext();
    makeCurrent(context);
    glViewport(0, 0, kSize, kSize);
    depthTexture();
    makeProgram(kPlain);
    glEnable(kFragment);
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    set(sampler);
    glBindSampler(0, sampler);
    glRectf(-1, -1, 1, 1);
    r.pixel(what, 32, 32, kHalf);
    r.check(integer(GL_SAMPLER_BINDING) == GLint(sampler), what + ": the binding");
    makeCurrent(mainContext());
    destroyContext(context);
  }
}

/// Tests PopAttrib and lists, which set it as well.
void restored(Recorder &r) {
  depthTexture();
  makeProgram(kPlain);
  glEnable(kFragment);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  expectPlain(r, "set");
  glPushAttrib(GL_TEXTURE_BIT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  expectPlain(r, "none");
  glPopAttrib();
  expectPlain(r, "popped");
  GLint mode = 0;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, &mode);
  r.check(mode == GL_COMPARE_R_TO_TEXTURE, "the texture's own mode");
  const GLuint list = glGenLists(2);
  glNewList(list, GL_COMPILE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  glRectf(-1, -1, 0, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  glEndList();
  glCallList(list);
  expectPlain(r, "by a list");
  // The layer's sampler is bound while the stack is pushed; the pop must not restore it.
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glDisable(kFragment);
  glPopAttrib();
  r.check(integer(GL_SAMPLER_BINDING) == 0, "a sampler shows");
  glDisable(kFragment);
  glEnable(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glColor4f(1, 1, 1, 1);
  glTexCoord3f(0.5f, 0.5f, 0.75f);
  glRectf(-1, -1, 1, 1);
  r.pixel("fixed function compares", 32, 32, {0, 0, 0, 255});
}

} // namespace

const std::vector<Case> kCompareCases = {
    {"compare-every-setter", everySetter, "compares whatever the target"},
    {"compare-samplers", samplers, "compares whatever the target"},
    {"compare-restored", restored, "compares whatever the target"},
};

} // namespace paths
