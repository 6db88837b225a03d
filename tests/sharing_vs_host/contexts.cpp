// Selects the context of each turn, its thread and its drawable; shows and resizes windows.
#include <algorithm>

#include "world.h"

namespace sharing {

void World::handOn(int context, int thread, int drawable, Ending ending, bool release) {
  Context &before = this->context();
  Context &next = m_contexts[std::size_t(context)];
  const bool sameGroup = before.group == next.group;
  GLsync fence = nullptr;
  here([&] {
    // A flush completes nothing for another thread, and a fence belongs to the group.
    if (ending == Ending::Fence && sameGroup) {
      fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
      glFlush();
    } else if (ending == Ending::Flush && thread == before.thread) {
      glFlush();
    } else {
      glFinish();
    }
    if (release)
      m_platform.makeCurrent(nullptr, nullptr);
  });
  if (release)
    before.thread = -1;
  m_current = context;
  // A drawable is current with one context at a time.
  const auto isTaken = [&](int which) {
    return std::any_of(m_contexts.begin(), m_contexts.begin() + m_count, [&](const Context &other) {
      return &other != &next && other.thread >= 0 && other.drawable == which &&
             other.thread != thread;
    });
  };
  if (isTaken(drawable))
    drawable = next.drawable;
  for (int other = 0; isTaken(drawable); ++other)
    drawable = other;
  if (next.thread >= 0 && next.thread != thread)
    m_workers.run(next.thread, [&] { m_platform.makeCurrent(nullptr, nullptr); });
  const bool stays = next.thread == thread && next.drawable == drawable;
  for (int i = 0; i < m_count; ++i)
    if (m_contexts[std::size_t(i)].thread == thread)
      m_contexts[std::size_t(i)].thread = -1;
  next.thread = thread;
  next.drawable = drawable;
  here([&] {
    if (!stays)
      makeCurrentHere(context);
    if (fence) {
      glClientWaitSync(fence, 0, 10'000'000'000u);
      glDeleteSync(fence);
    }
  });
}

void World::remake(int context) {
  Context &old = m_contexts[std::size_t(context)];
  void *share = nullptr;
  for (int i = 0; i < m_count; ++i)
    if (i != context && m_contexts[std::size_t(i)].group == old.group)
      share = m_contexts[std::size_t(i)].handle;
  if (!share)
    return; // the objects would be destroyed too
  const int thread = old.thread >= 0 ? old.thread : context % Workers::kThreads;
  if (old.thread >= 0)
    m_workers.run(thread, [&] {
      glFinish();
      m_platform.makeCurrent(nullptr, nullptr);
    });
  m_platform.destroyContext(old.handle);
  Context made;
  made.group = old.group;
  made.drawable = old.drawable;
  made.loads = old.loads;
  // The current context may be on the same thread; commands that finished before the creation are
  // visible.
  m_workers.run(this->context().thread, [&] { made.handle = m_platform.makeContext(share); });
  old = made;
  if (context != m_current)
    return;
  m_contexts[std::size_t(context)].thread = thread;
  here([&] { makeCurrentHere(context); });
}

namespace {

void handOnCommand(World &world, Random &random, const std::string &) {
  const int context = random.below(kContexts) % world.contexts();
  // A context that is current mostly stays so: it is not made current again before its next turn.
  const bool moves = random.once(8), changes = random.once(8);
  int thread = random.below(Workers::kThreads);
  const int drawable = random.below(kContexts) % world.contexts();
  const auto ending = World::Ending(random.below(3));
  // The first context mostly stays current while the others change, like an application's window
  // and its loaders. The rasterizer only draws for a context that is alone.
  const bool rarely = random.once(6), often = !random.once(6);
  const bool release = &world.context() == &world.context(0) ? rarely : often;
  const Context &next = world.context(context);
  if (context != 0 && thread == world.context(0).thread && often)
    thread = (thread + 1) % Workers::kThreads;
  world.handOn(context, moves || next.thread < 0 ? thread : next.thread,
               changes ? drawable : next.drawable, ending, release);
}

void remakeCommand(World &world, Random &random, const std::string &) {
  const int context = random.below(kContexts) % world.contexts();
  // A context that is current elsewhere may have commands in progress: only those of this turn are
  // known to be complete.
  world.remake(context);
}

void swapCommand(World &world, Random &, const std::string &what) {
  if (!world.platform().hasWindows())
    return;
  world.here([&] {
    world.platform().swap(world.drawable().handle);
    record(what + " shown", world.platform().grab(world.drawable().handle, world.drawable().size));
    const int before = world.context().bound;
    world.bindFramebuffer(-1);
    world.clearAll(); // the back buffer's content is undefined
    world.bindFramebuffer(before);
  });
}

void resizeCommand(World &world, Random &random, const std::string &) {
  static constexpr Size kSizes[] = {{64, 32}, {32, 64}, {128, 16}, {16, 16}, {64, 64}};
  const Size size = random.pick(kSizes);
  if (!world.platform().hasWindows())
    return;
  world.here([&] {
    glFinish();
    world.platform().resize(world.drawable().handle, size);
    world.drawable().size = size;
    const int before = world.context().bound;
    world.bindFramebuffer(-1);
    world.platform().swap(world.drawable().handle);
    glViewport(0, 0, size.width, size.height);
    world.clearAll();
    world.bindFramebuffer(before);
  });
}

} // namespace

const std::vector<Command> kContextCommands = {
    {"hand on", 34, handOnCommand, true},
    {"context made anew", 2, remakeCommand, true},
    {"swap", 5, swapCommand, true},
    {"resize", 3, resizeCommand, true},
};

} // namespace sharing
