#include "state/report/capture_record.h"

#include <GL/arbiter.h>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <unistd.h>

#include "fp_compiler/compiler.h"
#include "state/identity/active_profile.h"
#include "util/exit_lock.h"
#include "util/file.h"
#include "util/flags.h"
#include "util/json.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Limits on what is kept, as an application may keep on making programs.
constexpr std::size_t kMaxRows = 4096;
constexpr std::uint64_t kMaxTextBytesInAll = 256u << 20;
constexpr std::int64_t kSecond = 1'000'000'000;

std::int64_t now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t(time.tv_sec) * kSecond + time.tv_nsec;
}

} // namespace

CaptureRecord *CaptureRecord::instance() {
  static CaptureRecord *const s_record = settings().capturePath.empty()
                                             ? nullptr
                                             : new CaptureRecord(expandPid(settings().capturePath));
  return s_record;
}

CaptureRecord::CaptureRecord(std::string folder) : m_folder(std::move(folder)) { afterFork(); }

/// Begins a new record in a forked child: what the parent loaded and drew belongs to the parent.
void CaptureRecord::afterFork() {
  const pid_t process = getpid();
  if (process == m_process)
    return;
  m_process = process;
  m_order.clear();
  m_rows.clear();
  m_notListed = m_notWritten = m_contexts = m_frames = 0;
  m_nextWrite = 0;
  // The start time tells the process from an earlier one with its number, and from a program that
  // it becomes by exec.
  char name[64];
  std::snprintf(name, sizeof name, "/process-%d-%llx.json", int(process),
                static_cast<unsigned long long>(now(CLOCK_REALTIME)));
  m_path = m_folder + name;
}

CaptureRow *CaptureRecord::rowOf(Target target, const Hash128 &hash) {
  const std::string name = textFileName(target, hash);
  const auto it = m_rows.find(name);
  if (it != m_rows.end())
    return it->second.get();
  if (m_order.size() >= kMaxRows) {
    if (m_notListed++ == 0)
      logWarn("state", "%zu programs are captured; no others are", kMaxRows);
    return nullptr;
  }
  auto made = std::make_unique<CaptureRow>();
  made->target = target;
  made->hash = toHex(hash);
  m_order.reserve(std::bit_ceil(m_order.size() + 1)); // allocate before anything changes
  CaptureRow *const row = m_rows.emplace(name, std::move(made)).first->second.get();
  m_order.push_back(row);
  return row;
}

void CaptureRecord::writeFile(const std::string &name, std::string_view text, bool keep) {
  const std::string path = m_folder + "/" + name;
  m_bytes += text.size();
  const bool fits = m_bytes <= kMaxTextBytesInAll;
  if (fits && (keep ? createPrivateFile(path, text) : replacePrivateFile(path, text)))
    return;
  if (m_notWritten++ == 0)
    m_whyNotWritten = fits ? std::strerror(errno) : "more than 256 MiB of texts";
  if (!m_complained)
    logWarn("state", "cannot capture %s: %s", path.c_str(), m_whyNotWritten.c_str());
  m_complained = true;
}

/// Writes the GLSL file. An ATI shader has no GLSL before its first draw.
void CaptureRecord::writeGlsl(CaptureRow &row, const CompiledProgram &program) {
  if (row.hasGlsl || program.glsl.text.empty())
    return;
  row.hasGlsl = true;
  writeFile(textFileName(row.target, program.hash) + ".glsl", program.glsl.text, false);
}

void CaptureRecord::contextMade() {
  const std::lock_guard lock(m_mutex);
  afterFork();
  ++m_contexts;
  m_dirty = true;
}

void CaptureRecord::loaded(std::uint32_t context, Target target, std::string_view text,
                           const fp::CheckResult &result, const std::string &message,
                           const CompiledProgram *compiled) {
  const std::lock_guard lock(m_mutex);
  afterFork();
  const Hash128 hash = hashBytes(text);
  CaptureRow *const row = rowOf(target, hash);
  if (!row)
    return;
  if (row->loads++ == 0)
    writeFile(textFileName(target, hash), text, true);
  if (compiled)
    writeGlsl(*row, *compiled);
  row->contexts.insert(context);
  row->counted = result.ok();
  if (result.ok())
    row->options = optionNames(result.program->options,
                               result.program->language == fp::ir::Language::ArbVertex);
  row->counts = result.counts;
  row->nativeCounts = result.nativeCounts;
  row->underNativeLimits = result.underNativeLimits;
  row->replaced = compiled && compiled->replaced();
  row->errorPosition = result.errorPosition();
  (result.ok() ? row->warning : row->error) = message;
  m_dirty = true;
  writeNowAndThen();
}

void CaptureRecord::used(const ProgramUse &use) {
  const std::lock_guard lock(m_mutex);
  afterFork();
  // A shader that was made by commands and cannot be written as text has no row.
  const auto it = m_rows.find(textFileName(use.target, use.program->hash));
  if (it == m_rows.end())
    return;
  CaptureRow *const row = it->second.get();
  writeGlsl(*row, *use.program);
  for (const DrawsBy &draws : use.draws)
    row->add(draws);
  row->replaced |= use.program->replaced();
  const std::pair frame(use.context, use.frame);
  row->frames += frame == row->lastFrame ? 0 : 1;
  row->lastFrame = frame;
  row->lastUse = now(CLOCK_REALTIME);
  if (use.values) {
    row->program = use.program; // it names the values
    row->values = *use.values;
  }
  if (use.textures)
    row->textures = *use.textures;
  m_dirty = true;
}

void CaptureRecord::frameEnded() {
  const std::lock_guard lock(m_mutex);
  afterFork();
  ++m_frames;
  writeNowAndThen();
}

void CaptureRecord::writeNowAndThen() {
  if (m_dirty && now(CLOCK_MONOTONIC_COARSE) >= m_nextWrite)
    write(false);
}

void CaptureRecord::finish() {
  const std::unique_lock lock = lockAtExit(m_mutex);
  if (!lock)
    return;
  afterFork();
  if (m_contexts != 0 || !m_order.empty())
    write(true);
}

void CaptureRecord::write(bool complete) {
  const std::int64_t began = now(CLOCK_MONOTONIC);
  if (!replacePrivateFile(m_path, json(complete)) && !m_complained) {
    m_complained = true;
    logWarn("state", "cannot write %s: %s", m_path.c_str(), std::strerror(errno));
  }
  m_dirty = false;
  // Limits writing to a twentieth of the application's time, for slow disks and long records.
  const std::int64_t took = now(CLOCK_MONOTONIC) - began;
  m_nextWrite = now(CLOCK_MONOTONIC_COARSE) + std::max(kSecond, 20 * took);
}

std::string CaptureRecord::json(bool complete) const {
  JsonWriter json;
  json.beginObject();
  json.key("schema").value(ARBITER_CAPTURE_SCHEMA);
  json.key("pid").value(std::int64_t(m_process));
  json.key("command").value(program_invocation_short_name);
  json.key("profile").value(settings().profile);
  json.key("numerics").value(nameOf(activeNumerics()));
  json.key("complete").value(complete);
  json.key("contexts_made").value(m_contexts).key("frames").value(m_frames);
  json.key("programs_not_listed").value(m_notListed);
  json.key("files_not_written").value(m_notWritten);
  if (m_notWritten != 0)
    json.key("why_not_written").value(m_whyNotWritten);
  json.key("programs").beginArray();
  for (const CaptureRow *row : m_order)
    row->write(json);
  json.endArray().endObject();
  return json.take();
}

} // namespace arbiter::state
