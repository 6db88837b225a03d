#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/interface.h"

/// A shader of EXT_vertex_shader as data: the symbols that it names, and its operations in their
/// order. Section 2.14 of the extension defines it; lower.h turns it into IR, evaluate.h runs it as
/// the specification reads. Nothing here checks the rules of the API: what builds a shader does.
namespace arbiter::fp::vertex_shader {

enum class DataType : std::uint8_t { Scalar, Vector, Matrix };

/// Where the value of a symbol comes from.
enum class From : std::uint8_t {
  Local,     ///< what the shader wrote; zero before
  Constant,  ///< Symbol::constant
  Invariant, ///< a parameter that the application sets: rows of the program's env parameters
  Attribute, ///< of the vertex
  State,     ///< rows of GL state
};

/// A name of GenSymbolsEXT or of one of the Bind...ParameterEXT.
struct Symbol {
  DataType type = DataType::Vector;
  From from = From::Local;
  /// Attribute: one of a scalar or a vector, four of a matrix, which are its columns. A scalar is
  /// the x of its attribute.
  std::array<ir::Attribute, 4> attributes = {};
  bool clampsAttributes = false; ///< NORMALIZED_RANGE: a vertex array may hold more than [-1, 1]
  bool isDirection = false;      ///< Attribute, State: the fourth component is 0 (2.14)
  ir::StateRef state;            ///< State: of a matrix the first row
  std::uint8_t component = 0;    ///< State: of a scalar
  /// Constant: x of a scalar, a vector, or the rows of a matrix.
  std::array<ir::Vec4, 4> constant = {};
  /// The block of names that it was generated with, in Shader::symbols.
  std::uint32_t blockFirst = 0, blockCount = 1;
};

/// The rows that the value of a type has: scalars and vectors one, matrices four.
[[nodiscard]] constexpr int rowCount(DataType type) { return type == DataType::Matrix ? 4 : 1; }

enum class Op : std::uint8_t {
  // In the order of the enumerants from OP_INDEX_EXT on.
  Index,
  Negate,
  Dot3,
  Dot4,
  Mul,
  Add,
  Madd,
  Frac,
  Max,
  Min,
  SetGe,
  SetLt,
  Clamp,
  Floor,
  Round,
  ExpBase2,
  LogBase2,
  Power,
  Recip,
  RecipSqrt,
  Sub,
  CrossProduct,
  MultiplyMatrix,
  Mov,
  // Commands of their own.
  Swizzle,
  WriteMask,
  InsertComponent,
  ExtractComponent,
};
inline constexpr int kShaderOps = int(Op::Mov) + 1; ///< those of ShaderOp

/// The number of arguments that an operation of ShaderOp takes.
[[nodiscard]] int argumentCount(Op op);

/// The types of an operation's result and arguments are in the table of operations.
/// \param arguments argumentCount(op) of them
[[nodiscard]] bool isInTable(Op op, DataType result, const DataType *arguments);

/// What an operation writes.
enum class Place : std::uint8_t { Local, Position, Color, TexCoord, Fog };
struct Result {
  Place place = Place::Local;
  std::uint32_t index = 0; ///< Local: of the symbol; Color: 0 or 1; TexCoord: of the set
};
/// Fog is a scalar, the other outputs are vectors.
[[nodiscard]] DataType typeOf(const Result &result, const std::vector<Symbol> &symbols);

/// Of Swizzle: the enumerants from X_EXT on.
enum class Take : std::uint8_t { X, Y, Z, W, NegX, NegY, NegZ, NegW, Zero, One, NegOne };

struct Operation {
  Op op = Op::Mov;
  Result result;
  std::array<std::uint32_t, 3> arguments = {}; ///< in Shader::symbols
  std::array<Take, 4> takes = {};              ///< Swizzle
  std::uint8_t mask = 0xF;                     ///< WriteMask: bit 0 = x
  std::uint8_t component =
      0; ///< InsertComponent, ExtractComponent: of a vector, or a row of a matrix
};

struct Shader {
  std::vector<Symbol> symbols;
  std::vector<Operation> code;
};

} // namespace arbiter::fp::vertex_shader
