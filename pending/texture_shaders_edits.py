# Edits of existing files for texture_shaders.patch: sub(path, (old, new), ...) replaces once, and stops where the old
# text is not found. Run in the root of a tree that has the register combiners, after the patch; then clang-format.
import re

from replace import sub

# --- compiler ---
sub('src/fp_compiler/meson.build',
    ("subdir('combiners')\n", "subdir('combiners')\nsubdir('texture_shader')\n"),
    ("    'combiners': 'combiners/lower_test.cpp',\n", "    'combiners': 'combiners/lower_test.cpp',\n    'texture-shader': 'texture_shader/lower_test.cpp',\n"))
sub('src/fp_compiler/testing/meson.build',
    ("  'evaluate_combiners.cpp',\n", "  'evaluate_combiners.cpp',\n  'evaluate_environments.cpp',\n  'evaluate_texture_shaders.cpp',\n  'texture_shader_rules.cpp',\n"),
    ("  'random_combiners.cpp',\n", "  'random_combiners.cpp',\n  'random_texture_shaders.cpp',\n"))
sub('src/fp_compiler/combiners/lower.h',
    ('#pragma once\n#include "fp_compiler/combiners/state.h"\n#include "fp_compiler/ir/ir.h"\n',
     '#pragma once\n#include <functional>\n#include <optional>\n\n#include "fp_compiler/combiners/state.h"\n#include "fp_compiler/ir/builder.h"\n#include "fp_compiler/ir/ir.h"\n'),
    ('[[nodiscard]] ir::Program lower(const State &state, const Surroundings &surroundings);\n',
     '''[[nodiscard]] ir::Program lower(const State &state, const Surroundings &surroundings);

/// What a texture register is initialised with; nothing: zeros.
using InitialTexture = std::function<std::optional<ir::Source>(int unit)>;
/// The same behind code that makes the texture registers (NV_texture_shader, 3.8.13): no unit is
/// sampled, and of the surroundings the fog alone is read.
void lower(ir::Builder &builder, const State &state, const Surroundings &surroundings,
           const InitialTexture &textures);
'''))
sub('src/fp_compiler/combiners/lower.cpp',
    ('''  Lowering(const State &state, const Surroundings &surroundings)
      : m_state(state), m_around(surroundings) {}

  ir::Program run() {''', '''  /// \\param textures what makes the texture registers; none: samples of the units' targets
  Lowering(ir::Builder &builder, const State &state, const Surroundings &surroundings,
           const InitialTexture &textures)
      : m_state(state), m_around(surroundings), m_textures(textures), m_builder(builder) {}

  void run() {'''),
    ('''    final();
    return m_builder.take();
  }''', '''    final();
  }'''),
    ('''    if (!known)
      known = sample(unit);
    return *known;
  }

  Contents sample''', '''    if (!known)
      known = m_textures ? given(m_textures(unit)) : sample(unit);
    return *known;
  }

  Contents given(const std::optional<Source> &texture) {
    if (!texture)
      return {m_values.literal(0.0f), m_values.literal(0.0f)};
    return {{*texture, -Value::kAny, Value::kAny, {}},
            {texture->swz("w"), -Value::kAny, Value::kAny, {}}};
  }

  Contents sample'''),
    ('''  const Surroundings &m_around;
  ir::Builder m_builder;
''', '''  const Surroundings &m_around;
  const InitialTexture &m_textures;
  ir::Builder &m_builder;
'''),
    ('''  return Lowering(state, surroundings).run();
}''', '''  ir::Builder builder;
  Lowering(builder, state, surroundings, {}).run();
  return builder.take();
}

void lower(ir::Builder &builder, const State &state, const Surroundings &surroundings,
           const InitialTexture &textures) {
  Lowering(builder, state, surroundings, textures).run();
}'''))
sub('src/fp_compiler/hw/rows.def', ('PROFILE_ROW(VertexApiInstructions,', '''PROFILE_ROW(TextureShaders, model, texture_shaders, textureShaders, "none: how many of NV_texture_shader and NV_texture_shader2 and NV_texture_shader3 are there", 0, 3)
PROFILE_ROW(VertexApiInstructions,'''))
sub('src/fp_compiler/hw/profile.h', ('  Combiners combiners;\n', '''  Combiners combiners;
  std::uint32_t textureShaders = 0; ///< the first so many of NV_texture_shader, 2 and 3
'''))
for p, v, src in (('host', 3, 'Arbiter: on any host that has textures of floats and of signed numbers'),
                  ('nv30', 3, 'glxinfo of a GeForce FX 5900XT, Linux driver 61.11: GL_NV_texture_shader3'),
                  ('r300', 0, 'NV_texture_shader is not offered'), ('i915', 0, 'NV_texture_shader is not offered')):
    f = f'src/fp_compiler/hw/profiles/{p}.toml'
    s = open(f).read()
    s = re.sub(r'(per_stage_constants = .*\n)', lambda m: m.group(1) + f'texture_shaders = {{ value = {v}, source = "{src}" }}\n', s, count=1)
    open(f, 'w').write(s)

