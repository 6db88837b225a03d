#include <algorithm>

#include "fp_compiler/hw/slots.h"

namespace arbiter::fp::hw {

namespace {

const char *textOf(SlotCause cause) {
  switch (cause) {
  case SlotCause::Instruction:
    return "";
  case SlotCause::Constant:
    return "a constant moved";
  case SlotCause::Attribute:
    return "an attribute moved";
  case SlotCause::Swizzle:
    return "constants and signs of a swizzle";
  case SlotCause::Coordinate:
    return "its coordinate moved";
  case SlotCause::Result:
    return "its result moved under the write mask";
  case SlotCause::FogCoordinate:
    return "the fog coordinate's w";
  case SlotCause::Depth:
    return "the depth moved";
  case SlotCause::Fog:
    return "the fog option";
  case SlotCause::ColorSum:
    return "the colour sum";
  }
  return "";
}

class Lines {
public:
  Lines(const ir::Program &program, std::string_view text) : m_program(program), m_text(text) {}

  /// Returns "line 5: SIN" or "instruction 2: SIN", or an empty text for the whole program.
  std::string of(std::uint16_t origin) {
    if (origin == kWholeProgram)
      return "";
    const ir::Instruction &instruction = m_program.code[origin];
    const std::string mnemonic = info(instruction.op).mnemonic;
    if (m_text.empty())
      return "instruction " + std::to_string(origin + 1) + ": " + mnemonic;
    // Instructions are in the order of the text, except for moves that are put before them.
    const std::size_t at = std::min<std::size_t>(instruction.span.begin, m_text.size());
    if (at < m_at) {
      m_at = 0;
      m_line = 1;
    }
    m_line += std::size_t(std::count(m_text.begin() + std::ptrdiff_t(m_at),
                                     m_text.begin() + std::ptrdiff_t(at), '\n'));
    m_at = at;
    return "line " + std::to_string(m_line) + ": " + mnemonic;
  }

private:
  const ir::Program &m_program;
  std::string_view m_text;
  std::size_t m_at = 0, m_line = 1;
};

} // namespace

std::string listSlots(const ir::Program &program, const SlotProgram &code, const SlotWords &words,
                      std::string_view text) {
  Lines lines(program, text);
  std::string out;
  std::uint32_t phase = 0;
  for (std::size_t i = 0; i < code.slots.size(); ++i) {
    const Slot &slot = code.slots[i];
    if (code.phases != 0 && (i == 0 || slot.phase != phase)) {
      phase = slot.phase;
      out += std::string(words.phase) + " " + std::to_string(phase + 1) + "\n";
    }
    std::string number = std::to_string(i + 1);
    number.insert(0, number.size() < 5 ? 5 - number.size() : 0, ' ');
    out += number + (slot.texture ? " tex" : " alu");
    if (slot.passes > 1)
      out += " (" + std::to_string(slot.passes) + " passes)";
    const std::string origin = lines.of(slot.origin);
    const std::string cause = textOf(slot.cause);
    out += "  ; " + origin + (origin.empty() || cause.empty() ? "" : ", ") + cause + "\n";
  }
  return out;
}

} // namespace arbiter::fp::hw
