#include "state/testing/fake_host.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace arbiter::state::testing {

FakeHost *FakeHost::s_active = nullptr;

namespace {

FakeHost &fake() { return *FakeHost::s_active; }

std::string words(const char *name, std::initializer_list<long long> values) {
  std::string text = name;
  for (const long long value : values)
    text += " " + std::to_string(value);
  return text;
}

const GLubyte *getString(GLenum name) {
  static std::string s_joined;
  switch (name) {
  case GL_VENDOR:
    return reinterpret_cast<const GLubyte *>("Fake Inc.");
  case GL_RENDERER:
    return reinterpret_cast<const GLubyte *>("Fake renderer");
  case GL_VERSION:
    return reinterpret_cast<const GLubyte *>(fake().version.c_str());
  case GL_SHADING_LANGUAGE_VERSION:
    return reinterpret_cast<const GLubyte *>(fake().shadingLanguage.c_str());
  case GL_EXTENSIONS:
    s_joined.clear();
    for (const std::string &extension : fake().extensions)
      s_joined += extension + " ";
    return reinterpret_cast<const GLubyte *>(s_joined.c_str());
  default:
    return nullptr;
  }
}

const GLubyte *getStringi(GLenum, GLuint index) {
  return index < fake().extensions.size()
             ? reinterpret_cast<const GLubyte *>(fake().extensions[index].c_str())
             : nullptr;
}

void getIntegerv(GLenum pname, GLint *value) {
  ++fake().queries;
  FakeHost &f = fake();
  if (f.lost)
    return;
  const auto it = f.integers.find(pname);
  if (pname == GL_CURRENT_PROGRAM)
    *value = GLint(f.currentProgram);
  else if (pname == GL_NUM_EXTENSIONS)
    *value = GLint(f.extensions.size());
  else if (pname == GL_LIST_INDEX)
    *value = GLint(f.compiling);
  else if (pname == GL_ATTRIB_STACK_DEPTH)
    *value = f.attribDepth;
  else if (it != f.integers.end())
    *value = it->second;
  else
    *value = 16; // for limits
}

void getFloatv(GLenum pname, GLfloat *value) {
  if (const auto it = fake().floats.find(pname); it != fake().floats.end())
    std::copy(it->second.begin(), it->second.end(), value);
}
void matrixMode(GLenum mode) { fake().note(words("MatrixMode", {mode})); }

/// Notes "NAME index x y ..", in thousandths.
template <std::size_t kCount> void noteValues(const char *name, GLuint index, const GLfloat *v) {
  std::string call = std::string(name) + " " + std::to_string(index);
  for (std::size_t i = 0; i < kCount; ++i)
    call += " " + std::to_string(int(v[i] * 1000.0f));
  fake().note(call);
}
void vertex4fv(const GLfloat *v) { noteValues<4>("Vertex4fv", 0, v); }
void normal3fv(const GLfloat *v) { noteValues<3>("Normal3fv", 0, v); }
void color4fv(const GLfloat *v) { noteValues<4>("Color4fv", 0, v); }
void secondaryColor3fv(const GLfloat *v) { noteValues<3>("SecondaryColor3fv", 0, v); }
void fogCoordfv(const GLfloat *v) { noteValues<1>("FogCoordfv", 0, v); }
void multiTexCoord4fv(GLenum unit, const GLfloat *v) {
  noteValues<4>("MultiTexCoord4fv", unit - GL_TEXTURE0, v);
}
void vertexAttrib4fv(GLuint index, const GLfloat *v) { noteValues<4>("VertexAttrib4fv", index, v); }

void enableVertexAttribArray(GLuint index) { fake().attribArrays.insert(index); }
void disableVertexAttribArray(GLuint index) { fake().attribArrays.erase(index); }
void vertexAttribPointer(GLuint index, GLint size, GLenum type, GLboolean normalized,
                         GLsizei stride, const void *) {
  fake().note(words("VertexAttribPointer", {index, size, type, normalized, stride}));
}
void getVertexAttribiv(GLuint index, GLenum pname, GLint *value) {
  *value = pname == GL_VERTEX_ATTRIB_ARRAY_ENABLED ? GLint(fake().attribArrays.count(index)) : 3;
}
void enableClientState(GLenum array) { fake().note(words("EnableClientState", {array})); }

void getProgramLimit(GLenum, GLenum pname, GLint *value) {
  const auto it = fake().programLimits.find(pname);
  *value = it != fake().programLimits.end() ? it->second : fake().programLimit;
}

GLenum getError() {
  if (fake().lost)
    return GL_CONTEXT_LOST;
  const GLenum error = fake().error;
  fake().error = GL_NO_ERROR;
  return error;
}

GLuint createShader(GLenum type) {
  if (fake().createFails || fake().lost)
    return 0;
  fake().note(words("CreateShader", {type}));
  fake().shaders.insert(++fake().lastName);
  return fake().lastName;
}
GLuint createProgram() {
  if (fake().createFails || fake().lost)
    return 0;
  fake().programs.insert(++fake().lastName);
  return fake().lastName;
}
void deleteShader(GLuint name) { fake().shaders.erase(name); }
void deleteProgram(GLuint name) {
  fake().note(words("DeleteProgram", {name}));
  fake().programs.erase(name);
}
void getShaderiv(GLuint name, GLenum pname, GLint *value) {
  if (fake().lost)
    return;
  if (pname == GL_SHADER_TYPE)
    *value = GLint(name); // the name is the type, as in getAttachedShaders()
  else
    *value = pname == GL_COMPILE_STATUS ? !fake().compileFails : 5;
}
void getProgramiv(GLuint, GLenum pname, GLint *value) {
  if (!fake().lost)
    *value = pname == GL_LINK_STATUS ? !fake().linkFails : 5;
}
void getLog(GLuint, GLsizei length, GLsizei *written, GLchar *text) {
  *written = std::min<GLsizei>(length, 4);
  std::memcpy(text, "no.\n", std::size_t(*written));
}
void linkProgram(GLuint name) { fake().note(words("LinkProgram", {name})); }

void useProgram(GLuint name) {
  fake().note(words("UseProgram", {name}));
  if (name != 0 && fake().programs.count(name) == 0)
    return fake().raise(GL_INVALID_VALUE);
  if (fake().compiling == 0)
    fake().currentProgram = name;
}

void programParameteri(GLuint name, GLenum pname, GLint value) {
  fake().note(words("ProgramParameteri", {name, pname, value}));
}

void genPipelines(GLsizei n, GLuint *names) {
  for (GLsizei i = 0; i < n; ++i)
    names[i] = fake().createFails ? 0 : ++fake().lastName;
}
void bindPipeline(GLuint name) {
  fake().note(words("BindProgramPipeline", {name}));
  fake().integers[GL_PROGRAM_PIPELINE_BINDING] = GLint(name);
}
void useStages(GLuint pipeline, GLbitfield stages, GLuint program) {
  fake().note(words("UseProgramStages", {pipeline, stages, program}));
}
void deletePipelines(GLsizei count, const GLuint *names) {
  for (GLsizei i = 0; i < count; ++i)
    fake().note(words("DeleteProgramPipeline", {names[i]}));
}

/// Returns 10 + i for arb_param[i], 500 + i for arb_vparam[i] and 0 for samplers.
GLint getUniformLocation(GLuint, const GLchar *name) {
  if (std::strncmp(name, "arb_vparam[", 11) == 0)
    return 500 + std::atoi(name + 11);
  return std::strncmp(name, "arb_param[", 10) == 0 ? 10 + std::atoi(name + 10) : 0;
}
void bindAttribLocation(GLuint, GLuint index, const GLchar *name) {
  fake().note("BindAttribLocation " + std::to_string(index) + " " + name);
}
void uniform4fv(GLint location, GLsizei count, const GLfloat *values) {
  fake().note(words("Uniform4fv", {location, count}));
  for (GLsizei i = 0; i < count; ++i)
    fake().uniforms[location + i].assign(values + std::ptrdiff_t(4) * i,
                                         values + std::ptrdiff_t(4) * i + 4);
}
void programUniform4fv(GLuint program, GLint location, GLsizei count, const GLfloat *) {
  fake().note(words("ProgramUniform4fv", {program, location, count}));
}
void uniform1i(GLint location, GLint value) { fake().note(words("Uniform1i", {location, value})); }

void newList(GLuint name, GLenum mode) {
  fake().calls.push_back(words("NewList", {name, mode}));
  fake().compiling = name;
}
void endList() {
  fake().calls.emplace_back("EndList");
  fake().lists.insert(fake().compiling);
  fake().compiling = 0;
}
void callList(GLuint name) { fake().note(words("CallList", {name})); }
GLboolean isList(GLuint name) { return fake().lists.count(name) != 0; }
void deleteLists(GLuint first, GLsizei count) {
  fake().calls.push_back(words("DeleteLists", {first, count}));
  for (GLsizei i = 0; i < count; ++i)
    fake().lists.erase(first + GLuint(i));
}

void genPrograms(GLsizei n, GLuint *names) {
  for (GLsizei i = 0; i < n; ++i)
    names[i] = ++fake().lastName;
}
void programString(GLenum target, GLenum, GLsizei length, const void *text) {
  fake().note(words("ProgramString", {target, length}));
  if (fake().refusesAssembly)
    return fake().raise(GL_INVALID_OPERATION);
  fake().assembly[fake().bound[target]] =
      std::string(static_cast<const char *>(text), std::size_t(length));
}
void bindProgram(GLenum target, GLuint name) {
  fake().note(words("BindProgram", {target, name}));
  fake().bound[target] = name;
}
void deletePrograms(GLsizei count, const GLuint *names) {
  for (GLsizei i = 0; i < count; ++i)
    fake().assembly.erase(names[i]);
}
/// Notes "NAME target first-index x...", with the x of each parameter.
void parameters(const char *name, GLenum target, GLuint index, GLsizei count,
                const GLfloat *values) {
  std::string call = std::string(name) + " " + std::to_string(target) + " " + std::to_string(index);
  for (GLsizei i = 0; i < count; ++i)
    call += " " + std::to_string(int(values[4 * i]));
  fake().note(call);
}
void envParameters(GLenum target, GLuint index, GLsizei count, const GLfloat *values) {
  parameters("ProgramEnvParameters4fv", target, index, count, values);
}
void localParameters(GLenum target, GLuint index, GLsizei count, const GLfloat *values) {
  parameters("ProgramLocalParameters4fv", target, index, count, values);
}
void envParameter(GLenum target, GLuint index, const GLfloat *value) {
  fake().note(words("ProgramEnvParameter4fv", {target, index, static_cast<long long>(value[0])}));
}
void localParameter(GLenum target, GLuint index, const GLfloat *value) {
  fake().note(words("ProgramLocalParameter4fv", {target, index, static_cast<long long>(value[0])}));
}
/// Keeps the enable of program targets.
void noteTarget(GLenum cap, bool enabled) {
  if (cap == GL_VERTEX_PROGRAM_ARB || cap == GL_FRAGMENT_PROGRAM_ARB)
    fake().targets[cap] = enabled;
}
void pushAttrib(GLbitfield) {
  if (fake().attribDepth >= 16)
    return fake().raise(GL_STACK_OVERFLOW);
  ++fake().attribDepth;
  fake().savedTargets.push_back(fake().targets);
}
void popAttrib() {
  if (fake().attribDepth <= 0)
    return fake().raise(GL_STACK_UNDERFLOW);
  --fake().attribDepth;
  fake().targets = fake().savedTargets.back();
  fake().savedTargets.pop_back();
}
void begin(GLenum mode) { fake().note(words("Begin", {mode})); }
void enable(GLenum cap) {
  fake().note(words("Enable", {cap}));
  noteTarget(cap, true);
}
GLboolean isEnabled(GLenum cap) {
  ++fake().queries;
  fake().note(words("IsEnabled", {cap}));
  return fake().enabled.count(cap) != 0;
}
void bindTexture(GLenum target, GLuint name) { fake().note(words("BindTexture", {target, name})); }
void materialfv(GLenum face, GLenum pname, const GLfloat *) {
  fake().note(words("Materialfv", {face, pname}));
}
void activeTexture(GLenum unit) { fake().note(words("ActiveTexture", {unit})); }
void disable(GLenum cap) {
  fake().note(words("Disable", {cap}));
  noteTarget(cap, false);
}
void getAttachedShaders(GLuint program, GLsizei most, GLsizei *count, GLuint *shaders) {
  *count = 0;
  for (const GLenum type : fake().stages[program])
    if (*count < most)
      shaders[(*count)++] = type;
}

struct Row {
  const char *name;
  void *function;
};
#define ROW(name, function)                                                                        \
  { "gl" #name, reinterpret_cast<void *>(&(function)) }
const Row kRows[] = {
    ROW(GetString, getString),
    ROW(GetStringi, getStringi),
    ROW(GetIntegerv, getIntegerv),
    ROW(GetFloatv, getFloatv),
    ROW(MatrixMode, matrixMode),
    ROW(Vertex4fv, vertex4fv),
    ROW(Normal3fv, normal3fv),
    ROW(Color4fv, color4fv),
    ROW(SecondaryColor3fv, secondaryColor3fv),
    ROW(FogCoordfv, fogCoordfv),
    ROW(MultiTexCoord4fv, multiTexCoord4fv),
    ROW(VertexAttrib4fv, vertexAttrib4fv),
    ROW(EnableVertexAttribArray, enableVertexAttribArray),
    ROW(DisableVertexAttribArray, disableVertexAttribArray),
    ROW(VertexAttribPointer, vertexAttribPointer),
    ROW(GetVertexAttribiv, getVertexAttribiv),
    ROW(EnableClientState, enableClientState),
    ROW(GetError, getError),
    ROW(GetProgramivARB, getProgramLimit),
    ROW(CreateShader, createShader),
    ROW(CreateProgram, createProgram),
    ROW(DeleteShader, deleteShader),
    ROW(DeleteProgram, deleteProgram),
    ROW(GetShaderiv, getShaderiv),
    ROW(GetProgramiv, getProgramiv),
    ROW(GetShaderInfoLog, getLog),
    ROW(GetProgramInfoLog, getLog),
    ROW(LinkProgram, linkProgram),
    ROW(UseProgram, useProgram),
    ROW(ProgramParameteri, programParameteri),
    ROW(GenProgramPipelines, genPipelines),
    ROW(BindProgramPipeline, bindPipeline),
    ROW(UseProgramStages, useStages),
    ROW(DeleteProgramPipelines, deletePipelines),
    ROW(ProgramUniform4fv, programUniform4fv),
    ROW(GetUniformLocation, getUniformLocation),
    ROW(Uniform4fv, uniform4fv),
    ROW(Uniform1i, uniform1i),
    ROW(NewList, newList),
    ROW(EndList, endList),
    ROW(CallList, callList),
    ROW(IsList, isList),
    ROW(DeleteLists, deleteLists),
    ROW(GenProgramsARB, genPrograms),
    ROW(ProgramStringARB, programString),
    ROW(BindProgramARB, bindProgram),
    ROW(DeleteProgramsARB, deletePrograms),
    ROW(ProgramEnvParameter4fvARB, envParameter),
    ROW(ProgramLocalParameter4fvARB, localParameter),
    ROW(ProgramEnvParameters4fvEXT, envParameters),
    ROW(ProgramLocalParameters4fvEXT, localParameters),
    ROW(PushAttrib, pushAttrib),
    ROW(PopAttrib, popAttrib),
    ROW(Begin, begin),
    ROW(Enable, enable),
    ROW(IsEnabled, isEnabled),
    ROW(ActiveTexture, activeTexture),
    ROW(BindTexture, bindTexture),
    ROW(Materialfv, materialfv),
    ROW(Disable, disable),
    ROW(BindAttribLocation, bindAttribLocation),
    ROW(GetAttachedShaders, getAttachedShaders),
};
#undef ROW

void *getProc(const char *name) {
  for (const Row &row : kRows)
    if (std::strcmp(row.name, name) == 0)
      return row.function;
  return nullptr;
}

} // namespace

FakeHost::FakeHost() {
  s_active = this;
  integers = {{GL_CONTEXT_PROFILE_MASK, 0}, {GL_CONTEXT_FLAGS, 0}, {GL_LIST_BASE, 0}};
  (void)host::loadHostTable(m_table, getProc);
}

FakeHost::~FakeHost() { s_active = nullptr; }

void FakeHost::note(const std::string &call) {
  calls.push_back(call);
  if (compiling != 0)
    recorded.push_back(call);
}

int FakeHost::count(const std::string &call) const {
  return int(std::count_if(calls.begin(), calls.end(), [&](const std::string &c) {
    return c == call || c.compare(0, call.size() + 1, call + " ") == 0;
  }));
}

} // namespace arbiter::state::testing
