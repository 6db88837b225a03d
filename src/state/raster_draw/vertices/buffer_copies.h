#pragma once
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <GL/gl.h>

namespace arbiter::state::software {

class GenerationCounter;

/// What small buffer objects hold, kept on our side so that a draw from one that has not changed
/// needs no mapping. A buffer that is drawn from once after each change is never copied.
class BufferCopies {
public:
  struct Contents {
    const std::uint8_t *data = nullptr;
    std::size_t bytes = 0;
  };
  /// Null data: there is no copy that still holds. Copies stay until a change of any buffer.
  [[nodiscard]] Contents find(const GenerationCounter &clock, GLuint buffer);
  /// The buffer is mapped for a draw. It is copied if it was drawn from before, unchanged since.
  void drawnFrom(GLuint buffer, const Contents &contents);
  /// An application of this process gives the host memory of its own as a buffer
  /// (AMD_pinned_memory), and writes to it without a command: from now on nothing is copied, in any
  /// context.
  static void stop();

private:
  static constexpr std::size_t kMostBytes = 64 << 10; ///< of one
  static constexpr std::size_t kAllBytes = 1 << 20;
  static constexpr std::size_t kMostBuffers = 256;
  /// Empty until the buffer is drawn from a second time.
  std::unordered_map<GLuint, std::vector<std::uint8_t>> m_copies;
  std::size_t m_bytes = 0;
  std::uint64_t m_seen = 0;
};

} // namespace arbiter::state::software
