#include "state/capture_record.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <unistd.h>

#include "fp_compiler/ir/print.h"
#include "util/file.h"
#include "util/flags.h"
#include "util/json.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

constexpr int kSchema = 1; ///< ARBITER_CAPTURE_SCHEMA
/// An application may make programs for ever: what is kept of them is bounded.
constexpr std::size_t kMaxRows = 4096;
constexpr std::uint64_t kMaxTextBytesInAll = 256u << 20;
constexpr std::int64_t kSecond = 1'000'000'000;

std::int64_t now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t(time.tv_sec) * kSecond + time.tv_nsec;
}

/// The options of a program as it would spell them.
std::vector<const char *> optionNames(const fp::ir::Options &options) {
  std::vector<const char *> names;
  constexpr const char *kFog[] = {nullptr, "ARB_fog_exp", "ARB_fog_exp2", "ARB_fog_linear"};
  constexpr const char *kPrecision[] = {nullptr, "ARB_precision_hint_fastest",
                                        "ARB_precision_hint_nicest"};
  for (const char *name :
       {kFog[std::size_t(options.fog)], kPrecision[std::size_t(options.precision)],
        options.shadow ? "ARB_fragment_program_shadow" : nullptr,
        options.drawBuffers ? "ARB_draw_buffers" : nullptr,
        options.originUpperLeft ? "ARB_fragment_coord_origin_upper_left" : nullptr,
        options.pixelCenterInteger ? "ARB_fragment_coord_pixel_center_integer" : nullptr,
        options.positionInvariant ? "ARB_position_invariant" : nullptr})
    if (name)
      names.push_back(name);
  return names;
}

void writeCounts(JsonWriter &json, const char *key, const fp::ResourceCounts &counts) {
  json.key(key).beginObject();
  json.key("instructions").value(counts.instructions);
  json.key("alu_instructions").value(counts.aluInstructions);
  json.key("tex_instructions").value(counts.texInstructions);
  json.key("tex_indirections").value(counts.texIndirections);
  json.key("temporaries").value(counts.temporaries);
  json.key("parameters").value(counts.parameters);
  json.key("attribs").value(counts.attribs);
  json.key("address_registers").value(counts.addressRegisters);
  json.endObject();
}

/// "RGBA8" for the formats of the time, else the number.
std::string formatName(GLint format) {
  struct Name {
    GLenum format;
    const char *name;
  };
  static constexpr Name kNames[] = {
      {1, "1"},
      {2, "2"},
      {3, "3"},
      {4, "4"},
      {GL_ALPHA, "ALPHA"},
      {GL_RGB, "RGB"},
      {GL_RGBA, "RGBA"},
      {GL_LUMINANCE, "LUMINANCE"},
      {GL_LUMINANCE_ALPHA, "LUMINANCE_ALPHA"},
      {GL_ALPHA8, "ALPHA8"},
      {GL_LUMINANCE8, "LUMINANCE8"},
      {GL_LUMINANCE16, "LUMINANCE16"},
      {GL_LUMINANCE8_ALPHA8, "LUMINANCE8_ALPHA8"},
      {GL_INTENSITY, "INTENSITY"},
      {GL_INTENSITY8, "INTENSITY8"},
      {GL_RGB5, "RGB5"},
      {GL_RGB8, "RGB8"},
      {GL_RGB16, "RGB16"},
      {GL_RGBA4, "RGBA4"},
      {GL_RGB5_A1, "RGB5_A1"},
      {GL_RGBA8, "RGBA8"},
      {GL_RGB10_A2, "RGB10_A2"},
      {GL_RGBA16, "RGBA16"},
      {GL_RGBA16F, "RGBA16F"},
      {GL_RGBA32F, "RGBA32F"},
      {GL_R8, "R8"},
      {GL_RG8, "RG8"},
      {GL_R16, "R16"},
      {GL_R32F, "R32F"},
      {GL_SRGB8, "SRGB8"},
      {GL_SRGB8_ALPHA8, "SRGB8_ALPHA8"},
      {GL_DEPTH_COMPONENT, "DEPTH_COMPONENT"},
      {GL_DEPTH_COMPONENT16, "DEPTH_COMPONENT16"},
      {GL_DEPTH_COMPONENT24, "DEPTH_COMPONENT24"},
      {GL_DEPTH24_STENCIL8, "DEPTH24_STENCIL8"},
      {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, "COMPRESSED_RGB_S3TC_DXT1"},
      {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, "COMPRESSED_RGBA_S3TC_DXT1"},
      {GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, "COMPRESSED_RGBA_S3TC_DXT3"},
      {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, "COMPRESSED_RGBA_S3TC_DXT5"},
  };
  for (const Name &row : kNames)
    if (GLint(row.format) == format)
      return row.name;
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", unsigned(format));
  return text;
}

