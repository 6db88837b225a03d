// Vertex programs of the same meaning in ARB's language and in one of NVIDIA's.
#include "nv_texts.h"

namespace bench {
namespace {

constexpr GLenum kVertex = GL_VERTEX_PROGRAM_ARB;

constexpr NvPair kPairs[] = {
    {"!!VP2.0", kVertex, R"(!!ARBvp1.0
PARAM c[96] = { program.env[0..95] };
TEMP n, l, t;
DP4 result.position.x, c[0], vertex.position;
DP4 result.position.y, c[1], vertex.position;
DP4 result.position.z, c[2], vertex.position;
DP4 result.position.w, c[3], vertex.position;
DP3 n.w, vertex.texcoord[1], vertex.texcoord[1];
RSQ n.w, n.w;
MUL n.xyz, vertex.texcoord[1], n.w;
SUB l.xyz, c[4], vertex.position;
DP3 l.w, l, l;
RSQ l.w, l.w;
MUL l.xyz, l, l.w;
DP3 t.x, n, l;
DP3 t.y, n, c[5];
MOV t.w, c[5].w;
LIT t, t;
MAD t, t.y, c[6], t.z;
MOV result.color, t;
MOV result.texcoord[0], vertex.texcoord[0];
MOV result.texcoord[1], program.env[@];
END
)",
     R"(!!VP2.0
DP4 o[HPOS].x, c[0], v[OPOS];
DP4 o[HPOS].y, c[1], v[OPOS];
DP4 o[HPOS].z, c[2], v[OPOS];
DP4 o[HPOS].w, c[3], v[OPOS];
DP3 R0.w, v[TEX1], v[TEX1];
RSQ R0.w, R0.w;
MUL R0.xyz, v[TEX1], R0.w;
ADD R1.xyz, c[4], -v[OPOS];
DP3 R1.w, R1, R1;
RSQ R1.w, R1.w;
MUL R1.xyz, R1, R1.w;
DP3 R2.x, R0, R1;
DP3 R2.y, R0, c[5];
MOV R2.w, c[5].w;
LIT R2, R2;
MAD R2, R2.y, c[6], R2.z;
MOV o[COL0], R2;
MOV o[TEX0], v[TEX0];
MOV o[TEX1], c[@];
END
)"},
    {"!!VP1.1", kVertex, R"(!!ARBvp1.0
PARAM c[96] = { program.env[0..95] };
ADDRESS a;
TEMP p;
ARL a.x, vertex.texcoord[2].x;
DP4 p.x, c[a.x + 8], vertex.position;
DP4 p.y, c[a.x + 9], vertex.position;
DP4 p.z, c[a.x + 10], vertex.position;
MOV p.w, vertex.position.w;
DP4 result.position.x, c[0], p;
DP4 result.position.y, c[1], p;
DP4 result.position.z, c[2], p;
DP4 result.position.w, c[3], p;
MUL result.color, vertex.color, c[6];
MOV result.texcoord[1], program.env[@];
END
)",
     R"(!!VP1.1
ARL A0.x, v[TEX2].x;
DP4 R0.x, c[A0.x + 8], v[OPOS];
DP4 R0.y, c[A0.x + 9], v[OPOS];
DP4 R0.z, c[A0.x + 10], v[OPOS];
MOV R0.w, v[OPOS].w;
DP4 o[HPOS].x, c[0], R0;
DP4 o[HPOS].y, c[1], R0;
DP4 o[HPOS].z, c[2], R0;
DP4 o[HPOS].w, c[3], R0;
MUL o[COL0], v[COL0], c[6];
MOV o[TEX1], c[@];
END
)"},
    {"condition codes of vertices", kVertex, R"(!!ARBvp1.0
PARAM c[96] = { program.env[0..95] };
TEMP n, t, u, r;
DP4 result.position.x, c[0], vertex.position;
DP4 result.position.y, c[1], vertex.position;
DP4 result.position.z, c[2], vertex.position;
DP4 result.position.w, c[3], vertex.position;
DP3 t.x, vertex.texcoord[1], c[4];
DP3 t.y, vertex.texcoord[1], c[5];
SLT u, t.xyxy, 0.0;
SUB r, c[7], c[6];
MAD r, u.x, r, c[6];
MUL n, r, vertex.color;
SUB t, n, r;
MAD r, u.y, t, r;
MOV result.color, r;
MOV result.texcoord[1], program.env[@];
END
)",
     R"(!!ARBvp1.0
OPTION NV_vertex_program3;
PARAM c[96] = { program.env[0..95] };
TEMP t, r;
DP4 result.position.x, c[0], vertex.position;
DP4 result.position.y, c[1], vertex.position;
DP4 result.position.z, c[2], vertex.position;
DP4 result.position.w, c[3], vertex.position;
DP3C t.x, vertex.texcoord[1], c[4];
DP3C1 t.y, vertex.texcoord[1], c[5];
MOV r, c[6];
MOV r (LT.x), c[7];
MUL r (LT1.y), r, vertex.color;
MOV result.color, r;
MOV result.texcoord[1], program.env[@];
END
)"},
    {"a loop by BRA", kVertex, R"(!!ARBvp1.0
PARAM c[96] = { program.env[0..95] };
TEMP l, t, r;
DP4 result.position.x, c[0], vertex.position;
DP4 result.position.y, c[1], vertex.position;
DP4 result.position.z, c[2], vertex.position;
DP4 result.position.w, c[3], vertex.position;
MOV r, c[4];
SUB l, c[19], vertex.position;
DP3 l.w, l, l;
RSQ l.w, l.w;
DP3 t.x, l, vertex.texcoord[1];
MUL t.x, t.x, l.w;
MAX t.x, t.x, 0.0;
MAD r, t.x, c[6], r;
SUB l, c[18], vertex.position;
DP3 l.w, l, l;
RSQ l.w, l.w;
DP3 t.x, l, vertex.texcoord[1];
MUL t.x, t.x, l.w;
MAX t.x, t.x, 0.0;
MAD r, t.x, c[6], r;
SUB l, c[17], vertex.position;
DP3 l.w, l, l;
RSQ l.w, l.w;
DP3 t.x, l, vertex.texcoord[1];
MUL t.x, t.x, l.w;
MAX t.x, t.x, 0.0;
MAD r, t.x, c[6], r;
SUB l, c[16], vertex.position;
DP3 l.w, l, l;
RSQ l.w, l.w;
DP3 t.x, l, vertex.texcoord[1];
MUL t.x, t.x, l.w;
MAX t.x, t.x, 0.0;
MAD r, t.x, c[6], r;
MOV result.color, r;
MOV result.texcoord[1], program.env[@];
END
)",
     R"(!!ARBvp1.0
OPTION NV_vertex_program3;
PARAM c[96] = { program.env[0..95] };
ADDRESS a;
TEMP l, t, r, k;
DP4 result.position.x, c[0], vertex.position;
DP4 result.position.y, c[1], vertex.position;
DP4 result.position.z, c[2], vertex.position;
DP4 result.position.w, c[3], vertex.position;
MOV r, c[4];
MOV k.x, 3.0;
again:
ARL a.x, k.x;
SUB l, c[a.x + 16], vertex.position;
DP3 l.w, l, l;
RSQ l.w, l.w;
DP3 t.x, l, vertex.texcoord[1];
MUL t.x, t.x, l.w;
MAX t.x, t.x, 0.0;
MAD r, t.x, c[6], r;
ADDC k.x, k.x, -1.0;
BRA again (GE.x);
MOV result.color, r;
MOV result.texcoord[1], program.env[@];
END
)"},
};

} // namespace

std::span<const NvPair> nvVertexPairs() { return kPairs; }

} // namespace bench
