#include "exact_program.h"

namespace software {
namespace {

constexpr const char *kTargetNames[kExactUnits] = {"2D", "RECT", "CUBE", "3D", "1D"};
constexpr unsigned kAll = 0xF;

using Operands = std::array<ExactOperand, 3>;

bool has(Leaves leaves, Leaves flag) { return (leaves & flag) != 0; }
bool apart(Leaves a, Leaves b) { return !has(a & b, ~kFlags); }
Leaves all(const std::array<Leaves, 4> &leaves) {
  return leaves[0] | leaves[1] | leaves[2] | leaves[3];
}

/// True if component i of the result is one that hosts do not simplify before rounding.
using Holds = bool (*)(const Operands &of, std::size_t i);

bool always(const Operands &, std::size_t) { return true; }
/// True if no term is constant or a sum of products, and no two have anything in common.
bool termsApart(std::initializer_list<Leaves> terms) {
  Leaves before = kConstant;
  for (const Leaves term : terms) {
    if (!apart(before, term) || has(term, kProducts))
      return false;
    before |= term;
  }
  return true;
}
bool sum(const Operands &of, std::size_t i) {
  return termsApart({of[0].leaves[i], of[1].leaves[i]});
}
bool comparison(const Operands &of, std::size_t i) {
  return apart(of[0].leaves[i], of[1].leaves[i]);
}
bool product(const Operands &of, std::size_t i) {
  const Leaves a = of[0].leaves[i], b = of[1].leaves[i];
  return !has(a & b, kFunction) && !(has(a | b, kConstant) && has(a | b, kProduct));
}
/// Returns the leaves of a product's factors, which may be any.
Leaves pair(const Operands &of, std::size_t i) {
  return (of[0].leaves[i] | of[1].leaves[i]) & ~kFlags;
}
bool productAndSum(const Operands &of, std::size_t i) {
  return product(of, i) && termsApart({pair(of, i), of[2].leaves[i]});
}
bool dot3(const Operands &of, std::size_t) {
  return termsApart({pair(of, 0), pair(of, 1), pair(of, 2)});
}
bool dot4(const Operands &of, std::size_t) {
  return termsApart({pair(of, 0), pair(of, 1), pair(of, 2), pair(of, 3)});
}
bool homogeneous(const Operands &of, std::size_t) {
  return termsApart({pair(of, 0), pair(of, 1), pair(of, 2), of[1].leaves[3]}) &&
         !has(of[1].leaves[3], kProduct);
}
bool cross(const Operands &of, std::size_t i) {
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return i == 3 || termsApart({(of[0].leaves[j] | of[1].leaves[k]) & ~kFlags,
                               (of[0].leaves[k] | of[1].leaves[j]) & ~kFlags});
}
bool function(const Operands &of, std::size_t i) {
  return !has(of[0].leaves[i], kFunction | kConstant);
}
/// True if LRP is computed as the specification says, which the host only does for constants.
bool blend(const Operands &of, std::size_t i) {
  return termsApart({of[1].leaves[i], of[2].leaves[i]}) &&
         !has(of[1].leaves[i] | of[2].leaves[i], kProduct);
}

constexpr const char *kFactors[] = {"{0.3, 0.1, 0.75, 0.9}", "{0.6, 0.25, 0.01, 0.4}"};

/// How the components of the result depend on those of the operands.
enum class Shape {
  Each,
  Sum,
  Product,
  ProductAndSum,
  Dot,
  Cross,
  Blend,
  Distance,
  Function,
  Selection,
  Bound
};

struct Operation {
  const char *name;
  int operands;
  Holds holds;
  bool constants = false; ///< operands may be constants
  Shape shape = Shape::Each;
  unsigned mask = kAll; ///< the components that the specification defines
};
constexpr Operation kOperations[] = {
    {"MOV", 1, always, true},
    {"ABS", 1, always},
    {"FLR", 1, always},
    {"FRC", 1, always},
    {"SWZ", 1, always, false, Shape::Selection},
    {"ADD", 2, sum, false, Shape::Sum},
    {"SUB", 2, sum, false, Shape::Sum},
    {"MUL", 2, product, false, Shape::Product},
    {"MAD", 3, productAndSum, false, Shape::ProductAndSum},
    {"MIN", 2, always, true, Shape::Bound},
    {"MAX", 2, always, true, Shape::Bound},
    {"SLT", 2, comparison, true},
    {"SGE", 2, comparison, true},
    {"CMP", 3, always, true},
    {"LRP", 3, blend, false, Shape::Blend},
    {"DST", 2, product, false, Shape::Distance},
    {"DP3", 2, dot3, false, Shape::Dot},
    {"DP4", 2, dot4, false, Shape::Dot},
    {"DPH", 2, homogeneous, false, Shape::Dot},
    {"XPD", 2, cross, false, Shape::Cross, 0x7},
    {"RCP", 1, function, false, Shape::Function},
    {"EX2", 1, function, false, Shape::Function},
    {"SIN", 1, function, false, Shape::Function},
    {"COS", 1, function, false, Shape::Function},
    {"SCS", 1, function, false, Shape::Function, 0x3},
};

Leaves leavesAfter(Shape shape, const Operands &of, std::size_t i) {
  const Leaves a = of[0].leaves[i], b = of[1].leaves[i], c = of[2].leaves[i], any = a | b | c;
  const auto sumOf = [&](Leaves first, Leaves second) {
    return (any & ~kProduct) | (has(first & second, kProduct) ? kProducts : 0);
  };
  const Leaves every = (all(of[0].leaves) | all(of[1].leaves)) & ~kProduct;
  switch (shape) {
  case Shape::Sum:
    return sumOf(a, b);
  case Shape::Product:
    return any | kProduct | kHuge;
  case Shape::ProductAndSum:
    return sumOf(kProduct, c) | kHuge;
  case Shape::Dot:
    return every | kHuge;
  case Shape::Cross:
    return every | kProducts | kHuge;
  case Shape::Blend:
    return (any & ~kProduct) | kProducts;
  case Shape::Distance:
    return any | kProduct | kConstant | kHuge; // its x is 1
  case Shape::Function:
    return any | kFunction | kHuge;
  case Shape::Bound: // no constant, except of constants only
    return a == kConstant ? b : b == kConstant ? a : any;
  default:
    return any;
  }
}

class Writer {
public:
  explicit Writer(Random &random) : m_random(random), m_registers(random) {}

