// Compares fixed-function vertex programs, run by the interpreter, with the host in the same state.
// The host's feedback mode gives positions, colours and texture coordinates.
#define GL_GLEXT_PROTOTYPES // before any header of GL
#include "state/raster_draw/fixed_function/fixed_vertex.h"

#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "state/core/host_state.h"
#include "state/mirror/mirror.h"
#include "state/testing/real_host.h"

namespace arbiter::state {
namespace {

using fp::ir::AttributeKind;
using fp::ir::OutputKind;
using testing::Numbers;
using testing::RealHost;
using Vec = std::array<float, 4>;

struct Vertex {
  Vec position, color, texCoord;
  std::array<float, 3> normal;
  float fogCoord;
};

struct Result {
  Vec position{}, color{}, texCoord{}; ///< position: x, y, z in the window, and clip w
};

Vertex randomVertex(Numbers &numbers) {
  Vertex v{};
  for (int i = 0; i < 3; ++i) {
    v.position[std::size_t(i)] = numbers.real(-0.9f, 0.9f);
    v.normal[std::size_t(i)] = numbers.real(-1, 1);
    v.color[std::size_t(i)] = numbers.real(0, 1);
  }
  v.position[3] = 1;
  v.color[3] = numbers.real(0, 1);
  v.texCoord = {numbers.real(-2, 2), numbers.real(-2, 2), numbers.real(-2, 2), 1};
  return v;
}

void randomTransform(Numbers &numbers) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  if (numbers.chance(50))
    glFrustum(-1, 1, -1, 1, 1.5, 20);
  else
    glOrtho(-3, 3, -3, 3, -1, 20);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glTranslatef(numbers.real(-0.5f, 0.5f), numbers.real(-0.5f, 0.5f), -5);
  glRotatef(numbers.real(0, 360), numbers.real(-1, 1), numbers.real(-1, 1), 0.3f);
  if (numbers.chance(50))
    glScalef(1.5f, 1.5f, 1.5f);
  (numbers.chance(50) ? glEnable : glDisable)(GL_NORMALIZE);
  (numbers.chance(50) ? glEnable : glDisable)(GL_RESCALE_NORMAL);
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  if (numbers.chance(50)) {
    glRotatef(30, 0.2f, 0.5f, 1);
    glTranslatef(0.25f, -1, 0);
  }
}

void randomMaterial(Numbers &numbers, GLenum face) {
  for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
    const GLfloat value[4] = {numbers.real(0, 0.4f), numbers.real(0, 0.4f), numbers.real(0, 0.4f),
                              numbers.real(0, 1)};
    glMaterialfv(face, pname, value);
  }
  glMaterialf(face, GL_SHININESS, numbers.real(0, 40));
}

void randomLight(Numbers &numbers, GLenum light) {
  (numbers.chance(60) ? glEnable : glDisable)(light);
  const GLfloat position[4] = {numbers.real(-3, 3), numbers.real(-3, 3), numbers.real(-3, 3),
                               numbers.chance(50) ? 1.0f : 0.0f};
  glLightfv(light, GL_POSITION, position);
  for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
    const GLfloat value[4] = {numbers.real(0, 0.6f), numbers.real(0, 0.6f), numbers.real(0, 0.6f),
                              1};
    glLightfv(light, pname, value);
  }
  const bool spot = numbers.chance(40), attenuated = numbers.chance(50);
  const GLfloat direction[3] = {numbers.real(-1, 1), numbers.real(-1, 1), -1};
  glLightfv(light, GL_SPOT_DIRECTION, direction);
  glLightf(light, GL_SPOT_CUTOFF, spot ? 60.0f : 180.0f);
  glLightf(light, GL_SPOT_EXPONENT, spot ? numbers.real(0, 10) : 0);
  glLightf(light, GL_CONSTANT_ATTENUATION, attenuated ? 0.5f : 1);
  glLightf(light, GL_LINEAR_ATTENUATION, attenuated ? 0.2f : 0);
  glLightf(light, GL_QUADRATIC_ATTENUATION, attenuated ? 0.05f : 0);
}

