#include "states.h"

#include <array>

namespace software {

namespace {

std::string targetName(const Scene &scene, bool shadow) {
  const std::string prefix = shadow ? "SHADOW" : "";
  switch (scene.token("texture")) {
  case GL_TEXTURE_1D:
    return prefix + "1D";
  case GL_TEXTURE_3D:
    return "3D";
  case GL_TEXTURE_CUBE_MAP:
    return "CUBE";
  case GL_TEXTURE_RECTANGLE_ARB:
    return prefix + "RECT";
  default:
    return prefix + "2D";
  }
}

/// The programs of factors.py, in its order; @ stands for the texture's target.
constexpr std::array<const char *, 14> kTexts = {
    "TEX result.color, fragment.texcoord[0], texture[0], @;\n",
    "TEX t, fragment.texcoord[0], texture[0], @;\nMUL result.color, t, fragment.color;\n",
    "TEX t, fragment.texcoord[0], texture[0], @;\n"
    "MAD result.color, t, {0.5, 0.5, 0.5, 0.5}, fragment.color;\n",
    "MOV result.color, fragment.color;\n",
    "TXP t, fragment.texcoord[0], texture[0], @;\nLRP result.color, fragment.color.w, t, "
    "fragment.color;\n",
    "TXB t, fragment.texcoord[0], texture[0], @;\nMOV result.color, t;\n",
    "MAD t.xy, fragment.position, {0.02, 0.018, 0, 0}, {0.02, 0, 0, 0};\n"
    "MAD t.zw, fragment.position.z, {0, 0, 0.5, 0}, {0, 0, 0.1, 0.7};\nMUL result.color, t, "
    "fragment.color.wwww;\n",
    "TEX t, fragment.texcoord[0], texture[0], @;\n"
    "MAD result.color, fragment.fogcoord.x, {0.3, 0.1, 0.2, 0}, t;\n",
    "TEX t, fragment.texcoord[0], texture[0], @;\nSUB u, t.x, 0.31;\nKIL u.x;\n"
    "MUL result.color, t, fragment.color;\n",
    "ADD result.color, fragment.color, fragment.color.secondary;\n",
    "TEX t, fragment.texcoord[0], texture[0], @;\nMOV result.color, t;\n"
    "MAD result.depth.z, fragment.color.x, 0.5, 0.2;\n",
    "MOV result.color, program.local[0];\n",
    "TEX t, fragment.texcoord[0], texture[0], @;\nMOV result.color, t;\n",
    "TEX t, fragment.texcoord[0], texture[0], @;\nMUL result.color, t, fragment.color;\n",
};

std::string fragmentText(const Scene &scene) {
  const bool shadow = scene.choice("compare") != 0;
  const int which = scene.choice("program");
  std::string text = "!!ARBfp1.0\n";
  if (shadow)
    text += "OPTION ARB_fragment_program_shadow;\n";
  if (which == 12)
    text += "OPTION ARB_fog_linear;\n";
  if (which == 13)
    text += "OPTION ARB_fog_exp2;\n";
  text += "TEMP t, u;\n";
  for (const char *at = kTexts[std::size_t(which)]; *at; ++at) {
    if (*at == '@')
      text += targetName(scene, shadow);
    else
      text += *at;
  }
  return text + "END\n";
}

constexpr const char *kVertexText = "!!ARBvp1.0\nPARAM mvp[4] = { state.matrix.mvp };\n"
                                    "DP4 result.position.x, mvp[0], vertex.position;\n"
                                    "DP4 result.position.y, mvp[1], vertex.position;\n"
                                    "DP4 result.position.z, mvp[2], vertex.position;\n"
                                    "DP4 result.position.w, mvp[3], vertex.position;\n"
                                    "MUL result.color, vertex.color, {0.9, 0.8, 1, 1};\n"
                                    "MOV result.color.secondary, vertex.color.yzxw;\n"
                                    "MOV result.texcoord[0], vertex.texcoord[0];\n"
                                    "MAD result.fogcoord.x, vertex.position.x, 0.4, 0.5;\n";

void light() {
  static constexpr float kPosition[4] = {0.5f, 0.8f, 1.5f, 0.0f};
  static constexpr float kDiffuse[4] = {0.9f, 0.8f, 0.7f, 1.0f};
  glLightfv(GL_LIGHT0, GL_POSITION, kPosition);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, kDiffuse);
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHTING);
  glEnable(GL_NORMALIZE);
  glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  glEnable(GL_COLOR_MATERIAL);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
}

void generateCoordinates() {
  static constexpr float kS[4] = {0.6f, 0.2f, 0, 0.4f}, kT[4] = {-0.1f, 0.7f, 0, 0.5f};
  glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  glTexGenfv(GL_S, GL_OBJECT_PLANE, kS);
  glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
  glTexGenfv(GL_T, GL_EYE_PLANE, kT);
  glEnable(GL_TEXTURE_GEN_S);
  glEnable(GL_TEXTURE_GEN_T);
}

} // namespace

void setProgramState(const Scene &scene) {
  glMatrixMode(GL_PROJECTION);
  if (scene.choice("depths") == 2)
    glFrustum(-0.4, 0.4, -0.4, 0.4, 1.0, 6.0);
  glMatrixMode(GL_MODELVIEW);
  if (scene.choice("depths") == 2)
    glTranslatef(0, 0, -2.5f);
  switch (scene.choice("vertices")) {
  case 1:
    light();
    break;
  case 2:
    generateCoordinates();
    break;
  case 3:
    glMatrixMode(GL_TEXTURE);
    glTranslatef(0.1f, 0.2f, 0);
    glScalef(0.8f, 1.3f, 1);
    glMatrixMode(GL_MODELVIEW);
    break;
  case 4: {
    static constexpr double kPlane[4] = {0.7, -0.4, 0.1, 0.2};
    glClipPlane(GL_CLIP_PLANE0, kPlane);
    glEnable(GL_CLIP_PLANE0);
    break;
  }
  case 5:
  case 6: {
    const bool sized = scene.choice("vertices") == 6;
    (void)makeProgram(GL_VERTEX_PROGRAM_ARB,
                      std::string(kVertexText) +
                          (sized ? "MOV result.pointsize.x, 3.0;\nEND\n" : "END\n"));
    glEnable(GL_VERTEX_PROGRAM_ARB);
    if (sized)
      glEnable(GL_VERTEX_PROGRAM_POINT_SIZE_ARB);
    break;
  }
  default:
    break;
  }
  static constexpr float kFog[4] = {0.2f, 0.6f, 0.3f, 1.0f};
  glFogfv(GL_FOG_COLOR, kFog);
  glFogf(GL_FOG_START, 0.1f);
  glFogf(GL_FOG_END, 1.4f);
  glFogf(GL_FOG_DENSITY, 0.8f);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB, fragmentText(scene));
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
}

} // namespace software
