#pragma once
#include <memory>
#include <string>
#include <vector>

#include "fp_compiler/abi.h"
#include "fp_compiler/ir/interface.h"
#include "fp_compiler/numerics.h"

/// The interface of the JIT back end: compiles programs to machine code of this processor. The back
/// end is a library of its own (libarbiter_jit.so), so that LLVM is mapped only if it is used. The
/// layer and the tools see only this header. Its types do not cross to the library; makeEngine()'s
/// engine calls the library through jit_boundary.h.
namespace arbiter::fp::jit {

/// A fragment attribute that a function needs interpolated, in the order of FragmentKey::inputs and
/// of Primitive::inputs. `components` has a bit for each component that is read; other planes need
/// not be filled. fragment.position is not an input.
struct FragmentInput {
  ir::Attribute attribute;
  std::uint8_t components = 0xF;
};

/// A texture image unit that a program samples.
struct Sampler {
  std::uint8_t unit = 0;
  ir::TexTarget target = ir::TexTarget::Tex2D;
};

/// Returns the dimension of a texture target; a SHADOW target has that of the plain one.
[[nodiscard]] constexpr abi::Dimension dimensionOf(ir::TexTarget target) {
  switch (target) {
  case ir::TexTarget::Tex1D:
  case ir::TexTarget::Shadow1D:
    return abi::Dimension::Tex1D;
  case ir::TexTarget::Tex2D:
  case ir::TexTarget::Shadow2D:
    return abi::Dimension::Tex2D;
  case ir::TexTarget::Tex3D:
    return abi::Dimension::Tex3D;
  case ir::TexTarget::Cube:
    return abi::Dimension::Cube;
  case ir::TexTarget::Rect:
  case ir::TexTarget::ShadowRect:
    return abi::Dimension::Rect;
  }
  return abi::Dimension::Tex2D;
}

/// The properties that a key depends on: the inputs, samplers and outputs of a program after the
/// passes.
struct FragmentShape {
  std::vector<FragmentInput> inputs; ///< includes what the program's options read
  std::vector<Sampler> samplers;
  std::uint8_t colorOutputs = 0; ///< bit i: result.color[i] is written
  bool writesDepth = false;
  bool kills = false;
  bool derivatives = false; ///< has DDX or DDY, so no function of Lanes::Row
  /// A bit for each unit whose level of detail depends on more than an affine coordinate. A sampler
  /// there that has mipmaps, or different magnification and minification, needs Lanes::Quad.
  std::uint32_t needsQuads = 0;
};

/// A program that is checked, optimised for the mode, and ready to be compiled for any key.
class FragmentProgram {
public:
  virtual ~FragmentProgram() = default;
  [[nodiscard]] virtual const FragmentShape &shape() const = 0;
  /// Returns the program after the passes, with its fog and colour sum as instructions.
  /// FragmentData::parameters has a row for each of its parameters.
  [[nodiscard]] virtual const ir::Program &program() const = 0;
};

struct VertexShape {
  std::vector<ir::Attribute> inputs; ///< VertexData::inputs, in order
  std::vector<ir::Output> outputs;   ///< VertexData::outputs, in order
  std::vector<Sampler> samplers;
};
class VertexProgram {
public:
  virtual ~VertexProgram() = default;
  [[nodiscard]] virtual const VertexShape &shape() const = 0;
  [[nodiscard]] virtual const ir::Program &program() const = 0;
};

/// Machine code. The function is valid as long as this object.
template <typename Function> struct Code {
  virtual ~Code() = default;
  Function function = nullptr;
  std::size_t bytes = 0; ///< size of the machine code
};
using FragmentCode = Code<abi::ShadeFunction>;
using VertexCode = Code<abi::VertexFunction>;

struct EngineOptions {
  std::string cpu;         ///< "" for this processor; "avx512", "avx2" or "sse4.1" for tests
  std::string cacheFolder; ///< for object code (util/cache/cache_store.h); "" for no cache
  std::uint64_t cacheMaxBytes = 0;
  /// The folder of the library, for programs in another folder; "" for the folder of the caller's
  /// code.
  std::string folder;
};

/// A readable form of a program's code.
enum class Listing : std::uint8_t { Ir, Assembly };

/// The JIT engine. Threads may use it at the same time. Nothing throws. A program that cannot be
/// compiled gives null and a reason.
class Engine {
public:
  virtual ~Engine() = default;
  [[nodiscard]] virtual int lanes() const = 0;      ///< 4, 8 or 16
  [[nodiscard]] virtual int blockWidth() const = 0; ///< for Lanes::Quad: 2, 4, 4
  [[nodiscard]] virtual int blockHeight() const = 0;
  [[nodiscard]] virtual std::string target() const = 0; ///< "skylake-avx512, 16 lanes"
  /// Returns null for Fp24, which is not supported.
  [[nodiscard]] virtual std::unique_ptr<FragmentProgram> prepareFragment(const ir::Program &program,
                                                                         Numerics numerics) = 0;
  [[nodiscard]] virtual std::unique_ptr<VertexProgram> prepareVertex(const ir::Program &program,
                                                                     Numerics numerics) = 0;
  [[nodiscard]] virtual std::unique_ptr<FragmentCode>
  compile(const FragmentProgram &program, const abi::FragmentKey &key, std::string &reason) = 0;
  [[nodiscard]] virtual std::unique_ptr<VertexCode>
  compile(const VertexProgram &program, const abi::VertexKey &key, std::string &reason) = 0;
  /// Returns LLVM's IR or the assembly text of what compile() makes. Returns an empty text and a
  /// reason if that is null.
  [[nodiscard]] virtual std::string listing(const FragmentProgram &program,
                                            const abi::FragmentKey &key, Listing what,
                                            std::string &reason) = 0;
  [[nodiscard]] virtual std::string listing(const VertexProgram &program, const abi::VertexKey &key,
                                            Listing what, std::string &reason) = 0;
};

/// Makes an engine. The first call opens the library beside this one, or the one that
/// ARBITER_JIT_LIBRARY names. Returns null and a reason if it is missing or does not load.
[[nodiscard]] std::unique_ptr<Engine> makeEngine(const EngineOptions &options, std::string &reason);

} // namespace arbiter::fp::jit
