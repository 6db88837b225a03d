#include "fp_compiler/testing/generator.h"

namespace arbiter::fp::testing {

using namespace ir;

namespace {
class VertexGenerator : public Generator {
public:
  VertexGenerator(std::uint64_t seed, const RandomOptions &options)
      : Generator(Language::ArbVertex, seed, options) {}

  Program run() {
    m_builder.options().positionInvariant = m_options.options && m_random.chance(25);
    for (int i = 2 + m_random.below(5); i > 0; --i)
      newTemporary();
    for (int slot = 0; slot < 16; ++slot)
      m_generic[std::size_t(slot)] = m_random.chance(30);
    if (m_random.chance(45)) {
      declareArrays();
      if (!m_options.wild)
        loadAddress();
    }
    const int count = m_options.minInstructions +
                      m_random.below(m_options.maxInstructions - m_options.minInstructions + 1);
    for (int i = 0; i < count; ++i)
      statement();
    finish();
    return m_builder.take();
  }

private:
  struct Array {
    int index = 0;
    int rows = 0;
    Intervals ranges;
  };
  struct Address {
    Target target;
    int low = 0, high = -1; ///< values that it may have; none before the first ARL
  };

  // Operands ------------------------------------------------------------------------------------
  /// Returns a slot's attribute. A generic attribute and its conventional one exclude each other
  /// (table X.1).
  Source slotAttribute(int slot) {
    if (slot == 1 || slot == 6 || slot == 7 || m_generic[std::size_t(slot)])
      return m_builder.attribute(AttributeKind::Generic, slot);
    switch (slot) {
    case 0:
      return m_builder.attribute(AttributeKind::Position);
    case 2:
      return m_builder.attribute(AttributeKind::Normal);
    case 3:
      return m_builder.attribute(AttributeKind::ColorPrimary);
    case 4:
      return m_builder.attribute(AttributeKind::ColorSecondary);
    case 5:
      return m_builder.attribute(AttributeKind::FogCoord);
    default:
      return m_builder.attribute(AttributeKind::TexCoord, slot - 8);
    }
  }

  Picked attribute() override {
    const int slot = m_random.below(16);
    Picked result{slotAttribute(slot), {}};
    const Attribute &kind = m_builder.program().attributes[result.source.index];
    for (int i = 0; i < 4; ++i)
      result.ranges[std::size_t(i)] = vertexAttributeRange(kind, i);
    return result;
  }

  StateRef stateRef() override {
    StateRef ref;
    do
      ref = Generator::stateRef();
    while (ref.item == StateItem::TexEnvColor || ref.item == StateItem::DepthRange);
    return ref;
  }

  /// Declares an array of env rows, and one of all other rows. No row of state is in both, or twice
  /// in one (2.14.3.2).
  void declareArrays() {
    Intervals ranges;
    ranges.fill({InputRanges::kParameterLow, InputRanges::kParameterHigh});
    std::vector<Source> rows;
    const int first = m_random.below(8), count = 4 + m_random.below(5);
    rows.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i)
      rows.push_back(m_builder.env(first + i));
    m_arrays.push_back({m_builder.array(rows), count, ranges});
    if (m_random.chance(60)) {
      rows.clear();
      for (int i = 0; i < 4; ++i)
        rows.push_back(mixedRow(i));
      m_arrays.push_back({m_builder.array(rows), int(rows.size()), ranges});
    }
    // A host may have only one address register.
    for (int i = m_options.wild ? 1 + m_random.below(2) : 1; i > 0; --i)
      m_addresses.push_back({m_builder.address()});
  }

  Source mixedRow(int number) {
    const int kind = m_mixed < 0 ? m_mixed = m_random.below(4) : m_mixed;
    if (kind == 0 || (kind == 3 && number == 1))
      return m_builder.constant(m_random.real(-2, 2), float(number), m_random.real(-2, 2), 1);
    if (kind == 1 || (kind == 3 && number == 2))
      return m_builder.local(number * 2);
    StateRef ref;
    ref.item = kind == 2 ? StateItem::MatrixProgram : StateItem::MatrixMvp;
    ref.row = std::uint8_t(number);
    return m_builder.state(ref);
  }

