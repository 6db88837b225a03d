#include "still_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include "still_parts.h"
#include "surface.h"

namespace software {
namespace {

// --- Textures and their filters ---

template <int Filter> void filteredFloor() {
  floorView();
  glEnable(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, Filter);
  const GLint magnified = Filter == GL_NEAREST ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnified);
  floorQuads();
}

void makeAnisotropic() {
  makeTexture();
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
}

void makeAnisotropicProgram() {
  makeAnisotropic();
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, kTexturedText);
}

void programFloor() {
  floorView();
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  floorQuads();
}

/// Draws plain surfaces first, against whose depths the floor is tested.
void lateFloor() {
  for (int i = 0; i < 12; ++i) {
    glEnable(GL_DEPTH_TEST);
    glColor3f(0.1F * float(i), 0.3F, 0.6F);
    flatQuad(-0.9F + 0.14F * float(i), -0.8F, 0.1F, 0.9F, 0.5F - 0.06F * float(i));
  }
  filteredFloor<GL_LINEAR_MIPMAP_LINEAR>();
}

/// Draws with a texture whose limit changes within each frame.
void changingFloor() {
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 1);
  glScissor(0, 0, kStillEdge, kStillEdge / 3);
  glEnable(GL_SCISSOR_TEST);
  filteredFloor<GL_LINEAR_MIPMAP_LINEAR>();
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 16);
  glScissor(0, kStillEdge / 3, kStillEdge, kStillEdge);
  filteredFloor<GL_LINEAR_MIPMAP_LINEAR>();
}

/// Adds a draw that is the host's, as its texture has a signed format.
void makeMixed() {
  GLuint other = 0;
  glGenTextures(1, &other);
  glBindTexture(GL_TEXTURE_2D, other);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const unsigned char texel[] = {40, 90, 120, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8_SNORM, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  makeAnisotropic();
}

void mixedFloor() {
  const GLuint own = boundTexture();
  filteredFloor<GL_LINEAR_MIPMAP_LINEAR>();
  glBindTexture(GL_TEXTURE_2D, own - 1);
  flatQuad(-0.9F, 0.2F, 0.4F, 0.4F, -0.9F);
  glBindTexture(GL_TEXTURE_2D, own);
}

// --- Colours, fog and light ---

void plainQuads() {
  for (int i = 0; i < 8; ++i) {
    glColor3f(0.12F * float(i), 1 - 0.1F * float(i), 0.5F);
    flatQuad(-0.9F + 0.2F * float(i), -0.8F + 0.1F * float(i), 0.3F, 0.6F, 0);
  }
}

void gradients() {
  for (int i = 0; i < 6; ++i)
    gradientTriangle(0.3F * float(i));
}

void translucentGradients() {
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int i = 0; i < 12; ++i)
    gradientTriangle(0.2F * float(i), 0.3F);
}

void lit() {
  floorView();
  enableLight();
  ball();
}

void litApart() {
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  lit();
}

void litApartInFog() {
  enableFog(GL_LINEAR);
  litApart();
}

template <int Mode> void fog() {
  floorView();
  enableFog(Mode);
  glColor3f(0.9F, 0.8F, 0.2F);
  floorQuads();
}

void colorSum() {
  glEnable(GL_COLOR_SUM);
  glSecondaryColor3f(0.8F, 0.7F, 0.1F);
  plainQuads();
}

void colorSumInFog() {
  enableFog(GL_LINEAR);
  colorSum();
}

/// Draws other surfaces first, against whose depths the color sum is tested.
void lateColorSumInFog() {
  glEnable(GL_DEPTH_TEST);
  plainQuads();
  glDepthFunc(GL_LEQUAL);
  colorSumInFog();
}

void makeFogProgram() {
  makeTexture();
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, "!!ARBfp1.0\nOPTION ARB_fog_linear;\nTEMP t;\n"
                                             "TEX t, fragment.texcoord[0], texture[0], 2D;\n"
                                             "ADD result.color, t, fragment.color;\nEND\n");
}

void programInFog() {
  enableFog(GL_LINEAR);
  programFloor();
}

