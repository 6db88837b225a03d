#pragma once
#include <array>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/texture_shader/lower.h"
#include "state/objects/program_object.h"
#include "state/programs/variants/state_program.h"

namespace arbiter::state {

struct ProgramContext;

/// The state of NV_texture_shader, 2 and 3 that belongs to GL_TEXTURE_BIT (3.8.13.3), except
/// TEXTURE_SHADER_NV, which is the enable of a target.
struct TextureShaderSettings {
  std::array<fp::texture_shader::Stage, fp::texture_shader::kUnits> stages{};
  /// For each unit, indexed by fp::texture_shader::Row: matrix, scale and bias, eye vector, bump
  /// matrix.
  std::array<std::array<Vec4, fp::texture_shader::kRows>, fp::texture_shader::kUnits> rows;
  std::uint8_t environmentNone = 0; ///< units whose TEXTURE_ENV_MODE is NONE, one bit for each
  /// ATI_envmap_bumpmap: units whose COMBINE_RGB is BUMP_ENVMAP_ATI, and each unit's
  /// BUMP_TARGET_ATI.
  std::uint8_t bumps = 0;
  std::array<std::uint8_t, fp::texture_shader::kUnits> bumpTargets{};

  TextureShaderSettings() {
    rows.fill({{{1, 0, 0, 1}, {1, 0, 0, 0}, {0, 0, -1, 0}, {1, 0, 0, 1}}});
  }
};

/// The scales and biases of HILO components and texture offset groups (GL_PIXEL_MODE_BIT), in the
/// order of their enumerants: HI, LO, DS, DT, MAGNITUDE, VIBRANCE.
struct ComponentTransfers {
  std::array<GLfloat, 6> scales = {1, 1, 1, 1, 1, 1};
  std::array<GLfloat, 6> biases{};
};

/// A context's texture shaders, and other texturing state of GL_TEXTURE_BIT that the layer keeps.
/// The attribute stack shares the settings, which are copied when they next change.
class TextureShaderState {
public:
  /// \param extensions how many of the three are offered; 0: none, but ATI_envmap_bumpmap or
  /// NV_point_sprite, which are drawn by programs of conventional texturing
  /// \param units number of texture units
  TextureShaderState(int extensions, int units)
      : m_extensions(extensions), m_units(units),
        m_settings(std::make_shared<TextureShaderSettings>()) {}

  [[nodiscard]] int extensions() const { return m_extensions; }
  [[nodiscard]] int units() const { return m_units; }
  [[nodiscard]] const TextureShaderSettings &now() const { return *m_settings; }

  /// Sets a part of a unit's stage, or environmentNone. If that changes it, the next draw looks.
  template <typename Part, typename Value>
  void set(ProgramContext &context, Part part, const Value &value) {
    if (part(std::as_const(*m_settings)) == value)
      return;
    part(writable()) = value;
    changed(context);
  }
  void setRow(ProgramContext &context, int unit, fp::texture_shader::Row row, const Vec4 &value);

  /// Sets all env parameters of the target from these settings and from register combiners'.
  void setParameters(ProgramContext &context);

  /// Returns the settings for the attribute stack.
  [[nodiscard]] std::shared_ptr<const TextureShaderSettings> settings() const { return m_settings; }
  void restore(ProgramContext &context,
               const std::shared_ptr<const TextureShaderSettings> &settings);

  /// Returns the program for a key, which is made once.
  /// \param text see CombinerState::programUnder()
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  programUnder(ProgramContext &context, const fp::texture_shader::Key &key,
               const fp::GlslHost &host, const StateText *text);

  ComponentTransfers transfers;

  /// True if TEXTURE_SHADER_NV is enabled, but a client of control has switched off its program.
  bool switchedOff = false;

  /// True once a stage was set, or an image got one of these formats. Lists are then cut where
  /// textures change.
  bool used = false;

  /// True if the effective program is one of texture shaders, made for `drawnUnder`. Textures may
  /// change without a command that the layer sees (texture_shader_draw.h).
  bool effective = false;
  fp::texture_shader::State drawnUnder;
  /// The base and the signedness of the host's internal formats, as far as known.
  std::unordered_map<GLint, fp::texture_shader::Texture> formats;
  /// Textures whose pyramids or faces were found complete, with the values that decided it: name,
  /// target, base level, last level, width, height, internal format.
  using Whole = std::array<GLint, 7>;
  std::vector<Whole> wholeTextures;

private:
  [[nodiscard]] TextureShaderSettings &writable();
  void changed(ProgramContext &context);

  int m_extensions;
  int m_units;
  /// Never null. Made by this class alone, which may change it while nothing else shares it.
  std::shared_ptr<TextureShaderSettings> m_settings;
  StatePrograms<fp::texture_shader::Key> m_programs;
  NamedStatePrograms<fp::texture_shader::Key> m_named;
};

/// True if an extension is offered that keeps its state here. Those other than texture shaders only
/// begin to do so with their first command.
[[nodiscard]] bool mayKeepTextures(const ProgramContext &context);
/// Returns the context's TextureShaderState, and creates it if necessary. Requires
/// mayKeepTextures().
TextureShaderState &keepTextures(ProgramContext &context);
/// True if NV_texture_shader is offered.
[[nodiscard]] bool hasTextureShaders(const ProgramContext &context);
/// True if ATI_envmap_bumpmap is the layer's.
[[nodiscard]] bool hasBumpMaps(const ProgramContext &context);

/// True if draws depend on the bound textures, because their consistency selects programs.
[[nodiscard]] bool followsTextures(const ProgramContext &context);

/// Answers a Get of TEXTURE_SHADER_NV. Returns false if the context does not offer it.
[[nodiscard]] bool textureShaderValue(const ProgramContext &context, GLint &value);

} // namespace arbiter::state
