// The targets of programs' results: attachments, several colors, sRGB, samples, depth.
#include <memory>

#include "harness.h"

namespace paths {

namespace {

/// A framebuffer object of textures or renderbuffers, bound for drawing and reading.
class Framebuffer {
public:
  explicit Framebuffer(int samples = 0) : m_samples(samples) {
    glGenFramebuffers(1, &m_name);
    glBindFramebuffer(GL_FRAMEBUFFER, m_name);
  }
  void texture(GLenum attachment, GLenum format) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(format), kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, name, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    m_texture = name;
  }
  void renderbuffer(GLenum attachment, GLenum format) {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, m_samples, format, kSize, kSize);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  }
  void clear(Recorder &r) const {
    r.check(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "complete");
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  /// Copies the samples to the window, which is read from now on.
  void resolve() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_name);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  }
  [[nodiscard]] GLuint name() const { return m_name; }
  [[nodiscard]] GLuint texture() const { return m_texture; }

private:
  GLuint m_name = 0;
  GLuint m_texture = 0;
  int m_samples = 0;
};

void textureAndBack(Recorder &r) {
  usePrograms();
  Framebuffer target;
  target.texture(GL_COLOR_ATTACHMENT0, GL_RGBA8);
  target.renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
  target.clear(r);
  glEnable(GL_DEPTH_TEST);
  gradient();
  tint(1, 0, 0);
  glProgramEnvParameter4fARB(kVertex, 0, 0.5f, 0.5f, 0.5f, 0); // behind
  gradient();
  r.picture("texture");
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_DEPTH_TEST);
  glBindTexture(GL_TEXTURE_2D, target.texture());
  glProgramEnvParameter4fARB(kVertex, 0, 0, 0, 0, 0);
  load("!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND");
  gradient(-1, -1, 0.5f, 1);
  r.picture("drawn from the texture");
}

void renderbuffer(Recorder &r) {
  usePrograms();
  Framebuffer target;
  target.renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8);
  target.renderbuffer(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8);
  target.clear(r);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  load("!!ARBfp1.0\nSUB result.color, fragment.color, 0.4;\nKIL fragment.color.x;\nEND");
  gradient(-1, -1, 0.5f, 0.5f);
  load("!!ARBfp1.0\nTEMP t;\nSUB t, fragment.color, 0.5;\nKIL t.z;\nMOV result.color, t;\nEND");
  gradient(-0.5f, -0.5f, 1, 1);
  glStencilFunc(GL_EQUAL, 2, 0xFF);
  load(kGreen);
  gradient(-1, -1, 1, 1);
  r.picture("stencilled");
}

void drawBuffers(Recorder &r) {
  usePrograms();
  Framebuffer target;
  for (GLenum i = 0; i < 4; ++i)
    target.texture(GL_COLOR_ATTACHMENT0 + i, GL_RGBA8);
  const GLenum all[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT2, GL_NONE, GL_COLOR_ATTACHMENT3};
  const GLenum every[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                          GL_COLOR_ATTACHMENT3};
  glDrawBuffers(4, every);
  target.clear(r);
  glDrawBuffers(4, all);
  load("!!ARBfp1.0\nOPTION ARB_draw_buffers;\n"
       "MOV result.color[0], fragment.color;\nMOV result.color[1], fragment.color.bgra;\n"
       "MOV result.color[2], {1,1,1,1};\nMOV result.color[3], program.env[0];\nEND");
  glProgramEnvParameter4fARB(kFragment, 0, 0.25f, 0.5f, 0.75f, 1);
  gradient();
  r.errors("four results");
  // Without the option the single color goes to each buffer of DrawBuffers, as in fixed function.
  load(kTintFragments);
  tint(1, 0.5f, 0.25f);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 0, 0, 0);
  gradient(-0.2f, -0.2f, 0.2f, 0.2f);
  for (GLenum i = 0; i < 4; ++i) {
    glReadBuffer(GL_COLOR_ATTACHMENT0 + i);
    r.picture("buffer " + std::to_string(i));
  }
}

void srgb(Recorder &r) {
  usePrograms();
  Framebuffer target;
  target.texture(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8);
  target.clear(r);
  tint(0.5f, 0.5f, 0.5f, 0.5f);
  gradient(-1, -1, 0, 1);
  glEnable(GL_FRAMEBUFFER_SRGB);
  gradient(0, -1, 1, 1);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  tint(1, 0, 1, 0.5f);
  gradient(-1, -0.3f, 1, 0.3f);
  r.picture("encoded on the right");
  glDisable(GL_BLEND);
  glDisable(GL_FRAMEBUFFER_SRGB);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, target.texture());
  load("!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND");
  gradient(-1, -1, 1, 1);
  r.picture("decoded by the texture");
}

