#include "util/cache/cache_store.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dirent.h>
#include <fcntl.h>
#include <functional>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "util/cache/cache_key.h"
#include "util/file.h"
#include "util/hash.h"
#include "util/thread.h"

namespace arbiter {

namespace {

constexpr unsigned kShards = 64;
constexpr char kMagic[8] = {'A', 'R', 'B', 'C', 'A', 'C', 'H', '2'};
constexpr const char *kTemporary = ".tmp";
/// A hit renews the time of last use only if it is older than this, so that not every read causes a
/// write.
constexpr std::time_t kTouchSeconds = 600;
/// A temporary file of this age was left by a process that died.
constexpr std::time_t kAbandonedSeconds = 3600;

/// The header in front of key and value in a file.
struct Header {
  char magic[8];
  std::uint64_t keyBytes;
  std::uint64_t valueBytes;
  KeyedHash signature; ///< of the rest of the file, computed with this field zero
};

/// Returns "/folder/2a" for names whose first two digits are 2a, 6a, aa or ea.
std::string shardPath(const std::string &folder, unsigned shard) {
  char digits[8];
  std::snprintf(digits, sizeof digits, "/%02x", shard % kShards);
  return folder + digits;
}
std::string shardOf(const std::string &folder, const std::string &name) {
  return shardPath(folder, unsigned(std::strtoul(name.substr(0, 2).c_str(), nullptr, 16)));
}

/// Owns a file descriptor and closes it.
struct Descriptor {
  int number;
  explicit Descriptor(int n) : number(n) {}
  ~Descriptor() {
    if (number >= 0)
      ::close(number);
  }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;
};

/// Creates the folder if needed. Returns true if it is a folder, not a link, belongs to the user,
/// and no one else may read or write in it. Removes the read permission of others if that is all
/// they have.
bool makeFolders(const std::string &path) {
  for (std::size_t at = path.find('/', 1); at != std::string::npos; at = path.find('/', at + 1))
    ::mkdir(path.substr(0, at).c_str(), 0700); // existing folders stay as they are
  ::mkdir(path.c_str(), 0700);
  const Descriptor folder(
      ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY));
  struct stat status = {};
  if (folder.number < 0 || ::fstat(folder.number, &status) != 0 || status.st_uid != ::geteuid() ||
      (status.st_mode & 022) != 0)
    return false;
  return (status.st_mode & 077) == 0 || ::fchmod(folder.number, 0700) == 0;
}

bool readAll(int descriptor, std::string &bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    const ssize_t count = ::read(descriptor, bytes.data() + at, bytes.size() - at);
    if (count < 0 && errno == EINTR)
      continue;
    if (count <= 0)
      return false;
    at += std::size_t(count);
  }
  return true;
}

KeyedHash signatureOf(const HashKey &secret, std::string bytes) {
  std::fill_n(bytes.begin() + offsetof(Header, signature), sizeof(KeyedHash), '\0');
  return keyedHash(secret, bytes);
}

/// Returns the value in a file's bytes if they are complete, signed, and stored under this key.
std::optional<std::string> valueIn(const std::string &bytes, std::string_view key,
                                   const HashKey &secret) {
  Header header;
  if (bytes.size() < sizeof header)
    return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  const std::string_view rest = std::string_view(bytes).substr(sizeof header);
  if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0 || header.keyBytes != key.size() ||
      header.keyBytes > rest.size() || header.valueBytes != rest.size() - header.keyBytes ||
      rest.substr(0, key.size()) != key || signatureOf(secret, bytes) != header.signature)
    return std::nullopt;
  return std::string(rest.substr(key.size()));
}

struct FileRow {
  std::string path;
  std::uint64_t bytes;
  std::time_t used;
};

/// Calls `use` with each file of a subfolder.
void eachFile(const std::string &shard,
              const std::function<void(const std::string &name, FileRow)> &use) {
  DIR *const stream = ::opendir(shard.c_str());
  if (stream == nullptr)
    return;
  while (const dirent *const entry = ::readdir(stream)) {
    struct stat status = {};
    if (::fstatat(::dirfd(stream), entry->d_name, &status, AT_SYMLINK_NOFOLLOW) == 0 &&
        S_ISREG(status.st_mode))
      use(entry->d_name,
          {shard + "/" + entry->d_name, std::uint64_t(status.st_size), status.st_mtime});
  }
  ::closedir(stream);
}

