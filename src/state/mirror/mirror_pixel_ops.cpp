// Queries the per-fragment operations (OpenGL 1.4, chapter 4; 2.0 for separate state).
#include <algorithm>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"

namespace arbiter::state {

namespace {

abi::Compare compareOf(GLenum function) { return abi::Compare(function - GL_NEVER); }

abi::StencilOp stencilOp(GLenum op) {
  switch (op) {
  case GL_ZERO:
    return abi::StencilOp::Zero;
  case GL_REPLACE:
    return abi::StencilOp::Replace;
  case GL_INCR:
    return abi::StencilOp::Increment;
  case GL_DECR:
    return abi::StencilOp::Decrement;
  case GL_INVERT:
    return abi::StencilOp::Invert;
  case GL_INCR_WRAP:
    return abi::StencilOp::IncrementWrap;
  case GL_DECR_WRAP:
    return abi::StencilOp::DecrementWrap;
  default:
    return abi::StencilOp::Keep;
  }
}

bool blendFactor(GLenum factor, abi::BlendFactor &out) {
  using F = abi::BlendFactor;
  switch (factor) {
  case GL_ZERO:
    out = F::Zero;
    return true;
  case GL_ONE:
    out = F::One;
    return true;
  default:
    if (factor >= GL_SRC_COLOR && factor <= GL_SRC_ALPHA_SATURATE) {
      constexpr F kInOrder[] = {
          F::SourceColor,         F::OneMinusSourceColor, F::SourceAlpha,
          F::OneMinusSourceAlpha, F::DestAlpha,           F::OneMinusDestAlpha,
          F::DestColor,           F::OneMinusDestColor,   F::SourceAlphaSaturate};
      out = kInOrder[factor - GL_SRC_COLOR];
      return true;
    }
    if (factor >= GL_CONSTANT_COLOR && factor <= GL_ONE_MINUS_CONSTANT_ALPHA) {
      constexpr F kInOrder[] = {F::ConstantColor, F::OneMinusConstantColor, F::ConstantAlpha,
                                F::OneMinusConstantAlpha};
      out = kInOrder[factor - GL_CONSTANT_COLOR];
      return true;
    }
    return false; // dual-source blending
  }
}

bool blendEquation(GLenum mode, abi::BlendEquation &out) {
  switch (mode) {
  case GL_FUNC_ADD:
    out = abi::BlendEquation::Add;
    return true;
  case GL_FUNC_SUBTRACT:
    out = abi::BlendEquation::Subtract;
    return true;
  case GL_FUNC_REVERSE_SUBTRACT:
    out = abi::BlendEquation::ReverseSubtract;
    return true;
  case GL_MIN:
    out = abi::BlendEquation::Min;
    return true;
  case GL_MAX:
    out = abi::BlendEquation::Max;
    return true;
  default:
    return false; // an advanced equation
  }
}

struct BlendNames {
  GLenum sourceColor, destColor, sourceAlpha, destAlpha, color, alpha;
};

bool blendOf(const BlendNames &names, abi::BlendKey &key) {
  key = {};
  key.enabled = 1;
  return blendFactor(names.sourceColor, key.sourceColor) &&
         blendFactor(names.destColor, key.destColor) &&
         blendFactor(names.sourceAlpha, key.sourceAlpha) &&
         blendFactor(names.destAlpha, key.destAlpha) && blendEquation(names.color, key.color) &&
         blendEquation(names.alpha, key.alpha);
}

/// Queries the blend state of draw buffer `i`, or of all if the host has one state for all.
BlendNames queryBlend(const HostQuery &query, bool indexed, GLuint i) {
  const auto get = [&](GLenum pname) {
    GLint value = 0;
    if (indexed)
      query.host.GetIntegeri_v(pname, i, &value);
    else
      query.host.GetIntegerv(pname, &value);
    return GLenum(value);
  };
  return {get(GL_BLEND_SRC_RGB),   get(GL_BLEND_DST_RGB),      get(GL_BLEND_SRC_ALPHA),
          get(GL_BLEND_DST_ALPHA), get(GL_BLEND_EQUATION_RGB), get(GL_BLEND_EQUATION_ALPHA)};
}

void queryTarget(const HostCaps &caps, const HostQuery &query, GLuint i,
                 abi::ColorTargetKey &target, bool &lacking) {
  GLboolean mask[4] = {1, 1, 1, 1};
  bool blends = false;
  if (caps.indexedBuffers) {
    query.host.GetBooleani_v(GL_COLOR_WRITEMASK, i, mask);
    blends = query.host.IsEnabledi(GL_BLEND, i) != GL_FALSE;
  } else {
    query.host.GetBooleanv(GL_COLOR_WRITEMASK, mask);
    blends = query.enabled(GL_BLEND);
  }
  target.writeMask = 0;
  for (int c = 0; c < 4; ++c)
    target.writeMask |= std::uint8_t((mask[c] ? 1 : 0) << c);
  target.blend = {};
  if (blends && !blendOf(queryBlend(query, caps.indexedBlend, i), target.blend))
    lacking = true;
}

bool isConstant(abi::BlendFactor factor) {
  using F = abi::BlendFactor;
  return factor == F::ConstantColor || factor == F::OneMinusConstantColor ||
         factor == F::ConstantAlpha || factor == F::OneMinusConstantAlpha;
}

bool usesConstant(const abi::BlendKey &key) {
  return key.enabled && (isConstant(key.sourceColor) || isConstant(key.destColor) ||
                         isConstant(key.sourceAlpha) || isConstant(key.destAlpha));
}

/// Queries the blend colour as it was set. Blending clamps it by the buffer's format, but a query
/// clamps it by CLAMP_FRAGMENT_COLOR (ARB_color_buffer_float). That is switched off for the query.
void queryBlendColor(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  const auto &targets = mirror.pixelOps.targets;
  const bool matters =
      caps.clampColor && std::any_of(targets.begin(), targets.end(),
                                     [](const auto &target) { return usesConstant(target.blend); });
  const GLenum clamp = matters ? query.name(GL_CLAMP_FRAGMENT_COLOR) : GLenum(GL_FALSE);
  if (clamp != GL_FALSE)
    query.host.ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
  query.host.GetFloatv(GL_BLEND_COLOR, mirror.constants.blendColor);
  if (clamp != GL_FALSE)
    query.host.ClampColor(GL_CLAMP_FRAGMENT_COLOR, clamp);
}

void queryTargets(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  bool lacking = false;
  const int count = std::min(caps.maxDrawBuffers, abi::kMaxColorTargets);
  for (int i = 0; i < count; ++i) {
    if (i > 0 && !caps.indexedBuffers)
      mirror.pixelOps.targets[std::size_t(i)] = mirror.pixelOps.targets[0];
    else
      queryTarget(caps, query, GLuint(i), mirror.pixelOps.targets[std::size_t(i)], lacking);
  }
  mirror.blendLacking = lacking;
  queryBlendColor(caps, query, mirror);
  mirror.pixelOps.logicOpEnabled = query.enabled(GL_COLOR_LOGIC_OP) ? 1 : 0;
  mirror.pixelOps.logicOp = mirror.pixelOps.logicOpEnabled
                                ? abi::LogicOp(query.name(GL_LOGIC_OP_MODE) - GL_CLEAR)
                                : abi::LogicOp::Copy;
}

struct StencilNames {
  GLenum function, fail, depthFail, depthPass, reference, compareMask, writeMask;
};
constexpr StencilNames kFront = {
    GL_STENCIL_FUNC, GL_STENCIL_FAIL,       GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS,
    GL_STENCIL_REF,  GL_STENCIL_VALUE_MASK, GL_STENCIL_WRITEMASK};
constexpr StencilNames kBack = {GL_STENCIL_BACK_FUNC,
                                GL_STENCIL_BACK_FAIL,
                                GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                                GL_STENCIL_BACK_PASS_DEPTH_PASS,
                                GL_STENCIL_BACK_REF,
                                GL_STENCIL_BACK_VALUE_MASK,
                                GL_STENCIL_BACK_WRITEMASK};

abi::StencilFaceKey queryFace(const HostQuery &query, const StencilNames &names,
                              abi::FragmentData &data, int face) {
  data.stencilReference[face] = std::uint8_t(std::clamp(query.integer(names.reference), 0, 0xFF));
  data.stencilCompareMask[face] = std::uint8_t(query.integer(names.compareMask));
  data.stencilWriteMask[face] = std::uint8_t(query.integer(names.writeMask));
  return {compareOf(query.name(names.function)), stencilOp(query.name(names.fail)),
          stencilOp(query.name(names.depthFail)), stencilOp(query.name(names.depthPass))};
}

/// Queries the stencil state. EXT_stencil_two_side has its own back face, which its active face
/// selects and which applies only while its test is enabled. The back face of GL 2.0 always
/// applies.
void queryStencil(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  abi::DepthStencilKey &key = mirror.pixelOps.depthStencil;
  abi::FragmentData &data = mirror.constants;
  key.stencilTest = query.enabled(GL_STENCIL_TEST) ? 1 : 0;
  key.front = key.back = {};
  if (!key.stencilTest)
    return;
  if (!caps.stencilTwoSide || !query.enabled(GL_STENCIL_TEST_TWO_SIDE_EXT)) {
    GLint active = GL_FRONT;
    if (caps.stencilTwoSide) {
      active = query.integer(GL_ACTIVE_STENCIL_FACE_EXT);
      if (active != GL_FRONT)
        query.host.ActiveStencilFaceEXT(GL_FRONT);
    }
    key.front = queryFace(query, kFront, data, 0);
    key.back = queryFace(query, kBack, data, 1);
    if (active != GL_FRONT)
      query.host.ActiveStencilFaceEXT(GLenum(active));
    return;
  }
  const GLenum active = query.name(GL_ACTIVE_STENCIL_FACE_EXT);
  query.host.ActiveStencilFaceEXT(GL_FRONT);
  key.front = queryFace(query, kFront, data, 0);
  query.host.ActiveStencilFaceEXT(GL_BACK);
  key.back = queryFace(query, kFront, data, 1);
  query.host.ActiveStencilFaceEXT(active);
}

void queryDepth(const HostQuery &query, abi::DepthStencilKey &key) {
  key.depthTest = query.enabled(GL_DEPTH_TEST) ? 1 : 0;
  key.depthWrite = 0;
  key.depthCompare = abi::Compare::Less;
  if (!key.depthTest)
    return;
  GLboolean mask = GL_TRUE;
  query.host.GetBooleanv(GL_DEPTH_WRITEMASK, &mask);
  key.depthWrite = mask ? 1 : 0;
  key.depthCompare = compareOf(query.name(GL_DEPTH_FUNC));
}

} // namespace

void queryPixelOps(const HostCaps &caps, const HostQuery &query, Mirror &mirror) {
  abi::FragmentKey &key = mirror.pixelOps;
  key.alphaTest = abi::Compare::Always;
  mirror.constants.alphaReference = 0;
  if (query.enabled(GL_ALPHA_TEST)) {
    key.alphaTest = compareOf(query.name(GL_ALPHA_TEST_FUNC));
    mirror.constants.alphaReference = query.number(GL_ALPHA_TEST_REF);
  }
  queryTargets(caps, query, mirror);
  queryDepth(query, key.depthStencil);
  queryStencil(caps, query, mirror);
  GLint clamp = GL_TRUE, clampVertex = GL_TRUE;
  if (caps.clampColor) {
    clamp = query.integer(GL_CLAMP_FRAGMENT_COLOR);
    clampVertex = query.integer(GL_CLAMP_VERTEX_COLOR);
  }
  mirror.clampFixedOnly = clamp == GL_FIXED_ONLY;
  key.clampColors = clamp != GL_FALSE ? 1 : 0;
  mirror.clampVertexColors = clampVertex != GL_FALSE;
  mirror.clampVertexFixedOnly = clampVertex == GL_FIXED_ONLY;
}

} // namespace arbiter::state