  std::string start() {
    std::string body;
    for (int i = 0; i < kExactTemporaries; ++i) {
      const ExactOperand from = m_registers.input();
      body += "MOV t" + std::to_string(i) + ", " + from.text + "; ";
      m_registers.write(i, kAll, from.leaves);
    }
    return body;
  }

  std::string some(int count) {
    std::string body;
    for (int i = 0; i < count; ++i)
      body += m_random.once(4) ? lookUp() : arithmetic();
    return body + (m_random.once(6) ? "KIL " + m_registers.operand().text + "; " : "");
  }

  std::string lookUp() {
    const int to = m_random.below(kExactTemporaries);
    const unsigned mask = anyMask(kAll);
    ExactOperand at = m_registers.operandOrConstants();
    std::string text;
    if (has(all(at.leaves), kHuge)) {
      text = "MIN p, " + at.text + ", {64, 64, 64, 64}; MAX p, p, {-64, -64, -64, -64}; ";
      at.text = "p";
    }
    text += lookUpTo(saturation() + " t" + std::to_string(to) + nameOf(mask), at.text);
    m_registers.write(to, mask, m_registers.texel(m_unit).leaves);
    return text;
  }

  /// \param to includes the suffix of saturation
  /// \param at the coordinate; a projected lookup's divisor is never near zero
  std::string lookUpTo(const std::string &to, const std::string &at) {
    m_unit = m_random.below(kExactUnits);
    const bool projected = kExactTargets[m_unit] != GL_TEXTURE_CUBE_MAP && m_random.once(4);
    static constexpr const char *kOrders[] = {"", ".yxzw", ".xxyw", ".zyxw"};
    const std::string divided =
        "fragment.texcoord[" + std::to_string(m_random.below(3)) + "]" + m_random.pick(kOrders);
    return std::string(projected          ? "TXP"
                       : m_random.once(4) ? "TXB"
                                          : "TEX") +
           to + ", " + (projected ? divided : at) + ", texture[" + std::to_string(m_unit) + "], " +
           kTargetNames[m_unit] + "; ";
  }

  std::string operand() { return m_registers.operand().text; }
  std::string result() { return "MOV result.color, t" + std::to_string(m_registers.last()) + "; "; }

private:
  std::string saturation() { return m_random.once(6) ? "_SAT" : ""; }

  unsigned anyMask(unsigned of) {
    const unsigned some = of & unsigned(m_random.below(16));
    return m_random.once(4) && some ? some : of;
  }
  static std::string nameOf(unsigned mask) {
    std::string name = mask == kAll ? "" : ".";
    for (unsigned i = 0; i < 4 && mask != kAll; ++i)
      if (mask >> i & 1)
        name += "xyzw"[i];
    return name;
  }

