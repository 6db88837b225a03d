#include "fp_compiler/testing/random_nv_words.h"

#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::testing {

using ir::Opcode;
using ir::OpInfo;

std::string NvWords::swizzle(bool scalar) {
  std::string word = ".";
  for (int i = 0; i < (scalar ? 1 : 4); ++i)
    word += "xyzw"[m_random.below(4)];
  return word;
}

std::string NvWords::attribute() {
  if (!m_options.vertex) {
    if (m_counting > 0 && m_random.chance(50))
      return "fragment.texcoord[A0.x + " + number(m_random.below(4)) + "]";
    return m_random.chance(10) && second() ? "fragment.facing"
           : m_random.chance(50)           ? "fragment.texcoord[1]"
                                           : "fragment.color";
  }
  if (second() && m_random.chance(30))
    return "vertex.texcoord[" + address() + " + " + number(m_random.below(5)) + "]";
  return m_random.chance(50) ? "vertex.texcoord[2]" : "vertex.color";
}

std::string NvWords::parameter() {
  if (m_options.vertex && m_random.chance(25))
    return "c[" + address() + " + " + number(m_random.below(5)) + "]";
  if (m_options.wild && m_random.chance(10))
    return m_random.chance(50) ? "large" : "small";
  return m_random.chance(70) ? "c[" + number(m_random.below(8)) + "]" : "k";
}

std::string NvWords::operand(bool scalar) {
  const std::string name = m_random.chance(60)   ? temporary()
                           : m_random.chance(50) ? parameter()
                                                 : attribute();
  std::string value = name + (scalar || m_random.chance(50) ? swizzle(scalar) : "");
  if (name == "fragment.facing") // NVIDIA has the same value in all of its components
    value = name + (scalar ? ".x" : ".xxxx");
  const std::string sign = m_random.chance(25) ? "-" : "";
  return m_random.chance(15) ? sign + "|" + value + "|" : sign + value;
}

std::string NvWords::condition() {
  constexpr const char *kRules[] = {"EQ", "GE", "GT", "LE", "LT", "NE", "TR", "FL"};
  const bool numbered = m_options.vertex && second() && m_random.chance(40);
  const int rule = m_random.chance(85) ? m_random.below(6) : m_random.below(8);
  return std::string(kRules[rule]) + (numbered ? (m_random.chance(50) ? "0" : "1") : "") +
         (m_random.chance(60) ? swizzle(m_random.chance(60)) : "");
}

std::string NvWords::suffix(const OpInfo &op, bool &saturates) {
  std::string word;
  if (!m_options.vertex && !op.has(ir::NoPrecision) && m_random.chance(30))
    word += m_options.peer                               ? "R"
            : op.has(ir::NoFixed) || m_random.chance(50) ? (m_random.chance(50) ? "R" : "H")
                                                         : "X";
  const bool sets = !op.has(ir::NoCondition) && m_random.chance(40) && updatesHere();
  if (sets)
    word += m_options.vertex && second() ? (m_random.chance(50) ? "C1" : "C") : "C";
  saturates = !op.has(ir::NoSaturate) && (!m_options.vertex || second()) && m_random.chance(20) &&
              !(m_options.peer && (sets || &op == &info(Opcode::Ssg)));
  if (saturates)
    word += !m_options.vertex && second() && m_random.chance(50) ? "_SSAT" : "_SAT";
  return word;
}

std::string NvWords::destination(Opcode op) {
  constexpr const char *kMasks[] = {"", "", "", ".x", ".yz", ".xw", ".xyz", ".w"};
  const int mask = m_random.below(8);
  const bool three = op == Opcode::Xpd || op == Opcode::Nrm || op == Opcode::Rfl;
  const std::string letters = op == Opcode::Scs        ? mask % 2 != 0 ? ".x" : ".xy"
                              : three && mask % 2 != 0 ? ".yz"
                              : three                  ? ".xyz"
                                                       : kMasks[mask];
  return temporary() + letters + (m_random.chance(35) ? " (" + condition() + ")" : std::string());
}

std::string NvWords::bare(std::string value) {
  std::erase_if(value, [](char letter) { return letter == '|'; });
  return value.starts_with('-') ? value.substr(1) : value;
}

} // namespace arbiter::fp::testing
