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

struct ProgramContext;

/// The state of NV_register_combiners and 2 that belongs to GL_TEXTURE_BIT (3.8.12.4), except
/// REGISTER_COMBINERS_NV, which is the enable of a target.
struct CombinerSettings {
  fp::combiners::State state;
  /// In [0,1], indexed by fp::combiners::globalConstant() and stageConstant().
  std::array<Vec4, fp::combiners::kConstants> constants{};
};

/// A context's register combiners. The attribute stack shares the settings, which are copied when
/// they next change.
class CombinerState {
public:
  /// The state that a draw's program was made for.
  struct Key {
    fp::combiners::State state;
    fp::combiners::Surroundings around;
    bool operator==(const Key &) const = default;
  };

  /// \param stages number of general combiner stages to offer, 2 to fp::combiners::kStages
  /// \param perStageConstants true if NV_register_combiners2 is offered
  /// \param units number of texture units that have a register
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

  /// Sets a part of the state. If that changes it, the next draw looks.
  template <typename Part, typename Value>
  void set(ProgramContext &context, Part part, const Value &value) {
    if (part(std::as_const(m_settings->state)) == value)
      return;
    part(writable().state) = value;
    changed(context);
  }
  /// Sets a constant. \param value components in [0,1]
  void setConstant(ProgramContext &context, int index, const Vec4 &value);

  /// Returns the settings for the attribute stack.
  [[nodiscard]] std::shared_ptr<const CombinerSettings> settings() const { return m_settings; }
  void restore(ProgramContext &context, const std::shared_ptr<const CombinerSettings> &settings);

  /// Returns the program for a key, whose state must be fp::combiners::essential(). It is made
  /// once.
  /// \param text the text of the application's state; the key holds the state of its replacement
  [[nodiscard]] std::shared_ptr<const CompiledProgram> programUnder(ProgramContext &context,
                                                                    const Key &key,
                                                                    const fp::GlslHost &host,
                                                                    const StateText *text);

  /// True if the effective program is one of combiners, made for `drawnUnder` (combiner_draw.h).
  bool effective = false;
  fp::combiners::Surroundings drawnUnder;

private:
  [[nodiscard]] CombinerSettings &writable();
  void changed(ProgramContext &context);

  int m_stages;
  int m_units;
  bool m_perStageConstants;
  /// Never null. Made by this class alone, which may change it while nothing else shares it.
  std::shared_ptr<CombinerSettings> m_settings;
  StatePrograms<Key> m_programs;
  NamedStatePrograms<Key> m_named;
};

/// Answers a Get of NV_register_combiners and 2, except colours, which have four values. Returns
/// false for other names, or if the context does not offer the extension.
[[nodiscard]] bool combinerValue(const ProgramContext &context, GLenum pname, GLint &value);

/// True if the context has register combiners and some texture may have depths. Combiners read
/// these otherwise than colours (table RC.2).
[[nodiscard]] bool mayCombineDepths(const ProgramContext &context);
/// True if draws depend on which of the bound textures have depths.
[[nodiscard]] bool followsDepths(const ProgramContext &context);

} // namespace arbiter::state