  /// Tries operands until some are suitable; those of dot products seldom are.
  std::string arithmetic() {
    constexpr int kTries = 40;
    Operation operation = {};
    for (int i = 0;; ++i) {
      if (i % kTries == 0)
        operation = m_random.pick(kOperations);
      const unsigned mask = anyMask(operation.mask);
      Operands of;
      for (int k = 0; k < operation.operands; ++k)
        of[std::size_t(k)] = operandOf(operation, k);
      bool holds = true;
      for (std::size_t c = 0; c < 4; ++c)
        holds = holds && (!(mask >> c & 1) || operation.holds(of, c));
      if (holds)
        return write(operation, mask, of);
    }
  }

  ExactOperand operandOf(const Operation &operation, int which) {
    if (operation.shape == Shape::Function)
      return m_registers.scalar();
    if (operation.shape == Shape::Selection)
      return m_registers.selection();
    if (operation.shape == Shape::Blend && which == 0) {
      ExactOperand factor = {m_random.pick(kFactors), {}};
      factor.leaves.fill(kConstant);
      return factor;
    }
    return operation.constants ? m_registers.operandOrConstants() : m_registers.operand();
  }

  std::string write(const Operation &operation, unsigned mask, const Operands &of) {
    const int to = m_random.below(kExactTemporaries);
    std::array<Leaves, 4> leaves = {};
    for (std::size_t i = 0; i < 4; ++i)
      leaves[i] = leavesAfter(operation.shape, of, i);
    m_registers.write(to, mask, leaves);
    std::string text = operation.name + saturation() + " t" + std::to_string(to) + nameOf(mask);
    for (int k = 0; k < operation.operands; ++k)
      text += ", " + of[std::size_t(k)].text;
    return text + "; ";
  }

  Random &m_random;
  ExactRegisters m_registers;
  int m_unit = 0;
};

/// An instruction whose rounding is implementation-dependent, after ones that keep its operands A,
/// B and C in the range that the specification defines.
struct Near {
  const char *name, *text;
};
#define POSITIVE "ABS p, A; MAX p, p, {0.05, 0.05, 0.05, 0.05}; "
#define UNITS "MOV_SAT p, A; MOV_SAT q, B; MOV_SAT r, C; "
constexpr Near kNear[] = {
    {"RSQ", POSITIVE "RSQ result.color, p.x; "},
    {"LG2", POSITIVE "LG2 result.color, p.x; "},
    {"POW", POSITIVE "MIN q, B, {8, 8, 8, 8}; MAX q, q, {-8, -8, -8, -8}; "
                     "POW result.color, p.x, q.y; "},
    {"LIT", POSITIVE "MIN p, p, {16, 16, 16, 16}; MOV p.x, B; LIT result.color, p; "},
    {"LRP", UNITS "LRP result.color, p, q, r; "},
    {"terms that cancel", UNITS "SUB q, q, p; ADD result.color, q, p; "},
    {"terms with a factor in common", UNITS "MUL q, q, p; MAD result.color, p, r, q; "},
    {"a third term", UNITS "MUL p, p, q; MAD p, r, r, p; ADD result.color, p, r; "},
    {"constants in sums", UNITS "ADD p, p, {0.1, 0.2, 0.3, 0.7}; "
                                "ADD result.color, p, {0.3, 0.7, 0.9, 0.1}; "},
};

std::string around(const std::string &body) {
  std::string text = "!!ARBfp1.0 TEMP p, q, r";
  for (int i = 0; i < kExactTemporaries; ++i)
    text += ", t" + std::to_string(i);
  return text + "; " + body + "END";
}

} // namespace

std::string plainProgram(Random &random) {
  Writer writer(random);
  const std::string from = ExactRegisters(random).input().text;
  return around(random.once(2) ? "MOV result.color, " + from + "; "
                               : writer.lookUpTo(" result.color", from));
}

std::string exactProgram(Random &random) {
  Writer writer(random);
  std::string body = writer.start();
  body += writer.some(random.between(2, 7));
  return around(body + writer.result());
}

std::string nearProgram(Random &random) {
  Writer writer(random);
  const Near near = random.pick(kNear);
  std::string body = writer.start();
  body += writer.some(random.between(0, 3));
  for (const char *at = near.text; *at; ++at) {
    const bool isOperand = *at >= 'A' && *at <= 'C' && (at[1] == ';' || at[1] == ',');
    body += isOperand ? writer.operand() : std::string(1, *at);
  }
  return std::string("about ") + near.name + ": " + around(body);
}

} // namespace software
