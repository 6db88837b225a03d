#include "scene.h"

#include <algorithm>
#include <cmath>

#include "cell_square.h"
#include "fp_compiler/testing/evaluate_combiners_fx9.h"
#include "issue.h"
#include "random_color.h"

namespace combined {

using namespace arbiter::fp::combiners;
using arbiter::fp::testing::Random;

namespace {

constexpr GLenum kTargets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D,
                               GL_TEXTURE_CUBE_MAP};

} // namespace

Scene::Scene(int units, bool negativeTexels, bool fx9)
    : m_units(units), m_fx9(fx9), m_textures(makeTextures(negativeTexels)),
      m_cells(kCells * kCells) {}

/// Binds a texture to every target of each unit, and enables one or none of them.
std::uint8_t Scene::bind(Random &random) {
  std::uint8_t enabled = 0;
  m_bound.fill(nullptr);
  for (int unit = 0; unit < m_units; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    const auto pick = random.below(int(m_textures.size()));
    const Texture &texture = m_textures[std::size_t(pick)];
    const bool used = random.chance(85);
    for (const GLenum target : kTargets)
      (used && target == texture.target ? glEnable : glDisable)(target);
    glBindTexture(texture.target, texture.name);
    if (!used)
      continue;
    m_bound[std::size_t(unit)] = &texture;
    enabled |= std::uint8_t(1u << unsigned(unit));
  }
  return enabled;
}

void Scene::arrangeFog(Random &random) {
  constexpr GLenum kModes[] = {GL_NONE, GL_LINEAR, GL_EXP, GL_EXP2};
  m_fogMode = kModes[random.below(4)];
  m_inputs.fog = randomColor(random, m_fx9);
  m_inputs.fog[3] = 0.25; // no register has it
  m_density = double(random.real(0.25f, 2.0f));
  m_start = double(random.real(0.0f, 0.5f));
  m_end = double(random.real(0.75f, 2.0f));
  (m_fogMode == GL_NONE ? glDisable : glEnable)(GL_FOG);
  if (m_fogMode != GL_NONE)
    glFogi(GL_FOG_MODE, GLint(m_fogMode));
  const GLfloat fog[] = {GLfloat(m_inputs.fog[0]), GLfloat(m_inputs.fog[1]),
                         GLfloat(m_inputs.fog[2]), GLfloat(m_inputs.fog[3])};
  glFogfv(GL_FOG_COLOR, fog);
  glFogf(GL_FOG_DENSITY, GLfloat(m_density));
  glFogf(GL_FOG_START, GLfloat(m_start));
  glFogf(GL_FOG_END, GLfloat(m_end));
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
}

double Scene::fogFactor(double distance) const {
  switch (m_fogMode) {
  case GL_LINEAR:
    return std::clamp((m_end - distance) / (m_end - m_start), 0.0, 1.0);
  case GL_EXP:
    return std::exp(-m_density * distance);
  case GL_EXP2:
    return std::exp(-m_density * distance * m_density * distance);
  default:
    return 1.0;
  }
}

void Scene::arrangeCells(Random &random) {
  for (Cell &cell : m_cells) {
    cell.primary = randomColor(random, m_fx9);
    cell.secondary = randomColor(random, m_fx9);
    cell.secondary[3] = 1.0; // as SecondaryColor3 sets it
    cell.fog = random.real(0.0f, 2.0f);
    for (std::size_t unit = 0; unit < cell.r.size(); ++unit) {
      cell.r[unit] = random.real(0.0f, 1.0f);
      const Texture *const texture = m_bound[unit];
      if (texture && std::abs(double(cell.r[unit]) - texture->contents[3]) < 1e-3)
        cell.r[unit] += 4e-3f;
    }
  }
}

void Scene::arrange(Random &random, arbiter::fp::testing::RandomCombinersOptions options) {
  options.textures = bind(random);
  m_state = arbiter::fp::testing::randomCombiners(random, options);
  issue(m_state);
  for (Color &constant : m_inputs.constants)
    constant = randomColor(random, m_fx9);
  issueConstants(m_inputs, options.stages);
  arrangeFog(random);
  arrangeCells(random);
}

void Scene::draw() const {
  glBegin(GL_QUADS);
  for (int i = 0; i < kCells * kCells; ++i) {
    const Cell &cell = m_cells[std::size_t(i)];
    glColor4dv(cell.primary.data());
    glSecondaryColor3dv(cell.secondary.data());
    glFogCoordf(cell.fog);
    for (unsigned unit = 0; unit < unsigned(m_units); ++unit)
      glMultiTexCoord4f(GL_TEXTURE0 + unit, 0.5f, 0.5f, cell.r[unit], 1.0f);
    drawCellSquare(i, kCells);
  }
  glEnd();
}

Evaluated Scene::evaluate(int cell) const {
  const Cell &of = m_cells[std::size_t(cell)];
  Inputs inputs = m_inputs;
  inputs.primary = of.primary;
  inputs.secondary = of.secondary;
  inputs.fogFactor = fogFactor(double(of.fog));
  for (std::size_t unit = 0; unit < m_bound.size(); ++unit) {
    const Texture *const texture = m_bound[unit];
    if (!texture)
      continue;
    inputs.textures[unit] = texture->contents;
    if (texture->compares)
      inputs.textures[unit].fill(double(of.r[unit]) <= texture->contents[3] ? 1.0 : 0.0);
  }
  return m_fx9 ? arbiter::fp::combiners::evaluateFx9(m_state, inputs)
               : arbiter::fp::combiners::evaluate(m_state, inputs);
}

} // namespace combined
