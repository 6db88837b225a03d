#include "exact_operands.h"

namespace software {
namespace {

constexpr const char *kInputs[] = {"fragment.color",       "fragment.color.secondary",
                                   "fragment.texcoord[0]", "fragment.texcoord[1]",
                                   "fragment.texcoord[2]", "fragment.fogcoord.x"};
constexpr int kFog = int(std::size(kInputs)) - 1;

/// Returns four consecutive leaves; those of texels follow those of inputs.
std::array<Leaves, 4> leavesOf(int place) {
  std::array<Leaves, 4> result = {};
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = Leaves(1) << (4 * std::size_t(place) + i);
  return result;
}

std::string orderOf(Random &random) {
  static constexpr const char *kTies[] = {"xxyy", "yyxx", "xyxy", "yxyx", "xyyz", "xxyz", "xxxx"};
  if (random.once(2))
    return "xyzw";
  if (random.once(2))
    return random.pick(kTies);
  std::string result;
  for (int i = 0; i < 4; ++i)
    result += "xyzw"[random.below(4)];
  return result;
}

} // namespace

ExactOperand ExactRegisters::ordered(const std::string &name, const std::array<Leaves, 4> &leaves) {
  const std::string order = orderOf(m_random);
  ExactOperand result = {name + (order == "xyzw" ? "" : "." + order), {}};
  for (std::size_t i = 0; i < 4; ++i)
    result.leaves[i] = leaves[std::string("xyzw").find(order[i])];
  return result;
}

ExactOperand ExactRegisters::input() {
  const int which = m_random.below(int(std::size(kInputs)));
  if (which != kFog)
    return ordered(kInputs[which], leavesOf(which));
  ExactOperand fog = {kInputs[kFog], {}};
  fog.leaves.fill(leavesOf(kFog)[0]);
  return fog;
}

/// Returns a temporary, often the last one, so that most instructions affect the result.
int ExactRegisters::temporary() {
  return m_random.once(2) ? m_last : m_random.below(kExactTemporaries);
}

ExactOperand ExactRegisters::operand() {
  const bool negated = m_random.once(3);
  const int which = temporary();
  ExactOperand result = m_random.below(7) < 4 ? ordered("t" + std::to_string(which),
                                                        m_temporaries[std::size_t(which)])
                                              : input();
  if (negated)
    result.text = "-" + result.text;
  return result;
}

ExactOperand ExactRegisters::operandOrConstants() {
  if (!m_random.once(8))
    return operand();
  static constexpr const char *kNumbers[] = {"0.5", "0.25", "1.0", "2.0", "-1.0", "0.1"};
  ExactOperand result = {m_random.once(3) ? "-{" : "{", {}};
  for (int i = 0; i < 4; ++i)
    result.text += std::string(i ? ", " : "") + m_random.pick(kNumbers);
  result.text += "}";
  result.leaves.fill(kConstant);
  return result;
}

ExactOperand ExactRegisters::whole() {
  const int which = temporary(), from = m_random.below(kFog);
  if (m_random.once(2))
    return {"t" + std::to_string(which), m_temporaries[std::size_t(which)]};
  return {kInputs[from], leavesOf(from)};
}

ExactOperand ExactRegisters::scalar() {
  ExactOperand result = whole();
  const int component = m_random.below(4);
  result.text += std::string(".") + "xyzw"[component];
  if (m_random.once(3))
    result.text = "-" + result.text;
  result.leaves.fill(result.leaves[std::size_t(component)]);
  return result;
}

ExactOperand ExactRegisters::selection() {
  const ExactOperand from = whole();
  ExactOperand result = {from.text, {}};
  for (Leaves &each : result.leaves) {
    const int which = m_random.below(6);
    result.text += std::string(m_random.once(3) ? ", -" : ", ") + "xyzw01"[which];
    each = which < 4 ? from.leaves[std::size_t(which)] : kConstant;
  }
  return result;
}

ExactOperand ExactRegisters::texel(int unit) { return {"", leavesOf(kFog + 1 + unit)}; }

void ExactRegisters::write(int temporary, unsigned mask, const std::array<Leaves, 4> &leaves) {
  m_last = temporary;
  for (std::size_t i = 0; i < 4; ++i)
    if (mask >> i & 1)
      m_temporaries[std::size_t(temporary)][i] = leaves[i];
}

} // namespace software
