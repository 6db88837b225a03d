#include "fp_compiler/combiners/state.h"

#include <bit>

#include <algorithm>

namespace arbiter::fp::combiners {

namespace {

bool discardsAll(const Portion &portion) {
  return portion.ab == Register::Discard && portion.cd == Register::Discard &&
         portion.sum == Register::Discard;
}

bool readsProduct(const State &state) {
  return std::any_of(state.finals.begin(), state.finals.begin() + 4,
                     [](const Input &input) { return input.source == Register::ETimesF; });
}

/// Walks the stages and records which texture registers are read before they are written.
class FirstReads {
public:
  explicit FirstReads(const State &state) : m_state(state) {}

  std::uint32_t textures() {
    for (std::size_t i = 0; i < m_state.count; ++i)
      general(m_state.stages[i]);
    for (std::size_t v = 0; v < m_state.finals.size(); ++v)
      if ((v != 4 && v != 5) || readsProduct(m_state))
        read(m_state.finals[v]);
    return m_textures;
  }

private:
  struct Written {
    bool rgb = false, alpha = false;
  };

  void general(const Stage &stage) {
    for (const Portion *const portion : {&stage.rgb, &stage.alpha})
      if (!discardsAll(*portion)) {
        for (const Input &input : portion->inputs)
          read(input);
        if (portion->mux)
          read({Register::Spare0, Mapping::UnsignedIdentity, Usage::Alpha});
      }
    write(stage.rgb, &Written::rgb);
    write(stage.alpha, &Written::alpha);
  }

  void read(const Input &input) {
    if (input.source >= Register::TexturesEnd)
      return; // no other register starts with a texel
    const Written &written = m_written[std::size_t(input.source)];
    if (input.usage == Usage::Alpha ? written.alpha : written.rgb)
      return;
    if (const int unit = textureUnit(input.source); unit >= 0)
      m_textures |= 1u << unit;
    else if (input.source == Register::Spare0 && input.usage == Usage::Alpha)
      m_textures |= 1u;
  }

  void write(const Portion &portion, bool Written::*half) {
    for (const Register to : {portion.ab, portion.cd, portion.sum})
      if (to != Register::Discard)
        m_written[std::size_t(to)].*half = true;
  }

  const State &m_state;
  std::array<Written, kRegisters> m_written{};
  std::uint32_t m_textures = 0;
};

} // namespace

std::uint32_t texturesRead(const State &state) { return FirstReads(state).textures(); }

std::uint32_t registersWritten(const State &state) {
  std::uint32_t written = 0;
  for (std::size_t i = 0; i < state.count; ++i)
    for (const Portion *const portion : {&state.stages[i].rgb, &state.stages[i].alpha})
      for (const Register to : {portion->ab, portion->cd, portion->sum})
        if (to != Register::Discard)
          written |= 1u << unsigned(to);
  return std::uint32_t(std::popcount(written));
}

State essential(const State &state) {
  State result = state;
  for (std::size_t i = result.count; i < result.stages.size(); ++i)
    result.stages[i] = {};
  if (!readsProduct(state))
    result.finals[4] = result.finals[5] = {};
  return result;
}

} // namespace arbiter::fp::combiners