# --- state: targets, context, stacks, lists ---
sub('src/state/programs/program_object.h', ('''  Combiners,   ///< NV_register_combiners: state, not objects, of which programs are made
};
inline constexpr int kTargetCount = 6;''', '''  Combiners,   ///< NV_register_combiners: state, not objects, of which programs are made
  TextureShaders, ///< NV_texture_shader: the same, before combiners or texture environments
};
inline constexpr int kTargetCount = 7;'''))
sub('src/state/core/target.h', ('''    {GL_REGISTER_COMBINERS_NV, fp::ir::Language::ArbFragment, "combiners", ""},
''', '''    {GL_REGISTER_COMBINERS_NV, fp::ir::Language::ArbFragment, "combiners", ""},
    {GL_TEXTURE_SHADER_NV, fp::ir::Language::ArbFragment, "texture-shaders", ""},
'''), ('''  return target == Target::AtiText || target == Target::AtiApi || target == Target::Combiners;''', '''  return target == Target::AtiText || target == Target::AtiApi || target == Target::Combiners ||
         target == Target::TextureShaders;'''), ("(not AtiApi's and Combiners').", "(not AtiApi's, Combiners'\n  /// and TextureShaders')."))
sub('src/state/core/context.h', ('class ShareGroup;\nclass Link', 'class ShareGroup;\nclass TextureShaderState;\nclass Link'),
    ('''  std::unique_ptr<CombinerState> combiners; ///< where the profile has register combiners, else null
''', '''  std::unique_ptr<CombinerState> combiners; ///< where the profile has register combiners, else null
  std::unique_ptr<TextureShaderState> textureShaders; ///< the same of NV_texture_shader
'''), ('/// NV_register_combiners.\n', '/// NV_register_combiners or NV_texture_shader.\n'),
    ('{Target::AtiApi, Target::Combiners})', '{Target::AtiApi, Target::Combiners, Target::TextureShaders})'))
sub('src/state/core/attrib_stack.h', ('struct CombinerSettings;\n', 'struct CombinerSettings;\nstruct ComponentTransfers;\nstruct TextureShaderSettings;\n'),
    ('of register combiners in GL_TEXTURE_BIT with all of their state.', 'of register combiners and of texture shaders in GL_TEXTURE_BIT with all of their state.'),
    ('''    std::shared_ptr<const CombinerSettings> combiners; ///< null without GL_TEXTURE_BIT
''', '''    std::shared_ptr<const CombinerSettings> combiners; ///< null without GL_TEXTURE_BIT
    std::shared_ptr<const TextureShaderSettings> textureShaders; ///< the same
    std::shared_ptr<const ComponentTransfers> transfers;         ///< null without GL_PIXEL_MODE_BIT
'''))
sub('src/state/core/capability.h', ('''    {infoOf(Target::Combiners).name, Capability::ProgramTarget, 0},
''', '''    {infoOf(Target::Combiners).name, Capability::ProgramTarget, 0},
    {infoOf(Target::TextureShaders).name, Capability::ProgramTarget, 0},
'''))
sub('src/state/lists/display_list.h', ('''    Combiners, ///< bytes: some CombinerCommands, in a row
''', '''    Combiners, ///< bytes: some CombinerCommands, in a row
    TextureShaders, ///< bytes: some TextureShaderCommands, in a row
    ComponentImage, ///< bytes: a ComponentImage, then its components as floats
'''))
sub('src/state/lists/list_compiler.cpp', ('''  else if (command.kind == Command::Kind::Combiners)
''', '''  else if (command.kind == Command::Kind::Combiners ||
           command.kind == Command::Kind::TextureShaders)
'''), ('So are commands of register combiners, which come by the dozen.', 'So are commands of register combiners and texture shaders, which come by the dozen.'))
sub('src/state/lists/list_execute.cpp', ('''  case Command::Kind::CopyTexture:
''', '''  case Command::Kind::TextureShaders:
    return executeTextureShaderCommands(context, command.bytes);
  case Command::Kind::ComponentImage:
    if (context.software)
      context.software->residency.textureRedefined(componentImageOf(command.bytes).target);
    return executeComponentImage(context, command.bytes);
  case Command::Kind::CopyTexture:
'''), ('#include "state/raster_draw/copy_texture.h"', '''#include "state/programs/texture_shaders/component_image.h"
#include "state/programs/texture_shaders/texture_shader_commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/copy_texture.h"'''))
sub('src/state/core/identity.h', ('''  bool perStageConstants = false;         ///< and NV_register_combiners2
''', '''  bool perStageConstants = false;         ///< and NV_register_combiners2
  std::uint32_t textureShaders = 0;       ///< the first so many of NV_texture_shader, 2 and 3
'''))
sub('src/state/core/identity.cpp', ('  rules.maxYear = settings()', '  rules.textureShaders = activeProfile().textureShaders;\n  rules.maxYear = settings()'),
    ('''/// A host that has register combiners itself is not asked for them: the layer's answer in every
/// context that offers them, as ATI's fragment shaders are.
void addCombiners(FilteredExtensions &extensions, const IdentityRules &rules) {
''', '''/// A host that has register combiners or texture shaders itself is not asked for them: the layer's
/// answer in every context that offers them, as ATI's fragment shaders are.
void addStateShaders(FilteredExtensions &extensions, const HostCaps &caps,
                     const IdentityRules &rules) {
'''), ('''  announce("GL_NV_register_combiners2", rules.perStageConstants);
''', '''  announce("GL_NV_register_combiners2", rules.perStageConstants);
  const std::uint32_t shaders = caps.drawsTextureShaders() ? rules.textureShaders : 0;
  announce("GL_NV_texture_shader", shaders >= 1);
  announce("GL_NV_texture_shader2", shaders >= 2);
  announce("GL_NV_texture_shader3", shaders >= 3);
'''), ('    addCombiners(identity.extensions, rules);', '    addStateShaders(identity.extensions, caps, rules);'))
sub('src/state/core/host_caps.h', ("  /// Whether a vertex program's clip", '''  /// Whether the texture formats of NV_texture_shader have one of the host's that stands for them.
  [[nodiscard]] bool drawsTextureShaders() const;
  /// Whether a vertex program's clip'''))
