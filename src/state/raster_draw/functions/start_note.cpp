#include "state/raster_draw/functions/start_note.h"

#include <atomic>
#include <optional>
#include <string>

#include "state/raster_draw/functions/compile_thread.h"
#include "state/raster_draw/functions/functions.h"
#include "util/build_id.h"
#include "util/cache/cache_store.h"
#include "util/defaults/program.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

/// After a mixed frame, this many whole frames in a row are needed to note whole frames again.
constexpr int kWholeAgain = 64;
/// Limits writes by an application that alternates between kinds of frames.
constexpr int kMaxNotes = 8;

struct Note {
  CacheStore store;
  std::string key;
};

std::optional<Note> openNote() {
  const std::string folder = settings().cache ? cacheFolder() : std::string();
  if (folder.empty())
    return std::nullopt;
  const defaults::Program program = defaults::programOf(defaults::ownFacts());
  if (program.path.empty())
    return std::nullopt;
  return Note{{folder + "/code", std::uint64_t(settings().cacheMaxMegabytes) << 20},
              buildId() + " start of " + program.file() + " " + program.windows};
}

LastStart readNote() {
  const std::optional<Note> note = openNote();
  const std::optional<std::string> value = note ? note->store.find(note->key) : std::nullopt;
  if (!value)
    return LastStart::Unknown;
  return *value == "whole frames" ? LastStart::WholeFrames : LastStart::Engine;
}

/// The note that is on disk, or about to be written.
std::atomic<LastStart> g_noted{LastStart::Unknown};
std::atomic<int> g_notes{0};
std::atomic<int> g_wholeInRow{kWholeAgain}; ///< number of frames

/// Writes the note after the pending compilations, so that a start that finds the note also finds
/// the code.
void write(LastStart noted) {
  if (g_noted.exchange(noted, std::memory_order_relaxed) == noted ||
      g_notes.fetch_add(1, std::memory_order_relaxed) >= kMaxNotes)
    return;
  compileLater([noted] {
    if (const std::optional<Note> note = openNote())
      note->store.store(note->key,
                        noted == LastStart::WholeFrames ? "whole frames" : "engine used");
  });
}

} // namespace

LastStart lastStart() {
  static const LastStart s_last = [] {
    const LastStart read = readNote();
    g_noted.store(read, std::memory_order_relaxed);
    return read;
  }();
  return s_last;
}

void startEngineAsBefore() {
  static std::atomic<bool> s_asked{false};
  if (!settings().cache || s_asked.exchange(true, std::memory_order_relaxed))
    return;
  compileLater([] {
    if (lastStart() != LastStart::Unknown)
      static_cast<void>(engine());
  });
}

void noteEngine() {
  if (lastStart() == LastStart::Unknown)
    write(LastStart::Engine);
}

void noteFrame(bool whole) {
  static_cast<void>(lastStart());
  int inRow = g_wholeInRow.load(std::memory_order_relaxed);
  inRow = !whole ? 0 : inRow < kWholeAgain ? inRow + 1 : inRow;
  g_wholeInRow.store(inRow, std::memory_order_relaxed);
  if (!whole || inRow == kWholeAgain)
    write(whole ? LastStart::WholeFrames : LastStart::Engine);
}

} // namespace arbiter::state
