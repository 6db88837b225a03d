// Changes of fragment operations, and of their target.
#include "changes.h"

namespace software {

namespace {

void blends(bool on) {
  (on ? glEnable : glDisable)(GL_BLEND);
  if (on)
    glBlendFunc(GL_ONE, GL_ONE);
}

void compares(Stage &stage, bool on) {
  glBindTexture(GL_TEXTURE_2D, stage.textures[0]);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, on ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, on ? 1 : 0);
}

void stencils(bool on) {
  (on ? glEnable : glDisable)(GL_STENCIL_TEST);
  glStencilFunc(on ? GL_NOTEQUAL : GL_ALWAYS, 0, ~0u);
  glStencilOp(GL_KEEP, GL_KEEP, on ? GL_INCR : GL_KEEP);
}

void texels(Stage &stage, int level, unsigned char value) {
  const std::vector<unsigned char> bytes(std::size_t(4 * 16), value);
  glBindTexture(GL_TEXTURE_2D, stage.textures[0]);
  glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

/// Redefines level 0 with other texels.
void define(GLint internalFormat, unsigned char value) {
  const std::vector<unsigned char> bytes(std::size_t(4 * 64), value);
  glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, 8, 8, 0, GL_BGRA, GL_UNSIGNED_BYTE, bytes.data());
}

/// Redefines it repeatedly with the same format and size, until the layer recognizes that.
void redefine(Stage &stage, GLint last) {
  glBindTexture(GL_TEXTURE_2D, stage.textures[0]);
  for (const int value : {60, 130, 220, 90}) {
    define(GL_RGBA, static_cast<unsigned char>(value));
    stage.draw();
    stage.draw();
  }
  define(last, 250);
}

void toTarget(Stage &stage) {
  glBindFramebuffer(GL_FRAMEBUFFER, stage.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, stage.target, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glViewport(0, 0, kSide / 2, kSide);
}

void toWindow(Stage &) {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, kSide, kSide);
}

/// Samples level 1 of a texture that generates it from level 0; then replaces level 0.
void remakeMipmaps(Stage &stage, void (*replace)()) {
  glBindTexture(GL_TEXTURE_2D, stage.textures[0]);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  for (int i = 0; i < 2; ++i) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
    stage.draw();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
    stage.draw();
    replace();
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
}

/// Draws to a texture, which must not generate its mipmaps; moving its pixels must not either.
void drawToMipmapped(Stage &stage) {
  const std::vector<unsigned char> bytes(std::size_t(4 * kSide * kSide), 200);
  glBindTexture(GL_TEXTURE_2D, stage.target);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               bytes.data());
  glBindTexture(GL_TEXTURE_2D, stage.textures[0]);
  toTarget(stage);
  stage.draw();
  toWindow(stage);
  // The host draws it, and gets all pixels
  glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  glBindTexture(GL_TEXTURE_2D, stage.target);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
}

void keepMipmaps(Stage &stage) {
  glBindTexture(GL_TEXTURE_2D, stage.textures[0]);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_FALSE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
}

void size(Stage &stage, int edge) {
  const std::vector<unsigned char> bytes(std::size_t(4 * edge * edge), 200);
  glBindTexture(GL_TEXTURE_2D, stage.textures[0]);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, edge, edge, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

/// Clears the target's texels, which later draws sample.
void clearSampled(Stage &stage, float red) {
  glBindTexture(GL_TEXTURE_2D, stage.target);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, stage.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, stage.target, 0);
  glClearColor(red, 0.5f, 1.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(0.2f, 0.1f, 0.4f, 1.0f);
}

} // namespace

