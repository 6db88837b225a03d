#include "state/share/share_group.h"

#include <utility>

namespace arbiter::state {

ShareGroup::ShareGroup() {
  for (std::size_t i = 0; i < m_defaults.size(); ++i)
    m_defaults[i] = std::make_shared<ProgramObject>(0, Target(i));
}

ShareGroup::~ShareGroup() = default;

std::shared_ptr<ProgramObject> ShareGroup::find(GLuint name) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_objects.find(name);
  return it == m_objects.end() ? nullptr : it->second;
}

std::shared_ptr<ProgramObject> ShareGroup::findOrCreate(GLuint name, Target target,
                                                        std::size_t localParameters,
                                                        Existence existence) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_objects.find(name);
  const bool known = it != m_objects.end();
  if (known && (it->second->target == target || it->second->exists)) {
    if (existence == Existence::Now)
      it->second->exists = true;
    return it->second;
  }
  auto made = std::make_shared<ProgramObject>(name, target); // complete before it can be found
  made->locals.resize(localParameters);
  made->exists = existence == Existence::Now;
  if (!known)
    return m_objects.emplace(name, std::move(made)).first->second;
  it->second->deleted.store(true, std::memory_order_release); // it lives on where it is bound
  return it->second = std::move(made);
}

std::shared_ptr<ProgramObject> ShareGroup::remove(GLuint name) {
  const std::lock_guard lock(m_mutex);
  return takeOut(m_objects, name);
}

bool ShareGroup::contains(GLuint name) {
  const std::lock_guard lock(m_mutex);
  const auto it = m_objects.find(name);
  return it != m_objects.end() && it->second->exists;
}

GLuint ShareGroup::takeName() {
  const std::lock_guard lock(m_mutex);
  do
    ++m_lastName;
  while (m_lastName == 0 || m_objects.count(m_lastName) != 0);
  return m_lastName;
}

void ShareGroup::setCompiled(ProgramObject &object,
                             std::shared_ptr<const CompiledProgram> compiled) {
  const std::lock_guard lock(m_mutex);
  object.compiled = std::move(compiled);
  object.changed();
}

std::shared_ptr<const CompiledProgram> ShareGroup::compiledOf(const ProgramObject &object) {
  const std::lock_guard lock(m_mutex);
  return object.compiled;
}

std::vector<std::shared_ptr<ProgramObject>> ShareGroup::objects() {
  std::vector<std::shared_ptr<ProgramObject>> all = fragmentShaders.objects();
  const std::lock_guard lock(m_mutex);
  all.insert(all.end(), m_defaults.begin(), m_defaults.end());
  for (const auto &[name, object] : m_objects)
    all.push_back(object);
  return all;
}

void ShareGroup::setDefaultLocals(Target target, std::size_t count) {
  const std::lock_guard lock(m_mutex);
  std::vector<LocalParameter> &locals = defaultProgram(target)->locals;
  if (locals.size() < count)
    locals.resize(count);
}

void ShareGroup::addGarbage(const Garbage &garbage) {
  const auto append = [](std::vector<GLuint> &to, const std::vector<GLuint> &from) {
    to.insert(to.end(), from.begin(), from.end());
    return !to.empty();
  };
  const std::lock_guard lock(m_mutex);
  const bool programs = append(m_garbage.programs, garbage.programs);
  const bool shaders = append(m_garbage.shaders, garbage.shaders);
  const bool samplers = append(m_garbage.samplers, garbage.samplers);
  const bool assembly = append(m_garbage.assembly, garbage.assembly);
  m_hasGarbage.store(programs || shaders || samplers || assembly, std::memory_order_release);
}

ShareGroup::Garbage ShareGroup::takeGarbage() {
  const std::lock_guard lock(m_mutex);
  m_hasGarbage.store(false, std::memory_order_release);
  return std::exchange(m_garbage, {});
}

void ShareGroup::addHostProgram(GLuint name) {
  const std::lock_guard lock(m_mutex);
  m_hostPrograms.insert(name);
  m_hostProgramCount.store(int(m_hostPrograms.size()), std::memory_order_release);
}

void ShareGroup::removeHostProgram(GLuint name) {
  const std::lock_guard lock(m_mutex);
  m_hostPrograms.erase(name);
  m_hostProgramCount.store(int(m_hostPrograms.size()), std::memory_order_release);
}

bool ShareGroup::ownsHostProgram(GLuint name) {
  if (m_hostProgramCount.load(std::memory_order_acquire) == 0)
    return false;
  const std::lock_guard lock(m_mutex);
  return m_hostPrograms.count(name) != 0;
}

} // namespace arbiter::state
