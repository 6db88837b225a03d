// Tests program text as untrusted input: it gives a clean error or the right result, in bounded
// time.
#include <ctime>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::firstError;
using testing_support::forEachTokenEdit;
using testing_support::generous;
using testing_support::repeat;
using testing_support::small;
using testing_support::wrap;
using testing_support::wrapVertex;

/// A copy of a text that ends at an unmapped page.
class GuardedText {
public:
  explicit GuardedText(std::string_view text) {
    const auto page = std::size_t(sysconf(_SC_PAGESIZE));
    const std::size_t pages = (text.size() + page - 1) / page;
    m_size = (pages + 1) * page;
    m_base = static_cast<char *>(
        mmap(nullptr, m_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    char *end = m_base + pages * page;
    mprotect(end, page, PROT_NONE);
    m_text = {std::copy(text.begin(), text.end(), end - text.size()) - text.size(), text.size()};
  }
  ~GuardedText() { munmap(m_base, m_size); }
  GuardedText(const GuardedText &) = delete;
  GuardedText &operator=(const GuardedText &) = delete;

  [[nodiscard]] std::string_view text() const { return m_text; }

private:
  char *m_base = nullptr;
  std::size_t m_size = 0;
  std::string_view m_text;
};

/// Checks what must hold for every result, whatever the text.
void expectSane(std::string_view text, const CheckResult &result) {
  EXPECT_LE(result.diagnostics.size(), kMaxDiagnostics);
  EXPECT_LE(std::int64_t(result.errorPosition()), std::int64_t(text.size()));
  EXPECT_EQ(result.ok(), result.errorPosition() < 0);
  for (const Diagnostic &diagnostic : result.diagnostics) {
    EXPECT_LE(diagnostic.span.begin, diagnostic.span.end);
    EXPECT_FALSE(diagnostic.message.empty());
    EXPECT_LT(diagnostic.message.size() + diagnostic.hint.size(), 600u);
  }
  if (!result.ok()) {
    EXPECT_FALSE(result.errorString(text).empty());
  }
}

// Short texts that cover the whole grammar: the corpus for truncation and token edits.
const std::string kCorpus[] = {
    "!!ARBfp1.0\nOPTION ARB_fog_exp;\nTEMP a, b;\nATTRIB t = fragment.texcoord[1];\n"
    "PARAM p[4] = { program.local[0..1], {1,-2}, state.matrix.mvp.inverse.row[3] };\n"
    "OUTPUT o = result.color;\nALIAS c = a;\nMAD_SAT c.xyz, -t.wzyx, p[2].x, 0.5;\n"
    "SWZ b, a, -x, 0, 1, w;\nRCP b.w, a.r;\nKIL -b;\nTXP a, t, texture[3], CUBE;\nMOV o, a;\nEND",
    "!!ARBfp1.0\nOPTION ARB_draw_buffers;OPTION ARB_fragment_program_shadow;\nTEMP s;\n"
    "TEX s, fragment.texcoord, texture, SHADOW2D;\nPOW s.g, s.b, {2}.x;\n"
    "PARAM m[] = { state.matrix.texture[2].transpose, state.lightprod[1].back.diffuse };\n"
    "DP4 result.depth.z, s, m[4];\nMOV result.color[1], state.light[0].spot.direction;\n"
    "LRP result.color, 1e-1, state.material.shininess, program.env[3];\nEND # done",
    "!!ARBvp1.0\nOPTION ARB_position_invariant;\nADDRESS A;TEMP a;ATTRIB n = vertex.normal;\n"
    "PARAM c[] = { program.env[0..1], {1,-2}, state.matrix.program[1].inverse.row[3] };\n"
    "ARL A.x, -vertex.attrib[7].w;\nMAD a.xyz, -c[A.x - 64].wzyx, c[A.x+63].x, c[2];\n"
    "OUTPUT o = result.color.back.secondary;\nEXP o.xy, n.z;\nMOV result.texcoord[1], a;\nEND",
    "!!ARBvp1.0\nPARAM p[] = { state.texgen[1].eye.q, state.clip[5].plane, state.point.size };\n"
    "TEMP TEX;\nDPH TEX.w, vertex.fogcoord, p[1];\nLOG TEX, TEX.w;\nALIAS t = TEX;\n"
    "SWZ result.position, t, -x, 0, 1, w;\nMOV result.color.front, vertex.color.secondary.x;\n"
    "MOV result.pointsize.x, state.point.attenuation.y;\nEND",
};

TEST(Hostile, NoByteIsReadPastTheLength) {
  for (const std::string &text : kCorpus) {
    const GuardedText guarded(text);
    const CheckResult result = check(guarded.text());
    EXPECT_TRUE(result.ok()) << result.errorString(text);
  }
}

TEST(Hostile, TruncationAtEveryByte) {
  for (const std::string &text : kCorpus)
    for (std::size_t size = 0; size < text.size(); ++size) {
      const GuardedText guarded(std::string_view(text).substr(0, size));
      const CheckResult result = check(guarded.text());
      expectSane(guarded.text(), result);
      // Only the last bytes complete END.
      if (size < text.rfind("END") + 3) {
        EXPECT_FALSE(result.ok()) << size;
      }
    }
}

TEST(Hostile, EachTokenDeletedOrDoubled) {
  int refused = 0;
  int edits = 0;
  for (const std::string &text : kCorpus)
    forEachTokenEdit(text, [&](const std::string &edited) {
      const CheckResult result = check(edited);
      expectSane(edited, result);
      refused += result.ok() ? 0 : 1;
      ++edits;
    });
  EXPECT_GT(edits, 400);
  EXPECT_GT(refused, edits * 8 / 10);
}

TEST(Hostile, EachByteReplaced) {
  for (const std::string &text : kCorpus)
    for (std::size_t i = 0; i < text.size(); ++i)
      for (char c : {'\0', '\n', '.', '[', '9', '#', '\xFF'}) {
        std::string edited = text;
        edited[i] = c;
        expectSane(edited, check(edited));
      }
}

TEST(Hostile, NothingAtAll) {
  EXPECT_EQ(check("").errorPosition(), 0);
  EXPECT_EQ(check(std::string_view()).errorPosition(), 0);
  EXPECT_EQ(check("\0").errorPosition(), 0);
}

TEST(Hostile, NulInside) {
  const std::string inside("!!ARBfp1.0\nTEMP a;\0MOV a, 1;\nEND", 32);
  EXPECT_EQ(firstError(check(inside)), "invalid_character");
  EXPECT_EQ(check(inside).errorPosition(), 18);
  const std::string behind("!!ARBfp1.0 END\0x", 16);
  EXPECT_EQ(firstError(check(behind)), "text_after_end");
}

TEST(Hostile, LongText) {
  std::string text = "!!ARBfp1.0 END #";
  text.resize(kMaxTextBytes, 'c');
  EXPECT_TRUE(check(text).ok());
  text += 'c';
  EXPECT_EQ(firstError(check(text)), "text_too_long");
  EXPECT_EQ(check(text).errorPosition(), std::int32_t(kMaxTextBytes));
  text.resize(50u << 20, 'c');
  expectSane(text, check(text));
}

TEST(Hostile, LongWords) {
  const std::string name(kMaxIdentifierBytes, 'n');
  EXPECT_TRUE(check(wrap("TEMP " + name + ";\nMOV " + name + ", 1;")).ok());
  EXPECT_EQ(firstError(check(wrap("TEMP " + name + "n;"))), "identifier_too_long");
  EXPECT_EQ(firstError(check(wrap("TEMP " + std::string(1000000, 'n') + ";"))),
            "identifier_too_long");
  EXPECT_EQ(firstError(check(wrap("PARAM p = 0." + std::string(63, '1') + ";"))),
            "numeral_too_long");
  EXPECT_EQ(firstError(check(wrap("PARAM p = " + std::string(5u << 20, '1') + ";"))),
            "text_too_long");
  EXPECT_EQ(firstError(check(wrap("PARAM p = " + std::string(1000000, '1') + ";"))),
            "numeral_too_long");
}

TEST(Hostile, NumeralsOutOfRange) {
  const CheckResult big = check(wrap("PARAM p = {1e999, -1e39, 1e-999, 0};"));
  ASSERT_TRUE(big.ok());
  EXPECT_EQ(big.diagnostics.size(), 2u);
  const ir::Vec4 &value = big.program->parameters[0].constant;
  EXPECT_EQ(value, (ir::Vec4{3.4028235e38f, -3.4028235e38f, 0, 0}));
}

TEST(Hostile, ManyDeclarationsAndOptions) {
  std::string names;
  for (int i = 0; i < 60000; ++i)
    names += "TEMP t" + std::to_string(i) + ";\n";
  EXPECT_EQ(firstError(check(wrap(names))), "limit_temporaries");
  EXPECT_EQ(check(wrap(names)).diagnostics.size(), 1u);
  EXPECT_TRUE(check(wrap(repeat("OPTION ARB_fog_exp;\n", 50000))).ok());
  const CheckResult unsupported = check(wrap(repeat("OPTION NO_such_option;\n", 40000)));
  EXPECT_EQ(unsupported.diagnostics.size(), kMaxDiagnostics);
  EXPECT_EQ(firstError(check(wrap(repeat("TEMP t;", 100000)))), "redeclared_name");
}

TEST(Hostile, LongParameterLists) {
  for (std::uint32_t n : {4095u, 4096u, 4097u, 8192u}) {
    std::string list = "PARAM p[] = {0";
    for (std::uint32_t i = 1; i < n; ++i)
      list += "," + std::to_string(i);
    const std::string text = wrap(list + "};\nMOV result.color, p[" + std::to_string(n - 1) + "];");
    const CheckResult result = check(text, generous());
    EXPECT_EQ(result.ok(), n <= 4096) << n;
    if (result.ok()) {
      const ir::Program &program = *result.program;
      EXPECT_EQ(program.parameters[program.code[0].src[0].index].constant[0], float(n - 1));
    }
  }
  const std::string many = wrap("PARAM p[] = {" + repeat("1,", 500000) + "1};");
  EXPECT_EQ(firstError(check(many)), "array_entries");
  const std::string ranges = wrap("PARAM p[] = {" + repeat("program.env[0..4095],", 40000) + "1};");
  EXPECT_EQ(firstError(check(ranges, generous())), "array_entries");
}

TEST(Hostile, EveryErrorAtOnce) {
  for (const char *piece : {";", "MOV", "{", "[", "TEX a,b,", "PARAM p[]={", "a[0].x ", "- ", "..",
                            "\x80", "MOV a, b[c].x;\n", "PARAM q[3] = { state.matrix.mvp };\n"}) {
    const std::string text = wrap(repeat(piece, 500000 / std::char_traits<char>::length(piece)));
    expectSane(text, check(text));
  }
}

/// Returns seconds of this thread's processor time, because other tests share the machine.
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + double(time.tv_nsec) * 1e-9;
}

/// Returns the seconds of the fastest of several checks.
double seconds(const std::string &text, const CompileOptions &options) {
  double best = 1e9;
  for (int i = 0; i < 5; ++i) {
    const double begin = now();
    const CheckResult result = check(text, options);
    best = std::min(best, now() - begin);
    expectSane(text, result);
  }
  return best;
}

TEST(Hostile, AFullProgramTakesUnderFiveMilliseconds) {
#ifdef __SANITIZE_THREAD__
  // The bound is that of code which nothing instruments.
  GTEST_SKIP() << "ThreadSanitizer makes code ten times as slow";
#endif
  std::string text = "TEMP a, b;\nPARAM p[4] = { program.local[0..3] };\n";
  for (int i = 0; i < 32; ++i)
    text += "MAD a.xyz, -b.wzyx, p[" + std::to_string(i % 4) + "], {0.5, " + std::to_string(i) +
            "};\nTEX a, fragment.texcoord[1], texture[0], 2D;\nMUL_SAT b, a, a;\n";
  EXPECT_LT(seconds(wrap(text), generous()), 0.005);
}

// Twice the text must take about twice the time: quadratic time would show as four times.
TEST(Hostile, TimeIsLinear) {
  const struct {
    const char *name;
    std::string (*make)(int n);
    std::string (*around)(std::string_view statements) = wrap;
  } shapes[] = {
      {"names",
       [](int n) {
         std::string text;
         for (int i = 0; i < n; ++i)
           text += "TEMP a" + std::to_string(i) + ";MOV a" + std::to_string(i) + ",1;";
         return text;
       }},
      {"constants",
       [](int n) {
         std::string text = "PARAM p[] = {0";
         for (int i = 0; i < n; ++i)
           text += "," + std::to_string(i);
         return text + "};";
       }},
      {"undeclared",
       [](int n) {
         std::string text;
         for (int i = 0; i < n; ++i)
           text += "KIL name" + std::to_string(i) + ";";
         return text;
       }},
      {"one line of errors", [](int n) { return repeat("MOV ", std::size_t(n)); }},
      {"arrays under relative addressing",
       [](int n) {
         std::string text = "ADDRESS A; TEMP t;";
         for (int i = 0; i < n; ++i) {
           const std::string name = "c" + std::to_string(i);
           text += "PARAM " + name + "[]={1,1}; MOV t," + name + "[A.x];";
         }
         return text;
       },
       wrapVertex},
  };
  CompileOptions options = generous();
  options.policy = LimitPolicy::Report;
  for (const auto &shape : shapes) {
    // A shared cache can disturb the measurement, so try again.
    double ratio = 0;
    for (int attempt = 0; attempt < 5; ++attempt) {
      ratio = seconds(shape.around(shape.make(20000)), options) /
              seconds(shape.around(shape.make(10000)), options);
      if (ratio < 3)
        break;
    }
    EXPECT_LT(ratio, 3) << shape.name;
  }
}

} // namespace
} // namespace arbiter::fp