void floats(Recorder &r) {
  usePrograms();
  Framebuffer target;
  target.texture(GL_COLOR_ATTACHMENT0, GL_RGBA32F);
  target.clear(r);
  load("!!ARBfp1.0\nMAD result.color, fragment.color, 4, -1.5;\nEND");
  for (const GLenum clamp : {GL_FALSE, GL_TRUE, GL_FIXED_ONLY}) {
    glClampColor(GL_CLAMP_FRAGMENT_COLOR_ARB, clamp);
    gradient();
    GLfloat pixel[4] = {};
    glReadPixels(10, 32, 1, 1, GL_RGBA, GL_FLOAT, pixel);
    for (const GLfloat component : pixel) // to a thousandth, as interpolation may differ by a bit
      r.value("component", double(int(component * 1000 + (component < 0 ? -0.5f : 0.5f))));
  }
}

void multisample(Recorder &r) {
  usePrograms();
  Framebuffer target(4);
  target.renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8);
  target.clear(r);
  glEnable(GL_MULTISAMPLE);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 1, 0, 1), glVertex2f(-0.9f, -0.8f);
  glColor4f(0, 1, 1, 1), glVertex2f(0.9f, -0.5f);
  glColor4f(1, 0, 1, 1), glVertex2f(-0.1f, 0.9f);
  glEnd();
  target.resolve();
  r.picture("edges");
}

void alphaToCoverage(Recorder &r) {
  usePrograms();
  Framebuffer target(4);
  target.renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8);
  target.clear(r);
  glEnable(GL_MULTISAMPLE);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  load("!!ARBfp1.0\nMOV result.color, fragment.color;\nMOV result.color.a, fragment.texcoord[0].x;"
       "\nEND");
  gradient(-1, -1, 1, 0);
  glEnable(GL_SAMPLE_ALPHA_TO_ONE);
  gradient(-1, 0, 1, 0.5f);
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glEnable(GL_SAMPLE_COVERAGE);
  glSampleCoverage(0.5f, GL_TRUE);
  gradient(-1, 0.5f, 1, 1);
  target.resolve();
  r.picture("coverage of alpha");
}

void depthResult(Recorder &r) {
  usePrograms();
  glEnable(GL_DEPTH_TEST);
  load("!!ARBfp1.0\nMOV result.color, fragment.color;\nMOV result.depth.z, fragment.texcoord[0].x;"
       "\nEND");
  gradient(-1, -1, 1, 1);
  load(
      "!!ARBfp1.0\nMOV result.color, {1,1,0,1};\nMOV result.depth.z, fragment.texcoord[0].y;\nEND");
  gradient(-1, -1, 1, 1);
  load("!!ARBfp1.0\nMOV result.color, fragment.position.z;\nEND");
  glProgramEnvParameter4fARB(kVertex, 0, 0, 0, 0.4f, 0);
  glDepthRange(0.25, 0.75);
  gradient(-0.5f, -0.5f, 0.5f, 0.5f);
  r.picture("by depth");
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0, -2000000);
  gradient(-0.5f, -0.5f, 0, 0.5f);
  r.picture("by offset");
}

void depthOnly(Recorder &r) {
  usePrograms();
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kSize, kSize, 0, GL_DEPTH_COMPONENT,
               GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const Framebuffer target;
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  target.clear(r);
  glEnable(GL_DEPTH_TEST);
  load("!!ARBfp1.0\nMUL result.depth.z, fragment.texcoord[0].x, fragment.texcoord[0].y;\nEND");
  gradient(-1, -1, 1, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_DEPTH_TEST);
  load("!!ARBfp1.0\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\nEND");
  gradient(-1, -1, 1, 1);
  r.picture("a shadow map");
}

void rasterOperations(Recorder &r) {
  usePrograms();
  gradient(-1, -1, 1, 1);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.5f);
  load("!!ARBfp1.0\nMOV result.color, fragment.color.bgra;\n"
       "MOV result.color.a, fragment.texcoord[0].x;\nEND");
  gradient(-1, -1, 1, 0);
  glDisable(GL_ALPHA_TEST);
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_XOR);
  gradient(-0.5f, -0.5f, 0.5f, 0.5f);
  glDisable(GL_COLOR_LOGIC_OP);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_DST_COLOR, GL_ONE, GL_ZERO);
  gradient(-1, 0.5f, 1, 1);
  glEnable(GL_SCISSOR_TEST);
  glScissor(4, 40, 20, 4);
  glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_BLEND);
  load(kRed);
  gradient(-1, -1, 1, 1);
  r.picture("tests and blending");
}

} // namespace

const std::vector<Case> kFramebufferCases = {
    {"framebuffer-texture", textureAndBack},
    {"framebuffer-renderbuffer", renderbuffer},
    {"framebuffer-draw-buffers", drawBuffers},
    {"framebuffer-srgb", srgb},
    {"framebuffer-float", floats},
    {"framebuffer-multisample", multisample},
    {"framebuffer-alpha-to-coverage", alphaToCoverage},
    {"framebuffer-depth-result", depthResult},
    {"framebuffer-depth-only", depthOnly},
    {"framebuffer-raster-operations", rasterOperations},
};

} // namespace paths
