// Checks variants of vertex programs by the place of their attributes, run by the interpreter.
#include "state/programs/variants/attribute_forms.h"

#include <gtest/gtest.h>

#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::state {
namespace {

using fp::ir::AttributeKind;
using fp::ir::Builder;
using fp::ir::Language;
using fp::ir::Opcode;
using fp::ir::OutputKind;
using fp::ir::Program;
using fp::ir::Vec4;

Program copies(AttributeKind kind, std::string_view mask) {
  Builder builder(Language::ArbVertex);
  builder.op(Opcode::Mov, builder.result(OutputKind::FrontPrimary).mask(mask),
             {builder.attribute(kind)});
  Program program = builder.take();
  // Lowered like programs of NVIDIA's own languages.
  program.options.nv = fp::ir::NvOption::First;
  program.options.native = fp::ir::NativeLanguage::Vp1;
  return program;
}

/// Returns the colour computed by the variant of `v[number]` that reads both attributes.
Vec4 chosen(AttributeKind kind, unsigned number, const Vec4 &conventional, const Vec4 &generic) {
  const auto form = withAttributes(copies(kind, "xyzw"), 0, 1u << number);
  EXPECT_TRUE(fp::ir::validate(*form).empty());
  Program plain = copies(kind, "xyzw"); // now as an ARB program
  plain.options = {};
  EXPECT_TRUE(fp::ir::validate(*withAttributes(plain, 0, 1u << number)).empty());
  std::vector<Vec4> attributes;
  for (const fp::ir::Attribute &attribute : form->attributes)
    attributes.push_back(attribute.kind == AttributeKind::Generic ? generic : conventional);
  fp::ir::Inputs inputs;
  inputs.attributes = attributes;
  return fp::ir::evaluate(*form, inputs).outputs[0];
}

TEST(AttributeForms, GenericNamesBecomeTheConventionalOnes) {
  Builder builder(Language::ArbVertex);
  constexpr std::uint8_t kNumbers[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 15};
  for (const std::uint8_t number : kNumbers)
    builder.op(Opcode::Mov, builder.result(OutputKind::FrontPrimary),
               {builder.attribute(AttributeKind::Generic, number)});
  const Program program = builder.take();
  const auto form = withConventionalAttributes(program);
  ASSERT_TRUE(form);
  ASSERT_EQ(form->attributes.size(), std::size(kNumbers));
  for (std::size_t i = 0; i < std::size(kNumbers); ++i) {
    const fp::ir::Attribute &attribute = form->attributes[i];
    const bool hasNoOther = kNumbers[i] < 2 || kNumbers[i] == 6 || kNumbers[i] == 7;
    EXPECT_EQ(attribute.kind == AttributeKind::Generic, hasNoOther) << int(kNumbers[i]);
    EXPECT_EQ(hasNoOther ? attribute.index : genericNumberOf(attribute), kNumbers[i]);
  }
  EXPECT_EQ(registersOf(program), 0u);
  EXPECT_EQ(registersOf(*form), 0x813Cu);
  EXPECT_EQ(withConventionalAttributes(copies(AttributeKind::Normal, "xyz")), nullptr);
}

TEST(AttributeForms, ComponentsBeyondTheConventionalOnesAreFound) {
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::Normal, "xyz")), 0u);
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::Normal, "w")), 1u << 2);
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::ColorSecondary, "xyz")), 0u);
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::ColorSecondary, "xw")), 1u << 4);
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::FogCoord, "x")), 0u);
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::FogCoord, "y")), 1u << 5);
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::ColorPrimary, "xyzw")), 0u);
  EXPECT_EQ(readsBeyondConventional(copies(AttributeKind::TexCoord, "xyzw")), 0u);
}

TEST(AttributeForms, TheGenericOneCountsWhereTheCommonComponentsAreEqual) {
  const Vec4 normal = {1, 2, 3, 1};
  EXPECT_EQ(chosen(AttributeKind::Normal, 2, normal, {1, 2, 3, 4}), (Vec4{1, 2, 3, 4}));
  for (const Vec4 &other : {Vec4{9, 2, 3, 4}, Vec4{1, 9, 3, 4}, Vec4{1, 2, 9, 4}})
    EXPECT_EQ(chosen(AttributeKind::Normal, 2, normal, other), normal);
  const Vec4 fog = {5, 0, 0, 1};
  EXPECT_EQ(chosen(AttributeKind::FogCoord, 5, fog, {5, 6, 7, 8}), (Vec4{5, 6, 7, 8}));
  EXPECT_EQ(chosen(AttributeKind::FogCoord, 5, fog, {4, 6, 7, 8}), fog);
}

TEST(AttributeForms, AnArrayIsReadAlone) {
  const auto form = withAttributes(copies(AttributeKind::TexCoord, "xyzw"), 1u << 8, 0);
  ASSERT_EQ(form->attributes.size(), 1u);
  EXPECT_EQ(form->attributes[0], (fp::ir::Attribute{AttributeKind::Generic, 8}));
  EXPECT_EQ(form->code.size(), 1u);
}

} // namespace
} // namespace arbiter::state
