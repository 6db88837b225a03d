#include "fp_compiler/vertex_shader/lower.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/vertex_shader/random_shader.h"

namespace arbiter::fp::vertex_shader {
namespace {

using testing::RandomVertexShader;
using testing::SymbolValue;
using testing::VertexShaderResults;

ir::Vec4 rowOf(const Symbol &symbol, const SymbolValue &value, std::size_t row) {
  if (symbol.type == DataType::Matrix)
    return {float(value[row]), float(value[row + 4]), float(value[row + 8]),
            float(value[row + 12])};
  return {float(value[0]), float(value[1]), float(value[2]), float(value[3])};
}

/// The symbol values of a random shader, in the form that the IR's interpreter needs.
struct Surroundings {
  const RandomVertexShader &made;
  const Lowered &lowered;

  [[nodiscard]] ir::Vec4 parameter(const ir::Parameter &parameter) const {
    const auto &symbols = made.shader.symbols;
    if (parameter.kind == ir::ParameterKind::Env) {
      const EnvRow &row = lowered.env.at(parameter.index);
      return rowOf(symbols[row.symbol], made.values[row.symbol], row.row);
    }
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      ir::StateRef first = parameter.state;
      first.row = 0;
      if (symbols[i].from != From::State || !(symbols[i].state == first))
        continue;
      if (symbols[i].type != DataType::Scalar)
        return rowOf(symbols[i], made.values[i], parameter.state.row);
      ir::Vec4 value = {9.0f, 9.0f, 9.0f, 9.0f};
      value[symbols[i].component] = float(made.values[i][0]);
      return value;
    }
    ADD_FAILURE() << "a parameter of no symbol";
    return {};
  }

  [[nodiscard]] std::vector<ir::Vec4> attributes() const {
    std::vector<ir::Vec4> values;
    for (const ir::Attribute &wanted : lowered.program.attributes)
      for (std::size_t i = 0; i < made.values.size(); ++i) {
        const Symbol &symbol = made.shader.symbols[i];
        for (std::size_t column = 0; column < std::size_t(rowCount(symbol.type)); ++column)
          if (symbol.from == From::Attribute && symbol.attributes[column] == wanted) {
            ir::Vec4 value = {};
            for (std::size_t c = 0; c < 4; ++c)
              value[c] = float(made.values[i][column * 4 + c]);
            if (symbol.isDirection)
              value[3] = 1.0f; // as the attribute's w is
            values.push_back(value);
          }
      }
    return values;
  }
};

/// Compares a program's results with those of the specification.
struct Judge {
  const VertexShaderResults &exact, &disturbed;
  int judged = 0, unjudged = 0;

