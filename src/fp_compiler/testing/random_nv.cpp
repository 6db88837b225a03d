#include "fp_compiler/testing/random_nv.h"

#include <algorithm>

#include "fp_compiler/front/nv/words.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_nv_words.h"

namespace arbiter::fp::testing {

using ir::Opcode;
using ir::OpInfo;

namespace {
class NvWriter : NvWords {
public:
  NvWriter(std::uint64_t seed, const RandomNvOptions &options)
      : NvWords(seed * 7919 + 11, options),
        m_language(
            arbLanguage(options.vertex ? ir::Language::ArbVertex : ir::Language::ArbFragment)) {}

  std::string run() {
    declare();
    m_left = m_options.statements;
    while (m_left > 0)
      statement();
    placeLabels(true);
    results();
    if (m_subroutines > 0)
      subroutines();
    return m_text + "END\n";
  }

private:
  static constexpr int kMaxSubroutines = 3, kMaxDepth = 4;

  void line(const std::string &text) { m_text += text + "\n"; }

  // Declarations and results -----------------------------------------------------------------
  void declare() {
    const bool vertex = m_options.vertex;
    line(std::string(m_language.header));
    line(std::string("OPTION NV_") + (vertex ? "vertex_program" : "fragment_program") +
         (vertex ? (second() ? "3;" : "2;") : (second() ? "2;" : ";")));
    if (vertex && second() && m_options.vertexUnits > 1)
      line("OPTION ARB_fragment_program_shadow;");
    // The register may have its own size. A size below the program's precision is optional for the
    // implementation.
    line(vertex                                   ? "TEMP r0;"
         : !m_options.peer && m_random.chance(30) ? "SHORT TEMP r0;"
                                                  : "LONG TEMP r0;");
    line("TEMP r1, r2, r3, r4, guard, bits, turns;");
    line("PARAM c[8] = { program.local[0..7] };");
    // NVIDIA's compiler knows the sign of a negative constant. It sets a condition code that it
    // takes for a positive one where branches join. So the peer gets a parameter.
    line(m_options.peer ? "PARAM k = program.local[7];" : "PARAM k = { 0.5, 0.25, 2.0, -1.0 };");
    if (m_options.wild) {
      line("PARAM large = { 0.0, 1e30, -1e30, 300.0 };");
      line("PARAM small = { 1e-40, -2.5e-30, 1e-20, -0.0 };");
    }
    if (m_options.peer) { // the peer leaves registers undefined that nothing wrote
      for (int i = 0; i < 5; ++i)
        line("MOV r" + number(i) + ", program.local[" + number(i) + "];");
      line("MOV guard, program.local[5];");
      line("MOV bits, program.local[6];");
    }
    if (!vertex)
      return;
    line("ADDRESS A, B;");
    line("MOV turns, 5.0;");
    line("MOV result.position, vertex.position;");
    line(m_options.peer ? "ARL A, { 0.5, 1.5, 2.5, 3.5 };" : "ARL A, { 0.5, 1.5, 2.5, -0.5 };");
    if (m_options.peer)
      line("ARL B, { 0.5, 1.5, 2.5, 3.5 };");
    if (m_options.peer &&
        second()) // the peer leaves undefined what an address or a condition skips
      for (int i = 0; i < 8; ++i)
        line("MOV result.texcoord[" + number(i) + "], k;");
  }

  void results() {
    if (!m_options.vertex) {
      const std::string second = operand(false);
      line("MAD result.color, " + temporary() + ", 0.5, " + temporary() + ";");
      if (m_random.chance(30))
        line("MOV result.color." + std::string(m_random.chance(50) ? "w" : "xz") + " (" +
             condition() + "), " + second + ";");
    } else {
      line("MOV result.color, " + temporary() + ";");
      line("MOV result.texcoord[1], " + temporary() + ";");
    }
    if (m_options.vertex || second())
      line("RET;");
  }