sub('src/state/core/host_caps.cpp', ('fp::Limits queryHostLimits(', '''bool HostCaps::drawsTextureShaders() const {
  return has("GL_EXT_texture_snorm") && has("GL_ARB_texture_float") && has("GL_ARB_texture_rg") &&
         textureRectangle;
}

fp::Limits queryHostLimits('''))
sub('src/state/core/lifecycle.cpp', ('/// What this host can be given of the mode', '''/// Texture shaders, where the profile's card and the host's formats have them.
void offerTextureShaders(Context &context) {
  fp::Limits limits = context.row(Target::Fragment).limits;
  const std::uint32_t extensions = activeProfile().textureShaders;
  if (extensions == 0 || !context.caps.drawsTextureShaders())
    return;
  limits.envParameters = fp::texture_shader::kParameters;
  limits.localParameters = 0;
  offer(context, Target::TextureShaders, limits);
  context.textureShaders = std::make_unique<TextureShaderState>(
      int(extensions), int(std::min(limits.textureUnits, 8u)));
  context.textureShaders->setParameters(context);
}

/// What this host can be given of the mode'''), ('    offerCombiners(context);\n', '    offerCombiners(context);\n    offerTextureShaders(context);\n'),
    ('''  if ((mask & GL_ENABLE_BIT) == 0)
    return;
  to.hostAssembly''', '''  if (from.textureShaders && to.textureShaders) {
    if ((mask & GL_TEXTURE_BIT) != 0) {
      to.textureShaders->restore(
          to, std::make_shared<TextureShaderSettings>(*from.textureShaders->settings()));
      setEnabled(to, to.row(Target::TextureShaders), from.row(Target::TextureShaders).enabled);
    }
    if ((mask & GL_PIXEL_MODE_BIT) != 0)
      to.textureShaders->transfers = from.textureShaders->transfers;
  }
  if ((mask & GL_ENABLE_BIT) == 0)
    return;
  to.hostAssembly'''), ('#include "state/programs/combiners/combiner_state.h"\n', '#include "state/programs/combiners/combiner_state.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'),
    ('    ++context->frames;\n', '    ++context->frames;\n    noteTextureChange(*context); // by commands that the layer does not see\n'),
    ('''  if (context->software)
    context->software->residency.enter(context->drawable);
}''', '''  noteTextureChange(*context);
  if (context->software)
    context->software->residency.enter(context->drawable);
}'''))
sub('src/state/programs/combiners/combiner_state.cpp', ('''  ProgramTarget &row = context.row(Target::Combiners);
  row.env[std::size_t(index)] = value;
  ++row.envVersion;
  context.attention |= row.parameterBits;
}
''', '''  for (const Target target : {Target::Combiners, Target::TextureShaders})
    if (ProgramTarget &row = context.row(target); row.offered) {
      row.env[std::size_t(index)] = value;
      ++row.envVersion;
      context.attention |= row.parameterBits;
    }
}
'''), ('''  ++row.envVersion;
  context.attention |= row.parameterBits;
  changed(context);''', '''  ++row.envVersion;
  context.attention |= row.parameterBits;
  if (context.textureShaders)
    context.textureShaders->setParameters(context);
  changed(context);'''), ('#include "state/programs/program_bind.h"\n', '#include "state/programs/program_bind.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'))
