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

class Context;

/// What NV_texture_shader, 2 and 3 keep in GL_TEXTURE_BIT (3.8.13.3), but for TEXTURE_SHADER_NV,
/// which is a target's enable.
struct TextureShaderSettings {
  std::array<fp::texture_shader::Stage, fp::texture_shader::kUnits> stages{};
  /// Of each unit by fp::texture_shader::Row: matrix, scale and bias, eye vector, bump matrix.
  std::array<std::array<Vec4, fp::texture_shader::kRows>, fp::texture_shader::kUnits> rows;
  std::uint8_t environmentNone = 0; ///< units whose TEXTURE_ENV_MODE is NONE, one bit each
  /// ATI_envmap_bumpmap: units whose COMBINE_RGB is BUMP_ENVMAP_ATI, and BUMP_TARGET_ATI of each.
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

/// A context's texture shaders, and what else of texturing the layer keeps in GL_TEXTURE_BIT. The
/// settings are shared with the attribute stack and copied when they are next changed.
class TextureShaderState {
public:
  /// \param extensions the first of the three that are offered; 0: none, but ATI_envmap_bumpmap or
  ///                   NV_point_sprite, whose draws are programs of conventional texturing
  /// \param units texture units
  TextureShaderState(int extensions, int units)
      : m_extensions(extensions), m_units(units),
        m_settings(std::make_shared<TextureShaderSettings>()) {}

  [[nodiscard]] int extensions() const { return m_extensions; }
  [[nodiscard]] int units() const { return m_units; }
  [[nodiscard]] const TextureShaderSettings &now() const { return *m_settings; }

  /// A part of a unit's stage, or of environmentNone, changes to `value`; the next draw looks,
  /// unless it is that already.
  template <typename Part, typename Value>
  void set(Context &context, Part part, const Value &value) {
    if (part(std::as_const(*m_settings)) == value)
      return;
    part(writable()) = value;
    changed(context);
  }
  void setRow(Context &context, int unit, fp::texture_shader::Row row, const Vec4 &value);

  /// All of the target's env parameters are set from the settings, and from register combiners'.
  void setParameters(Context &context);

  /// For the attribute stack.
  [[nodiscard]] std::shared_ptr<const TextureShaderSettings> settings() const { return m_settings; }
  void restore(Context &context, const std::shared_ptr<const TextureShaderSettings> &settings);

  /// The program for a key; made once for each.
  /// \param text as of CombinerState::programUnder()
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  programUnder(Context &context, const fp::texture_shader::Key &key, const fp::GlslHost &host,
               const StateText *text);

  ComponentTransfers transfers;

  /// TEXTURE_SHADER_NV is enabled, and a client of control has switched off what is drawn with.
  bool switchedOff = false;

  /// A stage was set here once, or an image of their formats: lists are cut where textures change.
  bool used = false;

  /// The effective program is of texture shaders, made for `drawnUnder`; textures may change
  /// without a command that the layer sees (texture_shader_draw.h).
  bool effective = false;
  fp::texture_shader::State drawnUnder;
  /// What is known of the host's internal formats: of each its base and signedness.
  std::unordered_map<GLint, fp::texture_shader::Texture> formats;
  /// Textures whose pyramids or faces were found whole, by what that was decided of: name, target,
  /// base level, last level, width, height, internal format.
  using Whole = std::array<GLint, 7>;
  std::vector<Whole> wholeTextures;

private:
  [[nodiscard]] TextureShaderSettings &writable();
  void changed(Context &context);

  int m_extensions;
  int m_units;
  /// Never null. Made by this class alone, as what may be changed while nothing else has it.
  std::shared_ptr<TextureShaderSettings> m_settings;
  StatePrograms<fp::texture_shader::Key> m_programs;
  NamedStatePrograms<fp::texture_shader::Key> m_named;
};

/// An extension is offered that keeps its state here. Other than texture shaders do they begin to
/// with their first command.
[[nodiscard]] bool mayKeepTextures(const Context &context);
/// The context has its TextureShaderState from here on. Requires mayKeepTextures().
TextureShaderState &keepTextures(Context &context);
/// NV_texture_shader is offered.
[[nodiscard]] bool hasTextureShaders(const Context &context);
/// ATI_envmap_bumpmap is the layer's.
[[nodiscard]] bool hasBumpMaps(const Context &context);

/// Draws depend on which textures are bound and on what they are: their consistency chooses
/// programs.
[[nodiscard]] bool followsTextures(const Context &context);

/// The value of Get of TEXTURE_SHADER_NV; false where the context does not offer it.
[[nodiscard]] bool textureShaderValue(const Context &context, GLint &value);

} // namespace arbiter::state