// --- Bitmaps ---

void letters() {
  static const std::array<unsigned char, 13> kBits = {255, 129, 189, 165, 165, 165, 189,
                                                      129, 255, 60,  66,  129, 255};
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glColor3f(1, 1, 0);
  glRasterPos3f(-0.6F, -0.2F, 0);
  for (int i = 0; i < 4; ++i)
    glBitmap(8, 13, 0, 0, 10, 0, kBits.data());
}

void lettersInFog() {
  plainQuads();
  enableFog(GL_LINEAR);
  letters();
}

void lettersWithCoordinate() {
  plainQuads();
  enableFog(GL_LINEAR);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogCoordf(0.6F);
  letters();
}

void lettersWithSum() {
  plainQuads();
  glEnable(GL_COLOR_SUM);
  glSecondaryColor3f(0.1F, 0.2F, 0.8F);
  letters();
}

void texturedLetters() {
  plainQuads();
  glEnable(GL_TEXTURE_2D);
  glTexCoord2f(0.3F, 0.6F);
  letters();
  glFlush(); // Mesa 22.3.6 draws waiting letters with the next draw's textures
}

void makeLetterProgram() {
  makeTexture();
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, kTexturedText);
}

void programLetters() {
  plainQuads();
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glTexCoord2f(0.3F, 0.6F);
  letters();
  glFlush();
}

// --- Lines, points and other ways to draw polygons ---

void lines() { strokes(GL_LINES); }

void wideLines() {
  glLineWidth(5);
  strokes(GL_LINE_STRIP);
}

void stippledLines() {
  glEnable(GL_LINE_STIPPLE);
  glLineStipple(3, 0x35f0);
  strokes(GL_LINES);
}

/// Draws a strip whose first line is out of view.
void stippledStrip() {
  glEnable(GL_LINE_STIPPLE);
  glLineStipple(7, 0x00ff);
  glLineWidth(9);
  glColor3f(1, 1, 1);
  glBegin(GL_LINE_STRIP);
  for (const float x : {-9.0F, -3.1F, -0.7F, 3.0F})
    glVertex2f(x, -0.3F);
  glEnd();
}

/// Draws lines whose ends differ in color and distance.
void stippledInPerspective() {
  floorView();
  glEnable(GL_LINE_STIPPLE);
  glLineStipple(2, 0x5f5f);
  glLineWidth(5);
  glBegin(GL_LINES);
  for (int i = -3; i < 4; ++i) {
    glColor3f(1, 0, 0);
    glVertex3f(float(i), 0.2F, -1);
    glColor3f(0, 1, 1);
    glVertex3f(float(i) * 0.5F, 0.4F, -14);
  }
  glEnd();
}

void smoothLines() {
  enableSmooth();
  glEnable(GL_LINE_SMOOTH);
  glLineWidth(2.5F);
  strokes(GL_LINES);
}

void points() {
  glPointSize(5);
  strokes(GL_POINTS);
}

void smoothPoints() {
  enableSmooth();
  glEnable(GL_POINT_SMOOTH);
  glPointSize(9);
  strokes(GL_POINTS);
}

/// Draws points, which only have a front, with a stencil test that passes for it.
void smoothPointsByStencil() {
  glEnable(GL_STENCIL_TEST);
  glStencilFuncSeparate(GL_FRONT, GL_ALWAYS, 0, 255);
  glStencilFuncSeparate(GL_BACK, GL_NEVER, 0, 255);
  glFrontFace(GL_CW);
  smoothPoints();
}

void sprites() {
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_POINT_SPRITE);
  glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
  glPointSize(15);
  strokes(GL_POINTS);
}

void unfilled() {
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  plainQuads();
  glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  glPointSize(4);
  gradients();
}

void polygonStipple() {
  std::array<unsigned char, 128> pattern{};
  for (std::size_t i = 0; i < pattern.size(); ++i)
    pattern[i] = (unsigned char)(i * 37);
  glPolygonStipple(pattern.data());
  glEnable(GL_POLYGON_STIPPLE);
  plainQuads();
}