  /// Writes the subroutines. Each may call those after it.
  void subroutines() {
    m_inSubroutine = true;
    for (m_subroutine = 0; m_subroutine < m_subroutines; ++m_subroutine) {
      line("sub" + number(m_subroutine) + ":");
      for (m_left = 1 + m_random.below(5); m_left > 0;)
        statement();
      placeLabels(true);
      line("RET;");
    }
  }

  // Arithmetic -------------------------------------------------------------------------------
  static bool isArithmetic(Opcode op) {
    switch (op) {
    case Opcode::Swz:
    case Opcode::Arl:
    case Opcode::Arr:
    case Opcode::Ara:
    case Opcode::Ddx:
    case Opcode::Ddy:
      return false;
    default:
      break;
    }
    const bool packs =
        int(op) >= ir::kOpcodeCount && int(op) < ir::kCodeOpcodeCount && ir::carriesBits(op);
    const OpInfo &row = info(op);
    return !packs && !row.has(ir::Flow) && !row.has(ir::Kills) && !row.has(ir::Texture);
  }

  /// Returns an operand inside the function's domain, or any operand if all numbers are in it.
  std::string within(Opcode op, bool scalar, int index) {
    std::string value = operand(scalar);
    if (m_options.wild)
      return value;
    std::string from = scalar ? "guard.x" : "guard";
    switch (op) {
    case Opcode::Rcp:
    case Opcode::Rsq:
    case Opcode::Lg2:
    case Opcode::Log:
    case Opcode::Rcc:
      line("MAX " + from + ", |" + bare(value) + "|, 0.125;");
      return from;
    case Opcode::Lit:
    case Opcode::Nrm:
      line("MAX guard, |" + bare(value) + "|, 0.125;");
      return from;
    case Opcode::Rfl:
    case Opcode::Div:
    case Opcode::Pow:
      if (index != (op == Opcode::Div ? 1 : 0))
        return op == Opcode::Pow ? "k" + swizzle(true) : value;
      line("MAX " + from + ", |" + bare(value) + "|, 0.25;");
      return from;
    case Opcode::Ex2:
    case Opcode::Exp:
    case Opcode::Sin:
    case Opcode::Cos:
    case Opcode::Scs:
      line("MIN guard.x, " + value + ", 3.0;");
      line("MAX guard.x, guard.x, -3.0;");
      return from;
    default:
      return value;
    }
  }

  void arithmetic() {
    Opcode op = Opcode::Mov;
    do
      op = Opcode(m_random.below(ir::kOpcodeRowCount));
    while (!isArithmetic(op) || !nv::offers(m_language, m_options.option, op));
    const OpInfo &row = info(op);
    std::string operands;
    for (int i = 0; i < row.operandCount(); ++i)
      operands += ", " + within(op, row.shapes[i] == 'S', i);
    bool saturates = false;
    const std::string word = row.mnemonic + suffix(row, saturates);
    std::string to = destination(op);
    while (m_options.peer && op == Opcode::X2d && operands.find(to.substr(0, 2)) != operands.npos)
      to = destination(op); // the peer reads components there that it has already written
    line(word + " " + to + operands + ";");
    if (!m_options.wild && !saturates)
      clamp(to.substr(0, 2));
  }

  void clamp(const std::string &name) {
    line("MIN " + name + ", " + name + ", 4.0;");
    line("MAX " + name + ", " + name + ", -4.0;");
  }

  void packing() {
    constexpr const char *kKinds[] = {"2H", "2US", "4B", "4UB"};
    const std::string kind = kKinds[m_random.below(4)];
    // A computed value may lie between two halves, and its last bit may differ on the peer.
    const bool exact = m_options.peer && kind == "2H";
    line("PK" + kind + " bits, " + (exact ? parameter() : operand(false)) + ";");
    if (m_random.chance(50))
      line("MOV bits" + std::string(m_random.chance(50) ? ".xz" : "") + " (" + condition() +
           "), bits;");
    bool saturates = false;
    const OpInfo &row = info(Opcode::Up4b);
    line("UP" + kind + suffix(row, saturates) + " " + destination() + ", bits" + swizzle(true) +
         ";");
  }