  void compare(double is, double should, double other, const std::string &what) {
    const double tolerance = 1e-3 * std::max(1.0, std::abs(should));
    if (std::abs(should - other) > tolerance / 4) {
      ++unjudged;
      return;
    }
    ++judged;
    EXPECT_NEAR(is, should, tolerance) << what;
  }
};

TEST(VertexShaderLowering, MeansWhatTheTableSays) {
  int judged = 0, unjudged = 0, undefined = 0;
  constexpr int kShaders = 3000;
  for (int seed = 0; seed < kShaders && !HasFailure(); ++seed) {
    testing::Random random{std::uint64_t(seed)};
    const RandomVertexShader made = testing::randomVertexShader(random);
    const Lowered lowered = lower(made.shader);
    ASSERT_EQ(ir::validate(lowered.program), std::vector<std::string>{})
        << seed << "\n"
        << ir::print(lowered.program);
    const VertexShaderResults exact = testing::evaluateVertexShader(made.shader, made.values);
    const VertexShaderResults disturbed =
        testing::evaluateVertexShader(made.shader, made.values, 1e-5);
    if (!exact.defined || !disturbed.defined) {
      ++undefined;
      continue;
    }
    const Surroundings around{made, lowered};
    const std::vector<ir::Vec4> attributes = around.attributes();
    ir::Inputs inputs;
    inputs.attributes = attributes;
    inputs.parameter = [&](const ir::Parameter &parameter) { return around.parameter(parameter); };
    const ir::Evaluation result = ir::evaluate(lowered.program, inputs);
    Judge judge{exact, disturbed};
    const std::string what = "seed " + std::to_string(seed) + "\n" + ir::print(lowered.program);
    for (std::size_t o = 0; o < lowered.program.outputs.size(); ++o) {
      const ir::Output &output = lowered.program.outputs[o];
      const ir::Vec4 &is = result.outputs[o];
      for (std::size_t c = 0; c < 4; ++c) {
        if (output.kind == ir::OutputKind::Position)
          judge.compare(double(is[c]), exact.position[c], disturbed.position[c], what);
        else if (output.kind == ir::OutputKind::TexCoord)
          judge.compare(double(is[c]), exact.texCoords[output.index][c],
                        disturbed.texCoords[output.index][c], what);
        else if (output.kind == ir::OutputKind::FogCoord && c == 0)
          judge.compare(double(is[0]), exact.fog, disturbed.fog, what);
        else if (output.kind == ir::OutputKind::FrontPrimary ||
                 output.kind == ir::OutputKind::FrontSecondary) {
          const std::size_t color = output.kind == ir::OutputKind::FrontPrimary ? 0 : 1;
          judge.compare(double(is[c]), exact.colors[color][c], disturbed.colors[color][c], what);
        }
      }
    }
    judged += judge.judged;
    unjudged += judge.unjudged;
    EXPECT_FALSE(emitAssembly(lowered.program).empty());
    EXPECT_FALSE(emitGlsl(lowered.program).text.empty());
  }
  EXPECT_LT(undefined, kShaders / 20);
  EXPECT_LT(unjudged, judged / 20);
  RecordProperty("judged", judged);
}

/// Runs one operation on constants and returns its result from a texture coordinate.
ir::Vec4 resultOf(Op op, std::initializer_list<ir::Vec4> arguments, DataType type) {
  Shader shader;
  Operation operation{.op = op, .result = {Place::TexCoord, 0}};
  std::size_t at = 0;
  for (const ir::Vec4 &argument : arguments) {
    Symbol symbol{.type = type, .from = From::Constant};
    symbol.constant[0] = argument;
    symbol.blockFirst = std::uint32_t(at);
    operation.arguments[at++] = std::uint32_t(shader.symbols.size());
    shader.symbols.push_back(symbol);
  }
  shader.symbols.push_back({.type = type});
  if (type == DataType::Scalar)
    operation.result = {Place::Local, std::uint32_t(shader.symbols.size() - 1)};
  shader.code.push_back(operation);
  if (type == DataType::Scalar)
    shader.code.push_back({.op = Op::Mov,
                           .result = {Place::TexCoord, 0},
                           .arguments = {std::uint32_t(shader.symbols.size() - 1)}});
  return ir::evaluate(lower(shader).program, {}).outputs[0];
}

TEST(VertexShaderLowering, ClampChoosesAsItIsWritten) {
  const ir::Vec4 low = {0, 0.5f, 1, -1}, high = {1, 0.25f, -1, -1};
  // (a <= low) ? low : (a >= high) ? high : a
  EXPECT_EQ(resultOf(Op::Clamp, {{2, 2, 2, 2}, low, high}, DataType::Vector),
            (ir::Vec4{1, 0.25f, -1, -1}));
  EXPECT_EQ(resultOf(Op::Clamp, {{-2, 0.3f, 1, -2}, low, high}, DataType::Vector),
            (ir::Vec4{0, 0.5f, 1, -1}));
  const float inf = std::numeric_limits<float>::max();
  EXPECT_EQ(resultOf(Op::Clamp, {{inf, -inf, inf, -inf}, low, high}, DataType::Vector),
            (ir::Vec4{1, 0.5f, -1, -1}));
}

TEST(VertexShaderLowering, PowersOfNegativeNumbers) {
  const auto power = [](float base, float exponent) {
    return resultOf(Op::Power, {{base, 0, 0, 0}, {exponent, 0, 0, 0}}, DataType::Scalar)[0];
  };
  EXPECT_NEAR(power(-2, 2), 4, 1e-4);
  EXPECT_NEAR(power(-2, 3), -8, 1e-4);
  EXPECT_NEAR(power(-2, -1), -0.5, 1e-5);
  EXPECT_NEAR(power(2, 0.5f), std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(power(2, -3), 0.125, 1e-5);
  EXPECT_EQ(power(0, 0), 1);
  EXPECT_EQ(power(-3, 0), 1);
  EXPECT_EQ(power(0, 2), 0);
}

TEST(VertexShaderLowering, NothingInTheTableIsAnErrorElsewhere) {
  const DataType scalar[] = {DataType::Scalar, DataType::Scalar, DataType::Scalar};
  const DataType vector[] = {DataType::Vector, DataType::Vector, DataType::Vector};
  const DataType matrix[] = {DataType::Matrix, DataType::Vector, DataType::Vector};
  EXPECT_FALSE(isInTable(Op::Add, DataType::Scalar, vector));
  EXPECT_TRUE(isInTable(Op::Add, DataType::Vector, scalar));
  EXPECT_FALSE(isInTable(Op::Mov, DataType::Matrix, matrix));
  EXPECT_FALSE(isInTable(Op::Recip, DataType::Vector, vector));
  EXPECT_FALSE(isInTable(Op::Dot3, DataType::Vector, scalar));
  EXPECT_TRUE(isInTable(Op::MultiplyMatrix, DataType::Vector, matrix));
  EXPECT_EQ(argumentCount(Op::Clamp), 3);
  EXPECT_EQ(argumentCount(Op::Index), 2);
  EXPECT_EQ(argumentCount(Op::Recip), 1);
}

} // namespace
} // namespace arbiter::fp::vertex_shader
