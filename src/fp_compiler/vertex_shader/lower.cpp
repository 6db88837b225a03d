#include "fp_compiler/vertex_shader/lower.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/vertex_shader/symbols.h"

namespace arbiter::fp::vertex_shader {

namespace {

class Lowering {
public:
  explicit Lowering(const Shader &shader) : m_shader(shader), m_symbols(m_builder, shader) {}

  Lowered run() {
    for (const Operation &operation : m_shader.code) {
      m_scratchUsed = 0;
      lower(operation);
    }
    Lowered lowered;
    lowered.program = m_builder.take();
    lowered.env = m_symbols.takeEnv();
    return lowered;
  }

private:
  void lower(const Operation &operation) {
    switch (operation.op) {
    case Op::Index:
      return index(operation);
    case Op::MultiplyMatrix:
      return multiplyMatrix(operation);
    case Op::Swizzle:
      return swizzle(operation);
    case Op::WriteMask:
      if (operation.mask != 0)
        m_builder.op(Opcode::Mov, withMask(target(operation.result), operation.mask),
                     {argument(operation, 0)});
      return;
    case Op::InsertComponent:
      return insert(operation);
    case Op::ExtractComponent:
      return extract(operation);
    default:
      arithmetic(operation, target(operation.result));
    }
  }

  // --- Registers ---

  Target target(const Result &result, int row = 0) {
    switch (result.place) {
    case Place::Position:
      return m_builder.result(ir::OutputKind::Position);
    case Place::Color:
      return m_builder.result(result.index == 0 ? ir::OutputKind::FrontPrimary
                                                : ir::OutputKind::FrontSecondary);
    case Place::TexCoord:
      return m_builder.result(ir::OutputKind::TexCoord, int(result.index));
    case Place::Fog:
      return m_builder.result(ir::OutputKind::FogCoord).mask("x");
    case Place::Local:
      break;
    }
    const Target local = m_symbols.local(result.index, row);
    return m_symbols[result.index].type == DataType::Scalar ? local.mask("x") : local;
  }

  Source argument(const Operation &operation, std::size_t at, int row = 0) {
    return m_symbols.read(operation.arguments[at], row);
  }

  /// Returns a temporary for use within one operation.
  Target scratch() {
    if (m_scratchUsed == m_scratch.size())
      m_scratch.push_back(m_builder.temporary("t" + std::to_string(m_scratchUsed)));
    return m_scratch[m_scratchUsed++];
  }

  Source step(Opcode op, std::initializer_list<Source> sources) {
    const Target to = scratch();
    m_builder.op(op, to, sources);
    return to.read();
  }

  // --- Operations ---

  void arithmetic(const Operation &operation, const Target &to) {
    const auto a = [&](std::size_t at) { return argument(operation, at); };
    switch (operation.op) {
    case Op::Negate:
      m_builder.op(Opcode::Mov, to, {-a(0)});
      return;
    case Op::Dot3: // r[3] is unchanged
      m_builder.op(Opcode::Dp3, withMask(to, to.Destination::mask & 7), {a(0), a(1)});
      return;
    case Op::Dot4:
      m_builder.op(Opcode::Dp4, to, {a(0), a(1)});
      return;
    case Op::Mul:
      m_builder.op(Opcode::Mul, to, {a(0), a(1)});
      return;
    case Op::Add:
      m_builder.op(Opcode::Add, to, {a(0), a(1)});
      return;
    case Op::Sub:
      m_builder.op(Opcode::Sub, to, {a(0), a(1)});
      return;
    case Op::Madd:
      m_builder.op(Opcode::Mad, to, {a(0), a(1), a(2)});
      return;
    case Op::Frac:
      m_builder.op(Opcode::Frc, to, {a(0)});
      return;
    case Op::Max:
      m_builder.op(Opcode::Max, to, {a(0), a(1)});
      return;
    case Op::Min:
      m_builder.op(Opcode::Min, to, {a(0), a(1)});
      return;
    case Op::SetGe:
      m_builder.op(Opcode::Sge, to, {a(0), a(1)});
      return;
    case Op::SetLt:
      m_builder.op(Opcode::Slt, to, {a(0), a(1)});
      return;
    case Op::Clamp:
      return clamp(operation, to);
    case Op::Floor:
      m_builder.op(Opcode::Flr, to, {a(0)});
      return;
    case Op::Round:
      m_builder.op(Opcode::Flr, to, {step(Opcode::Add, {a(0), m_symbols.literal(0.5f)})});
      return;
    case Op::ExpBase2:
      m_builder.op(Opcode::Ex2, to, {a(0)});
      return;
    case Op::LogBase2:
      m_builder.op(Opcode::Lg2, to, {a(0)});
      return;
    case Op::Power:
      return power(operation, to);
    case Op::Recip:
      m_builder.op(Opcode::Rcp, to, {a(0)});
      return;
    case Op::RecipSqrt:
      m_builder.op(Opcode::Rsq, to, {a(0)});
      return;
    case Op::CrossProduct:
      m_builder.op(Opcode::Xpd, to.mask("xyz"), {a(0), a(1)});
      m_builder.op(Opcode::Mov, to.mask("w"), {m_symbols.literal(1.0f)});
      return;
    default:
      m_builder.op(Opcode::Mov, to, {a(0)});
    }
  }

