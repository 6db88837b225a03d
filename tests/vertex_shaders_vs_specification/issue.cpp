#include "issue.h"

#include <algorithm>

namespace vertex_shaders {

namespace {

using namespace arbiter::fp;
using namespace arbiter::fp::vertex_shader;

constexpr bool hasName(const Symbol &symbol) {
  return symbol.from == From::State || (symbol.from == From::Attribute &&
                                        symbol.attributes[0].kind != ir::AttributeKind::Generic);
}

GLenum storageOf(From from) {
  switch (from) {
  case From::Local:
    return GL_LOCAL_EXT;
  case From::Constant:
    return GL_LOCAL_CONSTANT_EXT;
  case From::Invariant:
    return GL_INVARIANT_EXT;
  default:
    return GL_VARIANT_EXT;
  }
}

} // namespace

Issued::Issued(const testing::RandomVertexShader &made) : m_made(made) {
  for (const testing::SymbolValue &value : made.values) {
    std::array<GLfloat, 16> numbers{};
    std::copy(value.begin(), value.end(), numbers.begin());
    m_values.push_back(numbers);
  }
  m_shader = glGenVertexShadersEXT(1);
  glBindVertexShaderEXT(m_shader);
  generate();
  define();
}

Issued::~Issued() { glDeleteVertexShaderEXT(m_shader); }

bool Issued::isVariant(std::size_t symbol) const {
  const Symbol &of = m_made.shader.symbols[symbol];
  return of.from == From::Attribute && !hasName(of);
}

GLuint Issued::bindState(const Symbol &symbol) const {
  const ir::StateRef &state = symbol.state;
  switch (state.item) {
  case ir::StateItem::MatrixMvp:
    return glBindParameterEXT(GL_MVP_MATRIX_EXT);
  case ir::StateItem::MatrixTexture:
    return glBindTextureUnitParameterEXT(GL_TEXTURE0 + state.index, GL_TEXTURE_MATRIX);
  case ir::StateItem::LightDiffuse:
    return glBindLightParameterEXT(GL_LIGHT0 + state.index, GL_DIFFUSE);
  case ir::StateItem::LightAttenuation:
    return glBindLightParameterEXT(GL_LIGHT0 + state.index, GL_LINEAR_ATTENUATION);
  default:
    return glBindParameterEXT(GL_FOG_DENSITY);
  }
}

GLuint Issued::nameOf(const Symbol &symbol) const {
  if (symbol.from == From::State)
    return bindState(symbol);
  switch (symbol.attributes[0].kind) {
  case ir::AttributeKind::Position:
    return glBindParameterEXT(GL_CURRENT_VERTEX_EXT);
  case ir::AttributeKind::Normal:
    return glBindParameterEXT(GL_CURRENT_NORMAL);
  case ir::AttributeKind::ColorPrimary:
    return glBindParameterEXT(GL_CURRENT_COLOR);
  default:
    return glBindTextureUnitParameterEXT(GL_TEXTURE0 + symbol.attributes[0].index,
                                         GL_CURRENT_TEXTURE_COORDS);
  }
}

void Issued::generate() {
  for (const Symbol &symbol : m_made.shader.symbols) {
    if (hasName(symbol)) {
      m_names.push_back(nameOf(symbol));
    } else if (m_names.size() == symbol.blockFirst) {
      m_names.push_back(glGenSymbolsEXT(GL_SCALAR_EXT + GLenum(symbol.type), storageOf(symbol.from),
                                        GL_FULL_RANGE_EXT, symbol.blockCount));
    } else {
      m_names.push_back(m_names.back() + 1);
    }
  }
}

GLuint Issued::nameOf(const Result &result) const {
  switch (result.place) {
  case Place::Position:
    return GL_OUTPUT_VERTEX_EXT;
  case Place::Color:
    return GL_OUTPUT_COLOR0_EXT + result.index;
  case Place::TexCoord:
    return GL_OUTPUT_TEXTURE_COORD0_EXT + result.index;
  case Place::Fog:
    return GL_OUTPUT_FOG_EXT;
  case Place::Local:
    break;
  }
  return m_names[result.index];
}

void Issued::issue(const Operation &operation) const {
  const GLuint result = nameOf(operation.result);
  const GLuint a[] = {m_names[operation.arguments[0]], m_names[operation.arguments[1]],
                      m_names[operation.arguments[2]]};
  const auto take = [&](std::size_t i) { return GL_X_EXT + GLenum(operation.takes[i]); };
  const auto writes = [&](unsigned i) {
    return GLenum((operation.mask >> i & 1u) != 0 ? GL_TRUE : GL_FALSE);
  };
  const GLenum op = GL_OP_INDEX_EXT + GLenum(operation.op);
  switch (operation.op) {
  case Op::Swizzle:
    return glSwizzleEXT(result, a[0], take(0), take(1), take(2), take(3));
  case Op::WriteMask:
    return glWriteMaskEXT(result, a[0], writes(0), writes(1), writes(2), writes(3));
  case Op::InsertComponent:
    return glInsertComponentEXT(result, a[0], operation.component);
  case Op::ExtractComponent:
    return glExtractComponentEXT(result, a[0], operation.component);
  default:
    break;
  }
  switch (argumentCount(operation.op)) {
  case 1:
    return glShaderOp1EXT(op, result, a[0]);
  case 2:
    return glShaderOp2EXT(op, result, a[0], a[1]);
  default:
    return glShaderOp3EXT(op, result, a[0], a[1], a[2]);
  }
}

void Issued::define() const {
  glBeginVertexShaderEXT();
  for (std::size_t i = 0; i < m_names.size(); ++i)
    if (m_made.shader.symbols[i].from == From::Constant)
      glSetLocalConstantEXT(m_names[i], GL_FLOAT, m_values[i].data());
  for (const Operation &operation : m_made.shader.code)
    issue(operation);
  glEndVertexShaderEXT();
}

void Issued::setState(const Symbol &symbol, const GLfloat *v) const {
  switch (symbol.state.item) {
  case ir::StateItem::MatrixMvp:
    glMatrixMode(GL_PROJECTION);
    return glLoadMatrixf(v);
  case ir::StateItem::MatrixTexture:
    glActiveTexture(GL_TEXTURE0 + symbol.state.index);
    glMatrixMode(GL_TEXTURE);
    glLoadMatrixf(v);
    return glActiveTexture(GL_TEXTURE0);
  case ir::StateItem::LightDiffuse:
    return glLightfv(GL_LIGHT0 + symbol.state.index, GL_DIFFUSE, v);
  case ir::StateItem::LightAttenuation:
    return glLightf(GL_LIGHT0 + symbol.state.index, GL_LINEAR_ATTENUATION, v[0]);
  default:
    return glFogf(GL_FOG_DENSITY, v[0]);
  }
}

void Issued::setAttribute(std::size_t symbol) {
  const Symbol &of = m_made.shader.symbols[symbol];
  const GLfloat *const v = m_values[symbol].data();
  switch (of.attributes[0].kind) {
  case ir::AttributeKind::Normal:
    return glNormal3fv(v);
  case ir::AttributeKind::ColorPrimary:
    return glColor4fv(v);
  case ir::AttributeKind::TexCoord:
    return glMultiTexCoord4fv(GL_TEXTURE0 + of.attributes[0].index, v);
  case ir::AttributeKind::Generic:
    if (m_arrays) {
      glVariantPointerEXT(m_names[symbol], GL_FLOAT, 0, v);
      return glEnableVariantClientStateEXT(m_names[symbol]);
    }
    glDisableVariantClientStateEXT(m_names[symbol]);
    return glVariantfvEXT(m_names[symbol], v);
  default:
    return;
  }
}

void Issued::setValues(bool arrays) {
  m_arrays = arrays;
  for (std::size_t i = 0; i < m_names.size(); ++i) {
    const Symbol &symbol = m_made.shader.symbols[i];
    if (symbol.from == From::State)
      setState(symbol, m_values[i].data());
    else if (symbol.from == From::Attribute)
      setAttribute(i);
    else if (symbol.from == From::Invariant)
      glSetInvariantEXT(m_names[i], GL_FLOAT, m_values[i].data());
  }
}

void Issued::draw() const {
  static constexpr GLfloat kVertex[] = {0, 0, 0, 1};
  if (m_arrays) {
    glVertexPointer(4, GL_FLOAT, 0, kVertex);
    glEnableClientState(GL_VERTEX_ARRAY);
    glDrawArrays(GL_POINTS, 0, 1);
    glDisableClientState(GL_VERTEX_ARRAY);
    return;
  }
  glBegin(GL_POINTS);
  glVertex4fv(kVertex);
  glEnd();
}

} // namespace vertex_shaders
