// Fragment programs of the same meaning in ARB's language and in one of NVIDIA's.
#include "nv_texts.h"

namespace bench {
namespace {

constexpr GLenum kFragment = GL_FRAGMENT_PROGRAM_ARB;

constexpr NvPair kPairs[] = {
    {"H and X of an option", kFragment, R"(!!ARBfp1.0
TEMP n, h, s, t;
PARAM light = {0.3, 0.5, 0.8, 12.0};
TEX s, fragment.texcoord[0], texture[0], 2D;
TEX n, fragment.texcoord[1], texture[1], 2D;
MAD n.xyz, n, 2.0, -1.0;
DP3 n.w, n, n;
RSQ n.w, n.w;
MUL n.xyz, n, n.w;
DP3 t.x, n, light;
ADD h.xyz, light, fragment.texcoord[1];
DP3 h.w, h, h;
RSQ h.w, h.w;
MUL h.xyz, h, h.w;
DP3 t.y, n, h;
MOV t.w, light.w;
LIT t, t;
MAD s.xyz, s, t.y, @;
MAD result.color.xyz, s, fragment.color, t.z;
MOV result.color.w, 1.0;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
SHORT TEMP n, h, s;
TEMP t;
PARAM light = {0.3, 0.5, 0.8, 12.0};
TEX s, fragment.texcoord[0], texture[0], 2D;
TEX n, fragment.texcoord[1], texture[1], 2D;
MADH n.xyz, n, 2.0, -1.0;
DP3H n.w, n, n;
RSQH n.w, n.w;
MULX n.xyz, n, n.w;
DP3H t.x, n, light;
ADDH h.xyz, light, fragment.texcoord[1];
DP3H h.w, h, h;
RSQR h.w, h.w;
MULH h.xyz, h, h.w;
DP3X t.y, n, h;
MOVH t.w, light.w;
LITH t, t;
MADX s.xyz, s, t.y, @;
MADH result.color.xyz, s, fragment.color, t.z;
MOVX result.color.w, 1.0;
END
)"},
    {"condition codes for CMP", kFragment, R"(!!ARBfp1.0
TEMP a, b, c, d, e, r;
TEX b, fragment.texcoord[0], texture[0], 2D;
TEX c, fragment.texcoord[1], texture[1], 2D;
MAD a, fragment.color, 2.0, -1.0;
CMP r, a, b, c;
SUB d, r, @;
CMP e, d.x, r, b;
MUL e.w, e.x, e.y;
MAD d, c, 2.0, -e;
CMP e.xyz, -d, e, c;
ADD d.x, e.x, -e.y;
CMP e.xyz, d.x, e.yzxw, e;
MUL result.color, e, fragment.color;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, b, c, d, e, r;
TEX b, fragment.texcoord[0], texture[0], 2D;
TEX c, fragment.texcoord[1], texture[1], 2D;
MADC a, fragment.color, 2.0, -1.0;
MOV r, c;
MOV r (LT), b;
SUBC d, r, @;
MOV e, b;
MOV e (LT.x), r;
MUL e.w, e.x, e.y;
MADC d, c, 2.0, -e;
MOV e.xyz (LE), c;
ADDC d.x, e.x, -e.y;
MOV e.xyz (LT.x), e.yzxw;
MUL result.color, e, fragment.color;
END
)"},
    {"set-on and KIL by condition", kFragment, R"(!!ARBfp1.0
TEMP a, b, c;
TEX a, fragment.texcoord[0], texture[0], 2D;
TEX b, fragment.texcoord[1], texture[1], 2D;
SLT c, b, a;
SGE a, b, fragment.color;
MAD a, a, 0.25, c;
SLT c, b.wzyx, a;
MAD a, c, 0.5, a;
SUB c, b, 0.03;
KIL c.x;
MUL result.color, a, @;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, b, c;
TEX a, fragment.texcoord[0], texture[0], 2D;
TEX b, fragment.texcoord[1], texture[1], 2D;
SGT c, a, b;
SLE a, fragment.color, b;
MAD a, a, 0.25, c;
SGT c, a, b.wzyx;
MAD a, c, 0.5, a;
SUBC c, b, 0.03;
KIL LT.x;
MUL result.color, a, @;
END
)"},
    {"NRM, DIV, DP2A, RFL, X2D", kFragment, R"(!!ARBfp1.0
TEMP a, n, r, t;
TEX a, fragment.texcoord[0], texture[0], 2D;
DP3 t.x, a, a;
RSQ t.x, t.x;
MUL n, a, t.x;
DP3 t.x, n, fragment.texcoord[1];
DP3 t.y, n, n;
ADD t.x, t.x, t.x;
RCP t.y, t.y;
MUL t.x, t.x, t.y;
MAD r.xyz, n, t.x, -fragment.texcoord[1];
MUL t.y, n.y, r.y;
MAD t.x, n.x, r.x, t.y;
ADD t.x, t.x, @;
MOV r.w, t.x;
RCP t.y, a.w;
MUL r, r, t.y;
MAD t, r.x, a.xzxz, n.xyxy;
MAD result.color, r.y, a.ywyw, t;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, n, r;
TEX a, fragment.texcoord[0], texture[0], 2D;
NRM n, a;
RFL r.xyz, n, fragment.texcoord[1];
DP2A r.w, n, r, @;
DIV r, r, a.w;
X2D result.color, n, r, a;
END
)"},
    {"IF where pixels differ", kFragment, R"(!!ARBfp1.0
TEMP a, b, c, d, t;
TEX a, fragment.texcoord[0], texture[0], 2D;
SUB t.x, fragment.color.x, 0.5;
MUL b, a, fragment.color;
MAD b, b, b, a;
MUL b, b, fragment.texcoord[1].x;
MAD b, b, a, fragment.color;
DP3 b.w, b, a;
ADD b, b, @;
SUB c, fragment.color, a;
MAD c, c, a, c;
MUL c, c, 0.75;
MAD c, c, c, a.wzyx;
MIN c, c, 1.0;
CMP d, t.x, b, c;
MUL result.color, d, 0.5;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, b, t;
TEX a, fragment.texcoord[0], texture[0], 2D;
SUBC t.x, fragment.color.x, 0.5;
IF LT.x;
  MUL b, a, fragment.color;
  MAD b, b, b, a;
  MUL b, b, fragment.texcoord[1].x;
  MAD b, b, a, fragment.color;
  DP3 b.w, b, a;
  ADD b, b, @;
ELSE;
  SUB b, fragment.color, a;
  MAD b, b, a, b;
  MUL b, b, 0.75;
  MAD b, b, b, a.wzyx;
  MIN b, b, 1.0;
ENDIF;
MUL result.color, b, 0.5;
END
)"},
    {"IF of a parameter", kFragment, R"(!!ARBfp1.0
TEMP a, b, c, t;
PARAM how = program.local[0];
TEX a, fragment.texcoord[0], texture[0], 2D;
MUL b, a, fragment.color;
MAD b, b, b, a;
DP3 b.w, b, a;
ADD b, b, @;
POW t.x, a.x, how.z;
MUL c, t.x, a;
MAD c, c, c, a.wzyx;
SUB t.y, how.x, 0.25;
CMP a, t.y, b, c;
MUL result.color, a, fragment.color;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, b, t;
PARAM how = program.local[0];
TEX a, fragment.texcoord[0], texture[0], 2D;
SUBC t.y, how.x, 0.25;
IF LT.y;
  MUL b, a, fragment.color;
  MAD b, b, b, a;
  DP3 b.w, b, a;
  ADD b, b, @;
ELSE;
  POW t.x, a.x, how.z;
  MUL b, t.x, a;
  MAD b, b, b, a.wzyx;
ENDIF;
MUL result.color, b, fragment.color;
END
)"},
    {"REP", kFragment, R"(!!ARBfp1.0
TEMP a, b;
TEX b, fragment.texcoord[0], texture[0], 2D;
MOV a, fragment.color;
MAD a, a, b, @;
FRC a, a;
MAD a, a, b, @;
FRC a, a;
MAD a, a, b, @;
FRC a, a;
MAD a, a, b, @;
FRC a, a;
MAD a, a, b, @;
FRC a, a;
MAD a, a, b, @;
FRC a, a;
MOV result.color, a;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, b;
TEX b, fragment.texcoord[0], texture[0], 2D;
MOV a, fragment.color;
REP 6;
  MAD a, a, b, @;
  FRC a, a;
ENDREP;
MOV result.color, a;
END
)"},
    {"LOOP, left by BRK", kFragment, R"(!!ARBfp1.0
TEMP z, n, t, k;
PARAM c = {-0.7, 0.27, 0.0, @};
MAD z, fragment.color.xyxy, {2.0, 2.0, 0.0, 0.0}, {-1.0, -1.0, 0.0, 0.0};
MUL t, z, z;
SUB n.x, t.x, t.y;
MUL n.y, z.x, z.y;
MAD n.xy, n, {1.0, 2.0, 0.0, 0.0}, c;
ADD n.z, z.z, 1.0;
MUL t, n, n;
ADD t.w, t.x, t.y;
SUB k.x, t.w, 4.0;
MOV z.xyz, n;
SUB n.x, t.x, t.y;
MUL n.y, z.x, z.y;
MAD n.xy, n, {1.0, 2.0, 0.0, 0.0}, c;
ADD n.z, z.z, 1.0;
CMP z.xyz, k.x, n, z;
MUL t, z, z;
ADD t.w, t.x, t.y;
SUB k.x, t.w, 4.0;
SUB n.x, t.x, t.y;
MUL n.y, z.x, z.y;
MAD n.xy, n, {1.0, 2.0, 0.0, 0.0}, c;
ADD n.z, z.z, 1.0;
CMP z.xyz, k.x, n, z;
MUL t, z, z;
ADD t.w, t.x, t.y;
SUB k.x, t.w, 4.0;
SUB n.x, t.x, t.y;
MUL n.y, z.x, z.y;
MAD n.xy, n, {1.0, 2.0, 0.0, 0.0}, c;
ADD n.z, z.z, 1.0;
CMP z.xyz, k.x, n, z;
MUL result.color, z.z, {0.25, 0.125, 0.0625, 1.0};
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP z, n, t, k;
PARAM c = {-0.7, 0.27, 0.0, @};
PARAM turns = {4, 0, 1, 0};
MAD z, fragment.color.xyxy, {2.0, 2.0, 0.0, 0.0}, {-1.0, -1.0, 0.0, 0.0};
MUL t, z, z;
LOOP turns;
  SUB n.x, t.x, t.y;
  MUL n.y, z.x, z.y;
  MAD z.xy, n, {1.0, 2.0, 0.0, 0.0}, c;
  ADD z.z, z.z, 1.0;
  MUL t, z, z;
  ADD t.w, t.x, t.y;
  SGEC k.x, t.w, 4.0;
  BRK (NE.x);
ENDLOOP;
MUL result.color, z.z, {0.25, 0.125, 0.0625, 1.0};
END
)"},
    {"CAL", kFragment, R"(!!ARBfp1.0
TEMP a, b, t;
TEX a, fragment.texcoord[0], texture[0], 2D;
MAD b, a, a.wzyx, @;
DP3 t.x, b, b;
RSQ t.x, t.x;
MUL a, b, t.x;
MUL a, a, fragment.color;
MAD b, a, a.wzyx, @;
DP3 t.x, b, b;
RSQ t.x, t.x;
MUL a, b, t.x;
MOV result.color, a;
END
)",
     R"(!!ARBfp1.0
OPTION NV_fragment_program2;
TEMP a, b, t;
TEX a, fragment.texcoord[0], texture[0], 2D;
CAL unit;
MUL a, a, fragment.color;
CAL unit;
MOV result.color, a;
RET;
unit:
  MAD b, a, a.wzyx, @;
  DP3 t.x, b, b;
  RSQ t.x, t.x;
  MUL a, b, t.x;
  RET;
END
)"},
    {"!!FP1.0", kFragment, R"(!!ARBfp1.0
TEMP a, b, c, d;
TEX a, fragment.texcoord[0], texture[0], 2D;
TEX b, fragment.texcoord[1], texture[1], 2D;
MAD b, b, 2.0, -1.0;
DP3 c.w, b, b;
RSQ c.w, c.w;
MUL c.xyz, b, c.w;
DP3_SAT c.w, c, {0.3, 0.5, 0.8};
CMP d, -b, a, fragment.color;
MAD d, d, c.w, @;
MUL result.color, d, fragment.color;
END
)",
     R"(!!FP1.0
TEX R0, f[TEX0], TEX0, 2D;
TEX H1, f[TEX1], TEX1, 2D;
MADHC H1, H1, {2.0}.x, {-1.0}.x;
MOVR R3, f[COL0];
MOVR R3 (GT), R0;
DP3R R1.w, H1, H1;
RSQR R1.w, R1.w;
MULX H2.xyz, H1, R1.w;
DP3X_SAT H2.w, H2, {0.3, 0.5, 0.8};
MADR R3, R3, H2.w, {@}.x;
MULR o[COLR], R3, f[COL0];
END
)"},
};

} // namespace

std::span<const NvPair> nvFragmentPairs() { return kPairs; }

} // namespace bench
