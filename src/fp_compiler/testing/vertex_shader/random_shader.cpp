#include "fp_compiler/testing/vertex_shader/random_shader.h"

#include <cmath>
#include <initializer_list>

namespace arbiter::fp::testing {

namespace {

using namespace vertex_shader;

class Generator {
public:
  explicit Generator(Random &random) : m_random(random) {}

  RandomVertexShader run() {
    declare();
    begin();
    for (int i = 4 + m_random.below(20); i > 0; --i) {
      const std::size_t before = m_made.shader.code.size();
      operation();
      // Some results are undefined, such as logarithms of negative numbers. Drop the operation.
      if (!evaluateVertexShader(m_made.shader, m_made.values).defined)
        m_made.shader.code.resize(before);
    }
    // Copies locals to outputs, so that their values can be seen.
    for (int set = 0; set < kRandomTexCoords; ++set)
      if (m_random.chance(60))
        emit(Op::Mov, {Place::TexCoord, std::uint32_t(set)}, {any(DataType::Vector)});
    if (m_random.chance(60))
      emit(Op::Mov, {Place::Fog, 0}, {any(DataType::Scalar)});
    return std::move(m_made);
  }

private:
  using Ids = std::vector<std::uint32_t>;

  // --- Symbols ---

  SymbolValue value(DataType type) {
    SymbolValue numbers{};
    const std::size_t count = type == DataType::Scalar ? 1 : type == DataType::Vector ? 4 : 16;
    for (std::size_t i = 0; i < count; ++i)
      numbers[i] = double(m_random.real(-2.0f, 2.0f));
    return numbers;
  }

  /// Adds a block of symbols of one kind.
  void add(Symbol symbol, int count) {
    auto &symbols = m_made.shader.symbols;
    symbol.blockFirst = std::uint32_t(symbols.size());
    symbol.blockCount = std::uint32_t(count);
    for (int i = 0; i < count; ++i) {
      const SymbolValue numbers = symbol.from == From::Local ? SymbolValue{} : value(symbol.type);
      if (symbol.from == From::Constant)
        setConstant(symbol, numbers);
      if (symbol.from == From::Attribute && symbol.attributes[0].kind == ir::AttributeKind::Generic)
        for (int row = 0; row < rowCount(symbol.type); ++row)
          symbol.attributes[std::size_t(row)] = {ir::AttributeKind::Generic, m_attribute++};
      symbols.push_back(symbol);
      m_made.values.push_back(numbers);
    }
  }

  static void setConstant(Symbol &symbol, const SymbolValue &numbers) {
    if (symbol.type == DataType::Matrix) {
      for (std::size_t i = 0; i < 16; ++i)
        symbol.constant[i % 4][i / 4] = float(numbers[i]);
      return;
    }
    for (std::size_t i = 0; i < 4; ++i)
      symbol.constant[0][i] = float(numbers[i]);
  }

  void addAttribute(ir::AttributeKind kind, int index, double fourth) {
    Symbol symbol{.from = From::Attribute};
    symbol.attributes[0] = {kind, std::uint8_t(index)};
    symbol.isDirection = kind == ir::AttributeKind::Normal;
    add(symbol, 1);
    m_made.values.back()[3] = fourth;
  }

  void addState(DataType type, const ir::StateRef &state, int component = 0) {
    Symbol symbol{.type = type, .from = From::State};
    symbol.state = state;
    symbol.component = std::uint8_t(component);
    add(symbol, 1);
    if (type == DataType::Scalar) // attenuation and density cannot be negative
      m_made.values.back()[0] = std::abs(m_made.values.back()[0]);
  }

  void declare() {
    constexpr DataType kTypes[] = {DataType::Scalar, DataType::Vector, DataType::Matrix};
    addAttribute(ir::AttributeKind::Position, 0, 1.0);
    m_made.values.back() = {0.0, 0.0, 0.0, 1.0};
    addAttribute(ir::AttributeKind::ColorPrimary, 0, 0.25);
    addAttribute(ir::AttributeKind::Normal, 0, 0.0);
    addAttribute(ir::AttributeKind::TexCoord, 0, 0.5);
    addAttribute(ir::AttributeKind::TexCoord, 3, 0.75);
    addState(DataType::Matrix, {.item = ir::StateItem::MatrixMvp});
    addState(DataType::Matrix, {.item = ir::StateItem::MatrixTexture, .index = 1});
    addState(DataType::Vector, {.item = ir::StateItem::LightDiffuse, .index = 2});
    addState(DataType::Scalar, {.item = ir::StateItem::LightAttenuation, .index = 1}, 1);
    addState(DataType::Scalar, {.item = ir::StateItem::FogParams}, 0);
    for (const From from : {From::Local, From::Constant, From::Invariant})
      for (const DataType type : kTypes)
        add({.type = type, .from = from}, 1 + m_random.below(type == DataType::Matrix ? 3 : 5));
    // At most eleven of the fifteen generic attributes are used.
    Symbol variant{.from = From::Attribute};
    variant.attributes[0].kind = ir::AttributeKind::Generic;
    for (const DataType type : {DataType::Scalar, DataType::Vector, DataType::Matrix}) {
      variant.type = type;
      add(variant, type == DataType::Matrix ? 1 : 1 + m_random.below(3));
    }
    declareIndices();
  }

