#include "state/raster_draw/functions/functions.h"

#include <chrono>
#include <exception>

#include "fp_compiler/ir/ir.h"
#include "state/raster_draw/functions/compile_thread.h"
#include "state/raster_draw/functions/pixel_cost.h"
#include "state/raster_draw/functions/start_note.h"
#include "util/cache/cache_store.h"
#include "util/flags.h"
#include "util/log.h"
#include "util/thread.h"

namespace arbiter::state {

namespace {

std::atomic<bool> g_engineKnown{false};
std::atomic<std::uint64_t> g_functions{0}, g_failed{0}, g_codeBytes{0}, g_nanoseconds{0};

/// Adds its lifetime to the statistics.
class Stopwatch {
public:
  ~Stopwatch() {
    const auto time = std::chrono::steady_clock::now() - m_begin;
    g_nanoseconds += std::uint64_t(std::chrono::nanoseconds(time).count());
  }

private:
  std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

/// How long a draw waits for a function. A software host also compiles on the drawing thread before
/// the first draw with a program or state, and usually takes longer than this back end. If it takes
/// longer than this limit, the compiling thread goes on, and the host draws meanwhile.
constexpr std::chrono::milliseconds kWorthWaiting{50};
/// How long a draw waits for code on disk, which takes half a millisecond to read.
constexpr std::chrono::milliseconds kWorthReading{8};

/// Runs a task on the compiling thread. The application's thread may have a small stack, an
/// operator new of its own, or a floating-point environment that LLVM does not support. If there is
/// no such thread, the function is never ready and the host draws.
template <typename Task> void run(Wait wait, Task task) {
  const When when = wait == Wait::Not ? When::AfterFrame : When::Soon;
  if (!compileLater(std::move(task), when) || wait == Wait::Not)
    return;
  if (wait == Wait::UntilDone)
    awaitCompiler(std::nullopt);
  else
    awaitCompiler(wait == Wait::ForDisk ? kWorthReading : kWorthWaiting);
}

template <typename Code> void note(const Code &code, const char *what, const std::string &reason) {
  if (code) {
    ++g_functions;
    g_codeBytes += code->bytes;
    return;
  }
  ++g_failed;
  logInfo("software", "a %s program stays with the host: %s", what, reason.c_str());
}

/// Runs `work`, and ignores a lack of memory. The function is then missing, and the host draws.
template <typename Work> void withoutMemory(Work work) {
  try {
    work();
  } catch (const std::exception &) {
  }
}

/// Fills a slot with the code that `compile` makes.
template <typename Slot, typename Compile>
void make(Slot &slot, const char *what, Compile compile) {
  const Stopwatch stopwatch;
  std::string reason;
  withoutMemory([&] { slot.code = compile(reason); });
  note(slot.code, what, reason);
  if (slot.code)
    slot.function.store(slot.code->function, std::memory_order_release);
  slot.progress.store(slot.code ? Progress::Ready : Progress::Failed, std::memory_order_release);
}

/// Returns the slot of a key. A new slot is filled by `fill`, on the compiling thread.
template <typename Slots, typename Key, typename Fill>
typename Slots::Slot &placeFor(Slots &slots, const Key &key, Wait wait, Fill fill) {
  bool made = false;
  typename Slots::Slot &slot = slots.find(key, made);
  if (!made)
    return slot;
  try {
    run(wait, [fill = std::move(fill), place = &slot] { fill(*place); });
  } catch (const std::exception &) { // the function will never be made
    slot.progress.store(Progress::Failed, std::memory_order_release);
    throw;
  }
  return slot;
}

/// The function objects by program and mode. When an entry is added, entries whose program nothing
/// else holds are dropped.
template <typename Functions> class Table {
public:
  std::shared_ptr<Functions> find(const std::shared_ptr<const fp::ir::Program> &program,
                                  fp::Numerics numerics, bool &made) {
    const std::lock_guard lock(m_mutex);
    Entry &entry = m_entries[{program.get(), numerics}];
    made = !entry.functions;
    if (!made)
      return entry.functions;
    entry.program = program;
    entry.functions = std::make_shared<Functions>(program, numerics);
    std::shared_ptr<Functions> functions = entry.functions;
    sweep();
    return functions;
  }

private:
  struct Key {
    const fp::ir::Program *program;
    fp::Numerics numerics;
    bool operator==(const Key &) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key &key) const {
      return std::hash<const void *>()(key.program) * 4 + std::size_t(key.numerics);
    }
  };
  struct Entry {
    std::shared_ptr<const fp::ir::Program> program;
    std::shared_ptr<Functions> functions;
  };
  /// Drops unused entries: those held by the table and by their own functions alone.
  void sweep() {
    if (m_entries.size() < m_sweepAt)
      return;
    std::erase_if(m_entries, [](const auto &item) {
      return item.second.program.use_count() <= 2 && item.second.functions.use_count() == 1;
    });
    m_sweepAt = 2 * m_entries.size() + 64;
  }
  std::mutex m_mutex;
  std::unordered_map<Key, Entry, KeyHash> m_entries;
  std::size_t m_sweepAt = 64;
};

/// Returns the table. Never freed, because the compiling thread may outlive static destructors.
template <typename Functions> Table<Functions> &table() {
  static auto *const s_table = new Table<Functions>;
  return *s_table;
}

} // namespace

fp::jit::Engine *engine() {
  static fp::jit::Engine *const s_engine = []() -> fp::jit::Engine * {
    const NoCancel scope; // files are read, and LLVM is started
    fp::jit::EngineOptions options;
    options.cpu = settings().cpu;
    if (settings().cache && !cacheFolder().empty()) {
      options.cacheFolder = cacheFolder() + "/code";
      options.cacheMaxBytes = std::uint64_t(settings().cacheMaxMegabytes) << 20;
    }
    std::string reason;
    std::unique_ptr<fp::jit::Engine> made = fp::jit::makeEngine(options, reason);
    if (made) {
      logInfo("software", "rasterizer: %s", made->target().c_str());
      compileLater(noteEngine);
    } else {
      logWarn("software", "no rasterizer, the host draws: %s", reason.c_str());
    }
    g_engineKnown.store(true, std::memory_order_release);
    return made.release(); // leaked, because its code may run until the process ends
  }();
  return s_engine;
}

bool awaitsEngine() {
  static std::atomic<bool> s_asked{false};
  if (g_engineKnown.load(std::memory_order_acquire))
    return false;
  return s_asked.exchange(true) ||
         compileLater([] { static_cast<void>(engine()); }, When::AfterFrame);
}

void FragmentFunctions::prepare() {
  const Stopwatch stopwatch;
  withoutMemory([&] {
    if (fp::jit::Engine *const jit = engine())
      m_owned = jit->prepareFragment(*m_source, m_numerics);
  });
  if (m_owned)
    m_pixelCost = state::pixelCost(m_owned->program());
  m_prepared.store(m_owned.get(), std::memory_order_release);
  m_progress.store(m_owned ? Progress::Ready : Progress::Failed, std::memory_order_release);
}

void FragmentFunctions::compile(const abi::FragmentKey &key, Slot &slot) {
  make(slot, "fragment",
       [&](std::string &reason) { return engine()->compile(*m_owned, key, reason); });
}

FragmentFunctions::Slot &FragmentFunctions::slot(const abi::FragmentKey &key, Wait wait) {
  return placeFor(m_slots, key, wait,
                  [self = shared_from_this(), key](Slot &slot) { self->compile(key, slot); });
}

void VertexFunctions::compile(const abi::VertexKey &key, Slot &slot) {
  state::make(slot, "vertex",
              [&](std::string &reason) { return engine()->compile(*m_owned, key, reason); });
}

VertexFunctions::Slot &VertexFunctions::slot(const abi::VertexKey &key, Wait wait) {
  return placeFor(m_slots, key, wait,
                  [self = shared_from_this(), key](Slot &slot) { self->compile(key, slot); });
}

void VertexFunctions::make() {
  {
    const Stopwatch stopwatch;
    withoutMemory([&] {
      if (fp::jit::Engine *const jit = engine())
        m_owned = jit->prepareVertex(*m_source, m_numerics);
    });
  }
  bool ready = m_owned != nullptr;
  if (ready && m_owned->shape().samplers.empty()) {
    compile({}, m_only);
    ready = function() != nullptr;
  }
  if (!m_owned)
    note(m_only.code, "vertex", "it cannot be prepared");
  m_prepared.store(ready ? m_owned.get() : nullptr, std::memory_order_release);
  m_progress.store(ready ? Progress::Ready : Progress::Failed, std::memory_order_release);
}

std::shared_ptr<FragmentFunctions>
fragmentFunctions(const std::shared_ptr<const fp::ir::Program> &program, fp::Numerics numerics,
                  Wait wait) {
  bool made = false;
  auto functions = table<FragmentFunctions>().find(program, numerics, made);
  if (!made)
    return functions;
  try {
    run(wait, [functions] { functions->prepare(); });
  } catch (const std::exception &) {
    functions->m_progress.store(Progress::Failed, std::memory_order_release);
    throw;
  }
  return functions;
}

std::shared_ptr<VertexFunctions>
vertexFunctions(const std::shared_ptr<const fp::ir::Program> &program, fp::Numerics numerics,
                Wait wait) {
  bool made = false;
  auto functions = table<VertexFunctions>().find(program, numerics, made);
  if (!made)
    return functions;
  try {
    run(wait, [functions] { functions->make(); });
  } catch (const std::exception &) {
    functions->m_progress.store(Progress::Failed, std::memory_order_release);
    throw;
  }
  return functions;
}

CompileStatistics compileStatistics() {
  return {g_functions.load(), g_failed.load(), g_codeBytes.load(),
          double(g_nanoseconds.load()) * 1e-6};
}

} // namespace arbiter::state
