// Tests vertex functions through the engine: arrays in, arrays out, relative operands.

#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::llvm_back {
namespace {

using ir::Opcode;
using ir::Vec4;

constexpr std::size_t kVertices = 48;

/// Arrays in the form of a draw.
class Arrays {
public:
  explicit Arrays(std::size_t vectors) : m_floats(vectors * 4) {
    for (auto &array : m_floats)
      array = static_cast<float *>(std::aligned_alloc(64, kVertices * sizeof(float)));
    for (float *const array : m_floats)
      std::fill_n(array, kVertices, -99.0f);
  }
  ~Arrays() {
    for (float *const array : m_floats)
      std::free(array);
  }
  Arrays(const Arrays &) = delete;
  Arrays &operator=(const Arrays &) = delete;

  float *const *data() const { return m_floats.data(); }
  float *component(std::size_t vector, std::size_t c) { return m_floats[4 * vector + c]; }
  Vec4 at(std::size_t vector, std::size_t vertex) const {
    Vec4 value = {};
    for (std::size_t c = 0; c < 4; ++c)
      value[c] = m_floats[4 * vector + c][vertex];
    return value;
  }

private:
  std::vector<float *> m_floats;
};

class VertexTest : public ::testing::TestWithParam<std::string> {
protected:
  /// Compiles a program and runs it on kVertices vertices.
  void run(const ir::Program &program, const Arrays &in, Arrays &out,
           const std::vector<Vec4> &rows) {
    const auto engine = makeEngine({GetParam()});
    ASSERT_NE(engine, nullptr);
    const auto prepared = engine->prepareVertex(program, Numerics::Host);
    ASSERT_NE(prepared, nullptr);
    m_shape = prepared->shape();
    std::string reason;
    const auto code = engine->compile(*prepared, abi::VertexKey{}, reason);
    ASSERT_NE(code, nullptr) << reason;
    abi::VertexData data;
    data.parameters = reinterpret_cast<const float(*)[4]>(rows.data());
    data.inputs = in.data();
    data.outputs = out.data();
    code->function(&data, kVertices);
  }

  jit::VertexShape m_shape;
};

/// Addresses inside, at the ends of, and far outside an array.
const float kAddresses[] = {0,     1,      2,    2.9f,  3,    -1,      -2,  -0.5f,
                            1e10f, -1e10f, 1e9f, -1e9f, 2e9f, 0x1p31f, NAN, INFINITY};

void relativeProgram(ir::Builder &b, bool inOrder) {
  const ir::Source rows[] = {b.local(0), b.local(1), b.local(2), b.local(3)};
  const int array =
      inOrder ? b.array({rows[0], rows[1], rows[2]}) : b.array({rows[3], rows[1], rows[1]});
  const ir::Target address = b.address();
  b.op(Opcode::Arl, address.mask("x"), {b.attribute(ir::AttributeKind::Generic, 1).swz("x")});
  b.op(Opcode::Mov, b.result(ir::OutputKind::FrontPrimary), {ir::Builder::element(array, address)});
  b.op(Opcode::Mov, b.result(ir::OutputKind::FrontSecondary),
       {ir::Builder::element(array, address, 1)});
  b.op(Opcode::Mov, b.result(ir::OutputKind::BackPrimary).mask("xw"),
       {-ir::Builder::element(array, address, -2).swz("wzyx")});
}

TEST_P(VertexTest, RelativeOperandsReadTheirRowsOrZero) {
  for (const bool inOrder : {true, false}) {
    ir::Builder b(ir::Language::ArbVertex);
    relativeProgram(b, inOrder);
    const ir::Program &program = b.program();
    std::vector<Vec4> rows;
    for (std::size_t i = 0; i < program.parameters.size(); ++i)
      rows.push_back({float(i) + 1, float(i) + 10, float(i) + 100, float(i) + 1000});
    Arrays in(1), out(4); // three outputs and the position
    for (std::size_t i = 0; i < kVertices; ++i)
      in.component(0, 0)[i] = kAddresses[i % std::size(kAddresses)];
    run(program, in, out, rows);
    for (std::size_t i = 0; i < kVertices; ++i) {
      ir::Inputs inputs;
      const std::array<Vec4, 1> attributes = {in.at(0, i)};
      inputs.attributes = attributes;
      inputs.parameter = [&](const ir::Parameter &wanted) {
        return rows[std::size_t(&wanted - program.parameters.data())];
      };
      const auto expected = ir::evaluate(program, inputs).outputs;
      for (std::size_t o = 0; o < 3; ++o)
        EXPECT_EQ(out.at(o, i), expected[o])
            << "address " << in.at(0, i)[0] << ", output " << o << ", in order " << inOrder;
    }
  }
}

TEST_P(VertexTest, ShapeListsWhatIsReadAndWritten) {
  ir::Builder b(ir::Language::ArbVertex);
  const ir::Target unused = b.temporary();
  b.op(Opcode::Mov, unused, {b.attribute(ir::AttributeKind::Normal)});
  b.op(Opcode::Mov, b.result(ir::OutputKind::PointSize).mask("y"),
       {b.attribute(ir::AttributeKind::TexCoord)});
  b.op(Opcode::Mov, b.result(ir::OutputKind::FogCoord).mask("x"),
       {b.attribute(ir::AttributeKind::FogCoord)});
  b.op(Opcode::Mov, b.result(ir::OutputKind::TexCoord, 3).mask("y"),
       {b.attribute(ir::AttributeKind::FogCoord).swz("x")});
  Arrays in(1), out(3);
  for (std::size_t i = 0; i < kVertices; ++i)
    in.component(0, 0)[i] = float(i);
  run(b.program(), in, out, {});
  ASSERT_EQ(m_shape.inputs.size(), 1u);
  EXPECT_EQ(m_shape.inputs[0].kind, ir::AttributeKind::FogCoord);
  ASSERT_EQ(m_shape.outputs.size(), 3u);
  EXPECT_EQ(m_shape.outputs[0].kind, ir::OutputKind::FogCoord);
  EXPECT_EQ(m_shape.outputs[1].kind, ir::OutputKind::TexCoord);
  EXPECT_EQ(m_shape.outputs[2].kind, ir::OutputKind::Position) << "every vertex has one";
  EXPECT_EQ(out.at(0, 7), (Vec4{7, -99, -99, -99})); // only x is stored
  EXPECT_EQ(out.at(1, 7), (Vec4{0, 7, 0, 0}));
  EXPECT_EQ(out.at(2, 7), (Vec4{}));
}

INSTANTIATE_TEST_SUITE_P(All, VertexTest, ::testing::ValuesIn(testedCpus()),
                         [](const auto &param) { return nameInTests(param.param); });

} // namespace
} // namespace arbiter::fp::llvm_back
