#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "fp_compiler/numerics.h"
#include "fp_compiler/span.h"

/// The IR: a checked program as data. It is code over vec4 registers, straight-line except for
/// loops, without text and without GL. All languages share it. A feature that a language lacks
/// (relative operands, texture samples) does not occur in its programs.
namespace arbiter::fp::ir {

/// Traits of an opcode; the columns of ops.def.
enum Trait : std::uint32_t {
  None = 0,
  PerComponent = 1,
  Replicates = 2,
  Commutative = 4,
  Texture = 8,
  Kills = 16,
  FixedMask = 32,
  VertexOnly = 64,
  FragmentOnly = 128,
  // NVIDIA's options that have the opcode, and suffixes that its name cannot take.
  OfF1 = 256,
  OfF2 = 512,
  OfV2 = 1024,
  OfV3 = 2048,
  NoFixed = 4096,
  NoPrecision = 8192,
  NoCondition = 16384,
  NoSaturate = 32768,
  Flow = 65536, ///< changes what runs next; has no destination
  // NVIDIA's own languages that have the opcode, each with its successors.
  OfFp1 = 131072,
  OfVp1 = 262144,
  OfVp11 = 524288,
  OfVp2 = 1048576,
};

enum class Opcode : std::uint8_t {
#define FP_OP(Enumerator, mnemonic, shapes, traits, section, doc) Enumerator,
#define FP_NV_OP(Enumerator, mnemonic, shapes, traits, section, doc) Enumerator,
#define FP_NV_WORD(Enumerator, mnemonic, shapes, traits, section, doc) Enumerator,
#include "fp_compiler/ir/ops.def"
};

/// The number of the ARB languages' opcodes. NVIDIA's follow them.
inline constexpr int kOpcodeCount = int(Opcode::Seq);
/// The number of opcodes that may occur in a program's code. The front end lowers the opcodes after
/// them to these.
inline constexpr int kCodeOpcodeCount = int(Opcode::Sgt);
/// The number of rows of ops.def.
inline constexpr int kOpcodeRowCount = int(Opcode::Popa) + 1;

/// The number of opcodes before those that only vertex programs have.
inline constexpr int kFragmentOpcodeCount = int(Opcode::Arl);

/// A row of ops.def.
struct OpInfo {
  const char *name;     ///< enumerator, "Add"
  const char *mnemonic; ///< "ADD"
  const char *shapes;   ///< one letter for each operand, "VV"
  std::uint32_t traits; ///< Trait bits
  const char *section;  ///< a section of ARB_fragment_program
  const char *doc;      ///< one line

  [[nodiscard]] bool has(Trait trait) const { return (traits & trait) != 0; }
  [[nodiscard]] bool hasDestination() const { return (traits & (Kills | Flow)) == 0; }
  [[nodiscard]] int operandCount() const { return int(std::char_traits<char>::length(shapes)); }
};

[[nodiscard]] const OpInfo &info(Opcode op);

/// Register files.
enum class File : std::uint8_t {
  Temporary, ///< index into Program::temporaries
  Attribute, ///< index into Program::attributes
  Parameter, ///< index into Program::parameters (constants, env, local and state rows)
  Output,    ///< index into Program::outputs; written only
  Address, ///< index into Program::addresses; one integer, which only ARL writes and only relative
           ///< operands read
};

/// The source of a component of a swizzled operand. Zero and One come from SWZ, and from passes
/// that compose it.
enum class Select : std::uint8_t { X, Y, Z, W, Zero, One };

using Swizzle = std::array<Select, 4>;
inline constexpr Swizzle kIdentity = {Select::X, Select::Y, Select::Z, Select::W};

/// A source operand. Component i reads register[swizzle[i]], and is negated if bit i of `negate` is
/// set. A scalar operand (shape S) has the same component four times.
struct Operand {
  File file = File::Temporary;
  std::uint16_t index = 0;
  Swizzle swizzle = kIdentity;
  std::uint8_t negate = 0; ///< bit 0 = x .. bit 3 = w
  /// True for a relative operand (ARB_vertex_program 2.14.3.5). `file` is then Parameter, and
  /// `index` names an element of Program::arrays. It reads row `addresses[address] + offset` of
  /// that array, or zero if there is no such row.
  bool relative = false;
  std::uint8_t address = 0;
  std::int16_t offset = 0;
  Span span; ///< the operand's text
  bool operator==(const Operand &) const = default;
};

/// A destination: a register, the components written (bit 0 = x), and _SAT.
struct Destination {
  File file = File::Temporary;
  std::uint16_t index = 0;
  std::uint8_t mask = 0xF;
  bool saturate = false; ///< clamp to [0,1] before the write; NaN becomes 0
  Span span;
};

struct Instruction {
  Opcode op = Opcode::Mov;
  Destination dst; ///< unused if the opcode Kills
  std::array<Operand, 3> src;
  std::uint8_t unit = 0;               ///< Texture opcodes: image unit
  TexTarget target = TexTarget::Tex2D; ///< Texture opcodes
  Span span;                           ///< the whole statement's text
};

/// A declared temporary. The name is for listings only. A temporary may be unused.
struct Temporary {
  std::string name;
};

using fp::Numerics;

/// An array that relative operands read. Rows may repeat, and need not be consecutive.
struct ParameterArray {
  std::string name;                ///< for listings
  std::vector<std::uint16_t> rows; ///< indexes into Program::parameters
};

/// A whole program. A register that was not written reads as zero, on every path.
struct Program {
  Language language = Language::ArbFragment;
  Options options;
  std::vector<Temporary> temporaries;
  std::vector<Attribute> attributes;
  std::vector<Parameter> parameters;
  std::vector<Output> outputs;
  std::vector<Temporary> addresses;   ///< vertex programs: address registers
  std::vector<ParameterArray> arrays; ///< the arrays that relative operands read
  std::vector<Instruction> code;
};

/// True if the code has loops (REP to ENDREP) and so is not straight-line.
[[nodiscard]] bool hasLoops(const Program &program);

} // namespace arbiter::fp::ir