  /// True if both bounds are constants and in order.
  bool boundsAreInOrder(const Operation &operation) const {
    const Symbol &low = m_symbols[operation.arguments[1]],
                 &high = m_symbols[operation.arguments[2]];
    if (low.from != From::Constant || high.from != From::Constant)
      return false;
    const auto component = [](const Symbol &of, std::size_t i) {
      return of.constant[0][of.type == DataType::Scalar ? 0 : i];
    };
    for (std::size_t i = 0; i < 4; ++i)
      if (!(component(low, i) <= component(high, i)))
        return false;
    return true;
  }

  /// Emits (a <= low) ? low : (a >= high) ? high : a, which also defines bounds that are not in
  /// order.
  void clamp(const Operation &operation, const Target &to) {
    const Source value = argument(operation, 0), low = argument(operation, 1),
                 high = argument(operation, 2);
    const Source raised = step(Opcode::Max, {value, low});
    if (boundsAreInOrder(operation)) {
      m_builder.op(Opcode::Min, to, {raised, high});
      return;
    }
    // Products with 0 and 1 select exactly, as long as the bounds are finite.
    const Source inside = step(Opcode::Min, {raised, high});
    const Source above = step(Opcode::Slt, {low, value});
    const Source least = step(Opcode::Mul, {step(Opcode::Sge, {low, value}), low});
    m_builder.op(Opcode::Mad, to, {above, inside, least});
  }

  /// Emits a1 ^ a2. A negative base gives the power of its absolute value, with the sign for a
  /// whole exponent. POW itself does not take negative numbers.
  void power(const Operation &operation, const Target &to) {
    const Source base = argument(operation, 0), exponent = argument(operation, 1);
    const Source zero = m_symbols.literal(0.0f);
    // 0^0 must be 1. Hosts that multiply with a logarithm would give NaN.
    const Source exponentIsZero = step(Opcode::Sge, {-step(Opcode::Abs, {exponent}), zero});
    const Source size = step(Opcode::Max, {step(Opcode::Abs, {base}), exponentIsZero});
    const Source negative = step(Opcode::Slt, {base, zero});
    const Source half = step(Opcode::Mul, {exponent, m_symbols.literal(0.5f)});
    const Source odd = step(Opcode::Frc, {half}); // 0.5 if the exponent is odd
    const Source turns = step(Opcode::Mul, {negative, odd});
    const Source sign =
        step(Opcode::Mad, {turns, m_symbols.literal(-4.0f), m_symbols.literal(1.0f)});
    const Target raised = scratch();
    m_builder.op(Opcode::Pow, raised, {size.swz("x"), exponent});
    m_builder.op(Opcode::Mul, to, {raised.read(), sign});
  }

  void multiplyMatrix(const Operation &operation) {
    const Result &result = operation.result;
    const bool overwrites = result.place == Place::Local && result.index == operation.arguments[1];
    const Target to = overwrites ? scratch() : target(result);
    const Source vector = argument(operation, 1);
    for (int row = 0; row < 4; ++row)
      m_builder.op(Opcode::Dp4, to.mask(kLetters[row]), {argument(operation, 0, row), vector});
    if (overwrites)
      m_builder.op(Opcode::Mov, target(result), {to.read()});
  }

  void swizzle(const Operation &operation) {
    constexpr const char kTaken[] = "xyzwxyzw011";
    std::string letters;
    std::uint8_t negate = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Take take = operation.takes[i];
      letters += kTaken[std::size_t(take)];
      if ((take >= Take::NegX && take <= Take::NegW) || take == Take::NegOne)
        negate |= std::uint8_t(1u << i);
    }
    m_builder.op(Opcode::Swz, target(operation.result),
                 {argument(operation, 0).swz(letters).negated(negate)});
  }

  void insert(const Operation &operation) {
    const bool ofMatrix = m_symbols[operation.arguments[0]].type == DataType::Vector;
    const Target to = ofMatrix ? target(operation.result, operation.component)
                               : target(operation.result).mask(kLetters[operation.component]);
    m_builder.op(Opcode::Mov, to, {argument(operation, 0)});
  }

