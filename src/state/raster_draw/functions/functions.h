#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "fp_compiler/abi.h"
#include "fp_compiler/jit.h"
#include "state/raster_draw/outcome.h"

/// The process's machine code: the engine, created on first use, and functions by program and key.
/// Missing functions are compiled on another thread. A draw waits for that only a while; then the
/// host draws until the function is ready.
namespace arbiter::state {

/// Returns the engine, created at the first call, which loads LLVM. Returns null if the library
/// does not load; this is logged once.
[[nodiscard]] fp::jit::Engine *engine();
/// Starts to create the engine on the compiling thread. Returns true until it is ready. Returns
/// false if there is no such thread, too.
[[nodiscard]] bool awaitsEngine();

/// The progress of something that is compiled in the background.
enum class Progress : std::uint8_t { Making, Ready, Failed };

/// One function, or the slot where it will be.
template <typename Function> struct FunctionSlot {
  /// Null until it is ready. A draw pays only for this load.
  std::atomic<Function> function{nullptr};
  std::atomic<Progress> progress{Progress::Making};
  std::unique_ptr<fp::jit::Code<Function>> code;
};

/// How long a caller waits:
/// - Not: not at all, because the host can draw this time
/// - ForDisk: as long as reading code from disk takes
/// - Briefly: for a while
/// - UntilDone: until all is compiled (ARBITER_BACKEND=swrast)
enum class Wait : std::uint8_t { Not, ForDisk, Briefly, UntilDone };

/// The functions of one program, by key.
template <typename Key, typename Function> class FunctionSlots {
public:
  using Slot = FunctionSlot<Function>;
  /// Returns the slot for `key`. \param made true if it is new
  Slot &find(const Key &key, bool &made) {
    const std::lock_guard lock(m_mutex);
    std::unique_ptr<Slot> &entry = m_slots[key];
    made = !entry;
    if (made)
      entry = std::make_unique<Slot>();
    return *entry;
  }

private:
  struct Hash {
    std::size_t operator()(const Key &key) const { return abi::hashOf(key); }
  };
  std::mutex m_mutex;
  std::unordered_map<Key, std::unique_ptr<Slot>, Hash> m_slots;
};

/// Caches the slots that draws asked for recently, so that a repeated draw takes no lock.
template <typename Functions, typename Key> class RecentFunctions {
public:
  using Slot = typename Functions::Slot;
  /// Returns Functions::slot(), from the cache if possible.
  Slot &slot(Functions &functions, const Key &key, Wait wait) {
    for (const Recent &recent : m_recent)
      if (recent.slot && std::memcmp(&recent.key, &key, sizeof key) == 0)
        return *recent.slot;
    Slot &found = functions.slot(key, wait);
    m_recent[m_next++ % m_recent.size()] = {key, &found};
    return found;
  }

private:
  struct Recent {
    Key key;
    Slot *slot = nullptr;
  };
  std::array<Recent, 8> m_recent{};
  std::size_t m_next = 0;
};

/// Returns ok if the slot has its function, or else the reason why the host draws.
template <typename Function> Outcome outcomeOf(const FunctionSlot<Function> &slot) {
  if (slot.function.load(std::memory_order_acquire))
    return {};
  return slot.progress.load(std::memory_order_acquire) == Progress::Failed ? Fallback::NotCompiled
                                                                           : Fallback::Compiling;
}

/// The functions of one fragment program in one mode. Contexts share the object. Its functions live
/// as long as it does.
class FragmentFunctions : public std::enable_shared_from_this<FragmentFunctions> {
public:
  using Slots = FunctionSlots<abi::FragmentKey, abi::ShadeFunction>;
  using Slot = Slots::Slot;
  FragmentFunctions(std::shared_ptr<const fp::ir::Program> source, fp::Numerics numerics)
      : m_source(std::move(source)), m_numerics(numerics) {}