void randomLighting(Numbers &numbers) {
  (numbers.chance(70) ? glEnable : glDisable)(GL_LIGHTING);
  for (int i = 0; i < 3; ++i)
    randomLight(numbers, GLenum(GL_LIGHT0 + i));
  randomMaterial(numbers, GL_FRONT);
  randomMaterial(numbers, GL_BACK);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, numbers.below(2));
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, numbers.below(2));
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                numbers.chance(30) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  const GLfloat ambient[4] = {numbers.real(0, 0.5f), numbers.real(0, 0.5f), 0.1f, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  constexpr GLenum kParts[] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
                               GL_AMBIENT_AND_DIFFUSE};
  constexpr GLenum kFaces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
  glDisable(GL_COLOR_MATERIAL);
  glColorMaterial(numbers.of(kFaces), numbers.of(kParts));
  if (numbers.chance(40))
    glEnable(GL_COLOR_MATERIAL);
}

void randomTexGen(Numbers &numbers) {
  constexpr GLint kModes[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP,
                              GL_NORMAL_MAP};
  const bool any = numbers.chance(60);
  for (GLenum c = 0; c < 4; ++c) {
    const GLfloat object[4] = {numbers.real(-1, 1), numbers.real(-1, 1), numbers.real(-1, 1), 0.5f};
    const GLfloat eye[4] = {numbers.real(-1, 1), numbers.real(-1, 1), numbers.real(-1, 1), 0.25f};
    GLint mode = numbers.of(kModes);
    if (c >= 2 && mode == GL_SPHERE_MAP)
      mode = GL_EYE_LINEAR;
    if (c == 3 && (mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP))
      mode = GL_OBJECT_LINEAR;
    glTexGeni(GL_S + c, GL_TEXTURE_GEN_MODE, mode);
    glTexGenfv(GL_S + c, GL_OBJECT_PLANE, object);
    glTexGenfv(GL_S + c, GL_EYE_PLANE, eye);
    (any && numbers.chance(60) ? glEnable : glDisable)(GL_TEXTURE_GEN_S + c);
  }
}

void send(const Vertex &v) {
  glColor4fv(v.color.data());
  glNormal3fv(v.normal.data());
  glTexCoord4fv(v.texCoord.data());
  glVertex4fv(v.position.data());
}

/// Processes a vertex on the host. Returns false if it is clipped.
bool byHost(const Vertex &vertex, Result &result) {
  GLfloat buffer[32] = {};
  glFeedbackBuffer(32, GL_4D_COLOR_TEXTURE, buffer);
  glRenderMode(GL_FEEDBACK);
  glBegin(GL_POINTS);
  send(vertex);
  glEnd();
  if (glRenderMode(GL_RENDER) < 13 || buffer[0] != float(GL_POINT_TOKEN))
    return false;
  std::copy_n(buffer + 1, 4, result.position.begin());
  std::copy_n(buffer + 5, 4, result.color.begin());
  std::copy_n(buffer + 9, 4, result.texCoord.begin());
  return true;
}

std::vector<fp::ir::Vec4> attributesOf(const fp::ir::Program &program, const Vertex &vertex) {
  std::vector<fp::ir::Vec4> values;
  for (const fp::ir::Attribute &attribute : program.attributes)
    switch (attribute.kind) {
    case AttributeKind::Position:
      values.push_back(vertex.position);
      break;
    case AttributeKind::Normal:
      values.push_back({vertex.normal[0], vertex.normal[1], vertex.normal[2], 1});
      break;
    case AttributeKind::ColorPrimary:
      values.push_back(vertex.color);
      break;
    case AttributeKind::TexCoord:
      values.push_back(vertex.texCoord);
      break;
    case AttributeKind::FogCoord:
      values.push_back({vertex.fogCoord, 0, 0, 1});
      break;
    default:
      values.push_back({0, 0, 0, 1});
      break;
    }
  return values;
}

