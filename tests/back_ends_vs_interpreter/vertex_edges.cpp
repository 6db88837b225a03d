#include <array>
#include <cmath>
#include <cstdio>

#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/testing/specials.h"
#include "tolerance.h"
#include "vertex_clip.h"
#include "vertex_reader.h"
#include "vertex_suite.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
using fp::testing::kInf;

/// The values include no NaN, as a vertex with one may be dropped.
constexpr std::array<float, 20> kVertexSpecial = {
    0.0f,    -0.0f, 1.0f,   -1.0f,  0.5f,      2.0f,   -2.5f, kInf,       -kInf,    1e-40f,
    -1e-40f, 1e30f, -1e30f, 130.0f, 0x1p-100f, -0.75f, 8.0f,  7.9999995f, 0x1p127f, 0x1p-126f};

Vec4 specialAt(int x, int y) {
  const auto at = [](int i) {
    return comparable(kVertexSpecial[std::size_t(i) % kVertexSpecial.size()]);
  };
  return {at(y * kSide + x), at(3 * x + 7 * y), at(x + 3 * y), at(5 * x + y)};
}

struct Case {
  std::string name, text;
  Opcode op = Opcode::Mov; ///< its tolerance applies
};

Case opcodeCase(Opcode op) {
  const OpInfo &row = info(op);
  constexpr const char *kScalars[] = {"v.x", "v.y"};
  constexpr const char *kVectors[] = {"v", "v.yxwz", "v.zwxy"};
  std::string statement = std::string(row.mnemonic) + " r";
  for (int i = 0; i < row.operandCount(); ++i)
    statement += std::string(", ") + (row.shapes[i] == 'S' ? kScalars[i] : kVectors[i]);
  if (op == Opcode::Swz)
    statement += ", -y, 1, 0, -x";
  return {row.mnemonic,
          "!!ARBvp1.0\nATTRIB v = vertex.attrib[1];\nTEMP r;\n" + statement +
              ";\nMOV result.position, vertex.position;\nMOV result.texcoord[0], r;\nEND\n",
          op};
}

/// Returns a case that reads an array's rows at every special address; rows that do not exist are
/// zero.
Case addressCase(const std::string &rows, const char *offset) {
  return {"ARL " + rows + offset,
          "!!ARBvp1.0\nADDRESS a;\nPARAM rows[] = { " + rows +
              " };\nARL a.x, vertex.attrib[1].x;\nMOV result.position, vertex.position;\n"
              "MOV result.texcoord[0], rows[a.x" +
              offset + "];\nEND\n"};
}

std::vector<Case> cases() {
  std::vector<Case> result;
  for (int op = 0; op < kOpcodeCount; ++op)
    if (!info(Opcode(op)).has(FragmentOnly) && Opcode(op) != Opcode::Arl)
      result.push_back(opcodeCase(Opcode(op)));
  for (const char *offset : {"", "+1", "-2", "+63", "-64"}) {
    result.push_back(addressCase("program.env[3..6]", offset));
    result.push_back(addressCase("{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}", offset));
    result.push_back(addressCase("state.matrix.mvp, program.local[1], {5, 6, 7, 8}", offset));
  }
  return result;
}

/// Returns false if a host may fuse operations, or reorder sums, on the way to or from an infinity.
bool isDefined(Opcode op, const Vec4 &value) {
  const OpInfo &row = info(op);
  const bool sums = row.has(Replicates) && row.operandCount() == 2 && op != Opcode::Pow;
  if (!sums && op != Opcode::Mad && op != Opcode::Xpd)
    return true;
  for (const float v : value)
    if (std::fabs(v) > 1e4f)
      return false;
  return true;
}

bool agree(Opcode op, float seen, float expected) {
  const Tolerance allowed = tolerance(op, fp::Numerics::Legacy); // equal to Host's
  return std::fabs(seen - expected) <=
         (allowed.relative + 8 * allowed.operand) * std::fabs(expected) + allowed.absolute + 1e-37f;
}

