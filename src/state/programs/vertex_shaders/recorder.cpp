#include "state/programs/vertex_shaders/recorder.h"

#include <algorithm>

namespace arbiter::state {

namespace {

using fp::vertex_shader::DataType;
using fp::vertex_shader::From;
using fp::vertex_shader::Op;
using fp::vertex_shader::Place;
using fp::vertex_shader::Result;
using fp::vertex_shader::Symbol;
using fp::vertex_shader::Take;
using Verdict = VertexShaderRecorder::Verdict;

// The enumerants are in the order of Op and of Take.
static_assert(GL_OP_MOV_EXT - GL_OP_INDEX_EXT + 1 == fp::vertex_shader::kShaderOps);
static_assert(GL_OP_CLAMP_EXT - GL_OP_INDEX_EXT == int(Op::Clamp));
static_assert(GL_OP_MULTIPLY_MATRIX_EXT - GL_OP_INDEX_EXT == int(Op::MultiplyMatrix));
static_assert(GL_NEGATIVE_ONE_EXT - GL_X_EXT == int(Take::NegOne));

constexpr bool isError(const Verdict &verdict) { return verdict.error != GL_NO_ERROR; }

} // namespace

std::optional<Result> VertexShaderRecorder::outputOf(GLuint name) const {
  switch (name) {
  case GL_OUTPUT_VERTEX_EXT:
    return Result{Place::Position, 0};
  case GL_OUTPUT_COLOR0_EXT:
  case GL_OUTPUT_COLOR1_EXT:
    return Result{Place::Color, name - GL_OUTPUT_COLOR0_EXT};
  case GL_OUTPUT_FOG_EXT:
    return Result{Place::Fog, 0};
  default:
    if (name < GL_OUTPUT_TEXTURE_COORD0_EXT || name > GL_OUTPUT_TEXTURE_COORD31_EXT)
      return std::nullopt;
    return Result{Place::TexCoord, name - GL_OUTPUT_TEXTURE_COORD0_EXT};
  }
}

std::optional<std::uint32_t> VertexShaderRecorder::numberOf(GLuint name) {
  if (const auto known = m_numbers.find(name); known != m_numbers.end())
    return known->second;
  const std::shared_ptr<VertexSymbol> symbol = m_table.find(name);
  if (!symbol)
    return std::nullopt;
  auto &symbols = m_recorded.shader.symbols;
  const auto first = std::uint32_t(symbols.size());
  for (GLuint i = 0; i < symbol->count; ++i) {
    std::shared_ptr<VertexSymbol> each = m_table.find(symbol->first + i);
    Symbol meaning = each->meaning;
    meaning.blockFirst = first;
    meaning.blockCount = symbol->count;
    m_numbers.emplace(symbol->first + i, first + i);
    symbols.push_back(meaning);
    m_recorded.symbols.push_back(std::move(each));
    m_recorded.used.push_back(false);
  }
  return first + (name - symbol->first);
}

Verdict VertexShaderRecorder::result(GLuint name, Result &result) {
  if (const std::optional<Result> output = outputOf(name)) {
    if (output->place == Place::TexCoord && output->index >= m_coordinateSets)
      return {GL_INVALID_VALUE, "a vertex shader's result: there is no such texture unit"};
    result = *output;
    return {};
  }
  const std::optional<std::uint32_t> symbol = numberOf(name);
  if (!symbol)
    return {GL_INVALID_VALUE, "a vertex shader's result: no symbol of that name"};
  if (m_recorded.shader.symbols[*symbol].from != From::Local)
    return {GL_INVALID_OPERATION, "a vertex shader's result is neither a local nor an output"};
  result = {Place::Local, *symbol};
  return {};
}

Verdict VertexShaderRecorder::argument(GLuint name, std::uint32_t &symbol) {
  if (outputOf(name))
    return {GL_INVALID_OPERATION, "a vertex shader's argument is an output"};
  const std::optional<std::uint32_t> found = numberOf(name);
  if (!found)
    return {GL_INVALID_VALUE, "a vertex shader's argument: no symbol of that name"};
  symbol = *found;
  return {};
}

void VertexShaderRecorder::add(const fp::vertex_shader::Operation &operation) {
  m_work += 1;
  if (operation.op == Op::Index)
    m_work += kWorkOfIndexed * m_recorded.shader.symbols[operation.arguments[1]].blockCount;
  if (m_work > kMaxWork) {
    m_recorded.tooLong = true;
    return;
  }
  if (operation.result.place == Place::Local)
    m_recorded.used[operation.result.index] = true;
  const int count = fp::vertex_shader::argumentCount(operation.op);
  for (int i = 0; i < count; ++i)
    m_recorded.used[operation.arguments[std::size_t(i)]] = true;
  // OP_INDEX may read any symbol of the block.
  if (operation.op == Op::Index) {
    const Symbol &base = m_recorded.shader.symbols[operation.arguments[1]];
    std::fill_n(m_recorded.used.begin() + base.blockFirst, base.blockCount, true);
  }
  m_recorded.shader.code.push_back(operation);
}

Verdict VertexShaderRecorder::operation(GLenum op, GLuint resultName, int count,
                                        const std::array<GLuint, 3> &arguments) {
  if (op < GL_OP_INDEX_EXT || op > GL_OP_MOV_EXT)
    return {GL_INVALID_ENUM, "ShaderOp: op"};
  fp::vertex_shader::Operation operation{.op = Op(op - GL_OP_INDEX_EXT)};
  if (fp::vertex_shader::argumentCount(operation.op) != count)
    return {GL_INVALID_OPERATION, "ShaderOp: the operation has another number of arguments"};
  if (const Verdict verdict = result(resultName, operation.result); isError(verdict))
    return verdict;
  std::array<DataType, 3> types{};
  for (std::size_t i = 0; i < std::size_t(count); ++i) {
    if (const Verdict verdict = argument(arguments[i], operation.arguments[i]); isError(verdict))
      return verdict;
    types[i] = typeOf(operation.arguments[i]);
  }
  if (!fp::vertex_shader::isInTable(operation.op, typeOf(operation.result), types.data()))
    return {GL_INVALID_OPERATION, "ShaderOp: the types are not in the table of operations"};
  add(operation);
  return {};
}

Verdict VertexShaderRecorder::vectors(GLuint resultName, GLuint in,
                                      fp::vertex_shader::Operation &operation) {
  if (const Verdict verdict = result(resultName, operation.result); isError(verdict))
    return verdict;
  if (const Verdict verdict = argument(in, operation.arguments[0]); isError(verdict))
    return verdict;
  if (typeOf(operation.result) != DataType::Vector ||
      typeOf(operation.arguments[0]) != DataType::Vector)
    return {GL_INVALID_OPERATION, "Swizzle or WriteMask of what is no vector"};
  return {};
}

Verdict VertexShaderRecorder::swizzle(GLuint resultName, GLuint in,
                                      const std::array<GLenum, 4> &takes) {
  fp::vertex_shader::Operation operation{.op = Op::Swizzle};
  for (std::size_t i = 0; i < takes.size(); ++i) {
    if (takes[i] < GL_X_EXT || takes[i] > GL_NEGATIVE_ONE_EXT)
      return {GL_INVALID_ENUM, "Swizzle: a component"};
    operation.takes[i] = Take(takes[i] - GL_X_EXT);
  }
  const Verdict verdict = vectors(resultName, in, operation);
  if (!isError(verdict))
    add(operation);
  return verdict;
}

Verdict VertexShaderRecorder::writeMask(GLuint resultName, GLuint in,
                                        const std::array<GLenum, 4> &writes) {
  fp::vertex_shader::Operation operation{.op = Op::WriteMask, .mask = 0};
  for (std::size_t i = 0; i < writes.size(); ++i) {
    if (writes[i] != GL_TRUE && writes[i] != GL_FALSE)
      return {GL_INVALID_ENUM, "WriteMask: neither TRUE nor FALSE"};
    operation.mask |= std::uint8_t(writes[i] << i);
  }
  const Verdict verdict = vectors(resultName, in, operation);
  if (!isError(verdict))
    add(operation);
  return verdict;
}

Verdict VertexShaderRecorder::move(Op op, GLuint resultName, GLuint source, GLuint number) {
  if (number > 3)
    return {GL_INVALID_VALUE, "InsertComponent or ExtractComponent: the number is above 3"};
  fp::vertex_shader::Operation operation{.op = op, .component = std::uint8_t(number)};
  if (const Verdict verdict = result(resultName, operation.result); isError(verdict))
    return verdict;
  if (const Verdict verdict = argument(source, operation.arguments[0]); isError(verdict))
    return verdict;
  const bool inserts = op == Op::InsertComponent;
  const DataType to = typeOf(operation.result), from = typeOf(operation.arguments[0]);
  const DataType whole = inserts ? to : from, part = inserts ? from : to;
  if (!(whole == DataType::Vector && part == DataType::Scalar) &&
      !(whole == DataType::Matrix && part == DataType::Vector))
    return {GL_INVALID_OPERATION, "InsertComponent or ExtractComponent: the types"};
  add(operation);
  return {};
}

Verdict VertexShaderRecorder::insert(GLuint resultName, GLuint source, GLuint number) {
  return move(Op::InsertComponent, resultName, source, number);
}

Verdict VertexShaderRecorder::extract(GLuint resultName, GLuint source, GLuint number) {
  return move(Op::ExtractComponent, resultName, source, number);
}

Verdict VertexShaderRecorder::setConstant(GLuint name) {
  if (m_constants.insert(name).second)
    return {};
  return {GL_INVALID_OPERATION, "SetLocalConstant: it was set before in this shader"};
}

VertexShaderRecorder::Recorded VertexShaderRecorder::end() {
  for (std::size_t i = 0; i < m_recorded.symbols.size(); ++i)
    for (std::size_t row = 0; row < 4; ++row)
      m_recorded.shader.symbols[i].constant[row] = m_recorded.symbols[i]->value[row].load();
  return std::move(m_recorded);
}

} // namespace arbiter::state