fp::ir::Vec4 output(const fp::ir::Program &program, const fp::ir::Evaluation &evaluation,
                    OutputKind kind, int index = 0) {
  for (std::size_t i = 0; i < program.outputs.size(); ++i)
    if (program.outputs[i] == fp::ir::Output{kind, std::uint8_t(index)})
      return evaluation.outputs[i];
  return {-99, -99, -99, -99};
}

fp::ir::Evaluation run(RasterContext &context, const fp::ir::Program &program,
                       const Vertex &vertex) {
  const std::vector<fp::ir::Vec4> attributes = attributesOf(program, vertex);
  fp::ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.parameter = [&](const fp::ir::Parameter &parameter) {
    fp::ir::Vec4 value{};
    fetchState(context, parameter.state, value.data());
    return value;
  };
  return fp::ir::evaluate(program, inputs);
}

void expectNear(const Vec &got, const Vec &wanted, float tolerance, const char *what,
                const fp::ir::Program &program) {
  for (std::size_t c = 0; c < 4; ++c)
    ASSERT_NEAR(got[c], wanted[c], tolerance * std::max(1.0f, std::abs(wanted[c])))
        << what << " component " << c << "\n"
        << fp::ir::print(program);
}

void expectSame(const fp::ir::Program &program, const fp::ir::Evaluation &got,
                const Result &wanted) {
  const Vec clip = output(program, got, OutputKind::Position);
  const Vec window = {32 + 32 * clip[0] / clip[3], 32 + 32 * clip[1] / clip[3],
                      0.5f + 0.5f * clip[2] / clip[3], clip[3]};
  expectNear(window, wanted.position, 2e-5f, "position", program);
  expectNear(output(program, got, OutputKind::FrontPrimary), wanted.color, 2e-4f, "colour",
             program);
  expectNear(output(program, got, OutputKind::TexCoord, 0), wanted.texCoord, 5e-4f,
             "texture coordinate", program);
}

TEST(FixedVertex, IsWhatTheHostMakesOfTheSameState) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "the test is built where OSMesa is";
  RasterContext &context = host.context();
  glViewport(0, 0, 64, 64);
  // The host only processes coordinates of units that are in use.
  const GLubyte texel[4] = {};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  Mirror mirror(*context.host, context.caps);
  FixedVertexPrograms programs;
  int compared = 0;
  // The host compiles a shader for each state, which takes most of the time.
  for (int round = 0; round < 60; ++round) {
    Numbers numbers{std::uint64_t(round)};
    randomTransform(numbers);
    randomLighting(numbers);
    randomTexGen(numbers);
    context.dirty = dirty::kAll;
    mirror.refresh(context.dirty);
    mirror.refreshVertexState();
    VertexNeeds needs;
    needs.primary = needs.secondary = true;
    needs.texCoords = 1;
    const auto program = programs.get(mirror.vertex, needs);
    ASSERT_EQ(fp::ir::validate(*program), std::vector<std::string>{});
    for (int i = 0; i < 8; ++i) {
      const Vertex vertex = randomVertex(numbers);
      Result wanted;
      if (!byHost(vertex, wanted))
        continue;
      ++compared;
      SCOPED_TRACE("round " + std::to_string(round) + " vertex " + std::to_string(i));
      expectSame(*program, run(context, *program, vertex), wanted);
      if (HasFatalFailure())
        return;
    }
  }
  EXPECT_GT(compared, 320);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(FixedVertex, PrimaryAndSecondarySumToTheSingleColor) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "the test is built where OSMesa is";
  RasterContext &context = host.context();
  Mirror mirror(*context.host, context.caps);
  VertexNeeds needs;
  needs.primary = needs.secondary = true;
  for (int round = 0; round < 100; ++round) {
    Numbers numbers{std::uint64_t(round) + 5000};
    randomTransform(numbers);
    randomLighting(numbers);
    glEnable(GL_LIGHTING);
    glClampColorARB(GL_CLAMP_VERTEX_COLOR_ARB, GL_FALSE);
    const Vertex vertex = randomVertex(numbers);
    Vec sums[2][2] = {};
    for (int separate = 0; separate < 2; ++separate) {
      glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                    separate ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
      context.dirty = dirty::kAll;
      mirror.refresh(context.dirty);
      mirror.refreshVertexState();
      const fp::ir::Program program = makeFixedVertexProgram(fixedVertexKey(mirror.vertex, needs));
      const fp::ir::Evaluation got = run(context, program, vertex);
      for (int back = 0; back < (mirror.vertex.twoSided ? 2 : 1); ++back)
        for (std::size_t c = 0; c < 3; ++c) {
          const float sum =
              output(program, got, back ? OutputKind::BackPrimary : OutputKind::FrontPrimary)[c] +
              output(program, got,
                     back ? OutputKind::BackSecondary : OutputKind::FrontSecondary)[c];
          if (separate == 0)
            sums[back][0][c] = sum;
          else
            EXPECT_NEAR(sum, sums[back][0][c], 1e-5f) << "round " << round;
        }
    }
  }
}