class VertexEdges {
public:
  VertexEdges(Backend &backend, fp::Numerics numerics) : m_backend(backend), m_numerics(numerics) {}

  Report run() {
    if (!begin(m_report, m_target))
      return m_report;
    applyState(m_backend.hasProgramMatrices());
    for (const Case &wanted : cases())
      one(wanted);
    ++m_report.programs;
    if (const std::string difference = clipDifference(m_backend, m_target); !difference.empty())
      fail({"user clip plane", ""}, difference);
    return m_report;
  }

private:
  static void drawSpecialPoints(const Program &) {
    glBegin(GL_POINTS);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        glVertexAttrib4fvARB(1, specialAt(x, y).data());
        glVertex4fv(vertexValue({AttributeKind::Position, 0}, x, y).data());
      }
    glEnd();
  }

  void one(const Case &wanted) {
    ++m_report.programs;
    const fp::CheckResult checked = fp::checkProgram(Language::ArbVertex, wanted.text,
                                                     {suiteLimits(), fp::LimitPolicy::Enforce});
    if (!checked.ok())
      return fail(wanted, checked.errorString(wanted.text));
    const Reader reader(*checked.program);
    const std::string problem =
        reader.draw(m_backend, wanted.text, *checked.program, m_target, drawSpecialPoints);
    if (!problem.empty())
      return fail(wanted, problem);
    const Drawn drawn(m_target);
    int wrong = 0;
    std::string first;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const std::string difference = compare(wanted.op, *checked.program, drawn, x, y);
        if (!difference.empty() && wrong++ == 0)
          first = difference;
      }
    if (wrong != 0)
      fail(wanted, std::to_string(wrong) + " of 256 vertices, first: " + first);
  }

  std::string compare(Opcode op, const Program &program, const Drawn &drawn, int x, int y) {
    const Vec4 given = specialAt(x, y);
    if (!isDefined(op, given)) {
      m_report.skipped += 4;
      return "";
    }
    std::vector<Vec4> attributes;
    for (const Attribute &attribute : program.attributes)
      attributes.push_back(attribute.kind == AttributeKind::Generic ? given
                                                                    : vertexValue(attribute, x, y));
    Inputs inputs;
    inputs.attributes = attributes;
    inputs.parameter = parameterValue;
    inputs.numerics = m_numerics;
    const Evaluation evaluation = evaluate(program, inputs);
    const Vec4 seen = drawn.color(0, x, y);
    for (std::size_t o = 0; o < program.outputs.size(); ++o) {
      const Vec4 &expected = evaluation.outputs[o];
      for (std::size_t i = 0; program.outputs[o].kind == OutputKind::TexCoord && i < 4; ++i) {
        // A rasterizer need not pass on an infinite coordinate.
        if (!std::isfinite(expected[i])) {
          ++m_report.skipped;
          continue;
        }
        ++m_report.compared;
        if (!agree(op, seen[i], expected[i]))
          return numbers(given) + " gave " + numbers(seen) + ", expected " + numbers(expected);
      }
    }
    return "";
  }

  static std::string numbers(const Vec4 &value) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g, %.9g)", double(value[0]), double(value[1]),
                  double(value[2]), double(value[3]));
    return text;
  }

  void fail(const Case &wanted, const std::string &reason) {
    m_report.failures.push_back({std::uint64_t(m_report.programs), wanted.name + ": " + reason});
  }

  Backend &m_backend;
  fp::Numerics m_numerics;
  FloatTarget m_target;
  Report m_report;
};
} // namespace

Report runVertexEdges(Backend &backend, const SuiteOptions &options) {
  (void)keepsDenormals(); // it draws, which is not allowed between Begin and End
  return VertexEdges(backend, options.numerics).run();
}

} // namespace arbiter::differential
