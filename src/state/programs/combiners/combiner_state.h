#pragma once
#include <array>
#include <memory>
#include <utility>

#include <GL/gl.h>

#include "fp_compiler/combiners/state.h"
#include "fp_compiler/emit.h"
#include "state/objects/program_object.h"
#include "state/programs/variants/state_program.h"

namespace arbiter::state {

class Context;

/// What NV_register_combiners and 2 keep in GL_TEXTURE_BIT (3.8.12.4), but for
/// REGISTER_COMBINERS_NV, which is a target's enable.
struct CombinerSettings {
  fp::combiners::State state;
  /// In [0,1], by fp::combiners::globalConstant() and stageConstant().
  std::array<Vec4, fp::combiners::kConstants> constants{};
};

/// A context's register combiners. The settings are shared with the attribute stack and copied when
/// they are next changed.
class CombinerState {
public:
  /// What a draw's program was made for.
  struct Key {
    fp::combiners::State state;
    fp::combiners::Surroundings around;
    bool operator==(const Key &) const = default;
  };

  /// \param stages general combiner stages that are offered, 2 to fp::combiners::kStages
  /// \param perStageConstants NV_register_combiners2 is offered
  /// \param units texture units that have a register
  CombinerState(int stages, bool perStageConstants, int units)
      : m_stages(stages), m_units(units), m_perStageConstants(perStageConstants),
        m_settings(std::make_shared<CombinerSettings>()) {}

  [[nodiscard]] int stages() const { return m_stages; }
  [[nodiscard]] int units() const { return m_units; }
  [[nodiscard]] bool hasPerStageConstants() const { return m_perStageConstants; }
  [[nodiscard]] const fp::combiners::State &state() const { return m_settings->state; }
  [[nodiscard]] const Vec4 &constant(int index) const {
    return m_settings->constants[std::size_t(index)];
  }

  /// A part of the state changes to `value`; the next draw looks, unless it is that already.
  template <typename Part, typename Value>
  void set(Context &context, Part part, const Value &value) {
    if (part(std::as_const(m_settings->state)) == value)
      return;
    part(writable().state) = value;
    changed(context);
  }
  /// \param value components in [0,1]
  void setConstant(Context &context, int index, const Vec4 &value);

  /// For the attribute stack.
  [[nodiscard]] std::shared_ptr<const CombinerSettings> settings() const { return m_settings; }
  void restore(Context &context, const std::shared_ptr<const CombinerSettings> &settings);

  /// The program for a key, whose state is fp::combiners::essential(); made once for each.
  /// \param text of the application's state; the key's is that of what stands in for it
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  programUnder(Context &context, const Key &key, const fp::GlslHost &host, const StateText *text);

  /// The effective program is of combiners, made for `drawnUnder` (combiner_draw.h).
  bool effective = false;
  fp::combiners::Surroundings drawnUnder;

private:
  [[nodiscard]] CombinerSettings &writable();
  void changed(Context &context);

  int m_stages;
  int m_units;
  bool m_perStageConstants;
  /// Never null. Made by this class alone, as what may be changed while nothing else has it.
  std::shared_ptr<CombinerSettings> m_settings;
  StatePrograms<Key> m_programs;
  NamedStatePrograms<Key> m_named;
};

/// True, with it, for a value of Get that NV_register_combiners and 2 have, but for the colours,
/// which are four. False where the context does not offer the extension.
[[nodiscard]] bool combinerValue(const Context &context, GLenum pname, GLint &value);

/// Some texture may be of depths, where the context has register combiners: what those read of it
/// is not a colour (table RC.2).
[[nodiscard]] bool mayCombineDepths(const Context &context);
/// Draws depend on which of the bound textures are.
[[nodiscard]] bool followsDepths(const Context &context);

} // namespace arbiter::state