sub('src/state/control/draw_probe.cpp', ('Target::Combiners};', 'Target::Combiners, Target::TextureShaders};'))
sub('src/state/host_draw/use_program.cpp', ('  (void)context.attribStack.push', '''  if (context.textureShaders && (mask & GL_TEXTURE_BIT) != 0)
    entry.textureShaders = context.textureShaders->settings();
  if (context.textureShaders && (mask & GL_PIXEL_MODE_BIT) != 0)
    entry.transfers = std::make_shared<const ComponentTransfers>(context.textureShaders->transfers);
  (void)context.attribStack.push'''), ('void popEnables(Context &context) {', '''/// The same of texture shaders.
void popTextureShaders(Context &context, const AttribStack::Entry &entry) {
  ProgramTarget &row = context.row(Target::TextureShaders);
  if (entry.textureShaders) {
    context.textureShaders->restore(context, entry.textureShaders);
    setEnabled(context, row, (entry.enabledTargets >> unsigned(row.target) & 1u) != 0);
  }
  if (entry.transfers)
    context.textureShaders->transfers = *entry.transfers;
}

void popEnables(Context &context) {'''), ('''    popCombiners(context, entry);
  if (!popped''', '''    popCombiners(context, entry);
  if (popped && context.textureShaders)
    popTextureShaders(context, entry);
  if (!popped'''), ('#include "state/programs/program_bind.h"\n', '#include "state/programs/program_bind.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'),
    ('''  noteFixedFunctionChange(context);
  noteClipPlanesChange(context);''', '''  noteFixedFunctionChange(context);
  noteTextureChange(context);
  noteClipPlanesChange(context);'''))
sub('src/state/host_draw/path_choice.cpp', ('''  bool combiners = false; ///< register combiners are enabled, and no `fragment`
  [[nodiscard]] bool none() const { return !vertex && !fragment && !ati && !combiners; }''', '''  bool combiners = false; ///< register combiners are enabled, and no `fragment`
  /// Texture shaders are enabled, or fixed function has textures or environments that the host
  /// lacks, and no `fragment`.
  bool textureShaders = false;
  [[nodiscard]] bool none() const {
    return !vertex && !fragment && !ati && !combiners && !textureShaders;
  }'''), ('EffectivePrograms enabledRows(const Context &context) {', 'EffectivePrograms enabledRows(Context &context) {'),
    ('''  rows.combiners = !rows.fragment && ifEnabled(Target::Combiners);
  return rows;''', '''  rows.combiners = !rows.fragment && ifEnabled(Target::Combiners);
  rows.textureShaders =
      !rows.fragment && (ifEnabled(Target::TextureShaders) || texturesNeedLayer(context));
  return rows;'''), ('''  if (rows.combiners && !pair.fragment)
    pair.fragment''', '''  if (rows.textureShaders && !pair.fragment)
    pair.fragment = texturesEffective(context, glslHost(context.caps), rows.combiners);
  else if (rows.combiners && !pair.fragment)
    pair.fragment'''), ('    rows.ati = rows.combiners = false;', '    rows.ati = rows.combiners = rows.textureShaders = false;'),
    ('  context.followsFixedFunction = false;\n', '  context.followsFixedFunction = false;\n  if (context.textureShaders)\n    context.textureShaders->effective = false;\n'),
    ('#include "state/host_draw/variants/depth_variants.h"\n', '#include "state/host_draw/variants/depth_variants.h"\n#include "state/host_draw/variants/texture_shader_draw.h"\n'),
    ('#include "state/programs/program_load.h"\n', '#include "state/programs/program_load.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'))
sub('src/state/host_draw/path_choice.h', ('''over register
/// combiners (NV_fragment_program: "the fragment program replaces ..."), and these over fixed
/// function.''', '''over texture
/// shaders and register combiners (NV_fragment_program: "the fragment program replaces ..."), and
/// these over fixed function.'''))
sub('src/state/host_draw/draw.cpp', ('''  if (mayFollowCombinedDepths(context))
    bits |= attention::kDepth;''', '''  if (mayFollowCombinedDepths(context) || mayFollowTextures(context))
    bits |= attention::kDepth;'''), ('''    followCombinedDepths(context);
  constexpr''', '''    followCombinedDepths(context);
  if (mayFollowTextures(context)) [[unlikely]]
    followTextures(context);
  constexpr'''), ('''    followCombinedDepths(context);
  refresh''', '''    followCombinedDepths(context);
  if (mayFollowTextures(context)) [[unlikely]]
    followTextures(context);
  refresh'''), ('#include "state/host_draw/variants/combiner_draw.h"\n', '#include "state/host_draw/variants/combiner_draw.h"\n#include "state/host_draw/variants/texture_shader_draw.h"\n'),
    ('#include "state/programs/replacement.h"\n', '#include "state/programs/replacement.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'),
    ('''  noteFixedFunctionChange(context);
  noteClipPlanesAfterList(context);''', '''  noteFixedFunctionChange(context);
  noteTextureChange(context);
  noteClipPlanesAfterList(context);'''))