void polygonOffset() {
  glEnable(GL_DEPTH_TEST);
  plainQuads();
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -2);
  gradients();
}

// --- Pixels' tests and operations ---

void tests() {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 255);
  glStencilOp(GL_KEEP, GL_INCR, GL_INCR);
  plainQuads();
  glStencilFunc(GL_LESS, 1, 255);
  glDepthFunc(GL_ALWAYS);
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.5F);
  flatQuad(-1, -1, 2, 2, 0);
}

void blended() {
  glEnable(GL_BLEND);
  for (const GLenum to : {GL_ONE, GL_ONE_MINUS_SRC_COLOR, GL_SRC_COLOR}) {
    glBlendFunc(GL_DST_COLOR, to);
    plainQuads();
  }
}

void logicOperation() {
  plainQuads();
  glEnable(GL_COLOR_LOGIC_OP);
  glLogicOp(GL_XOR);
  flatQuad(-0.5F, -0.5F, 1, 1, 0);
}

} // namespace

const std::vector<StillScene> &stillScenes() {
  static const std::vector<StillScene> s_scenes = [] {
    std::vector<StillScene> scenes = {
        {"nearest", makeTexture, filteredFloor<GL_NEAREST>},
        {"linear", makeTexture, filteredFloor<GL_LINEAR>},
        {"mipmaps", makeTexture, filteredFloor<GL_NEAREST_MIPMAP_NEAREST>},
        {"trilinear", makeTexture, filteredFloor<GL_LINEAR_MIPMAP_LINEAR>},
        {"anisotropy", makeAnisotropic, filteredFloor<GL_LINEAR_MIPMAP_LINEAR>},
        {"anisotropy-by-program", makeAnisotropicProgram, programFloor},
        {"anisotropy-late", makeAnisotropic, lateFloor},
        {"anisotropy-changes", makeAnisotropic, changingFloor},
        {"anisotropy-mixed", makeMixed, mixedFloor},
        {"plain", nullptr, plainQuads},
        {"gradients", nullptr, gradients},
        {"translucent", nullptr, translucentGradients},
        {"lit", nullptr, lit},
        {"lit-apart", nullptr, litApart},
        {"lit-apart-in-fog", nullptr, litApartInFog},
        {"fog-linear", nullptr, fog<GL_LINEAR>},
        {"fog-exp", nullptr, fog<GL_EXP>},
        {"fog-exp2", nullptr, fog<GL_EXP2>},
        {"fog-by-program", makeFogProgram, programInFog},
        {"color-sum", nullptr, colorSum},
        {"color-sum-in-fog", nullptr, colorSumInFog},
        {"color-sum-late", nullptr, lateColorSumInFog},
        {"letters", nullptr, letters},
        {"letters-in-fog", nullptr, lettersInFog},
        {"letters-with-coordinate", nullptr, lettersWithCoordinate},
        {"letters-with-sum", nullptr, lettersWithSum},
        {"letters-textured", makeTexture, texturedLetters},
        {"letters-by-program", makeLetterProgram, programLetters},
        {"lines", nullptr, lines},
        {"lines-wide", nullptr, wideLines},
        {"lines-stippled", nullptr, stippledLines},
        {"strip-stippled", nullptr, stippledStrip},
        {"stipple-in-perspective", nullptr, stippledInPerspective},
        {"lines-smooth", nullptr, smoothLines},
        {"points", nullptr, points},
        {"points-smooth", nullptr, smoothPoints},
        {"points-by-stencil", nullptr, smoothPointsByStencil},
        {"sprites", makeTexture, sprites},
        {"unfilled", nullptr, unfilled},
        {"polygon-stipple", nullptr, polygonStipple},
        {"polygon-offset", nullptr, polygonOffset},
        {"tests", makeTexture, tests},
        {"blended", nullptr, blended},
        {"logic-operation", nullptr, logicOperation},
    };
    const std::vector<StillScene> &more = otherStillScenes();
    scenes.insert(scenes.end(), more.begin(), more.end());
    return scenes;
  }();
  return s_scenes;
}

} // namespace software
