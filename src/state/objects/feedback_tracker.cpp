#include "state/objects/feedback_tracker.h"

namespace arbiter::state {

const char *copyKindName(CopyKind kind) {
  switch (kind) {
  case CopyKind::Image1D:
    return "CopyTexImage1D";
  case CopyKind::Image2D:
    return "CopyTexImage2D";
  case CopyKind::SubImage1D:
    return "CopyTexSubImage1D";
  case CopyKind::SubImage2D:
    return "CopyTexSubImage2D";
  case CopyKind::SubImage3D:
    return "CopyTexSubImage3D";
  }
  return "";
}

std::size_t FeedbackTracker::Hash::operator()(const TextureLevel &level) const {
  std::uint64_t key = (std::uint64_t(level.texture) << 32) ^ (std::uint64_t(level.target) << 8) ^
                      std::uint32_t(level.level);
  key *= 0x9E3779B97F4A7C15u;
  return std::size_t(key ^ (key >> 32));
}

void FeedbackTracker::record(const TextureLevel &to, CopyKind kind, const ColorBuffer &from,
                             const CopyRegion &region, std::uint64_t frame) {
  ++m_sequence;
  Totals &totals = m_totals[std::size_t(kind)];
  ++totals.copies;
  if (region.width > 0 && region.height > 0)
    totals.pixels += std::uint64_t(region.width) * std::uint64_t(region.height);
  if (!m_levels)
    m_levels = std::make_unique<Map>();
  const auto it = m_levels->find(to);
  if (it != m_levels->end())
    it->second = {kind, from, region, frame, m_sequence};
  else if (m_levels->size() < kMaxLevels)
    m_levels->emplace(to, Copy{kind, from, region, frame, m_sequence});
}

const Copy *FeedbackTracker::lastCopy(const TextureLevel &level) const {
  if (!m_levels)
    return nullptr;
  const auto it = m_levels->find(level);
  return it == m_levels->end() ? nullptr : &it->second;
}

void FeedbackTracker::forget(std::uint32_t texture) {
  if (m_levels)
    std::erase_if(*m_levels, [&](const auto &entry) { return entry.first.texture == texture; });
}

} // namespace arbiter::state