  /// Returns the program prepared for the back end; null until that is done, or if it failed.
  [[nodiscard]] const fp::jit::FragmentProgram *prepared() const {
    return m_prepared.load(std::memory_order_acquire);
  }
  [[nodiscard]] Progress progress() const { return m_progress.load(std::memory_order_acquire); }
  /// Returns the cost of a pixel in nanoseconds (pixel_cost.h). Requires prepared().
  [[nodiscard]] std::uint32_t pixelCost() const { return m_pixelCost; }
  /// Returns the slot for `key`, and requests the function if this is the first call. Requires
  /// prepared(). It takes a lock, so keep the result.
  [[nodiscard]] Slot &slot(const abi::FragmentKey &key, Wait wait);

private:
  friend std::shared_ptr<FragmentFunctions>
  fragmentFunctions(const std::shared_ptr<const fp::ir::Program> &, fp::Numerics, Wait);
  void prepare();
  void compile(const abi::FragmentKey &key, Slot &slot);

  const std::shared_ptr<const fp::ir::Program> m_source;
  const fp::Numerics m_numerics;
  std::unique_ptr<fp::jit::FragmentProgram> m_owned;
  std::uint32_t m_pixelCost = 1;
  std::atomic<const fp::jit::FragmentProgram *> m_prepared{nullptr};
  std::atomic<Progress> m_progress{Progress::Making};
  Slots m_slots;
};

/// The functions of one vertex program in one mode. A program that samples no texture has one
/// function.
class VertexFunctions : public std::enable_shared_from_this<VertexFunctions> {
public:
  using Slots = FunctionSlots<abi::VertexKey, abi::VertexFunction>;
  using Slot = Slots::Slot;
  VertexFunctions(std::shared_ptr<const fp::ir::Program> source, fp::Numerics numerics)
      : m_source(std::move(source)), m_numerics(numerics) {}
  /// Returns the prepared program; null until it is ready or if it failed. If there is only one
  /// function, that is ready too.
  [[nodiscard]] const fp::jit::VertexProgram *prepared() const {
    return m_prepared.load(std::memory_order_acquire);
  }
  /// Returns the only function of a program that samples nothing.
  [[nodiscard]] abi::VertexFunction function() const {
    return m_only.function.load(std::memory_order_acquire);
  }
  /// Returns the slot for `key`, for a program that samples, like FragmentFunctions::slot().
  [[nodiscard]] Slot &slot(const abi::VertexKey &key, Wait wait);
  [[nodiscard]] Progress progress() const { return m_progress.load(std::memory_order_acquire); }

private:
  friend std::shared_ptr<VertexFunctions>
  vertexFunctions(const std::shared_ptr<const fp::ir::Program> &, fp::Numerics, Wait);
  void make();
  void compile(const abi::VertexKey &key, Slot &slot);

  const std::shared_ptr<const fp::ir::Program> m_source;
  const fp::Numerics m_numerics;
  std::unique_ptr<fp::jit::VertexProgram> m_owned;
  Slot m_only;
  Slots m_slots;
  std::atomic<const fp::jit::VertexProgram *> m_prepared{nullptr};
  std::atomic<Progress> m_progress{Progress::Making};
};

/// Returns the functions of a program. The same program and mode give the same object. It takes a
/// lock, so keep the result while the program is effective.
[[nodiscard]] std::shared_ptr<FragmentFunctions>
fragmentFunctions(const std::shared_ptr<const fp::ir::Program> &program, fp::Numerics numerics,
                  Wait wait);
[[nodiscard]] std::shared_ptr<VertexFunctions>
vertexFunctions(const std::shared_ptr<const fp::ir::Program> &program, fp::Numerics numerics,
                Wait wait);

/// Counts of compiled functions, for --stats.
struct CompileStatistics {
  std::uint64_t functions = 0, failed = 0;
  std::uint64_t codeBytes = 0;
  double milliseconds = 0; ///< time spent compiling, on any thread
};
[[nodiscard]] CompileStatistics compileStatistics();

} // namespace arbiter::state
