#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "util/cache/keyed_hash.h"

/// Values by key on disk, shared by all processes of a user. A cache: anything may be missing at
/// any time, nothing that goes wrong is an error, and a file that is not whole, or that was not
/// written by this user into this folder, is a miss.
namespace arbiter {

class CacheStore {
public:
  /// `folder` is made, with its parents, readable by its owner only, and with a secret that entries
  /// are signed with. One that belongs to another user, that others may write to, or that cannot be
  /// made leaves a store that holds nothing.
  /// \param maxBytes of all files together; the 64 subfolders are held to a 64th each, by the time
  ///                 of last use
  CacheStore(std::string folder, std::uint64_t maxBytes) noexcept;

  [[nodiscard]] bool usable() const { return m_usable; }

  /// The value stored under exactly this key. A file that is damaged, not signed with the folder's
  /// secret, of another key, or open to others is removed.
  /// Safe from any thread and any number of processes, as store() is.
  [[nodiscard]] std::optional<std::string> find(std::string_view key) const noexcept;

  /// Writes a new file and moves it into place, so that readers see all of it or nothing. A value
  /// of more than half a subfolder's share is not stored. \returns false if nothing was stored.
  bool store(std::string_view key, std::string_view value) const noexcept;

private:
  std::string m_folder;
  std::uint64_t m_shardBytes;
  HashKey m_secret{};
  bool m_usable = false;
};

/// What a cache's folder holds.
struct CacheUsage {
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
};
[[nodiscard]] CacheUsage cacheUsage(const std::string &folder);
/// Removes the entries that CacheStore made, and nothing else: the secret stays, for those who have
/// read it. \returns what is left.
CacheUsage clearCache(const std::string &folder);

/// $XDG_CACHE_HOME/arbiter, or ~/.cache/arbiter; empty without either, for a path that is not
/// absolute (the XDG base directory specification ignores it), and in a set-user-id program.
[[nodiscard]] std::string cacheFolder();

} // namespace arbiter
