#include "fp_compiler/hw/cycles.h"

#include <algorithm>

namespace arbiter::fp::hw {

namespace {

/// Returns the estimate with the slowest unit as its bound. If two are equally slow, the first
/// counts.
CycleEstimate boundBy(std::vector<CycleEstimate::Unit> units, std::string limits) {
  CycleEstimate estimate;
  const auto slowest = std::max_element(
      units.begin(), units.end(), [](const CycleEstimate::Unit &a, const CycleEstimate::Unit &b) {
        return a.cycles < b.cycles;
      });
  estimate.cycles = slowest->cycles;
  estimate.bound = slowest->name;
  estimate.units = std::move(units);
  estimate.limits = std::move(limits);
  return estimate;
}

/// R300: one pair and one sample a clock, at the same time. Source: reviews at the card's launch
/// (2002), from ATI. Each of the 8 pipes has one texture unit and starts a sample and a colour
/// operation in each clock; 16 textures take it 16 clocks.
constexpr double kR300PairsPerClock = 1, kR300SamplesPerClock = 1;

/// NV30: fragment processor tests by "thepkrl" (Beyond3D, April 2003), run on the card. Every
/// instruction is one pass; LRP, RSQ, LIT and POW are two (nv30/translate.cpp). Floating point and
/// textures share the unit. Two samples of interpolated coordinates take one pass. The unit runs at
/// full speed with two full registers; two 16-bit registers count as one.
constexpr std::uint32_t kNv30SamplesPerPass = 2;
constexpr std::uint32_t kNv30FullSpeedRegisters = 2;
/// NV35: twice the floating-point rate of NV30, as NVIDIA announced it, because its integer units
/// became float units (Beyond3D, review of the GeForce FX 5900, May 2003). So a pass runs at most a
/// second arithmetic instruction.
constexpr double kNv35InstructionsPerPass = 2;

/// 915G: a pixel a clock in each of 4 pipes (Intel, 2004). Nothing was published about the speed of
/// programs; an instruction a clock is an assumption.
constexpr double kI915InstructionsPerClock = 1;

/// Passes through NV30's one unit, counted by kind.
struct Passes {
  std::uint32_t textures = 0, arithmetic = 0;
};

Passes passesOf(const SlotProgram &code) {
  Passes passes;
  std::uint32_t paired = 0; // interpolated samples in the current pass
  for (const Slot &slot : code.slots) {
    if (!slot.texture || !slot.interpolated) {
      (slot.texture ? passes.textures : passes.arithmetic) += slot.passes;
      paired = 0;
      continue;
    }
    passes.textures += paired == 0 ? 1 : 0;
    paired = (paired + 1) % kNv30SamplesPerPass;
  }
  return passes;
}

} // namespace

CycleEstimate estimateR300(const r300::Code &code) {
  return boundBy({{"ALU", double(code.pairs.size()) / kR300PairsPerClock},
                  {"texture", double(code.textures.size()) / kR300SamplesPerClock}},
                 "one ALU slot and one sample a clock, side by side; left out are texture cache "
                 "misses, filtering beyond bilinear, the wait for a dependent read (other pixels "
                 "fill it), setup and memory");
}

CycleEstimate estimateNv30(const SlotProgram &code, NativeModel model) {
  const Passes passes = passesOf(code);
  std::vector<CycleEstimate::Unit> units;
  double unit = passes.textures + passes.arithmetic;
  if (model == NativeModel::Nv35) {
    units.push_back({"texture", double(passes.textures)});
    unit /= kNv35InstructionsPerPass;
    units.push_back({"float", unit});
    unit = std::max(unit, double(passes.textures));
  } else {
    units.push_back({"float and texture", unit});
  }
  // The chip keeps as many pixels in flight as their registers fit in its store, in steps of two.
  const std::uint32_t steps =
      std::max(1u, (code.temporaries + kNv30FullSpeedRegisters - 1) / kNv30FullSpeedRegisters);
  if (steps > 1)
    units.push_back({"registers", unit * steps});
  return boundBy(std::move(units),
                 "full speed is two full registers; that the pixels in flight, and with them the "
                 "speed, fall in proportion beyond is an assumption; left out are texture cache "
                 "misses, filtering, and the fixed-point units, which these programs do not reach");
}

CycleEstimate estimateI915(const SlotProgram &code) {
  return boundBy({{"shader", double(code.slots.size()) / kI915InstructionsPerClock}},
                 "an instruction a clock is an assumption, for nothing was published; left out are "
                 "texture cache misses, filtering, the change of a phase and memory");
}

} // namespace arbiter::fp::hw
