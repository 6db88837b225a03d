#pragma once
#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/back/llvm/fragment/fragment_consecutive.h"
#include "fp_compiler/back/llvm/pixel/pixel.h"
#include "fp_compiler/back/llvm/program/program.h"

/// Provides the registers of a fragment program.
namespace arbiter::fp::llvm_back {

class FragmentHooks final : public ProgramHooks {
public:
  /// \param flow for Lanes::Row; null for blocks
  /// \param samples null if no sample is affine
  FragmentHooks(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                const Places &places, Interpolator &interpolator, Value *data,
                const AffineFlow *flow, const ConsecutiveSamples *samples, SamplePath path,
                const PixelPlace &place)
      : m_code(code), m_program(program), m_key(key), m_places(places),
        m_interpolator(interpolator), m_data(data), m_flow(flow), m_samples(samples), m_path(path),
        m_place(place), m_live(analysis::liveOf(program.program())) {}

  [[nodiscard]] Vec attribute(int index, unsigned needed) override;
  [[nodiscard]] Vec parameter(int index, unsigned needed) override;
  [[nodiscard]] Vec texture(const ir::Instruction &instruction, const std::array<Vec, 3> &operands,
                            unsigned needed) override;
  [[nodiscard]] bool hasQuads() override;
  [[nodiscard]] Value *wanted() override;
  /// Sets the texels of SamplePath::Given, as they are in memory.
  void give(Value *texels) { m_given = texels; }
  void kill(Value *lanes) override;
  [[nodiscard]] Vec relative(int array, Value *index, unsigned needed) override;

  /// Returns the input of an attribute that an option reads, or nulls.
  [[nodiscard]] Vec input(ir::Attribute attribute, unsigned needed);
  /// True if a row met a derivative, or a level of detail that depends on more than an affine
  /// coordinate.
  [[nodiscard]] bool refused() const { return m_refused; }
  [[nodiscard]] Value *alive() const { return m_alive; }
  [[nodiscard]] std::vector<PackedTexel> takeTexels() { return std::move(m_texels); }

private:
  /// Returns the index of the current texture instruction. The walk passes narrowed copies in
  /// order.
  [[nodiscard]] std::size_t nextTexture();
  [[nodiscard]] Vec facing(unsigned needed);
  [[nodiscard]] SampleAt sampleAt(const ir::Instruction &instruction,
                                  const std::array<Vec, 3> &operands);
  /// Sets the derivatives of a coordinate between neighbouring pixels in a row.
  void addRowDerivatives(SampleAt &at, std::size_t index, const abi::SamplerKey &key);
  /// Sets the derivatives of a coordinate in quads.
  void addDerivatives(SampleAt &at, const abi::SamplerKey &key);

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Interpolator &m_interpolator;
  Value *m_data;
  const AffineFlow *m_flow;
  const ConsecutiveSamples *m_samples;
  bool m_refused = false;
  SamplePath m_path;
  const PixelPlace &m_place;
  Value *m_alive = nullptr;
  Value *m_given = nullptr;
  analysis::LiveValues m_live;
  std::size_t m_next = 0; ///< next instruction of the code that the walk reaches
  std::vector<PackedTexel> m_texels;
};

} // namespace arbiter::fp::llvm_back
