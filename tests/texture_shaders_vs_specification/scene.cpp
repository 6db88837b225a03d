#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "../combiners_vs_specification/cell_square.h"
#include "../combiners_vs_specification/issue.h"
#include "../combiners_vs_specification/random_color.h"
#include "fp_compiler/testing/evaluate_combiners_fx9.h"
#include "fp_compiler/testing/random_combiners.h"
#include "fp_compiler/testing/random_texture_shaders.h"
#include "fp_compiler/texture_shader/operations.h"
#include "issue.h"
#include "peer.h"

namespace shaded {

using namespace arbiter::fp::texture_shader;
using arbiter::fp::testing::Random;

namespace {

constexpr GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D,
                               GL_TEXTURE_CUBE_MAP};

/// Keeps random numbers off the grid that the edges of texels are on.
constexpr float kOffGrid = 0.0011f;

/// Replaces what ARB_texture_env_combine and NV_texture_env_combine4 cannot express: hosts without
/// ATI_texture_env_combine3 lack its functions, and its sources except with four arguments.
void withoutAtis(Environment &environment) {
  for (CombineHalf *const half : {&environment.color, &environment.alpha}) {
    if (half->function >= CombineFunction::ModulateAdd &&
        half->function <= CombineFunction::ModulateSubtract)
      half->function = CombineFunction::Modulate;
    const bool four = argumentsOf(half->function) == 4;
    for (CombineArgument &argument : half->arguments)
      if (argument.source == CombineSource::One ||
          (argument.source == CombineSource::Zero && !four))
        argument.source = CombineSource::Previous;
  }
}

} // namespace

Scene::Scene(bool peer, bool fx9)
    : m_peer(peer), m_fx9(fx9), m_textures(makeTextures(peer)), m_cells(kCells * kCells) {}

/// Arranges conventional texturing: each unit has a target or none.
void Scene::arrangeConventional(Random &random) {
  constexpr Operation kOperations[] = {Operation::None,      Operation::Texture1D,
                                       Operation::Texture2D, Operation::TextureRectangle,
                                       Operation::Texture3D, Operation::TextureCubeMap};
  m_state.conventional = true;
  for (std::size_t unit = 0; unit < m_state.units; ++unit) {
    m_state.stages[unit] = {};
    m_state.stages[unit].operation = kOperations[random.below(6)];
    m_state.textures[unit] = arbiter::fp::testing::randomTexture(random);
  }
}

/// Binds a texture of the kind that the state needs, and any textures to the other targets.
void Scene::bind(Random &random, int unit) {
  const auto at = std::size_t(unit);
  const GLenum wanted = targetOf(m_state.stages[at].operation);
  m_bound[at] = nullptr;
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  for (const GLenum target : kTargets) {
    std::vector<const Texture *> fitting;
    for (const Texture &texture : m_textures)
      if (texture.target == target && (target != wanted || texture.kind == m_state.textures[at]))
        fitting.push_back(&texture);
    const Texture *const texture = fitting[std::size_t(random.below(int(fitting.size())))];
    glBindTexture(target, texture->name);
    if (target == wanted)
      m_bound[at] = texture;
  }
}

void Scene::arrangeParameters(Random &random) {
  for (std::size_t unit = 0; unit < m_state.units; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    const auto wide = [&] { return random.real(-1.5f, 1.5f); };
    GLfloat matrix[4], eye[3];
    for (std::size_t i = 0; i < 4; ++i)
      m_inputs.matrices[unit][i] = double(matrix[i] = wide());
    for (std::size_t i = 0; i < 3; ++i)
      m_inputs.eyes[unit][i] = double(eye[i] = wide());
    const GLfloat scale = wide(), bias = wide();
    m_inputs.scales[unit] = double(scale);
    m_inputs.biases[unit] = double(bias);
    if (m_peer)
      std::swap(matrix[1], matrix[2]);
    glTexEnvfv(GL_TEXTURE_SHADER_NV, GL_OFFSET_TEXTURE_MATRIX_NV, matrix);
    glTexEnvfv(GL_TEXTURE_SHADER_NV, GL_CONST_EYE_NV, eye);
    glTexEnvf(GL_TEXTURE_SHADER_NV, GL_OFFSET_TEXTURE_SCALE_NV, scale);
    glTexEnvf(GL_TEXTURE_SHADER_NV, GL_OFFSET_TEXTURE_BIAS_NV, bias);
  }
  constexpr float kRanges[][2] = {{0, 1}, {0.125f, 0.875f}, {0.75f, 0.25f}};
  const auto &range = kRanges[random.below(3)];
  glDepthRange(double(range[0]), double(range[1]));
  m_inputs.near = double(range[0]);
  m_inputs.far = double(range[1]);
}

