#pragma once
#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/back/llvm/fragment/fragment_consecutive.h"
#include "fp_compiler/back/llvm/pixel/pixel.h"
#include "fp_compiler/back/llvm/program/program.h"

/// Where a fragment program's registers come from.
namespace arbiter::fp::llvm_back {

class FragmentHooks final : public ProgramHooks {
public:
  /// \param flow of Lanes::Row; null for blocks
  /// \param samples null where no sample is affine
  FragmentHooks(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                const Places &places, Interpolator &interpolator, Value *data, Value *primitive,
                const AffineFlow *flow, const ConsecutiveSamples *samples, SamplePath path,
                const PixelPlace &place)
      : m_code(code), m_program(program), m_key(key), m_places(places),
        m_interpolator(interpolator), m_data(data), m_primitive(primitive), m_flow(flow),
        m_samples(samples), m_path(path), m_place(place),
        m_live(analysis::liveOf(program.program())) {}

  [[nodiscard]] Vec attribute(int index, unsigned needed) override;
  [[nodiscard]] Vec parameter(int index, unsigned needed) override;
  [[nodiscard]] Vec texture(const ir::Instruction &instruction, const std::array<Vec, 3> &operands,
                            unsigned needed) override;
  [[nodiscard]] bool hasQuads() override;
  [[nodiscard]] Value *wanted() override;
  /// SamplePath::Given: the texels, as they lie in memory.
  void give(Value *texels) { m_given = texels; }
  void kill(Value *lanes) override;
  [[nodiscard]] Vec relative(int array, Value *index, unsigned needed) override;

  /// The input of an attribute that an option wants, or nulls.
  [[nodiscard]] Vec input(ir::Attribute attribute, unsigned needed);
  /// In a row: a derivative, or a level of detail that depends on more than an affine coordinate.
  [[nodiscard]] bool refused() const { return m_refused; }
  [[nodiscard]] Value *alive() const { return m_alive; }
  [[nodiscard]] std::vector<PackedTexel> takeTexels() { return std::move(m_texels); }

private:
  /// The walk passes instructions that it has narrowed, in order: the index of this one.
  [[nodiscard]] std::size_t nextTexture();
  [[nodiscard]] Vec facing(unsigned needed);
  [[nodiscard]] SampleAt sampleAt(const ir::Instruction &instruction,
                                  const std::array<Vec, 3> &operands);
  /// What a coordinate changes by from a pixel to the next, of a row.
  void addRowDerivatives(SampleAt &at, std::size_t index, const abi::SamplerKey &key);
  /// The same of quads.
  void addDerivatives(SampleAt &at, const abi::SamplerKey &key);

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Interpolator &m_interpolator;
  Value *m_data, *m_primitive;
  const AffineFlow *m_flow;
  const ConsecutiveSamples *m_samples;
  bool m_refused = false;
  SamplePath m_path;
  const PixelPlace &m_place;
  Value *m_alive = nullptr;
  Value *m_given = nullptr;
  analysis::LiveValues m_live;
  std::size_t m_next = 0; ///< the walk has come to this instruction of the code
  std::vector<PackedTexel> m_texels;
};

} // namespace arbiter::fp::llvm_back
