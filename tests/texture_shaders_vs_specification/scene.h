#pragma once
#include <array>
#include <vector>

#include "fp_compiler/testing/evaluate_combiners.h"
#include "fp_compiler/testing/evaluate_environments.h"
#include "fp_compiler/testing/random.h"
#include "reduce.h"
#include "textures.h"

/// The scene for random stages: textures of every target and format, and an 8x8 grid of rectangles.
/// Each has one color and one coordinate for each unit, so that interpolation does not affect the
/// comparison with the specification.
namespace shaded {

inline constexpr int kCells = 8;    ///< on a side
inline constexpr int kCellSize = 4; ///< in pixels
inline constexpr int kSize = kCells * kCellSize;

/// The framebuffer's content before a draw.
inline constexpr std::array<float, 4> kClearColor = {0.2f, 0.4f, 0.6f, 0.8f};
inline constexpr float kClearDepth = 0.125f;

/// The color that the framebuffer receives from a fragment, before clamping.
struct Colored {
  arbiter::fp::texture_shader::Color color{};
  bool isExact = false; ///< sum of whole 255ths
  double margin = 1.0;  ///< combiners::Evaluated::margin
};

class Scene {
public:
  /// Makes the scene. \param peer leaves out what NVIDIA's driver does differently
  /// (docs/write/texture_shaders.md)
  /// \param fx9 puts register combiners of random states behind the stages, for Numerics::Fx9
  Scene(bool peer, bool fx9);
  /// Chooses new stages and new values for everything around them, and sets GL to it.
  void arrange(arbiter::fp::testing::Random &random, int units);
  void draw() const;

  [[nodiscard]] Kept kept() const { return {m_state, m_environments}; }
  /// Restores stages and environments, in GL too, and keeps everything around them.
  void restore(const Kept &kept);
  /// Prints the state, and its units' results for a cell.
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
  arbiter::fp::combiners::State m_combiners;         ///< used with m_fx9
  arbiter::fp::combiners::Inputs m_combinerInputs{}; ///< without primary colors and textures
  arbiter::fp::texture_shader::Environments m_environments;
  std::array<arbiter::fp::texture_shader::Color, arbiter::fp::texture_shader::kUnits> m_constants{};
  arbiter::fp::texture_shader::Inputs m_inputs; ///< without coordinates
  std::vector<Cell> m_cells;
};

} // namespace shaded
