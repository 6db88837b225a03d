#pragma once
#include <array>
#include <vector>

#include "fp_compiler/testing/evaluate_combiners.h"
#include "fp_compiler/testing/evaluate_environments.h"
#include "fp_compiler/testing/random.h"
#include "reduce.h"
#include "textures.h"

/// What random stages are drawn with: textures of every target and format, and an 8x8 grid of
/// rectangles, each of one colour and one coordinate a unit, so that no interpolation stands
/// between a draw and the specification.
namespace shaded {

inline constexpr int kCells = 8;    ///< a side
inline constexpr int kCellSize = 4; ///< in pixels
inline constexpr int kSize = kCells * kCellSize;

/// What the framebuffer holds before a draw.
inline constexpr std::array<float, 4> kClearColor = {0.2f, 0.4f, 0.6f, 0.8f};
inline constexpr float kClearDepth = 0.125f;

/// What the framebuffer gets of a fragment, before it is clamped.
struct Colored {
  arbiter::fp::texture_shader::Color color{};
  bool isExact = false; ///< of whole 255ths, and nothing else
  double margin = 1.0;  ///< combiners::Evaluated::margin
};

class Scene {
public:
  /// \param peer for NVIDIA's driver: what it does otherwise (docs/write/texture_shaders.md) is
  /// left out \param fx9 of Numerics::Fx9: register combiners of random states stand behind the
  /// stages
  Scene(bool peer, bool fx9);
  /// New stages and new values for everything around them; GL is set to it.
  void arrange(arbiter::fp::testing::Random &random, int units);
  void draw() const;

  [[nodiscard]] Kept kept() const { return {m_state, m_environments}; }
  /// Stages and environments become these, in GL too, and all around them stays.
  void restore(const Kept &kept);
  /// Prints what there is, and what its units make of a cell.
  void describe(int cell) const;

  [[nodiscard]] const arbiter::fp::texture_shader::State &state() const { return m_state; }
  [[nodiscard]] bool combines() const { return m_combines; }
  [[nodiscard]] arbiter::fp::texture_shader::Evaluated evaluate(int cell) const;
  [[nodiscard]] Colored colorOf(int cell,
                                const arbiter::fp::texture_shader::Evaluated &evaluated) const;

private:
  void makeConstantsCurrent() const;
  struct Cell {
    std::array<arbiter::fp::texture_shader::Color, arbiter::fp::texture_shader::kUnits>
        coordinates{};
    arbiter::fp::texture_shader::Color primary{};
  };

  void arrangeConventional(arbiter::fp::testing::Random &random);
  void bind(arbiter::fp::testing::Random &random, int unit);
  void arrangeParameters(arbiter::fp::testing::Random &random);
  void arrangeCoordinates(arbiter::fp::testing::Random &random);
  void arrangeColoring(arbiter::fp::testing::Random &random);

  void arrangeCombiners(arbiter::fp::testing::Random &random);

  bool m_peer, m_fx9;
  std::vector<Texture> m_textures;
  arbiter::fp::texture_shader::State m_state;
  std::array<const Texture *, arbiter::fp::texture_shader::kUnits> m_bound{};
  bool m_combines = false;
  int m_shown = 0;
  arbiter::fp::combiners::State m_combiners;         ///< with m_fx9
  arbiter::fp::combiners::Inputs m_combinerInputs{}; ///< without primary colours and textures
  arbiter::fp::texture_shader::Environments m_environments;
  std::array<arbiter::fp::texture_shader::Color, arbiter::fp::texture_shader::kUnits> m_constants{};
  arbiter::fp::texture_shader::Inputs m_inputs; ///< without coordinates
  std::vector<Cell> m_cells;
};

} // namespace shaded
