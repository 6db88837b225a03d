// Changes of vertex processing, and of the way primitives are drawn.
#include "changes.h"

namespace software {

namespace {

void load(GLenum mode, float scale, float move) {
  const GLfloat matrix[16] = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1, 0, move, 0, 0, 1};
  glMatrixMode(mode);
  glLoadMatrixf(matrix);
  glMatrixMode(GL_MODELVIEW);
}

#define MATRIX(mode, forms)                                                                        \
  {                                                                                                \
#mode, forms, 0,                                                                               \
        [](Stage &) { load(mode, 0.7f, 0.13f); }, [](Stage &) { load(mode, 1.0f, 0.0f); }          \
  }

void light(GLenum pname, float r, float g, float b, float w) {
  const GLfloat value[4] = {r, g, b, w};
  glLightfv(GL_LIGHT0, pname, value);
}

void material(float r, float g, float b) {
  const GLfloat value[4] = {r, g, b, 1.0f};
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, value);
}

constexpr unsigned kLit = unsigned(Form::FixedVertices);
constexpr unsigned kProgram = unsigned(Form::Programs);

} // namespace

const std::vector<Change> kVertexChanges = {
    MATRIX(GL_MODELVIEW, kAllForms),
    MATRIX(GL_PROJECTION, kAllForms),
    MATRIX(GL_TEXTURE, kAllForms),
    {"clip plane", kFixedVertexForms, GL_TRANSFORM_BIT,
     [](Stage &) {
       const GLdouble plane[4] = {1, 0.25, 0, 0.125};
       glClipPlane(GL_CLIP_PLANE0, plane);
       glEnable(GL_CLIP_PLANE0);
     },
     [](Stage &) { glDisable(GL_CLIP_PLANE0); }},
    {"clip plane by its enable", kFixedVertexForms, GL_ENABLE_BIT,
     [](Stage &) {
       const GLdouble plane[4] = {-1, 0.25, 0, 0.125};
       glClipPlane(GL_CLIP_PLANE1, plane);
       glEnable(GL_CLIP_PLANE1);
     },
     [](Stage &) { glDisable(GL_CLIP_PLANE1); }},
    {"Color", kProgram | unsigned(Form::Fixed), GL_CURRENT_BIT,
     [](Stage &) { glColor4f(0.2f, 0.9f, 0.4f, 0.5f); },
     [](Stage &) { glColor4f(0.9f, 0.7f, 0.8f, 0.75f); }},
    {"SecondaryColor", kProgram, GL_CURRENT_BIT,
     [](Stage &) { glSecondaryColor3f(0.9f, 0.1f, 0.6f); },
     [](Stage &) { glSecondaryColor3f(0.1f, 0.2f, 0.3f); }},
    {"VertexAttrib", kProgram, GL_CURRENT_BIT,
     [](Stage &) { glVertexAttrib4f(6, 0.9f, 0.1f, 0.6f, 1.0f); },
     [](Stage &) { glVertexAttrib4f(6, 0.0f, 0.0f, 0.0f, 1.0f); }},
    {"Normal", kLit, GL_CURRENT_BIT, [](Stage &) { glNormal3f(0.8f, 0.0f, 0.6f); },
     [](Stage &) { glNormal3f(0.0f, 0.6f, 0.8f); }},
    {"COLOR_SUM", unsigned(Form::Fixed), 0, [](Stage &) { glEnable(GL_COLOR_SUM); },
     [](Stage &) { glDisable(GL_COLOR_SUM); }},
    {"lighting disabled", kLit, GL_LIGHTING_BIT, [](Stage &) { glDisable(GL_LIGHTING); },
     [](Stage &) { glEnable(GL_LIGHTING); }},
    {"Light", kLit, GL_LIGHTING_BIT, [](Stage &) { light(GL_DIFFUSE, 0.2f, 0.9f, 0.3f, 1); },
     [](Stage &) { light(GL_DIFFUSE, 1, 1, 1, 1); }},
    {"Light position", kLit, GL_LIGHTING_BIT,
     [](Stage &) { light(GL_POSITION, 0.5f, 1.5f, 1.0f, 1); },
     [](Stage &) { light(GL_POSITION, 0, 0, 1, 0); }},
    {"Material", kLit, GL_LIGHTING_BIT, [](Stage &) { material(0.1f, 0.3f, 0.9f); },
     [](Stage &) { material(0.8f, 0.8f, 0.8f); }},
    {"LightModel", kLit, GL_LIGHTING_BIT,
     [](Stage &) {
       const GLfloat ambient[4] = {0.6f, 0.1f, 0.1f, 1};
       glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
     },
     [](Stage &) {
       const GLfloat ambient[4] = {0.2f, 0.2f, 0.2f, 1};
       glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
     }},
    {"ColorMaterial, followed", kLit, 0,
     [](Stage &) {
       glColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
       glEnable(GL_COLOR_MATERIAL);
       glColor4f(0.1f, 0.9f, 0.2f, 1);
     },
     [](Stage &) {
       glDisable(GL_COLOR_MATERIAL);
       glColor4f(0.9f, 0.7f, 0.8f, 0.75f);
       material(0.8f, 0.8f, 0.8f);
     }},
    {"NORMALIZE", kLit, GL_TRANSFORM_BIT,
     [](Stage &) {
       glEnable(GL_NORMALIZE);
       glNormal3f(0.4f, 0, 0.3f);
     },
     [](Stage &) {
       glDisable(GL_NORMALIZE);
       glNormal3f(0, 0.6f, 0.8f);
     }},
    {"TexGen", kFixedVertexForms, GL_TEXTURE_BIT,
     [](Stage &) {
       glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
       glEnable(GL_TEXTURE_GEN_S);
     },
     [](Stage &) { glDisable(GL_TEXTURE_GEN_S); }},
    {"TexGen plane", kFixedVertexForms, 0,
     [](Stage &) {
       const GLfloat plane[4] = {0, 2, 0, 0.25f};
       glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
       glTexGenfv(GL_S, GL_OBJECT_PLANE, plane);
       glEnable(GL_TEXTURE_GEN_S);
     },
     [](Stage &) { glDisable(GL_TEXTURE_GEN_S); }},
    {"CullFace", kAllForms, GL_POLYGON_BIT,
     [](Stage &) {
       glEnable(GL_CULL_FACE);
       glCullFace(GL_FRONT);
     },
     [](Stage &) { glDisable(GL_CULL_FACE); }},
    {"FrontFace", kAllForms, GL_POLYGON_BIT,
     [](Stage &) {
       glEnable(GL_CULL_FACE);
       glCullFace(GL_BACK);
       glFrontFace(GL_CW);
     },
     [](Stage &) {
       glDisable(GL_CULL_FACE);
       glFrontFace(GL_CCW);
     }},
    {"PolygonMode", kAllForms, GL_POLYGON_BIT,
     [](Stage &) { glPolygonMode(GL_FRONT_AND_BACK, GL_POINT); },
     [](Stage &) { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
    {"PointSize", kAllForms, 0,
     [](Stage &) {
       glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
       glPointSize(5.0f);
     },
     [](Stage &) {
       glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
       glPointSize(1.0f);
     }},
    {"PolygonStipple", kAllForms, GL_POLYGON_BIT | GL_POLYGON_STIPPLE_BIT,
     [](Stage &) {
       const std::vector<GLubyte> pattern(128, 0x5A);
       glPolygonStipple(pattern.data());
       glEnable(GL_POLYGON_STIPPLE);
     },
     [](Stage &) { glDisable(GL_POLYGON_STIPPLE); }},
    // With an assembly program the bare host shades smoothly whatever the model.
    {"ShadeModel", unsigned(Form::Fixed), GL_LIGHTING_BIT,
     [](Stage &) {
       glEnableClientState(GL_COLOR_ARRAY);
       glShadeModel(GL_FLAT);
     },
     [](Stage &) {
       glDisableClientState(GL_COLOR_ARRAY);
       glShadeModel(GL_SMOOTH);
       glColor4f(0.9f, 0.7f, 0.8f, 0.75f);
     }},
    {"local parameter of vertices", kProgram, 0,
     [](Stage &) { glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 0.3f, -0.2f, 0.2f, 0); },
     [](Stage &) { glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 0, 0, 0, 0); }},
    {"env parameter of vertices", kProgram, 0,
     [](Stage &) { glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, -0.3f, 0.2f, -0.2f, 0); },
     [](Stage &) { glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 0, 0, 0, 0); }},
    {"BindProgram of vertices", kProgram, 0,
     [](Stage &s) { glBindProgramARB(GL_VERTEX_PROGRAM_ARB, s.vertices[1]); },
     [](Stage &s) { glBindProgramARB(GL_VERTEX_PROGRAM_ARB, s.vertices[0]); }},
    {"vertex program disabled", kProgram, GL_ENABLE_BIT,
     [](Stage &) { glDisable(GL_VERTEX_PROGRAM_ARB); },
     [](Stage &) { glEnable(GL_VERTEX_PROGRAM_ARB); }},
};

} // namespace software
