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

/// The process's machine code: the engine, made when first wanted, and the functions by program and
/// key. What is missing is compiled on a thread of its own, which the draw waits for a while; if it
/// is not ready by then the host draws until it is.
namespace arbiter::state::software {

/// The engine, made at the first call (it loads LLVM); null where the library does not load, which
/// is said once in the log.
[[nodiscard]] fp::jit::Engine *engine();
/// Has it made by the compiling thread. True while it is not there yet; false where there is no
/// such thread, too.
[[nodiscard]] bool awaitsEngine();

/// How far a thing that is compiled aside has come.
enum class Progress : std::uint8_t { Making, Ready, Failed };

/// One function, or the place where it will be.
template <typename Function> struct FunctionSlot {
  /// Null until it is ready: one load is all that a draw pays.
  std::atomic<Function> function{nullptr};
  std::atomic<Progress> progress{Progress::Making};
  std::unique_ptr<fp::jit::Code<Function>> code;
};

/// Whether a caller waits: not at all, as the host draws this time whatever there is; as long as
/// reading the disk takes, as the code should be there; for a while; or until all is compiled
/// (ARBITER_BACKEND=swrast).
enum class Wait : std::uint8_t { Not, ForDisk, Briefly, UntilDone };

/// The functions of one program by key.
template <typename Key, typename Function> class FunctionSlots {
public:
  using Slot = FunctionSlot<Function>;
  /// The place of the function for `key`. \param made whether there was none before
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

/// Functions of one program that were asked for before, so that a draw that repeats takes no lock.
template <typename Functions, typename Key> class RecentFunctions {
public:
  using Slot = typename Functions::Slot;
  /// As Functions::slot().
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

/// What a draw has of a place: the function, or why it is the host's.
template <typename Function> Outcome outcomeOf(const FunctionSlot<Function> &slot) {
  if (slot.function.load(std::memory_order_acquire))
    return {};
  return slot.progress.load(std::memory_order_acquire) == Progress::Failed ? Fallback::NotCompiled
                                                                           : Fallback::Compiling;
}

/// The functions of one fragment program in one mode. Contexts share it; it lives as long as
/// someone holds it, functions as long as it.
class FragmentFunctions : public std::enable_shared_from_this<FragmentFunctions> {
public:
  using Slots = FunctionSlots<abi::FragmentKey, abi::ShadeFunction>;
  using Slot = Slots::Slot;
  FragmentFunctions(std::shared_ptr<const fp::ir::Program> source, fp::Numerics numerics)
      : m_source(std::move(source)), m_numerics(numerics) {}

  /// The program as the back end sees it; null while it is prepared, and where it cannot be.
  [[nodiscard]] const fp::jit::FragmentProgram *prepared() const {
    return m_prepared.load(std::memory_order_acquire);
  }
  [[nodiscard]] Progress progress() const { return m_progress.load(std::memory_order_acquire); }
  /// Of what prepared() is, in nanoseconds (pixel_cost.h).
  [[nodiscard]] std::uint32_t pixelCost() const { return m_pixelCost; }
  /// The place of the function for `key`; asks for it if it was not asked for yet. Requires
  /// prepared(). Takes a lock: keep the answer.
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

/// The same of a vertex program. One that samples nothing has one function.
class VertexFunctions : public std::enable_shared_from_this<VertexFunctions> {
public:
  using Slots = FunctionSlots<abi::VertexKey, abi::VertexFunction>;
  using Slot = Slots::Slot;
  VertexFunctions(std::shared_ptr<const fp::ir::Program> source, fp::Numerics numerics)
      : m_source(std::move(source)), m_numerics(numerics) {}
  /// Null until it is ready, its function included where it is the only one, and where it cannot
  /// be made.
  [[nodiscard]] const fp::jit::VertexProgram *prepared() const {
    return m_prepared.load(std::memory_order_acquire);
  }
  /// The only one, of a program that samples nothing.
  [[nodiscard]] abi::VertexFunction function() const {
    return m_only.function.load(std::memory_order_acquire);
  }
  /// As FragmentFunctions::slot(), of a program that samples.
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

/// The functions of a program, the same object for the same program and mode. Takes a lock: keep
/// the answer while the program is effective.
[[nodiscard]] std::shared_ptr<FragmentFunctions>
fragmentFunctions(const std::shared_ptr<const fp::ir::Program> &program, fp::Numerics numerics,
                  Wait wait);
[[nodiscard]] std::shared_ptr<VertexFunctions>
vertexFunctions(const std::shared_ptr<const fp::ir::Program> &program, fp::Numerics numerics,
                Wait wait);

/// Compiled and still waiting, for --stats.
struct CompileStatistics {
  std::uint64_t functions = 0, failed = 0;
  std::uint64_t codeBytes = 0;
  double milliseconds = 0; ///< spent compiling, on whatever thread
};
[[nodiscard]] CompileStatistics compileStatistics();

} // namespace arbiter::state::software
