#include "state/era/fences.h"

#include "host/host_table.h"
#include "state/core/context_hooks.h"
#include "state/core/core_context.h"

namespace arbiter::state {

namespace {
/// The longest single wait; it is repeated. A host may refuse a longer one.
constexpr GLuint64 kLongest = 1'000'000'000;
} // namespace

GLuint Fences::generate() {
  do
    ++m_last;
  while (m_last == 0 || m_fences.count(m_last) != 0);
  m_fences[m_last] = {};
  return m_last;
}

void Fences::drop(CoreContext &context, Fence &fence) {
  if (fence.sync)
    context.host->DeleteSync(fence.sync);
  fence.sync = nullptr;
}

void Fences::remove(CoreContext &context, GLuint name) {
  const auto found = m_fences.find(name);
  if (found == m_fences.end())
    return;
  drop(context, found->second);
  m_fences.erase(found);
}

void Fences::set(CoreContext &context, GLuint name) {
  Fence &fence = m_fences[name];
  drop(context, fence);
  context.hooks->synchronise(context, "glSetFence");
  if (context.caps.syncObjects)
    fence.sync = context.host->FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  fence.status = Status::Waits;
}

bool Fences::isFence(GLuint name) const {
  const auto found = m_fences.find(name);
  return found != m_fences.end() && found->second.status != Status::Unset;
}

bool Fences::wait(CoreContext &context, Fence &fence, GLuint64 nanoseconds) {
  if (!fence.sync)
    context.host->Finish();
  else if (context.host->ClientWaitSync(fence.sync, GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds) ==
           GL_TIMEOUT_EXPIRED)
    return false;
  drop(context, fence);
  fence.status = Status::Done;
  return true;
}

bool Fences::test(CoreContext &context, GLuint name) {
  const auto found = m_fences.find(name);
  return found == m_fences.end() || found->second.status != Status::Waits ||
         wait(context, found->second, 0);
}

void Fences::finish(CoreContext &context, GLuint name) {
  const auto found = m_fences.find(name);
  if (found == m_fences.end() || found->second.status != Status::Waits)
    return;
  while (!wait(context, found->second, kLongest)) {
  }
}

} // namespace arbiter::state