sub('src/state/host_draw/fixed_function.cpp', ('''  if (context.followsFixedFunction)
    invalidateProgram(context);
}''', '''  if (context.followsFixedFunction)
    invalidateProgram(context);
  else
    noteTextureChange(context); // of fixed function's own textures
}'''), ('#include "state/programs/program_bind.h"\n', '#include "state/programs/program_bind.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'))
sub('src/state/share/share_group.h', ('#include "state/share/deleted_names.h"\n', '#include "state/share/deleted_names.h"\n#include "state/share/texture_formats.h"\n'),
    ('  TextureViews textureViews;\n', '  TextureViews textureViews;\n  TextureFormats textureFormats;\n'))
sub('src/state/core/straight.h', ('/// The layer has a part in MATRIXi_NV', '''/// What is bound chooses among the programs of texture shaders.
[[nodiscard]] inline bool BindTexture(Context &context, GLenum, GLuint) {
  return !context.textureShaders;
}

/// The layer has a part in MATRIXi_NV'''), ('''/// Of the parameters of textures the layer has a part in the comparison alone.
[[nodiscard]] inline bool TexParameteri(Context &, GLenum, GLenum pname, GLint) {
  return pname != GL_TEXTURE_COMPARE_MODE && pname != GL_DEPTH_TEXTURE_MODE;
}
[[nodiscard]] inline bool TexParameterf(Context &, GLenum, GLenum pname, GLfloat) {
  return pname != GL_TEXTURE_COMPARE_MODE && pname != GL_DEPTH_TEXTURE_MODE;
}''', '''/// Of the parameters of textures the layer has a part in the comparison, and texture shaders in what
/// makes a texture consistent.
[[nodiscard]] inline bool TexParameteri(Context &context, GLenum, GLenum pname, GLint) {
  return pname != GL_TEXTURE_COMPARE_MODE && pname != GL_DEPTH_TEXTURE_MODE &&
         !context.textureShaders;
}
[[nodiscard]] inline bool TexParameterf(Context &context, GLenum target, GLenum pname, GLfloat) {
  return TexParameteri(context, target, pname, 0);
}'''))
sub('src/state/core/straight_test.cpp', ('''                                       GLfloat(GL_COMPARE_R_TO_TEXTURE)));
}
''', '''                                       GLfloat(GL_COMPARE_R_TO_TEXTURE)));
}

TEST(Straight, TexturesAreTheHostsWhereNoTextureShaderIs) {
  FakeHost host; // without the formats that they need
  const CurrentContext context(host);
  ASSERT_FALSE(context->textureShaders);
  EXPECT_TRUE(straight::BindTexture(*context, GL_TEXTURE_2D, 1));
}
'''))

# --- handlers ---
sub('src/state/handlers/gets.cpp', ('/// True, with the value, for what we answer ourselves.', '''/// TEXTURE_SHADER_NV.
bool textureShaderValue(const Context &context, GLint &value) {
  value = context.row(Target::TextureShaders).enabled ? 1 : 0;
  return context.textureShaders != nullptr;
}

/// True, with the value, for what we answer ourselves.'''), ('    return combinerValue(context, pname, value);\n', '    return combinerValue(context, pname, value);\n  case infoOf(Target::TextureShaders).name:\n    return textureShaderValue(context, value);\n'),
    ('template <typename T, typename Host> void get(Context', '''/// True, with it, for a scale or bias of HILO components or texture offset groups.
template <typename T> bool getTransfer(const Context &context, GLenum pname, T *data) {
  const GLenum at = pname - GL_HI_SCALE_NV;
  if (at > 11 || !context.textureShaders) [[likely]]
    return false;
  const ComponentTransfers &transfers = context.textureShaders->transfers;
  const GLfloat value = at < 6 ? transfers.scales[at] : transfers.biases[at - 6];
  if constexpr (std::is_same_v<T, GLboolean>)
    *data = value != 0.0f ? GL_TRUE : GL_FALSE;
  else if constexpr (std::is_integral_v<T>)
    *data = T(std::floor(double(value) + 0.5));
  else
    *data = T(value);
  return true;
}

template <typename T, typename Host> void get(Context'''), ('''  if (!context.insideBeginEnd && data && getCombinerColor(context, pname, data))
    return;''', '''  if (!context.insideBeginEnd && data &&
      (getCombinerColor(context, pname, data) || getTransfer(context, pname, data)))
    return;'''), ('#include "state/programs/nv/nv_state.h"\n', '#include "state/programs/nv/nv_state.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'))