void writeTexture(JsonWriter &json, const TextureUse &use) {
  json.beginObject();
  json.key("unit").value(unsigned(use.unit)).key("target").value(fp::ir::targetText(use.target));
  json.key("name").value(use.name);
  json.key("width").value(use.width).key("height").value(use.height).key("depth").value(use.depth);
  json.key("format").value(formatName(use.format)).key("enabled").beginArray();
  for (std::size_t i = 0; i < std::size(kFixedTargets); ++i)
    if (use.enabled >> i & 1)
      json.value(kFixedTargets[i].name);
  json.endArray().endObject();
}

} // namespace

struct CaptureRecord::Row {
  Target target = Target::Fragment;
  std::string hash;
  std::uint64_t loads = 0, frames = 0, draws = 0;
  std::set<std::uint32_t> contexts;
  std::vector<const char *> options;
  bool counted = false;
  fp::ResourceCounts counts, nativeCounts;
  bool underNativeLimits = false;
  bool replaced = false;
  bool hasGlsl = false; ///< its file is written
  std::int32_t errorPosition = -1;
  std::string error, warning;
  // Of the last use.
  std::pair<std::uint32_t, std::uint64_t> lastFrame{0, ~std::uint64_t{0}}; ///< context and frame
  std::int64_t lastUse = -1;                                               ///< ns since the epoch
  const char *path = "";
  std::shared_ptr<const CompiledProgram> program;
  std::vector<Vec4> values; ///< of program->glsl.uniforms
  std::vector<TextureUse> textures;

  void write(JsonWriter &json) const;
};

void CaptureRecord::Row::write(JsonWriter &json) const {
  json.beginObject();
  json.key("hash").value(hash).key("target").value(infoOf(target).word);
  json.key("loads").value(loads).key("frames").value(frames).key("draws").value(draws);
  json.key("replaced").value(replaced);
  json.key("contexts").beginArray();
  for (const std::uint32_t context : contexts)
    json.value(context);
  json.endArray().key("options").beginArray();
  for (const char *option : options)
    json.value(option);
  json.endArray();
  if (counted) {
    writeCounts(json, "counts", counts);
    writeCounts(json, "native_counts", nativeCounts);
    json.key("under_native_limits").value(underNativeLimits);
  }
  json.key("error");
  if (error.empty())
    json.null();
  else
    json.beginObject().key("position").value(errorPosition).key("text").value(error).endObject();
  if (!warning.empty())
    json.key("warning").value(warning);
  json.key("last_use").value(lastUse).key("path").value(path);
  json.key("parameters").beginArray();
  for (std::size_t i = 0; program && i < values.size(); ++i) {
    json.beginObject();
    json.key("name").value(fp::ir::bindingText(program->glsl.uniforms[i].parameter));
    json.key("value").beginArray();
    for (const GLfloat component : values[i])
      json.value(double(component));
    json.endArray().endObject();
  }
  json.endArray().key("textures").beginArray();
  for (const TextureUse &use : textures)
    writeTexture(json, use);
  json.endArray().endObject();
}

CaptureRecord *CaptureRecord::instance() {
  static CaptureRecord *const s_record = settings().capturePath.empty()
                                             ? nullptr
                                             : new CaptureRecord(expandPid(settings().capturePath));
  return s_record;
}