void Scene::arrangeCoordinates(Random &random) {
  for (Cell &cell : m_cells)
    for (std::size_t unit = 0; unit < m_state.units; ++unit) {
      const Stage &stage = m_state.stages[unit];
      const Family family = infoOf(stage.operation).family;
      Color &c = cell.coordinates[unit];
      const bool texels = targetOf(stage.operation) == GL_TEXTURE_RECTANGLE &&
                          (family == Family::Texture || family == Family::Offset);
      for (std::size_t i = 0; i < 3; ++i)
        c[i] = double(random.real(-1.25f, 1.25f) + kOffGrid) * (texels ? 8.0 : 1.0);
      if (random.chance(60) && !texels)
        c[0] = std::abs(c[0]);
      c[3] = random.chance(50) ? 1.0 : 2.0;
      if (family == Family::Dot || family == Family::Reflect || family == Family::Diffuse)
        c[3] = double(random.real(-1.25f, 1.25f)); // an eye vector's component
      for (std::size_t i = 0; i < 4 && family == Family::Cull; ++i) {
        const bool less = (stage.cullLess >> i & 1) != 0;
        const double size = random.chance(10) && !less ? 0.0 : double(random.real(0.125f, 2.0f));
        c[i] = (less != random.chance(8)) ? -size : size;
      }
    }
}

void Scene::arrangeCombiners(Random &random) {
  GLint stages = 0;
  glGetIntegerv(GL_MAX_GENERAL_COMBINERS_NV, &stages);
  stages = std::min(stages, GLint(arbiter::fp::combiners::kStages));
  m_combiners =
      arbiter::fp::testing::randomCombiners(random, {.stages = stages, .units = m_state.units});
  combined::issue(m_combiners);
  for (Color &constant : m_combinerInputs.constants)
    constant = randomColor(random, true);
  combined::issueConstants(m_combinerInputs, stages);
  Color &secondary = m_combinerInputs.secondary = randomColor(random, true);
  secondary[3] = 1.0; // as SecondaryColor3 sets it
  glSecondaryColor3dv(secondary.data());
}

void Scene::arrangeColoring(Random &random) {
  m_combines = random.chance(50);
  (m_combines ? glEnable : glDisable)(GL_REGISTER_COMBINERS_NV);
  m_shown = random.below(m_state.units);
  if (m_combines && m_fx9)
    arrangeCombiners(random);
  else
    showUnit(m_shown);
  m_environments = arbiter::fp::testing::randomEnvironments(random, m_state.units);
  for (Environment &environment : m_environments)
    if (m_state.conventional && (environment.mode == EnvironmentMode::Combine ||
                                 environment.mode == EnvironmentMode::Decal))
      // GL leaves this undefined, so that the host decides
      environment = {EnvironmentMode::Modulate, {}, {}};
  if (!epoxy_has_gl_extension("GL_ATI_texture_env_combine3"))
    for (Environment &environment : m_environments)
      withoutAtis(environment);
  if (m_peer)
    leaveOut(m_state, m_environments);
  issue(m_environments, m_state.units);
  for (std::size_t unit = 0; unit < m_state.units; ++unit) {
    m_constants[unit] = randomColor(random, false);
    const Color &c = m_constants[unit];
    const GLfloat single[] = {GLfloat(c[0]), GLfloat(c[1]), GLfloat(c[2]), GLfloat(c[3])};
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, single);
  }
  for (Cell &cell : m_cells)
    cell.primary = randomColor(random, m_fx9);
}

