#pragma once
#include <optional>
#include <vector>

#include "fp_compiler/ir/builder.h"
#include "state/raster_draw/fixed_function/fixed_vertex.h"

/// Writes the program of one key. It is a part of fixed_vertex.cpp, which calls its functions in
/// turn.
namespace arbiter::state {

class FixedWriter {
public:
  using Builder = fp::ir::Builder;
  using Opcode = fp::ir::Opcode;
  using Source = fp::ir::Source;
  using Target = fp::ir::Target;
  using StateItem = fp::ir::StateItem;
  using MatrixModifier = fp::ir::MatrixModifier;

  explicit FixedWriter(const FixedVertexKey &key)
      : m_key(key), m_builder(fp::ir::Language::ArbVertex) {}

  void position();
  void colors();
  void texCoords();
  void fogCoord();
  void pointSize();
  [[nodiscard]] fp::ir::Program take() { return m_builder.take(); }

private:
  using Kind = fp::ir::AttributeKind;

  void op(Opcode opcode, const Target &to, std::initializer_list<Source> sources) {
    m_builder.op(opcode, to, sources);
  }
  [[nodiscard]] Target temporary() { return m_builder.temporary(); }
  [[nodiscard]] Source attribute(Kind kind, int index = 0) {
    return m_builder.attribute(kind, index);
  }
  /// Returns a source; each parameter is declared once.
  [[nodiscard]] Source constant(float x, float y, float z, float w);
  [[nodiscard]] Source state(const fp::ir::StateRef &ref);
  [[nodiscard]] Source state(StateItem item, int index = 0, int row = 0, bool back = false);
  [[nodiscard]] Source matrixRow(StateItem item, int index, int row,
                                 MatrixModifier modifier = MatrixModifier::Plain);

  // Values that several parts need; computed at the first call.
  [[nodiscard]] Source eye();     ///< the vertex in eye coordinates
  [[nodiscard]] Source eyeUnit(); ///< vector from the eye to the vertex, normalized
  [[nodiscard]] Source normal();  ///< in eye coordinates, rescaled or normalized as the state says
  [[nodiscard]] Source reflected(); ///< eyeUnit() reflected about normal()
  /// Returns a vector normalized; a zero vector stays zero.
  [[nodiscard]] Source normalized(const Source &vector);
  [[nodiscard]] Source square(const Source &vector); ///< in x; never 0

  /// Writes a colour, clamped as the key says.
  void storeColor(fp::ir::OutputKind kind, const Source &value);
  void unlit();
  [[nodiscard]] Source sphere(); ///< (s, t)
  [[nodiscard]] Source generated(int unit);

  // Lighting: fixed_lighting.cpp.
  struct Side;
  struct Ray;
  void lit();
  [[nodiscard]] Source materialPart(const Side &side, std::uint8_t part);
  [[nodiscard]] Source product(const Side &side, std::uint8_t part, int light);
  void startSums(Side &side);
  [[nodiscard]] Source attenuation(int light, const Source &distance);
  [[nodiscard]] Source spot(int light, const Source &direction);
  [[nodiscard]] Ray ray(int light);
  void addLight(const Side &side, const Ray &ray);
  void storeSums(const Side &side);

  const FixedVertexKey &m_key;
  Builder m_builder;
  struct StateRow {
    fp::ir::StateRef ref;
    Source source;
  };
  struct ConstantRow {
    fp::ir::Vec4 value;
    Source source;
  };
  std::vector<StateRow> m_states;
  std::vector<ConstantRow> m_constants;
  std::optional<Source> m_eye, m_eyeUnit, m_normal, m_reflected, m_sphere;
};

} // namespace arbiter::state