CaptureRecord::CaptureRecord(std::string folder) : m_folder(std::move(folder)) { afterFork(); }

/// A child that was forked from a process with a record begins its own: what its parent loaded and
/// drew is the parent's.
void CaptureRecord::afterFork() {
  const pid_t process = getpid();
  if (process == m_process)
    return;
  m_process = process;
  m_order.clear();
  m_rows.clear();
  m_notListed = m_contexts = m_frames = 0;
  m_nextWrite = 0;
  // The time of the beginning tells a process from an earlier one of its number, and from another
  // program that it went on as.
  char name[64];
  std::snprintf(name, sizeof name, "/process-%d-%llx.json", int(process),
                static_cast<unsigned long long>(now(CLOCK_REALTIME)));
  m_path = m_folder + name;
}

CaptureRecord::Row *CaptureRecord::rowOf(Target target, const Hash128 &hash) {
  const std::string name = textFileName(target, hash);
  const auto it = m_rows.find(name);
  if (it != m_rows.end())
    return it->second.get();
  if (m_order.size() >= kMaxRows) {
    ++m_notListed;
    return nullptr;
  }
  std::unique_ptr<Row> &slot = m_rows[name];
  slot = std::make_unique<Row>();
  slot->target = target;
  slot->hash = toHex(hash);
  m_order.push_back(slot.get());
  return slot.get();
}

void CaptureRecord::writeFile(const std::string &name, std::string_view text, bool keep) {
  const std::string path = m_folder + "/" + name;
  m_bytes += text.size();
  errno = EFBIG;
  if (m_bytes <= kMaxTextBytesInAll &&
      (keep ? createPrivateFile(path, text) : replacePrivateFile(path, text)))
    return;
  if (!m_complained)
    logWarn("state", "cannot capture %s: %s", path.c_str(), std::strerror(errno));
  m_complained = true;
}

/// An ATI shader has GLSL only when it is drawn with.
void CaptureRecord::writeGlsl(Row &row, const CompiledProgram &program) {
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
  Row *const row = rowOf(target, hash);
  if (!row)
    return;
  if (row->loads++ == 0)
    writeFile(textFileName(target, hash), text, true);
  if (compiled)
    writeGlsl(*row, *compiled);
  row->contexts.insert(context);
  row->counted = result.ok();
  if (result.ok())
    row->options = optionNames(result.program->options);
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
  // A shader that was made by calls has no text, and no row.
  const auto it = m_rows.find(textFileName(use.target, use.program->hash));
  if (it == m_rows.end())
    return;
  Row *const row = it->second.get();
  writeGlsl(*row, *use.program);
  row->draws += use.draws;
  row->replaced |= use.program->replaced();
  const std::pair frame(use.context, use.frame);
  row->frames += frame == row->lastFrame ? 0 : 1;
  row->lastFrame = frame;
  row->lastUse = now(CLOCK_REALTIME);
  row->path = use.path;
  if (use.values) {
    row->program = use.program; // names the values
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
  const std::lock_guard lock(m_mutex);
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
  // A slow disk or a long record must not take more than a twentieth of the application's time.
  const std::int64_t took = now(CLOCK_MONOTONIC) - began;
  m_nextWrite = now(CLOCK_MONOTONIC_COARSE) + std::max(kSecond, 20 * took);
}

std::string CaptureRecord::json(bool complete) const {
  JsonWriter json;
  json.beginObject();
  json.key("schema").value(kSchema);
  json.key("process").value(std::int64_t(m_process));
  json.key("command").value(program_invocation_short_name);
  json.key("profile").value(settings().profile);
  json.key("complete").value(complete);
  json.key("contexts").value(m_contexts).key("frames").value(m_frames);
  json.key("not_listed").value(m_notListed);
  json.key("programs").beginArray();
  for (const Row *row : m_order)
    row->write(json);
  json.endArray().endObject();
  return json.take();
}

} // namespace arbiter::state
