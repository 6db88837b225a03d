#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "util/cache/keyed_hash.h"

/// A cache on disk that all processes of a user share. Entries may vanish at any time, and no
/// failure is an error. A file that is incomplete, or that this user did not write into this
/// folder, is a miss.
namespace arbiter {

class CacheStore {
public:
  /// Creates `folder` and its parents, readable by the owner only, with a secret for signing
  /// entries. The store stays empty if the folder cannot be made, belongs to another user, or is
  /// writable by others.
  /// \param maxBytes of all files together; each of the 64 subfolders gets a 64th, and evicts by
  /// the
  ///                time of last use
  CacheStore(std::string folder, std::uint64_t maxBytes) noexcept;

  [[nodiscard]] bool usable() const { return m_usable; }

  /// Returns the value stored under exactly this key. Removes a file that is damaged, has another
  /// key or signature, or is accessible to others. Like store(), it is safe from any thread and any
  /// number of processes.
  [[nodiscard]] std::optional<std::string> find(std::string_view key) const noexcept;

  /// Writes a new file and moves it into place, so that readers see all of it or nothing. A value
  /// larger than half a subfolder's share is not stored.
  /// \returns false if nothing was stored
  bool store(std::string_view key, std::string_view value) const noexcept;

private:
  std::string m_folder;
  std::uint64_t m_shardBytes;
  HashKey m_secret{};
  bool m_usable = false;
};

/// The number and size of a cache's files.
struct CacheUsage {
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
};
[[nodiscard]] CacheUsage cacheUsage(const std::string &folder);
/// Removes the entries that CacheStore made, and nothing else. The secret stays, as running
/// processes have read it.
/// \returns what is left
CacheUsage clearCache(const std::string &folder);

/// Returns $XDG_CACHE_HOME/arbiter, or ~/.cache/arbiter. Returns "" in a set-user-id program, if
/// neither variable is set, and for a relative path (the XDG base directory specification ignores
/// it).
[[nodiscard]] std::string cacheFolder();

} // namespace arbiter