  void texture() {
    const std::string at = m_options.wild ? attribute() : operand(false);
    const bool chooses = m_options.vertex && m_options.vertexUnits > 1;
    const int number = chooses ? m_random.below(m_options.vertexUnits) : 0;
    const std::string unit = ", texture[" + std::to_string(number) + "], " +
                             ir::targetText(kUnitTargets[std::size_t(number)]) + ";";
    const int kind = m_random.below(5);
    if (kind == 1) {
      line("MOV guard, " + at + ";");
      line("MAX guard.w, |guard.w|, 0.25;");
      line("TXP " + destination() + ", guard" + unit);
    } else if (kind == 2 && !m_options.vertex) {
      line("TXD " + destination() + ", " + at + ", " + operand(false) + ", " + operand(false) +
           unit);
    } else {
      const bool biases = kind == 4 && !(m_options.peer && m_options.vertex);
      const char *const name = kind == 3 && second() ? "TXL " : biases ? "TXB " : "TEX ";
      line(name + destination() + ", " + at + unit);
    }
  }

  void derivative() {
    if ((m_loops > 0 || m_inSubroutine) && !m_options.loopDerivatives)
      return arithmetic();
    bool saturates = false;
    const std::string word = suffix(info(Opcode::Ddx), saturates);
    std::string to = destination();
    if (m_options.peer &&
        word.ends_with('C')) // the peer makes a branch of it, which splits the quad
      to = to.substr(0, to.find(' '));
    line((m_random.chance(50) ? "DDX" : "DDY") + word + " " + to + ", " + operand(false) + ";");
  }

  // Addresses --------------------------------------------------------------------------------
  /// Returns an index for an address register. The peer reads other memory beyond an array.
  std::string addressValue() {
    std::string value = operand(false);
    if (!m_options.peer)
      return value;
    line("MIN guard, |" + bare(value) + "|, 3.0;");
    return "guard";
  }

  void addresses() {
    const std::string name = m_random.chance(50) ? "A" : "B";
    const std::string mask = m_random.chance(60) ? "" : m_random.chance(50) ? ".x" : ".yw";
    const std::string test = m_random.chance(25) ? " (" + condition() + ")" : "";
    const std::string word = m_random.chance(25) && updatesHere() ? "C " : " ";
    switch (m_random.below(m_options.peer ? 2 : second() ? 4 : 3)) {
    case 0:
      line("ARL" + word + name + mask + test + ", " + addressValue() + ";");
      break;
    case 1:
      line("ARR" + word + name + mask + test + ", " + addressValue() + ";");
      break;
    case 2:
      line("ARA" + word + name + mask + test + ", " + (m_random.chance(50) ? "A" : "B") + ";");
      break;
    default:
      line("PUSHA " + name + ";");
      line("ARL " + name + ", " + operand(false) + ";");
      line("MOV " + temporary() + ", c[" + name + ".y + 3];");
      line("POPA " + std::string(m_random.chance(50) ? "A" : "B") + ";");
    }
  }

  void indexedResult() {
    line("MOV result.texcoord[" + address() + " + " + number(m_random.below(4)) + "]" +
         (m_random.chance(40) ? ".xy" : "") +
         (m_random.chance(40) ? " (" + condition() + ")" : "") + ", " + temporary() + ";");
  }

  // Flow -------------------------------------------------------------------------------------
  void statement() {
    --m_left;
    const int kind = m_random.below(100);
    if (m_options.vertex)
      return vertexStatement(kind);
    if (kind < 6)
      packing();
    else if (kind < 12)
      derivative();
    else if (kind < 20 && m_options.textures)
      texture();
    else if (kind < 22)
      line(m_random.chance(50) || m_options.wild || m_options.peer ? "KIL " + condition() + ";"
                                                                   : "KIL " + operand(false) + ";");
    else if (kind < 38 && second() && m_depth < kMaxDepth)
      block();
    else if (kind < 44 && second())
      call();
    else if (kind < 47 && second() && m_inSubroutine)
      line("RET (" + jumpCondition() + ");");
    else
      arithmetic();
  }