const std::vector<Change> kPixelChanges = {
    {"TexImage2D, as it is", kAllForms, 0, [](Stage &s) { redefine(s, GL_RGBA); },
     [](Stage &s) { redefine(s, GL_RGBA8); }},
    {"TexImage2D, as another format", kAllForms, 0, [](Stage &s) { redefine(s, GL_LUMINANCE); },
     [](Stage &s) { redefine(s, GL_RGB); }},
    {"drawn to, mipmaps by themselves", kAllForms, 0, drawToMipmapped, keepMipmaps},
    {"TexSubImage2D, mipmaps by themselves", kAllForms, 0,
     [](Stage &s) {
       remakeMipmaps(s, [] {
         const std::vector<unsigned char> bytes(std::size_t(4 * 64), 220);
         glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
       });
     },
     keepMipmaps},
    {"CopyTexSubImage2D, mipmaps by themselves", kAllForms, 0,
     [](Stage &s) {
       remakeMipmaps(s, [] { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 28, 28, 8, 8); });
     },
     keepMipmaps},
    {"CopyTexImage2D, mipmaps by themselves", kAllForms, 0,
     [](Stage &s) {
       remakeMipmaps(s, [] { glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 28, 28, 8, 8, 0); });
     },
     keepMipmaps},
    {"TexImage2D, mipmaps by themselves", kAllForms, 0,
     [](Stage &s) {
       remakeMipmaps(s, [] {
         const std::vector<unsigned char> bytes(std::size_t(4 * 64), 220);
         glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
       });
     },
     keepMipmaps},
    {"the sampled texture, cleared", kAllForms, 0,
     [](Stage &s) {
       for (const float red : {0.25f, 0.5f}) {
         clearSampled(s, red);
         s.draw();
         s.draw();
       }
       clearSampled(s, 1.0f);
     },
     [](Stage &s) { glBindTexture(GL_TEXTURE_2D, s.textures[0]); }},
    {"Scissor", kAllForms, GL_SCISSOR_BIT,
     [](Stage &) {
       glEnable(GL_SCISSOR_TEST);
       glScissor(9, 5, 30, 40);
     },
     [](Stage &) { glDisable(GL_SCISSOR_TEST); }},
    {"Viewport", kAllForms, GL_VIEWPORT_BIT, [](Stage &) { glViewport(8, 4, 40, 50); },
     [](Stage &) { glViewport(0, 0, kSide, kSide); }},
    {"DepthRange", kAllForms, GL_VIEWPORT_BIT | GL_DEPTH_BUFFER_BIT,
     [](Stage &) {
       glEnable(GL_DEPTH_TEST);
       glDepthRange(1.0, 1.0); // nothing is nearer than the cleared depth
     },
     [](Stage &) {
       glDisable(GL_DEPTH_TEST);
       glDepthRange(0.0, 1.0);
     }},
    {"AlphaFunc", kAllForms, GL_COLOR_BUFFER_BIT,
     [](Stage &) {
       glEnable(GL_ALPHA_TEST);
       glAlphaFunc(GL_LESS, 0.02f);
     },
     [](Stage &) { glDisable(GL_ALPHA_TEST); }},
    {"BlendFunc", kAllForms, GL_COLOR_BUFFER_BIT, [](Stage &) { blends(true); },
     [](Stage &) { blends(false); }},
    {"BlendColor", kAllForms, GL_COLOR_BUFFER_BIT,
     [](Stage &) {
       glEnable(GL_BLEND);
       glBlendFunc(GL_CONSTANT_COLOR, GL_ZERO);
       glBlendColor(0.25f, 0.5f, 0.75f, 1.0f);
     },
     [](Stage &) { glDisable(GL_BLEND); }},
    {"BlendEquation", kAllForms, GL_COLOR_BUFFER_BIT,
     [](Stage &) {
       glEnable(GL_BLEND);
       glBlendFunc(GL_ONE, GL_ONE);
       glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
     },
     [](Stage &) {
       glDisable(GL_BLEND);
       glBlendEquation(GL_FUNC_ADD);
     }},
    {"LogicOp", kAllForms, GL_COLOR_BUFFER_BIT,
     [](Stage &) {
       glEnable(GL_COLOR_LOGIC_OP);
       glLogicOp(GL_COPY_INVERTED);
     },
     [](Stage &) { glDisable(GL_COLOR_LOGIC_OP); }},
    {"ColorMask", kAllForms, GL_COLOR_BUFFER_BIT,
     [](Stage &) { glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE); },
     [](Stage &) { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }},
    {"DepthFunc", kAllForms, GL_DEPTH_BUFFER_BIT,
     [](Stage &) {
       glEnable(GL_DEPTH_TEST);
       glDepthFunc(GL_NEVER);
     },
     [](Stage &) { glDisable(GL_DEPTH_TEST); }},
    {"StencilFunc", kAllForms, GL_STENCIL_BUFFER_BIT, [](Stage &) { stencils(true); },
     [](Stage &) { stencils(false); }},
    // After it, the bare host's fixed function writes uninitialised values.
    {"DrawBuffer", kFragmentProgramForms, GL_COLOR_BUFFER_BIT,
     [](Stage &) { glDrawBuffer(GL_NONE); }, [](Stage &) { glDrawBuffer(GL_BACK); }},
    {"BindFramebuffer", kAllForms, 0, toTarget, toWindow},
    {"Fog", kAllForms, GL_FOG_BIT,
     [](Stage &) {
       const GLfloat color[4] = {0.9f, 0.2f, 0.6f, 1.0f};
       glFogfv(GL_FOG_COLOR, color);
       glFogi(GL_FOG_MODE, GL_LINEAR);
       glFogf(GL_FOG_START, -0.5f);
       glFogf(GL_FOG_END, 0.5f);
       glEnable(GL_FOG);
     },
     [](Stage &) {
       const GLfloat color[4] = {0, 0, 0, 0};
       glFogfv(GL_FOG_COLOR, color);
       glDisable(GL_FOG);
     }},
    {"BindTexture", kAllForms, GL_TEXTURE_BIT,
     [](Stage &s) { glBindTexture(GL_TEXTURE_2D, s.textures[1]); },
     [](Stage &s) { glBindTexture(GL_TEXTURE_2D, s.textures[0]); }},
    {"TexParameter", kAllForms, GL_TEXTURE_BIT, [](Stage &s) { compares(s, true); },
     [](Stage &s) { compares(s, false); }},
    {"TexParameter wrap and filter", kAllForms, GL_TEXTURE_BIT,
     [](Stage &) {
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
     },
     [](Stage &) {
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
     }},
    {"TexSubImage", kAllForms, 0, [](Stage &s) { texels(s, 0, 250); },
     [](Stage &s) { texels(s, 0, 120); }},
    {"TexImage", kAllForms, 0, [](Stage &s) { size(s, 4); }, [](Stage &s) { size(s, 8); }},
    {"CopyTexSubImage", kAllForms, 0,
     [](Stage &) { glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 10, 10, 8, 8); },
     [](Stage &s) { texels(s, 0, 99); }},
    {"TexEnv", unsigned(Form::Fixed), GL_TEXTURE_BIT,
     [](Stage &) { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD); },
     [](Stage &) { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE); }},
    {"TexEnv colour", unsigned(Form::Fixed), GL_TEXTURE_BIT,
     [](Stage &) {
       const GLfloat color[4] = {0.1f, 0.9f, 0.4f, 1.0f};
       glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
       glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);
     },
     [](Stage &) { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE); }},
    {"texture disabled", unsigned(Form::Fixed), GL_ENABLE_BIT,
     [](Stage &) { glDisable(GL_TEXTURE_2D); }, [](Stage &) { glEnable(GL_TEXTURE_2D); }},
    {"Fog by its enable", unsigned(Form::Fixed), GL_ENABLE_BIT, [](Stage &) { glEnable(GL_FOG); },
     [](Stage &) { glDisable(GL_FOG); }},
    {"enables", kAllForms, GL_ENABLE_BIT,
     [](Stage &) {
       glAlphaFunc(GL_LESS, 0.02f);
       glEnable(GL_ALPHA_TEST);
       glEnable(GL_COLOR_LOGIC_OP);
     },
     [](Stage &) {
       glDisable(GL_ALPHA_TEST);
       glDisable(GL_COLOR_LOGIC_OP);
     }},
    {"LOD bias", kAllForms, GL_TEXTURE_BIT,
     [](Stage &) {
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
       glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 5.0f);
     },
     [](Stage &) {
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
       glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0.0f);
     }},
    {"local parameter of fragments", kFragmentProgramForms, 0,
     [](Stage &) { glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0.3f, 0, 0.2f, 0); },
     [](Stage &) { glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0, 0, 0, 0); }},
    {"env parameter of fragments", kFragmentProgramForms, 0,
     [](Stage &) { glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0, 0, 0, 0.3f); },
     [](Stage &) { glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0, 0, 0, 0); }},
    {"BindProgram of fragments", kFragmentProgramForms, 0,
     [](Stage &s) { glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, s.fragments[1]); },
     [](Stage &s) { glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, s.fragments[0]); }},
    {"fragment program disabled", kFragmentProgramForms, GL_ENABLE_BIT,
     [](Stage &) { glDisable(GL_FRAGMENT_PROGRAM_ARB); },
     [](Stage &) { glEnable(GL_FRAGMENT_PROGRAM_ARB); }},
};

} // namespace software