  void extract(const Operation &operation) {
    const bool ofMatrix = m_symbols[operation.arguments[0]].type == DataType::Matrix;
    const Source from = ofMatrix ? argument(operation, 0, operation.component)
                                 : argument(operation, 0).swz(kLetters[operation.component]);
    m_builder.op(Opcode::Mov, target(operation.result), {from});
  }

  // --- OP_INDEX ---

  /// Returns the index into the second argument's block, rounded toward zero.
  Source placeOf(const Operation &operation) {
    const std::uint32_t base = operation.arguments[1];
    const Source value = argument(operation, 0);
    const Source whole = step(Opcode::Flr, {step(Opcode::Abs, {value})});
    const Source negative = step(Opcode::Slt, {value, m_symbols.literal(0.0f)});
    const Source sign =
        step(Opcode::Mad, {negative, m_symbols.literal(-2.0f), m_symbols.literal(1.0f)});
    const auto first = float(base - m_symbols[base].blockFirst);
    return step(Opcode::Mad, {whole, sign, m_symbols.literal(first)});
  }

  void index(const Operation &operation) {
    const std::uint32_t base = operation.arguments[1];
    const Symbol &symbol = m_symbols[base];
    if (symbol.blockCount == 1) {
      for (int row = 0; row < rowCount(symbol.type); ++row)
        m_builder.op(Opcode::Mov, target(operation.result, row), {argument(operation, 1, row)});
      return;
    }
    const Source place = placeOf(operation);
    if (Symbols::isParameter(symbol))
      indexParameters(operation, place);
    else
      indexRegisters(operation, place);
  }

  void indexParameters(const Operation &operation, const Source &place) {
    const Symbol &symbol = m_symbols[operation.arguments[1]];
    if (!m_address)
      m_address = m_builder.address();
    m_builder.op(Opcode::Arl, *m_address, {place.swz("x")});
    for (int row = 0; row < rowCount(symbol.type); ++row) {
      Source element = ir::Builder::element(arrayOf(symbol, row), *m_address);
      if (symbol.type == DataType::Scalar)
        element = element.swz("x");
      m_builder.op(Opcode::Mov, target(operation.result, row), {element});
    }
  }

  /// Returns an array with one row of each symbol in a block.
  int arrayOf(const Symbol &symbol, int row) {
    const auto [entry, isNew] = m_arrays.try_emplace({symbol.blockFirst, row}, 0);
    if (isNew) {
      std::vector<Source> rows;
      for (std::uint32_t i = 0; i < symbol.blockCount; ++i)
        rows.push_back(m_symbols.parameter(symbol.blockFirst + i, row));
      entry->second = m_builder.array(rows);
    }
    return entry->second;
  }

  /// Emits OP_INDEX on registers and attributes. They cannot be addressed at run time, so each is
  /// multiplied with one or zero.
  void indexRegisters(const Operation &operation, const Source &place) {
    const Symbol &symbol = m_symbols[operation.arguments[1]];
    const int rows = rowCount(symbol.type);
    std::vector<Target> sums;
    sums.reserve(std::size_t(rows));
    for (int row = 0; row < rows; ++row)
      sums.push_back(scratch());
    const Target chosen = scratch();
    for (std::uint32_t i = 0; i < symbol.blockCount; ++i) {
      m_builder.op(Opcode::Sub, chosen, {place, m_symbols.literal(float(i))});
      m_builder.op(Opcode::Abs, chosen, {chosen.read()});
      m_builder.op(Opcode::Slt, chosen, {chosen.read(), m_symbols.literal(0.5f)});
      for (int row = 0; row < rows; ++row) {
        const Target &sum = sums[std::size_t(row)];
        const Source value = m_symbols.read(symbol.blockFirst + i, row);
        if (i == 0)
          m_builder.op(Opcode::Mul, sum, {chosen.read(), value});
        else
          m_builder.op(Opcode::Mad, sum, {chosen.read(), value, sum.read()});
      }
    }
    for (int row = 0; row < rows; ++row)
      m_builder.op(Opcode::Mov, target(operation.result, row), {sums[std::size_t(row)].read()});
  }

  const Shader &m_shader;
  ir::Builder m_builder{ir::Language::ArbVertex};
  Symbols m_symbols;
  std::vector<Target> m_scratch;
  std::size_t m_scratchUsed = 0;
  std::optional<Target> m_address;
  std::map<std::pair<std::uint32_t, int>, int> m_arrays; ///< by block and row
};

} // namespace

Lowered lower(const Shader &shader) { return Lowering(shader).run(); }

} // namespace arbiter::fp::vertex_shader