/// Evicts the least recently used files when a subfolder exceeds its share. It frees a quarter of
/// the share, so that not every new file has to evict.
void evict(const std::string &shard, std::uint64_t share) {
  std::vector<FileRow> rows;
  std::uint64_t total = 0;
  const std::time_t now = std::time(nullptr);
  eachFile(shard, [&](const std::string &name, FileRow row) {
    if (name.find(kTemporary) != std::string::npos) {
      if (now - row.used > kAbandonedSeconds)
        ::unlink(row.path.c_str());
      return;
    }
    total += row.bytes;
    rows.push_back(std::move(row));
  });
  if (total <= share)
    return;
  std::sort(rows.begin(), rows.end(),
            [](const FileRow &a, const FileRow &b) { return a.used < b.used; });
  for (const FileRow &row : rows) {
    if (total <= share / 4 * 3)
      return;
    ::unlink(row.path.c_str());
    total -= row.bytes;
  }
}

std::string entryBytes(std::string_view key, std::string_view value, const HashKey &secret) {
  Header header = {};
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  header.keyBytes = key.size();
  header.valueBytes = value.size();
  std::string bytes(reinterpret_cast<const char *>(&header), sizeof header);
  bytes.append(key).append(value);
  header.signature = signatureOf(secret, bytes);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

} // namespace

CacheStore::CacheStore(std::string folder, std::uint64_t maxBytes) noexcept
    : m_folder(std::move(folder)), m_shardBytes(maxBytes / kShards) {
  const NoCancel scope;
  try {
    if (m_folder.empty() || m_folder[0] != '/' || !makeFolders(m_folder))
      return;
    if (const std::optional<HashKey> secret = cacheKeyOf(m_folder)) {
      m_secret = *secret;
      m_usable = true;
    }
  } catch (...) { // out of memory: the store works without a folder
  }
}

std::optional<std::string> CacheStore::find(std::string_view key) const noexcept {
  if (!m_usable)
    return std::nullopt;
  const NoCancel scope;
  try {
    const std::string name = toHex(hashBytes(key));
    const std::string path = shardOf(m_folder, name) + "/" + name;
    const Descriptor file(
        ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    struct stat status = {};
    if (file.number < 0 || ::fstat(file.number, &status) != 0 || !S_ISREG(status.st_mode) ||
        status.st_uid != ::geteuid() || std::uint64_t(status.st_size) > m_shardBytes)
      return std::nullopt;
    std::string bytes(std::size_t(status.st_size), '\0');
    std::optional<std::string> value;
    if ((status.st_mode & 077) == 0 && readAll(file.number, bytes))
      value = valueIn(bytes, key, m_secret);
    if (!value)
      ::unlink(path.c_str());
    else if (std::time(nullptr) - status.st_mtime > kTouchSeconds)
      (void)::futimens(file.number, nullptr);
    return value;
  } catch (...) {
    return std::nullopt;
  }
}

bool CacheStore::store(std::string_view key, std::string_view value) const noexcept {
  if (!m_usable)
    return false;
  const NoCancel scope;
  try {
    const std::string bytes = entryBytes(key, value, m_secret);
    if (bytes.size() > m_shardBytes / 2)
      return false;
    const std::string name = toHex(hashBytes(key));
    const std::string shard = shardOf(m_folder, name);
    ::mkdir(shard.c_str(), 0700);
    static std::atomic<unsigned> s_count{0};
    const std::string path = shard + "/" + name;
    const std::string temporary =
        path + kTemporary + std::to_string(::getpid()) + "-" + std::to_string(s_count.fetch_add(1));
    bool written = false;
    {
      const Descriptor file(::open(temporary.c_str(),
                                   O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC | O_NOCTTY,
                                   0600));
      if (file.number < 0)
        return false;
      written = writeAll(file.number, bytes);
    }
    if (!written || ::rename(temporary.c_str(), path.c_str()) != 0) {
      ::unlink(temporary.c_str());
      return false;
    }
    evict(shard, m_shardBytes);
    return true;
  } catch (...) {
    return false;
  }
}

CacheUsage cacheUsage(const std::string &folder) {
  CacheUsage usage;
  for (unsigned shard = 0; shard < kShards; ++shard)
    eachFile(shardPath(folder, shard), [&](const std::string &, const FileRow &row) {
      ++usage.files;
      usage.bytes += row.bytes;
    });
  return usage;
}

CacheUsage clearCache(const std::string &folder) {
  for (unsigned shard = 0; shard < kShards; ++shard) {
    const std::string path = shardPath(folder, shard);
    eachFile(path, [&](const std::string &name, const FileRow &row) {
      const bool hash = name.find_first_not_of("0123456789abcdef") >= 32;
      if (hash && name.size() >= 32)
        ::unlink(row.path.c_str());
    });
    ::rmdir(path.c_str());
  }
  return cacheUsage(folder);
}

std::string cacheFolder() {
  if (const char *base = ::secure_getenv("XDG_CACHE_HOME"); base != nullptr && base[0] == '/')
    return std::string(base) + "/arbiter";
  if (const char *home = ::secure_getenv("HOME"); home != nullptr && home[0] == '/')
    return std::string(home) + "/.cache/arbiter";
  return {};
}

} // namespace arbiter