p = 'src/state/handlers/pixel_handlers.cpp'; s = open(p).read()
a = s.index('void GetTexImage('); b = s.index('void Flush(Context'); s = s[:a] + s[b:]   # moved to texture_image_handlers.cpp
a = s.index('ARBITER_REDEFINES(TexImage1D,'); b = s.index('ARBITER_REDEFINES(CompressedTexImage1D,'); s = s[:a] + s[b:]
a = s.index('void TexImage2D('); b = s.index('} // namespace arbiter::state::handlers'); s = s[:a].rstrip() + '\n\n' + s[b:]
open(p, 'w').write(s)
sub(p, ('''                GLenum type, void *pixels) {
  if (executes(context) && context.software) {''', '''                GLenum type, void *pixels) {
  if (context.textureShaders && !context.insideBeginEnd &&
      (isComponentFormat(format) || isSignedPacked(type))) [[unlikely]]
    return raise(context, GL_INVALID_ENUM, "ReadPixels: a format or type of textures alone");
  if (executes(context) && context.software) {'''), ('#include "state/core/context.h"\n', '#include "state/core/context.h"\n#include "state/core/errors.h"\n'),
    ('#include "state/mirror/dirty_bits.h"\n', '#include "state/mirror/dirty_bits.h"\n#include "state/programs/texture_shaders/component_formats.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'),
    ('    context.host->Name Arguments;                                                                  \\\n  }', '    context.host->Name Arguments;                                                                  \\\n    noteTextureChange(context);                                                                    \\\n  }'))
sub('src/state/handlers/storage_handlers.cpp', ('    context.group->textureViews.remove(n, textures);\n', '    context.group->textureViews.remove(n, textures);\n    context.group->textureFormats.remove(n, textures);\n'),
    ('  context.host->DeleteTextures(n, textures);\n}', '  context.host->DeleteTextures(n, textures);\n  noteTextureChange(context);\n}'),
    ('#include "state/raster_draw/commands.h"\n', '#include "state/programs/texture_shaders/texture_shader_state.h"\n#include "state/raster_draw/commands.h"\n'))
p = 'src/state/handlers/texture_mode_handlers.cpp'
sub(p, ('namespace handlers {\n\n// Of a target', '''namespace {

/// TEXTURE_BORDER_VALUES_NV is what the host has as a border colour that it does not clamp.
template <typename T> GLenum hostName(const Context &context, GLenum pname, T) {
  return pname == GL_TEXTURE_BORDER_VALUES_NV && context.textureShaders && std::is_pointer_v<T>
             ? GLenum(GL_TEXTURE_BORDER_COLOR)
             : pname;
}

} // namespace

namespace handlers {

// Of a target'''), ('    context.host->name(object, pname, value);                                                      \\\n', '    context.host->name(object, hostName(context, pname, value), value);                            \\\n    noteTextureChange(context);                                                                    \\\n'),
    ('    context.host->name(object, target, pname, value);                                              \\\n', '    context.host->name(object, target, pname, value);                                              \\\n    noteTextureChange(context);                                                                    \\\n'),
    ('  context.host->BindSampler(unit, sampler);\n', '  context.host->BindSampler(unit, sampler);\n  noteTextureChange(context);\n'),
    ('  context.host->BindSamplers(first, count, samplers);\n', '  context.host->BindSamplers(first, count, samplers);\n  noteTextureChange(context);\n'),
    ('#include "state/host_draw/draw.h"\n', '#include "state/host_draw/draw.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n'),
    ('#include "host/handlers.h"\n', '#include <type_traits>\n\n#include "host/handlers.h"\n'))

# --- CopyTexImage: the old body of copyTexture() becomes copyColors() ---
p = 'src/state/raster_draw/copy_texture.cpp'; s = open(p).read()
a = s.index('void copyTexture(Context &context, const CopyCommand &copy) {')
a0 = s.rindex('/// Where the copy goes', 0, a)
b = s.index('Command commandOf(')
body = s[a + len('void copyTexture(Context &context, const CopyCommand &copy) {\n'):b].rstrip()
s = s[:a0] + '''namespace {

/// To an image that the host has as it is asked for. Where the copy goes to is asked from the host,
/// once: bindings are passed on untracked, and a query is small beside a copy.
void copyColors(Context &context, const CopyCommand &copy) {
''' + body + '''

bool defines(CopyKind kind) { return kind == CopyKind::Image1D || kind == CopyKind::Image2D; }

/// An image of HILO components or of a texture offset group (NV_texture_shader, 3.8.2).
bool takesNoColors(Context &context, const CopyCommand &copy) {
  const GLenum name = defines(copy.kind) ? copy.internalFormat
                                         : componentFormatOf(context, copy.target, copy.level);
  const ComponentFormat *const format = componentFormat(name);
  return format && format->external != 0;
}

/// The same where internal formats are NV_texture_shader's too.
void copyToOwnFormat(Context &context, const CopyCommand &copy) {
  if (takesNoColors(context, copy))
    return raise(context, GL_INVALID_OPERATION, "CopyTexImage: the image has no colours");
  const ComponentFormat *const own =
      defines(copy.kind)
          ? componentFormat(copy.internalFormat, context.textureShaders->extensions())
          : nullptr;
  noteTextureChange(context);
  CopyCommand hosts = copy;
  if (own)
    hosts.internalFormat = own->host;
  if (!defines(copy.kind) || (!own && !context.group->textureFormats.any()))
    return copyColors(context, hosts);
  const GLenum earlier = takeHostErrors(*context.host);
  copyColors(context, hosts);
  const GLenum error = takeHostErrors(*context.host);
  if (error == GL_NO_ERROR)
    noteImageFormat(context, copy.target, copy.level, own ? own->name : 0);
  if (earlier != GL_NO_ERROR || error != GL_NO_ERROR)
    raise(context, earlier != GL_NO_ERROR ? earlier : error, "CopyTexImage");
}

} // namespace

void copyTexture(Context &context, const CopyCommand &copy) {
  if (context.textureShaders && !context.insideBeginEnd && context.listMode != GL_COMPILE)
    return copyToOwnFormat(context, copy);
  copyColors(context, copy);
}

''' + s[b:]
s = s.replace('#include "state/raster_draw/context_state.h"\n', '#include "state/core/errors.h"\n#include "state/programs/texture_shaders/component_formats.h"\n#include "state/programs/texture_shaders/component_image.h"\n#include "state/programs/texture_shaders/texture_shader_state.h"\n#include "state/raster_draw/context_state.h"\n#include "state/share/share_group.h"\n', 1)
open(p, 'w').write(s)