  void vertexStatement(int kind) {
    if (kind < 14)
      addresses();
    else if (kind < 18 && second())
      indexedResult();
    else if (kind < 26)
      branch();
    else if (kind < 32)
      call();
    else if (kind < 38 && m_options.textures && second())
      texture();
    else
      arithmetic();
    placeLabels(false);
  }

  void block() {
    ++m_depth;
    const int inside = std::min(m_left, 1 + m_random.below(4));
    const int rest = m_left - inside;
    const auto body = [&](int count) {
      for (m_left = count; m_left > 0;)
        statement();
    };
    if (m_random.chance(55)) {
      line("IF " + condition() + ";");
      body(inside / 2 + 1);
      if (m_random.chance(60)) {
        line("ELSE;");
        body(inside / 2);
      }
      line("ENDIF;");
    } else {
      loop([&] { body(inside); });
    }
    m_left = rest;
    --m_depth;
  }

  template <typename Body> void loop(Body body) {
    const bool counts = m_random.chance(50);
    const std::string times = number(1 + m_random.below(4));
    ++m_loops;
    m_counting += counts ? 1 : 0;
    line(counts                ? "LOOP { " + times + ", 0.0, 1.0 };"
         : m_random.chance(60) ? "REP " + times + ";"
         // NVIDIA's assembler ignores the signs of REP's operand.
         : m_options.peer ? "REP c[" + number(m_random.below(8)) + "];"
                          : "REP |c[" + number(m_random.below(8)) + "]|;");
    body();
    if (m_random.chance(60))
      line("BRK (" + jumpCondition() + ");");
    if (m_random.chance(30))
      body();
    line(counts ? "ENDLOOP;" : "ENDREP;");
    m_counting -= counts ? 1 : 0;
    --m_loops;
  }

  void call() {
    const int first = m_inSubroutine ? m_subroutine + 1 : 0;
    if (first >= kMaxSubroutines || m_loops > 1)
      return arithmetic();
    const int callee = first + m_random.below(kMaxSubroutines - first);
    m_subroutines = std::max(m_subroutines, callee + 1);
    line("CAL sub" + number(callee) +
         (m_random.chance(60) ? " (" + condition() + ");" : std::string(";")));
  }

  /// Branches forward over the next statements, or backward. `turns` limits all backward branches.
  void branch() {
    if (!m_placed.empty() && m_random.chance(35)) {
      line("ADDC turns.x, turns.x, -1.0;");
      line("BRA " + m_placed[std::size_t(m_random.below(int(m_placed.size())))] + " (GT.x);");
      return;
    }
    m_open.push_back("label" + number(m_labels++));
    line("BRA " + m_open.back() + (m_random.chance(85) ? " (" + jumpCondition() + ");" : ";"));
  }

  /// Returns a condition for BRA, BRK or RET. NVIDIA's driver never takes one whose condition tests
  /// several different components.
  std::string jumpCondition() {
    const std::string word = condition();
    return m_options.peer ? word.substr(0, word.find('.')) + swizzle(true) : word;
  }

  /// Writes labels for open branches. A branch stays in its subroutine.
  void placeLabels(bool all) {
    while (!m_open.empty() && (all || m_random.chance(30))) {
      line(m_open.front() + ":");
      m_placed.push_back(m_open.front());
      m_open.erase(m_open.begin());
    }
    if (all)
      m_placed.clear();
  }

  const ArbLanguage &m_language;
  std::string m_text;
  int m_left = 0, m_depth = 0, m_loops = 0;
  int m_subroutines = 0, m_subroutine = 0, m_labels = 0;
  std::vector<std::string> m_open,
      m_placed; ///< labels of branches that are not placed yet, and that are placed
};
} // namespace

std::string randomNvProgram(std::uint64_t seed, const RandomNvOptions &options) {
  return NvWriter(seed, options).run();
}

} // namespace arbiter::fp::testing
