#pragma once
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <GL/gl.h>

namespace arbiter::state {

class GenerationCounter;

/// Copies of small buffer objects, so that draws from unchanged buffers need no mapping. A buffer
/// that is drawn from once after each change is never copied.
class BufferCopies {
public:
  struct Contents {
    const std::uint8_t *data = nullptr;
    std::size_t bytes = 0;
  };
  /// Finds a valid copy; data is null if there is none. Copies are valid until any buffer changes.
  [[nodiscard]] Contents find(const GenerationCounter &clock, GLuint buffer);
  /// Notes that the buffer was mapped for a draw. It is copied if it was drawn from before and has
  /// not changed since.
  void drawnFrom(GLuint buffer, const Contents &contents);
  /// Stops copying in all contexts. Called when an application gives the host its own memory as a
  /// buffer (AMD_pinned_memory), because it may write there without a command.
  static void stop();

private:
  static constexpr std::size_t kMaxBytes = 64 << 10; ///< most bytes of one buffer
  static constexpr std::size_t kAllBytes = 1 << 20;
  static constexpr std::size_t kMaxBuffers = 256;
  /// An entry is empty until the buffer is drawn from a second time.
  std::unordered_map<GLuint, std::vector<std::uint8_t>> m_copies;
  std::size_t m_bytes = 0;
  std::uint64_t m_seen = 0;
};

} // namespace arbiter::state