  /// Declares scalars that OP_INDEX reads; their whole part is the distance.
  void declareIndices() {
    for (const From from : {From::Constant, From::Invariant})
      for (const double number : {0.0, 0.75, 1.0, 1.5, -1.25, 2.0}) {
        add({.type = DataType::Scalar, .from = from}, 1);
        m_made.values.back()[0] = number;
        setConstant(m_made.shader.symbols.back(), m_made.values.back());
        m_indices.push_back(std::uint32_t(m_made.values.size()) - 1);
      }
  }

  // --- Operations ---

  void emit(Op op, Result result, std::initializer_list<std::uint32_t> arguments) {
    Operation operation{.op = op, .result = result};
    std::copy(arguments.begin(), arguments.end(), operation.arguments.begin());
    m_made.shader.code.push_back(operation);
  }

  Ids of(DataType type, bool localsAlone = false) const {
    Ids found;
    const auto &symbols = m_made.shader.symbols;
    for (std::size_t i = 0; i < symbols.size(); ++i)
      if (symbols[i].type == type && (!localsAlone || symbols[i].from == From::Local))
        found.push_back(std::uint32_t(i));
    return found;
  }
  std::uint32_t pick(const Ids &from) {
    return from[std::size_t(m_random.below(int(from.size())))];
  }
  /// Returns a symbol; half of the time a local, so that operations build on each other.
  std::uint32_t any(DataType type) { return pick(of(type, m_random.chance(50))); }

  Result result(DataType type) {
    if (type == DataType::Matrix || m_random.chance(70))
      return {Place::Local, pick(of(type, true))};
    if (type == DataType::Scalar)
      return {Place::Fog, 0};
    const int output = m_random.below(kRandomTexCoords + 2);
    return output < kRandomTexCoords
               ? Result{Place::TexCoord, std::uint32_t(output)}
               : Result{Place::Color, std::uint32_t(output - kRandomTexCoords)};
  }

  void begin() {
    emit(Op::Mov, {Place::Position, 0}, {0});
    for (int set = 0; set < kRandomTexCoords; ++set)
      emit(Op::Mov, {Place::TexCoord, std::uint32_t(set)}, {any(DataType::Vector)});
    for (std::uint32_t color = 0; color < 2; ++color)
      emit(Op::Mov, {Place::Color, color}, {any(DataType::Vector)});
    emit(Op::Mov, {Place::Fog, 0}, {any(DataType::Scalar)});
  }

  void operation() {
    const Op op = Op(m_random.below(int(Op::ExtractComponent) + 1));
    switch (op) {
    case Op::Index:
      return index();
    case Op::Swizzle:
    case Op::WriteMask:
      emit(op, result(DataType::Vector), {any(DataType::Vector)});
      for (Take &take : m_made.shader.code.back().takes)
        take = Take(m_random.below(int(Take::NegOne) + 1));
      m_made.shader.code.back().mask = std::uint8_t(m_random.below(16));
      return;
    case Op::InsertComponent:
    case Op::ExtractComponent:
      return moveComponent(op);
    default:
      return ofTable(op);
    }
  }

  void moveComponent(Op op) {
    const bool matrix = m_random.chance(40);
    const DataType part = matrix ? DataType::Vector : DataType::Scalar;
    const DataType whole = matrix ? DataType::Matrix : DataType::Vector;
    if (op == Op::InsertComponent)
      emit(op, result(whole), {any(part)});
    else
      emit(op, result(part), {any(whole)});
    m_made.shader.code.back().component = std::uint8_t(m_random.below(4));
  }

  void index() {
    const std::uint32_t by = pick(m_indices);
    const auto way = std::int64_t(m_made.values[by][0]);
    const DataType type = DataType(m_random.below(3));
    Ids bases;
    const auto &symbols = m_made.shader.symbols;
    for (const std::uint32_t id : of(type)) {
      const std::int64_t place = std::int64_t(id) + way - std::int64_t(symbols[id].blockFirst);
      if (place >= 0 && place < std::int64_t(symbols[id].blockCount))
        bases.push_back(id);
    }
    if (!bases.empty())
      emit(Op::Index, result(type), {by, pick(bases)});
  }

  /// Adds an operation with random types that are a row of the table.
  void ofTable(Op op) {
    for (;;) {
      const DataType to = DataType(m_random.below(2));
      DataType types[3];
      for (DataType &type : types)
        type = DataType(m_random.below(3));
      if (!isInTable(op, to, types))
        continue;
      const Result result_ = result(to);
      std::uint32_t arguments[3] = {};
      for (int i = 0; i < argumentCount(op); ++i)
        arguments[i] = any(types[i]);
      emit(op, result_, {arguments[0], arguments[1], arguments[2]});
      return;
    }
  }

  Random &m_random;
  RandomVertexShader m_made;
  Ids m_indices;
  std::uint8_t m_attribute = 1;
};

} // namespace

RandomVertexShader randomVertexShader(Random &random) { return Generator(random).run(); }

} // namespace arbiter::fp::testing