# --- PlainTransfer moved from control/host_pixels to core/plain_transfer ---
p = 'src/state/control/host_pixels.h'; h = open(p).read()
a = h.index('/// Pixel store and transfer as GL begins with'); b = h.index('/// The size of the current drawable')
h = (h[:a] + h[b:]).replace('#include "state/core/host_errors.h"', '#include "state/core/plain_transfer.h"')
open(p, 'w').write(h)
p = 'src/state/control/host_pixels.cpp'; c = open(p).read()
a = c.index('constexpr std::array<GLenum, 8> kPack'); b = c.index('GLint get(const host::HostTable'); c = c[:a] + c[b:]
a = c.index('PlainTransfer::PlainTransfer('); b = c.index('PlainTransfer::~PlainTransfer'); b = c.index('}\n', c.index('m_context.dirty |= software::dirty::kPixelStore;\n', b)) + 2
c = c[:a] + c[b:].lstrip('\n'); open(p, 'w').write(c)
sub('src/state/hud/hud.cpp', ('#include "state/core/unit_scope.h"\n', '#include "state/core/plain_transfer.h"\n#include "state/core/unit_scope.h"\n'))
p = 'src/state/hud/hud.cpp'; s = open(p).read().replace('remote::PlainTransfer', 'PlainTransfer'); open(p, 'w').write(s)

# --- meson of state, dispatch ---
sub('src/state/meson.build',
    ("  'core/memory.cpp',\n", "  'core/memory.cpp',\n  'core/plain_transfer.cpp',\n"),
    ("  'handlers/storage_handlers.cpp',\n", "  'handlers/storage_handlers.cpp',\n  'handlers/texture_environment_handlers.cpp',\n  'handlers/texture_format_handlers.cpp',\n  'handlers/texture_image_handlers.cpp',\n"),
    ("  'host_draw/variants/combiner_draw.cpp',\n", "  'host_draw/variants/combiner_draw.cpp',\n  'host_draw/variants/environment_now.cpp',\n  'host_draw/variants/shader_textures.cpp',\n  'host_draw/variants/texture_shader_draw.cpp',\n"),
    ("  'programs/replacement_folder.cpp',\n", "  'programs/replacement_folder.cpp',\n  'programs/texture_shaders/component_formats.cpp',\n  'programs/texture_shaders/component_image.cpp',\n  'programs/texture_shaders/component_texels.cpp',\n  'programs/texture_shaders/texture_shader_commands.cpp',\n  'programs/texture_shaders/texture_shader_names.cpp',\n  'programs/texture_shaders/texture_shader_state.cpp',\n"),
    ("  'share/texture_views.cpp',\n", "  'share/texture_formats.cpp',\n  'share/texture_views.cpp',\n"),
    ("'nv_parameters', 'nv_programs']", "'nv_parameters', 'nv_programs',\n      'texture_shader_state']"),
    ("      'texture_views': 'share/texture_views_test.cpp',\n", "      'texture_formats': 'share/texture_formats_test.cpp',\n      'texture_shader_state': 'programs/texture_shaders/texture_shader_state_test.cpp',\n      'texture_views': 'share/texture_views_test.cpp',\n"))
sub('src/dispatch/entry_points.toml', ("  # ATI_fragment_shader, and the fixed", '''  # NV_texture_shader, 2 and 3.
  "TexEnv[fi]", "TexEnv[fi]v", "GetTexEnv[fi]v", "TexImage[123]D", "TexSubImage[123]D", "GetTexImage",
  "GetTexLevelParameter[fi]v", "GetTexParameter[fi]v", "PixelTransfer[fi]", "ReadPixels", "BindTexture",
  "CompressedTexImage[123]D", "TexStorage[123]D", "GenerateMipmap",
  # ATI_fragment_shader, and the fixed'''), ('straight = ["Enable", "Disable", "GetError", "TexParameteri",', 'straight = ["Enable", "Disable", "GetError", "BindTexture", "TexParameteri",'))
