#pragma once
#include <memory>
#include <string>
#include <vector>

#include "fp_compiler/abi.h"
#include "fp_compiler/ir/interface.h"
#include "fp_compiler/numerics.h"

/// The JIT back end from outside: programs as machine code of this processor. It lives in a library
/// of its own (libarbiter_jit.so), because LLVM is mapped only where it is used; this header is all
/// that the layer and the tools see of it. None of its types crosses to the library: makeEngine()'s
/// engine speaks with the library's through jit_boundary.h.
namespace arbiter::fp::jit {

/// A fragment attribute that a function wants interpolated, in the order of FragmentKey::inputs and
/// of Primitive::inputs. `components` has a bit for each that is read: the planes of others need
/// not be filled. fragment.position is no input.
struct FragmentInput {
  ir::Attribute attribute;
  std::uint8_t components = 0xF;
};

/// A texture image unit that a program samples.
struct Sampler {
  std::uint8_t unit = 0;
  ir::TexTarget target = ir::TexTarget::Tex2D;
};

/// What must be known of a program before a key can be made: what it reads, samples and writes
/// after the passes.
struct FragmentShape {
  std::vector<FragmentInput> inputs; ///< the fog coordinate included, where an option wants it
  std::vector<Sampler> samplers;
  std::uint8_t colorOutputs = 0; ///< bit i: result.color[i] is written
  bool writesDepth = false;
  bool kills = false;
  bool derivatives = false; ///< DDX or DDY: there is no function of Lanes::Row
  /// A sample whose level of detail depends on more than an affine coordinate, so that a sampler
  /// with mipmaps, or with different magnification and minification, needs Lanes::Quad. Bit a unit.
  std::uint32_t needsQuads = 0;
};

/// A program ready to be compiled for any key: checked, optimised for the mode.
class FragmentProgram {
public:
  virtual ~FragmentProgram() = default;
  [[nodiscard]] virtual const FragmentShape &shape() const = 0;
  /// The program after the passes; its parameters are what FragmentData::parameters has rows for.
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

/// Machine code; the function lives as long as this.
template <typename Function> struct Code {
  virtual ~Code() = default;
  Function function = nullptr;
  std::size_t bytes = 0; ///< of machine code
};
using FragmentCode = Code<abi::ShadeFunction>;
using VertexCode = Code<abi::VertexFunction>;

struct EngineOptions {
  std::string cpu;         ///< "" this one; else "avx512", "avx2", "sse4.1", for tests
  std::string cacheFolder; ///< of object code (util/cache/cache_store.h); "" none
  std::uint64_t cacheMaxBytes = 0;
  /// Where the library lies, for programs that are not beside it; "" beside the caller's code.
  std::string folder;
};

/// What people may read of the code of a program.
enum class Listing : std::uint8_t { Ir, Assembly };

/// Safe to call from several threads at once. Nothing throws; what cannot be compiled is null, with
/// a reason.
class Engine {
public:
  virtual ~Engine() = default;
  [[nodiscard]] virtual int lanes() const = 0;      ///< 4, 8 or 16
  [[nodiscard]] virtual int blockWidth() const = 0; ///< of Lanes::Quad: 2, 4, 4
  [[nodiscard]] virtual int blockHeight() const = 0;
  [[nodiscard]] virtual std::string target() const = 0; ///< "skylake-avx512, 16 lanes"
  /// Fog and colour sum are the program's options. Fp24 is not offered: null.
  [[nodiscard]] virtual std::unique_ptr<FragmentProgram> prepareFragment(const ir::Program &program,
                                                                         Numerics numerics) = 0;
  [[nodiscard]] virtual std::unique_ptr<VertexProgram> prepareVertex(const ir::Program &program,
                                                                     Numerics numerics) = 0;
  [[nodiscard]] virtual std::unique_ptr<FragmentCode>
  compile(const FragmentProgram &program, const abi::FragmentKey &key, std::string &reason) = 0;
  [[nodiscard]] virtual std::unique_ptr<VertexCode>
  compile(const VertexProgram &program, const abi::VertexKey &key, std::string &reason) = 0;
  /// LLVM's IR or the machine's assembly text of what compile() makes; empty, with a reason, where
  /// that is null.
  [[nodiscard]] virtual std::string listing(const FragmentProgram &program,
                                            const abi::FragmentKey &key, Listing what,
                                            std::string &reason) = 0;
  [[nodiscard]] virtual std::string listing(const VertexProgram &program, const abi::VertexKey &key,
                                            Listing what, std::string &reason) = 0;
};

/// Opens the library beside this one (or the one that ARBITER_JIT_LIBRARY names) at the first call
/// and makes an engine. Null, with a reason, if it is not there or does not load.
[[nodiscard]] std::unique_ptr<Engine> makeEngine(const EngineOptions &options, std::string &reason);

} // namespace arbiter::fp::jit