  Picked parameter() override {
    if (m_random.chance(50))
      if (const auto element = arrayElement())
        return *element;
    return Generator::parameter();
  }

  std::optional<Picked> arrayElement() {
    if (m_arrays.empty())
      return {};
    const Array &array = m_arrays[std::size_t(m_random.below(int(m_arrays.size())))];
    const Address &address = m_addresses[std::size_t(m_random.below(int(m_addresses.size())))];
    int low = -64, high = 63;
    if (!m_options.wild || m_random.chance(70)) { // stays inside the array, whatever the address
      if (address.high < address.low)
        return {};
      low = -address.low;
      high = array.rows - 1 - address.high;
    }
    if (high < low)
      return {};
    const int offset = low + m_random.below(high - low + 1);
    return Picked{Builder::element(array.index, address.target, offset), array.ranges};
  }

  // Statements ----------------------------------------------------------------------------------
  bool saturates() const override { return false; }

  void statement() {
    const Opcode op = Opcode(m_random.below(kOpcodeCount));
    if (info(op).has(FragmentOnly))
      return arithmetic(Opcode::Mad);
    if (!m_arrays.empty() && (op == Opcode::Arl || m_random.chance(12)))
      return loadAddress();
    arithmetic(op == Opcode::Arl ? Opcode::Mul : op);
  }

  void loadAddress() {
    Address &address = m_addresses[std::size_t(m_random.below(int(m_addresses.size())))];
    const int low = m_random.below(4) - 1, count = 1 + m_random.below(3);
    const Picked scalar = scalarWithin(float(low) + 0.0625f, float(low + count) - 0.0625f);
    m_builder.op(Opcode::Arl, address.target, {scalar.source});
    address.low = low;
    address.high = low + count - 1;
  }

  /// Writes the position as the vertex has it, and one or two results in full. Wild programs write
  /// more, and under `unwritten` results are written in part.
  void finish() {
    if (!m_builder.options().positionInvariant)
      position();
    constexpr std::array kKinds = {OutputKind::FrontPrimary, OutputKind::FrontSecondary,
                                   OutputKind::FogCoord, OutputKind::TexCoord,
                                   OutputKind::TexCoord};
    for (int i = 1 + m_random.below(2); i > 0; --i) {
      const OutputKind kind = kKinds[std::size_t(m_random.below(int(kKinds.size())))];
      Target result = m_builder.result(kind, kind == OutputKind::TexCoord ? m_random.below(8) : 0);
      if (m_options.unwritten && m_random.chance(50))
        result.Destination::mask = std::uint8_t(1 + m_random.below(15));
      write(result);
    }
    if (!m_options.wild)
      return;
    constexpr std::array kMore = {OutputKind::BackPrimary, OutputKind::BackSecondary,
                                  OutputKind::PointSize, OutputKind::TexCoord};
    Target partly = m_builder.result(kMore[std::size_t(m_random.below(int(kMore.size())))], 0);
    partly.Destination::mask = std::uint8_t(1 + m_random.below(15));
    write(partly);
  }

  /// Writes the position. Under `unwritten` it is often missing, or lacks w, and then no vertex is
  /// inside.
  void position() {
    const bool whole = !m_options.unwritten || m_random.chance(60);
    if (!whole && m_random.chance(50))
      return;
    Target written = m_builder.result(OutputKind::Position);
    if (!whole)
      written.Destination::mask = std::uint8_t(1 + m_random.below(7));
    m_builder.op(Opcode::Mov, written, {slotAttribute(0)});
  }

  void write(const Target &target) {
    if (m_random.chance(50))
      m_builder.op(Opcode::Mov, target, {operand(false, false).source});
    else
      m_builder.op(
          Opcode::Mad, target,
          {operand(false, false).source, m_builder.constant(0.5f), operand(false, false).source});
  }

  std::array<bool, 16> m_generic = {};
  std::vector<Array> m_arrays;
  std::vector<Address> m_addresses;
  int m_mixed = -1; ///< the kind of rows in the second array
};
} // namespace

Program randomVertexProgram(std::uint64_t seed, const RandomOptions &options) {
  return VertexGenerator(seed, options).run();
}

} // namespace arbiter::fp::testing