void Scene::arrange(Random &random, int units) {
  m_state = arbiter::fp::testing::randomTextureShaders(random, units);
  if (random.chance(12))
    arrangeConventional(random);
  if (m_peer)
    leaveOut(m_state);
  issue(m_state);
  for (int unit = 0; unit < units; ++unit)
    bind(random, unit);
  arrangeParameters(random);
  arrangeCoordinates(random);
  arrangeColoring(random);
  m_inputs.sample = [this](int unit, const std::array<double, 3> &at) {
    return m_bound[std::size_t(unit)]->at(at);
  };
}

/// Draws an invisible point. NVIDIA's driver draws texture shaders before environments with the
/// environment colors of the last draw with combiners or without texture shaders, and this is such
/// a draw.
void Scene::makeConstantsCurrent() const {
  glEnable(GL_REGISTER_COMBINERS_NV);
  glBegin(GL_POINTS);
  glVertex2f(2.0f, 2.0f);
  glEnd();
  glDisable(GL_REGISTER_COMBINERS_NV);
}

void Scene::restore(const Kept &kept) {
  m_state = kept.state;
  m_environments = kept.environments;
  issue(m_state);
  issue(m_environments, m_state.units);
}

void Scene::draw() const {
  if (m_peer && !m_combines)
    makeConstantsCurrent();
  glBegin(GL_QUADS);
  for (int i = 0; i < kCells * kCells; ++i) {
    const Cell &cell = m_cells[std::size_t(i)];
    glColor4dv(cell.primary.data());
    for (unsigned unit = 0; unit < m_state.units; ++unit)
      glMultiTexCoord4dv(GL_TEXTURE0 + unit, cell.coordinates[unit].data());
    drawCellSquare(i, kCells);
  }
  glEnd();
}

Evaluated Scene::evaluate(int cell) const {
  Inputs inputs = m_inputs;
  inputs.coordinates = m_cells[std::size_t(cell)].coordinates;
  return arbiter::fp::texture_shader::evaluate(m_state, inputs);
}

void Scene::describe(int cell) const {
  const Evaluated evaluated = evaluate(cell);
  shaded::describe(kept(), !m_combines, evaluated);
  for (std::size_t unit = 0; unit < m_state.units; ++unit) {
    const Color &c = m_cells[std::size_t(cell)].coordinates[unit], &k = m_constants[unit];
    std::printf(
        "    unit %zu: format 0x%04X, coordinates (%.4f %.4f %.4f %.4f), environment colour "
        "(%.4f %.4f %.4f %.4f)\n",
        unit, m_bound[unit] ? m_bound[unit]->format : 0, c[0], c[1], c[2], c[3], k[0], k[1], k[2],
        k[3]);
  }
  const Color &primary = m_cells[std::size_t(cell)].primary;
  std::printf("    primary colour (%.4f %.4f %.4f %.4f)", primary[0], primary[1], primary[2],
              primary[3]);
  if (m_combines)
    std::printf(", combiners show unit %d", m_shown);
  std::printf("\n");
}

Colored Scene::colorOf(int cell, const Evaluated &evaluated) const {
  const Color &primary = m_cells[std::size_t(cell)].primary;
  if (!m_combines)
    return {evaluateEnvironments(m_environments, evaluated.environment, evaluated.colors,
                                 m_constants, primary)};
  if (m_fx9) {
    arbiter::fp::combiners::Inputs inputs = m_combinerInputs;
    inputs.primary = primary;
    for (std::size_t unit = 0; unit < m_state.units; ++unit)
      inputs.textures[unit] = registerOf(evaluated, int(unit));
    const auto exact = arbiter::fp::combiners::evaluateFx9(m_combiners, inputs);
    return {exact.color, true, exact.margin};
  }
  Color color = registerOf(evaluated, m_shown);
  for (double &c : color)
    c = c * 0.5 + 0.5;
  return {color};
}

} // namespace shaded
