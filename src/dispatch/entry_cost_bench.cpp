/// Measures what a passed-on call costs compared with a direct call of the host's function. Both
/// are called by pointer, as libglvnd does. It prints a table and is no test; the bound is 0.6 ns
/// on a quiet machine.
#include <benchmark/benchmark.h>

#include "dispatch/entry_points.h"
#include "host/host_table.h"
#include "state/core/core_context.h"

namespace {

using arbiter::host::HostTable;
using arbiter::state::ContextHot;

// These functions are empty, so that they hide nothing of the entry point's own work.
[[gnu::noipa]] void hostDrawArrays(GLenum, GLint, GLsizei) {}
[[gnu::noipa]] void hostUniform4fv(GLint, GLsizei, const GLfloat *) {}
[[gnu::noipa]] void hostRasterPos2f(GLfloat, GLfloat) {}
[[gnu::noipa]] void hostEnable(GLenum) {}
[[gnu::noipa]] void hostTexParameteri(GLenum, GLenum, GLint) {}

arbiter::Counter g_draws;

/// Makes a context current that has no work for any call.
void makeCurrent() {
  static HostTable s_table;
  static ContextHot s_hot;
  s_table.DrawArrays = hostDrawArrays;
  s_table.Uniform4fv = hostUniform4fv;
  s_table.RasterPos2f = hostRasterPos2f;
  s_table.Enable = hostEnable;
  s_table.TexParameteri = hostTexParameteri;
  s_hot.host = &s_table;
  s_hot.drawCounter = &g_draws;
  arbiter::state::t_current = &s_hot;
}

template <typename... Values>
void calls(benchmark::State &state, void (*function)(Values...), Values... values) {
  void (*volatile pointer)(Values...) = function;
  for (auto _ : state)
    pointer(values...);
}

template <typename Function> Function *entry(Function *, const char *name) {
  return reinterpret_cast<Function *>(arbiter::dispatch::find(name).function);
}

template <typename Function, typename... Values>
void compare(const char *name, Function *host, Values... values) {
  Function *const thunk = entry(host, name);
  const std::string text = name;
  benchmark::RegisterBenchmark((text + "/host").c_str(),
                               [=](benchmark::State &s) { calls(s, host, values...); });
  benchmark::RegisterBenchmark((text + "/entry").c_str(),
                               [=](benchmark::State &s) { calls(s, thunk, values...); });
}

} // namespace

int main(int argc, char **argv) {
  benchmark::Initialize(&argc, argv);
  makeCurrent();
  static const GLfloat s_value[4] = {};
  compare("glDrawArrays", hostDrawArrays, GLenum(GL_POINTS), GLint(0), GLsizei(1));
  compare("glUniform4fv", hostUniform4fv, GLint(0), GLsizei(1),
          static_cast<const GLfloat *>(s_value));
  compare("glRasterPos2f", hostRasterPos2f, GLfloat(0), GLfloat(0));
  compare("glEnable", hostEnable, GLenum(GL_BLEND));
  compare("glTexParameteri", hostTexParameteri, GLenum(GL_TEXTURE_2D),
          GLenum(GL_TEXTURE_MIN_FILTER), GLint(GL_NEAREST));
  benchmark::RunSpecifiedBenchmarks();
}