TEST(FixedVertex, WhatIsNotNeededIsNotWritten) {
  VertexState state;
  state.lighting = true;
  state.lights = 1;
  state.textureMatrix = 0xFF;
  state.texGen[2] = {3, 3, 0, 0};
  const fp::ir::Program program = makeFixedVertexProgram(fixedVertexKey(state, {}));
  EXPECT_EQ(program.outputs, std::vector<fp::ir::Output>(1, {OutputKind::Position, 0}));
  EXPECT_EQ(program.code.size(), 4u);
  VertexNeeds needs;
  needs.texCoords = 1u << 2;
  EXPECT_FALSE(fixedVertexKey(state, {}) == fixedVertexKey(state, needs));
  state.lighting = false;
  EXPECT_EQ(makeFixedVertexProgram(fixedVertexKey(state, {})).code.size(), 4u);
}

TEST(FixedVertex, ClipDistancesAndFogAndPointSize) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "the test is built where OSMesa is";
  RasterContext &context = host.context();
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0, 0, -4);
  const GLdouble plane[4] = {1, 0, 0.5, 2};
  glClipPlane(GL_CLIP_PLANE5, plane);
  glEnable(GL_CLIP_PLANE5);
  const GLfloat attenuation[3] = {1, 0, 0.25f};
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  glPointSize(10);
  Mirror mirror(*context.host, context.caps);
  mirror.refresh(context.dirty);
  mirror.refreshVertexState();
  EXPECT_EQ(mirror.vertex.clipPlanes, 1u << 5);
  VertexNeeds needs;
  needs.fogCoord = needs.pointSize = true;
  const fp::ir::Program program = makeFixedVertexProgram(fixedVertexKey(mirror.vertex, needs));
  Vertex vertex{};
  // (1, 0, -3) in eye space; the plane was set before z was translated
  vertex.position = {1, 0, 1, 1};
  const fp::ir::Evaluation got = run(context, program, vertex);
  EXPECT_FLOAT_EQ(output(program, got, OutputKind::FogCoord)[0], 3);
  EXPECT_NEAR(output(program, got, OutputKind::PointSize)[0], 10 / std::sqrt(1 + 0.25 * 9), 1e-5);
  // The plane was set in object coordinates of that time: 1*1 + 0.5*1 + 2.
  EXPECT_NEAR(output(program, got, OutputKind::TexCoord, kClipDistanceOutput + 1)[1], 3.5, 1e-5);

  fp::ir::Builder b(fp::ir::Language::ArbVertex);
  b.op(fp::ir::Opcode::Mul, b.result(OutputKind::FrontPrimary),
       {b.attribute(AttributeKind::ColorPrimary), b.constant(2)});
  b.options().positionInvariant = true;
  const fp::ir::Program whole =
      withFixedPosition(b.take(), mirror.vertex.clipPlanes, ColorClamp::NanIsZero);
  EXPECT_EQ(fp::ir::validate(whole), std::vector<std::string>{});
  EXPECT_FALSE(whole.options.positionInvariant);
  vertex.color = {0.25f, 0.75f, -1, 1};
  const fp::ir::Evaluation invariant = run(context, whole, vertex);
  EXPECT_EQ(output(whole, invariant, OutputKind::Position),
            output(program, got, OutputKind::Position));
  EXPECT_EQ(output(whole, invariant, OutputKind::FrontPrimary), (fp::ir::Vec4{0.5f, 1, 0, 1}));
  EXPECT_NEAR(output(whole, invariant, OutputKind::TexCoord, kClipDistanceOutput + 1)[1], 3.5,
              1e-5);

  fp::ir::Builder moved(fp::ir::Language::ArbVertex);
  moved.op(fp::ir::Opcode::Mov, moved.result(OutputKind::Position), {moved.constant(1, 0, -3, 1)});
  const fp::ir::Program clipped =
      withFixedPosition(moved.take(), mirror.vertex.clipPlanes, ColorClamp::None);
  EXPECT_EQ(fp::ir::validate(clipped), std::vector<std::string>{});
  const fp::ir::Evaluation inClip = run(context, clipped, vertex);
  EXPECT_EQ(output(clipped, inClip, OutputKind::Position), (fp::ir::Vec4{1, 0, -3, 1}));
  EXPECT_NEAR(output(clipped, inClip, OutputKind::TexCoord, kClipDistanceOutput + 1)[1], 3.5, 1e-5);
}

