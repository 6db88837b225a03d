#define GL_GLEXT_PROTOTYPES // before any header of GL
#include "state/mirror/testing/mirror_fields.h"

#include <gtest/gtest.h>

namespace arbiter::state::testing {
namespace {

template <typename Value> struct Pair {
  GLenum name;
  Value value;
};
constexpr Pair<abi::Compare> kCompares[] = {
    {GL_NEVER, abi::Compare::Never},         {GL_LESS, abi::Compare::Less},
    {GL_EQUAL, abi::Compare::Equal},         {GL_LEQUAL, abi::Compare::LessEqual},
    {GL_GREATER, abi::Compare::Greater},     {GL_NOTEQUAL, abi::Compare::NotEqual},
    {GL_GEQUAL, abi::Compare::GreaterEqual}, {GL_ALWAYS, abi::Compare::Always}};
constexpr Pair<abi::StencilOp> kStencilOps[] = {{GL_KEEP, abi::StencilOp::Keep},
                                                {GL_ZERO, abi::StencilOp::Zero},
                                                {GL_REPLACE, abi::StencilOp::Replace},
                                                {GL_INCR, abi::StencilOp::Increment},
                                                {GL_DECR, abi::StencilOp::Decrement},
                                                {GL_INVERT, abi::StencilOp::Invert},
                                                {GL_INCR_WRAP, abi::StencilOp::IncrementWrap},
                                                {GL_DECR_WRAP, abi::StencilOp::DecrementWrap}};
constexpr Pair<abi::BlendFactor> kFactors[] = {
    {GL_ZERO, abi::BlendFactor::Zero},
    {GL_ONE, abi::BlendFactor::One},
    {GL_SRC_COLOR, abi::BlendFactor::SourceColor},
    {GL_ONE_MINUS_SRC_COLOR, abi::BlendFactor::OneMinusSourceColor},
    {GL_DST_COLOR, abi::BlendFactor::DestColor},
    {GL_ONE_MINUS_DST_COLOR, abi::BlendFactor::OneMinusDestColor},
    {GL_SRC_ALPHA, abi::BlendFactor::SourceAlpha},
    {GL_ONE_MINUS_SRC_ALPHA, abi::BlendFactor::OneMinusSourceAlpha},
    {GL_DST_ALPHA, abi::BlendFactor::DestAlpha},
    {GL_ONE_MINUS_DST_ALPHA, abi::BlendFactor::OneMinusDestAlpha},
    {GL_CONSTANT_COLOR, abi::BlendFactor::ConstantColor},
    {GL_ONE_MINUS_CONSTANT_COLOR, abi::BlendFactor::OneMinusConstantColor},
    {GL_CONSTANT_ALPHA, abi::BlendFactor::ConstantAlpha},
    {GL_ONE_MINUS_CONSTANT_ALPHA, abi::BlendFactor::OneMinusConstantAlpha},
    {GL_SRC_ALPHA_SATURATE, abi::BlendFactor::SourceAlphaSaturate}};
constexpr Pair<abi::BlendEquation> kEquations[] = {
    {GL_FUNC_ADD, abi::BlendEquation::Add},
    {GL_FUNC_SUBTRACT, abi::BlendEquation::Subtract},
    {GL_FUNC_REVERSE_SUBTRACT, abi::BlendEquation::ReverseSubtract},
    {GL_MIN, abi::BlendEquation::Min},
    {GL_MAX, abi::BlendEquation::Max}};

/// Picks one face's functions from the tables. `names` receives their GL names.
abi::StencilFaceKey randomFace(Numbers &n, GLenum names[4]) {
  const auto function = n.of(kCompares);
  const auto fail = n.of(kStencilOps), depthFail = n.of(kStencilOps), pass = n.of(kStencilOps);
  names[0] = function.name;
  names[1] = fail.name;
  names[2] = depthFail.name;
  names[3] = pass.name;
  return {function.value, fail.value, depthFail.value, pass.value};
}

constexpr Field kPixels[] = {
    {"alpha test", dirty::kPixelOps,
     [](Numbers &n) -> Check {
       const bool on = n.chance(60);
       const auto compare = n.of(kCompares);
       const float reference = n.real(0, 1);
       turn(GL_ALPHA_TEST, on);
       glAlphaFunc(compare.name, reference);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.pixelOps.alphaTest, on ? compare.value : abi::Compare::Always);
         if (on) {
           EXPECT_EQ(m.constants.alphaReference, reference);
         }
       };
     }},
    {"depth", dirty::kPixelOps,
     [](Numbers &n) -> Check {
       const bool on = n.chance(60), write = n.chance(50);
       const auto compare = n.of(kCompares);
       turn(GL_DEPTH_TEST, on);
       glDepthMask(write);
       glDepthFunc(compare.name);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.pixelOps.depthStencil.depthTest, on);
         EXPECT_EQ(m.pixelOps.depthStencil.depthWrite, on && write);
         if (on) {
           EXPECT_EQ(m.pixelOps.depthStencil.depthCompare, compare.value);
         }
       };
     }},
    {"stencil", dirty::kPixelOps,
     [](Numbers &n) -> Check {
       const bool on = n.chance(70), twoSide = n.chance(40);
       turn(GL_STENCIL_TEST, on);
       turn(GL_STENCIL_TEST_TWO_SIDE_EXT, twoSide);
       const auto active =
           (PFNGLACTIVESTENCILFACEEXTPROC)testing::address("glActiveStencilFaceEXT");
       abi::StencilFaceKey keys[2];
       int references[2], masks[2], writes[2];
       for (int face = 0; face < 2; ++face) {
         GLenum names[4];
         keys[face] = randomFace(n, names);
         references[face] = n.below(256);
         masks[face] = n.below(256);
         writes[face] = n.below(256);
         const GLenum side = face == 0 ? GL_FRONT : GL_BACK;
         if (twoSide) {
           active(side);
           glStencilFunc(names[0], references[face], GLuint(masks[face]));
           glStencilOp(names[1], names[2], names[3]);
           glStencilMask(GLuint(writes[face]));
         } else {
           glStencilFuncSeparate(side, names[0], references[face], GLuint(masks[face]));
           glStencilOpSeparate(side, names[1], names[2], names[3]);
           glStencilMaskSeparate(side, GLuint(writes[face]));
         }
       }
       active(n.chance(50) ? GL_FRONT : GL_BACK);
       return [=, front = keys[0], back = keys[1], r0 = references[0], r1 = references[1],
               m0 = masks[0], m1 = masks[1], w0 = writes[0], w1 = writes[1]](const Mirror &m) {
         const abi::DepthStencilKey &key = m.pixelOps.depthStencil;
         EXPECT_EQ(key.stencilTest, on);
         if (!on)
           return;
         EXPECT_TRUE(key.front == front);
         EXPECT_TRUE(key.back == back);
         EXPECT_EQ(m.constants.stencilReference[0], r0);
         EXPECT_EQ(m.constants.stencilReference[1], r1);
         EXPECT_EQ(m.constants.stencilCompareMask[0], m0);
         EXPECT_EQ(m.constants.stencilCompareMask[1], m1);
         EXPECT_EQ(m.constants.stencilWriteMask[0], w0);
         EXPECT_EQ(m.constants.stencilWriteMask[1], w1);
       };
     }},
    {"blending", dirty::kPixelOps,
     [](Numbers &n) -> Check {
       const int on = n.below(16);
       const bool perBuffer = n.chance(40);
       abi::BlendKey keys[4];
       for (int i = 0; i < 4; ++i) {
         const auto sc = n.of(kFactors), dc = n.of(kFactors), sa = n.of(kFactors),
                    da = n.of(kFactors);
         const auto c = n.of(kEquations), a = n.of(kEquations);
         keys[i] = {1, sc.value, dc.value, sa.value, da.value, c.value, a.value};
         ((on >> i & 1) != 0 ? glEnablei : glDisablei)(GL_BLEND, GLuint(i));
         if (perBuffer || i == 0) {
           if (i == 0) {
             glBlendFuncSeparate(sc.name, dc.name, sa.name, da.name);
             glBlendEquationSeparate(c.name, a.name);
           } else {
             glBlendFuncSeparatei(GLuint(i), sc.name, dc.name, sa.name, da.name);
             glBlendEquationSeparatei(GLuint(i), c.name, a.name);
           }
         } else {
           keys[i] = keys[0];
         }
       }
       const float color = n.real(0, 1);
       glBlendColor(0.5f, color, 0.25f, 1);
       return [=, k = std::array<abi::BlendKey, 4>{keys[0], keys[1], keys[2], keys[3]}](
                  const Mirror &m) {
         for (std::size_t i = 0; i < 4; ++i) {
           const abi::BlendKey &got = m.pixelOps.targets[i].blend;
           EXPECT_TRUE(got == ((on >> i & 1) != 0 ? k[i] : abi::BlendKey{})) << "buffer " << i;
         }
         EXPECT_EQ(m.constants.blendColor[1], color);
         EXPECT_FALSE(m.blendLacking);
       };
     }},
    {"masks and logic", dirty::kPixelOps,
     [](Numbers &n) -> Check {
       int masks[4];
       for (int i = 0; i < 4; ++i) {
         masks[i] = n.below(16);
         glColorMaski(GLuint(i), GLboolean(masks[i] & 1), GLboolean(masks[i] >> 1 & 1),
                      GLboolean(masks[i] >> 2 & 1), GLboolean(masks[i] >> 3 & 1));
       }
       const bool logic = n.chance(50);
       const int op = n.below(16);
       turn(GL_COLOR_LOGIC_OP, logic);
       glLogicOp(GLenum(GL_CLEAR + op));
       return [=, wanted =
                      std::array<int, 4>{masks[0], masks[1], masks[2], masks[3]}](const Mirror &m) {
         for (std::size_t i = 0; i < 4; ++i)
           EXPECT_EQ(m.pixelOps.targets[i].writeMask, wanted[i]) << "buffer " << i;
         EXPECT_EQ(m.pixelOps.logicOpEnabled, logic);
         EXPECT_EQ(m.pixelOps.logicOp, logic ? abi::LogicOp(op) : abi::LogicOp::Copy);
       };
     }},
    {"clamps", dirty::kPixelOps,
     [](Numbers &n) -> Check {
       constexpr GLenum kClamps[] = {GL_TRUE, GL_FALSE, GL_FIXED_ONLY};
       const GLenum fragment = n.of(kClamps), vertex = n.of(kClamps);
       glClampColor(GL_CLAMP_FRAGMENT_COLOR, fragment);
       glClampColor(GL_CLAMP_VERTEX_COLOR, vertex);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.pixelOps.clampColors, fragment != GL_FALSE);
         EXPECT_EQ(m.clampFixedOnly, fragment == GL_FIXED_ONLY);
         EXPECT_EQ(m.clampVertexColors, vertex != GL_FALSE);
         EXPECT_EQ(m.vertex.clampColors != ColorClamp::None, vertex != GL_FALSE);
       };
     }},
};

} // namespace

std::span<const Field> pixelFields() { return kPixels; }

} // namespace arbiter::state::testing