# software.toml [handled]: "ReadPixels", "GetTexImage", "TexImage[123]D", "TexSubImage[123]D", "CompressedTexImage[123]D",
# "TexStorage[123]D", "GenerateMipmap" are taken out (they are own now).
sub('src/dispatch/software.toml', ('''"ReadPixels", "GetTexImage", "TexImage[123]D", "TexSubImage[123]D",
  "CompressedTexImage[123]D", "CompressedTexSubImage[123]D", "TexStorage[123]D", "GenerateMipmap",''', '"CompressedTexSubImage[123]D",'))
sub('src/dispatch/reasons.toml', ('why = "Register combiners, texture shaders, EXT_vertex_shader and NV programs', "why = \"EXT_vertex_shader and what of NV programs is not Arbiter's"))

# --- tests ---
sub('tests/meson.build', ("subdir('combiners_vs_specification')\n", "subdir('combiners_vs_specification')\nsubdir('texture_shaders_vs_specification')\n"))
sub('tests/layer_vs_specification/meson.build', ("    'nv_evaluators_test.cpp',\n", "    'nv_evaluators_test.cpp',\n    'nv_texture_shader/draws_test.cpp',\n    'nv_texture_shader/errors_test.cpp',\n    'nv_texture_shader/formats_test.cpp',\n    'nv_texture_shader/state_test.cpp',\n"))
sub('tests/clients/vendor_gpa.cpp', ('"glUniform4fvARB"};', '"glUniform4fvARB",\n    "glTexImage2D", "glTexEnvi"};'), ('"glTexImage2D", "glBlendFunc"', '"glFlush", "glBlendFunc"'))
sub('tests/clients/identity.py', ("               'GL_NV_register_combiners2'} if profile == 'nv30' else set()", "               'GL_NV_register_combiners2', 'GL_NV_texture_shader', 'GL_NV_texture_shader2',\n               'GL_NV_texture_shader3'} if profile == 'nv30' else set()"),
    ("    combiners = {'GL_NV_register_combiners', 'GL_NV_register_combiners2'}  # the layer's, on any host\n", "    combiners = {'GL_NV_register_combiners', 'GL_NV_register_combiners2',  # the layer's, on any host\n                 'GL_NV_texture_shader', 'GL_NV_texture_shader2', 'GL_NV_texture_shader3'}\n"))

# --- docs (docs/entry_points.md and docs/profiles.md are made by docs/generate.py) ---
s = open('docs/extensions.md').read().rstrip('\n') + '''
| GL_NV_texture_shader | the layer's, on hosts with textures of floats and of signed numbers ([texture_shaders.md](texture_shaders.md)) | `host`, `nv30`, `nv35`, `nv40` | `tests/texture_shaders_vs_specification`, `tests/layer_vs_specification/nv_texture_shader` |
| GL_NV_texture_shader2 | the same | `host`, `nv30`, `nv35`, `nv40` | the same |
| GL_NV_texture_shader3 | the same | `host`, `nv30`, `nv35`, `nv40` | the same |
'''
open('docs/extensions.md', 'w').write(s)
sub('docs/architecture.md', ("  ati/, combiners/  ATI's fragment shaders and register combiners as data, to IR; each with a second reading\n", "  ati/, combiners/, texture_shader/  ATI's fragment shaders, register combiners and texture shaders as data, to IR; each\n                    with a second reading\n"),
    ("                    combiners/, the state of register combiners and the programs made of it\n", "                    combiners/ and texture_shaders/, the state of NVIDIA's and the programs made of it\n"),
    ('| texts of every opcode', '| random states of texture shaders, with textures of every format, drawn, against their specification | `tests/texture_shaders_vs_specification` | `./dev test` (120), whole `run.py` |\n| texts of every opcode'))
s = open('docs/architecture/calls.md').read()
i = s.index('**Register combiners** (['); j = s.index('\n\n', i)
s = s[:j] + '''

**Texture shaders** ([their page](../texture_shaders.md)) are another such row, whose program has register combiners or texture
environments in it. `state/host_draw/variants/shader_textures.h` asks what is bound, at each draw, as consistency depends on it;
`environment_now.h` the environments. `state/programs/texture_shaders` has the state, and the formats of textures that the host
stores as others: TexImage, TexSubImage and GetTexImage of them are the layer's (`state/handlers/texture_image_handlers.cpp`).''' + s[j:]
s = s.replace('register combiners, then fixed function)', 'texture shaders and register combiners, then fixed function)')
open('docs/architecture/calls.md', 'w').write(s)
s = open('README.md').read()
s = s.replace('and register combiners (docs/register_combiners.md).', 'register combiners (docs/register_combiners.md) and texture shaders\n  (docs/texture_shaders.md).')
open('README.md', 'w').write(s)