TEST(FixedVertex, FogCoordinatesBelowZeroAreFoldedWhereTheHostFoldsThem) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "the test is built where OSMesa is";
  VertexNeeds needs;
  needs.fogCoord = true;
  Vertex vertex{};
  vertex.position[3] = 1;
  vertex.fogCoord = -2;
  for (const auto &[from, wanted] :
       {std::pair(FogFrom::Coordinate, -2.0f), std::pair(FogFrom::AbsoluteCoordinate, 2.0f)}) {
    VertexState state;
    state.fogFrom = from;
    const fp::ir::Program program = makeFixedVertexProgram(fixedVertexKey(state, needs));
    const fp::ir::Evaluation got = run(host.context(), program, vertex);
    EXPECT_EQ(output(program, got, OutputKind::FogCoord)[0], wanted);
  }
}

/// HostCaps decides by the host's release, so a draw checks what the host really does.
TEST(FixedVertex, TheHostFoldsFogCoordinatesIfItsCapsSaySo) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "the test is built where OSMesa is";
  const GLfloat red[4] = {1, 0, 0, 1};
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 4);
  glFogfv(GL_FOG_COLOR, red);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glEnable(GL_FOG);
  glColor3f(0, 1, 0);
  const auto fogOf = [](GLfloat coordinate) {
    glFogCoordf(coordinate);
    glRectf(-1, -1, 1, 1);
    std::array<std::uint8_t, 4> pixel{};
    glReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    return int(pixel[0]);
  };
  (void)fogOf(0); // Mesa 25 draws the first one without fog
  const int above = fogOf(2), below = fogOf(-2);
  EXPECT_NEAR(above, 128, 2);
  EXPECT_NEAR(below, host.context().caps.foldsFogCoordinates ? above : 0, 2);
}

TEST(FixedVertex, ProgramsAreFoundAgain) {
  FixedVertexPrograms programs;
  VertexState state;
  VertexNeeds needs;
  needs.primary = true;
  const auto first = programs.get(state, needs);
  EXPECT_EQ(programs.get(state, needs), first);
  state.lighting = true;
  ++state.version;
  EXPECT_NE(programs.get(state, needs), first);
  state.lighting = false;
  ++state.version;
  EXPECT_EQ(programs.get(state, needs), first);
  FixedVertexPrograms ofAnotherContext;
  EXPECT_EQ(ofAnotherContext.get(state, needs), first) << "machine code is found by the program";
}

} // namespace
} // namespace arbiter::state
