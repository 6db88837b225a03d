// A Direct3D 9 program that draws twelve tiles into an off-screen target and writes them to o.ppm.
// It uses pixel shaders 2.x (2.a and 2.b are profiles of it) and 3.0, and vertex shaders 2.x and
// 3.0, with the features that each adds to the previous model.
#include <cmath>

#include "tiled.h"

namespace {

constexpr int kSteps = 16; // of a tile's grid

struct Vertex {
  float position[3], uv[4], color[4];
};

// The vertex shaders. setConstants() sets c0 to c7; b0 is true, i0 is (3, 0, 1).
constexpr char kPlainVs[] = "vs_3_0\n"
                            "dcl_position v0\ndcl_texcoord v1\ndcl_color v2\n"
                            "dcl_position o0\ndcl_texcoord o1\ndcl_color o2\ndcl_texcoord1 o3\n"
                            "mov o0, v0\nmov o1, v1\nmov o2, v2\nmov o3, v1.yxwz\n";
constexpr char kLoopVs[] = "vs_3_0\n"
                           "def c20, 0.3, 0.5, 0.0, 1.0\n"
                           "dcl_position v0\ndcl_texcoord v1\ndcl_color v2\n"
                           "dcl_position o0\ndcl_texcoord o1\ndcl_color o2\ndcl_texcoord1 o3\n"
                           "mov r0, c20.z\n"
                           "loop aL, i0\n"
                           "mad r0, c[aL + 2], v1.x, r0\n"
                           "endloop\n"
                           "if b0\nmul r0, r0, c20.y\nelse\nmov r0, c20.w\nendif\n"
                           "if_gt v1.x, c20.y\nadd r0.xyz, r0, v2\nendif\n"
                           "mov o0, v0\nmov o1, v1\nmov o2, r0\nmov o3, v1\n";
constexpr char kTextureVs[] = "vs_3_0\n"
                              "def c20, 0.3, -0.15, 0.0, 1.0\n"
                              "dcl_position v0\ndcl_texcoord v1\ndcl_color v2\ndcl_2d s0\n"
                              "dcl_position o0\ndcl_texcoord o1\ndcl_color o2\ndcl_texcoord1 o3\n"
                              "mov r1, v1\nmov r1.zw, c20.z\n"
                              "texldl r0, r1, s0\n"
                              "mov r2, v0\n"
                              "mad r2.xy, r0, c20.x, r2\nadd r2.xy, r2, c20.y\n"
                              "mov o0, r2\nmov o1, v1\nmov o2, r0\nmov o3, v1\n";
// Wine's GLSL for subroutines is unreliable as a reference: there the code replaces the call.
#define RELATIVE_VS                                                                                \
  "vs_2_x\n"                                                                                       \
  "def c20, 4.0, 0.5, 0.0, 1.0\n"                                                                  \
  "dcl_position v0\ndcl_texcoord v1\ndcl_color v2\n"                                               \
  "mul r0, v1.x, c20.x\nmova a0.x, r0.x\n"                                                         \
  "mov r1, c[a0.x + 1]\n"                                                                          \
  "slt r2, v1.y, c20.y\nmad r1, r2, v2, r1\n"
#define RESULTS_VS "mov oPos, v0\nmov oT0, v1\nmov oD0, r1\nmov oT1, v1\n"
constexpr char kCallVs[] =
    RELATIVE_VS "call l0\n" RESULTS_VS "ret\nlabel l0\nmul r1.x, r1.x, c20.y\nret\n";
constexpr char kCallVsInline[] = RELATIVE_VS "mul r1.x, r1.x, c20.y\n" RESULTS_VS;

constexpr char kColorPs[] = "ps_3_0\ndcl_texcoord v0\ndcl_color v1\nmov oC0, v1\n";
constexpr char kGradients[] = "ps_2_x\n"
                              "def c0, 20.0, 0.5, 0.0, 1.0\n"
                              "dcl t0.xy\ndcl v0\ndcl_2d s0\n"
                              "mul r0, t0.xyxy, t0.yxxy\n"
                              "dsx r1, r0\ndsy r2, r0\n"
                              "texldd r3, t0, s0, r1, r2\n"
                              "mul r3, r3, v0\n"
                              "mad r3, r1.xyxy, c0.x, r3\n"
                              "mov oC0, r3\n";
constexpr char kBranches[] =
    "ps_2_x\n"
    "def c0, 0.3, 0.7, 0.0, 1.0\n"
    "dcl t0.xy\ndcl v0\ndcl_2d s0\n"
    "mov r0, t0.xyxy\nmov r1, v0\n"
    "if_gt r0.x, c0.x\n"
    "if_lt r0.y, c0.y\nmul r1, r1, r0.y\nelse\nadd r1.x, r1.x, r0.x\nendif\n"
    "else\nsub r1, c0.w, r1\nendif\n"
    "mov oC0, r1\n";
// The dependent reads are deeper than any in model 2.0.
constexpr char kDependent[] = "ps_2_x\n"
                              "def c0, 0.5, 0.25, 0.0, 1.0\n"
                              "dcl t0.xy\ndcl_2d s0\n"
                              "texld r0, t0, s0\n"
                              "mad r0, r0, c0.y, t0.xyxy\ntexld r0, r0, s0\n"
                              "mad r0, r0, c0.y, t0.xyxy\ntexld r0, r0, s0\n"
                              "mad r0, r0, c0.y, t0.xyxy\ntexld r0, r0, s0\n"
                              "mad r0, r0, c0.y, t0.xyxy\ntexld r0, r0, s0\n"
                              "mad r0, r0, c0.y, t0.xyxy\ntexld r0, r0, s0\n"
                              "mov oC0, r0\n";
// Wine's assembler has no declaration of vFace.
constexpr char kFace3[] = "ps_3_0\n"
                          "def c0, 0.0, 0.5, 1.0, 0.25\n"
                          "dcl_texcoord v0\ndcl_color v1\n"
                          "if_gt vFace, c0.x\nmov r0, v1\nelse\nmul r0, v0.xyxy, c0.y\nendif\n"
                          "cmp r1, vFace, c0.w, c0.x\nadd r0.z, r0.z, r1.x\nmov oC0, r0\n";
constexpr char kInputs3[] = "ps_3_0\n"
                            "def c0, 0.0, 0.3, 1.0, 0.25\n"
                            "dcl_texcoord v0\ndcl_color v1\ndcl_texcoord1 v2\n"
                            "mov r0, c0.x\n"
                            "loop aL, i0\nmad r0, v[aL], c0.y, r0\nendloop\n"
                            "mov oC0, r0\n";
// This runs the iterations of a Mandelbrot-like series, which end by themselves.
constexpr char kBreak3[] = "ps_3_0\n"
                           "def c0, 0.0, 4.0, 3.0, -2.0\ndef c1, 0.0625, 1.5, 1.0, 2.0\n"
                           "defi i1, 16, 0, 0, 0\n"
                           "dcl_texcoord v0\n"
                           "mad r0.xy, v0, c0.z, -c1.w\nadd r0.y, r0.y, c1.x\n"
                           "mov r1, c0.x\nmov r2, c0.x\n"
                           "rep i1\n"
                           "mul r3.xy, r1, r1\nadd r3.z, r3.x, r3.y\n"
                           "break_gt r3.z, c0.y\n"
                           "mul r3.w, r1.x, r1.y\n"
                           "sub r1.x, r3.x, r3.y\nadd r1.x, r1.x, r0.x\n"
                           "mad r1.y, r3.w, c1.w, r0.y\n"
                           "add r2, r2, c1.x\n"
                           "endrep\n"
                           "mov oC0, r2\n";
constexpr char kLod3[] = "ps_3_0\n"
                         "def c0, 0.0, 3.0, 1.0, 0.25\n"
                         "dcl_texcoord v0\ndcl_2d s0\n"
                         "mov r0, v0\nmul r0.w, v0.x, c0.y\nmov r0.z, c0.x\n"
                         "texldl r1, r0, s0\n"
                         "mov oC0, r1\n";
constexpr char kCall3[] = "ps_3_0\n"
                          "def c0, 0.0, 0.5, 1.0, 0.25\n"
                          "dcl_texcoord v0\ndcl_color v1\n"
                          "mov r0, v1\n"
                          "if_gt v0.x, c0.y\ncall l0\nendif\n"
                          "mov oC0, r0\n"
                          "ret\n"
                          "label l0\nmul r0, r0, v0.y\nret\n";
constexpr char kCall3Inline[] = "ps_3_0\n"
                                "def c0, 0.0, 0.5, 1.0, 0.25\n"
                                "dcl_texcoord v0\ndcl_color v1\n"
                                "mov r0, v1\n"
                                "if_gt v0.x, c0.y\nmul r0, r0, v0.y\nendif\n"
                                "mov oC0, r0\n";
// This has nested loops, and at the end a sample with gradients. They are two of 64 texels a pixel,
// of which a tile's side has 115.2, so that the level of detail is 1. Between two levels hosts
// round it differently: llvmpipe has 1.125 for 1.152.
constexpr char kNested3[] = "ps_3_0\n"
                            "def c0, 0.0, 0.125, 0.75, 3.6\n"
                            "defi i1, 3, 0, 0, 0\ndefi i2, 2, 0, 0, 0\n"
                            "dcl_texcoord v0\ndcl_2d s0\n"
                            "mov r0, v0.xyxy\n"
                            "rep i1\nadd r0.x, r0.x, c0.y\n"
                            "rep i2\nmul r0.y, r0.y, c0.z\nbreak_lt r0.y, c0.y\nendrep\n"
                            "endrep\n"
                            "mul r1, v0.xyxy, c0.w\ndsx r2, r1\ndsy r3, r1\n"
                            "texldd r4, r0, s0, r2, r3\n"
                            "mov oC0, r4\n";

struct Tile {
  const char *vertex, *pixel;
  bool turned;
};
constexpr Tile kTiles[kColumns * kRows] = {
    {kPlainVs, kFace3, false},   {kPlainVs, kFace3, true},      {kPlainVs, kInputs3, false},
    {kPlainVs, kBreak3, false},  {kPlainVs, kLod3, false},      {kPlainVs, kCall3, false},
    {kLoopVs, kColorPs, false},  {kTextureVs, kColorPs, false}, {kCallVs, kGradients, false},
    {kCallVs, kBranches, false}, {kCallVs, kDependent, false},  {kPlainVs, kNested3, false},
};

struct Device : Target {
  IDirect3DTexture9 *picture = nullptr, *heights = nullptr;
};

/// Makes a texture with all levels, each of another tint, so that a level of detail is visible.
IDirect3DTexture9 *makePicture(IDirect3DDevice9 *device) {
  IDirect3DTexture9 *texture = nullptr;
  check("CreateTexture",
        device->CreateTexture(64, 64, 0, 0, D3DFMT_A8R8G8B8, D3DPOOL_MANAGED, &texture, nullptr));
  for (UINT level = 0; level < texture->GetLevelCount(); ++level) {
    const int side = 64 >> level;
    D3DLOCKED_RECT lock;
    check("LockRect", texture->LockRect(level, &lock, nullptr, 0));
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const int u = (x << level) * 4, v = (y << level) * 4;
        static_cast<DWORD *>(lock.pBits)[y * lock.Pitch / 4 + x] =
            D3DCOLOR_ARGB(255 - v, u, int(level) * 40, 128 + (u ^ v) / 2);
      }
    texture->UnlockRect(level);
  }
  return texture;
}

IDirect3DTexture9 *makeHeights(IDirect3DDevice9 *device) {
  IDirect3DTexture9 *texture = nullptr;
  check("CreateTexture of floats", device->CreateTexture(32, 32, 1, 0, D3DFMT_A32B32G32R32F,
                                                         D3DPOOL_MANAGED, &texture, nullptr));
  D3DLOCKED_RECT lock;
  check("LockRect", texture->LockRect(0, &lock, nullptr, 0));
  for (int y = 0; y < 32; ++y) {
    auto *row = reinterpret_cast<float *>(static_cast<char *>(lock.pBits) + y * lock.Pitch);
    for (int x = 0; x < 32; ++x) {
      row[4 * x] = 0.5f + 0.5f * std::sin(0.5f * float(x));
      row[4 * x + 1] = 0.5f + 0.5f * std::cos(0.4f * float(y));
      row[4 * x + 2] = float(x ^ y) / 32.0f;
      row[4 * x + 3] = 1;
    }
  }
  texture->UnlockRect(0);
  return texture;
}

Device prepare() {
  const Target target = open("models");
  const Device d{target, makePicture(target.device), makeHeights(target.device)};
  D3DCAPS9 caps = {};
  d.device->GetDeviceCaps(&caps);
  std::fprintf(stderr, "vertex shaders %lx, pixel shaders %lx, clip planes %lu\n",
               caps.VertexShaderVersion, caps.PixelShaderVersion, caps.MaxUserClipPlanes);
  return d;
}

void setConstants(const Device &d) {
  float rows[8][4];
  for (int i = 0; i < 8; ++i)
    for (int c = 0; c < 4; ++c)
      rows[i][c] = 0.1f + 0.11f * float((i * 3 + c * 5) % 8);
  const int counts[4] = {3, 0, 1, 0};
  const BOOL on = TRUE;
  IDirect3DDevice9 *const device = d.device;
  device->SetVertexShaderConstantF(0, rows[0], 8);
  device->SetVertexShaderConstantI(0, counts, 1);
  device->SetVertexShaderConstantB(0, &on, 1);
  device->SetPixelShaderConstantI(0, counts, 1);
  device->SetRenderState(D3DRS_CULLMODE, D3DCULL_NONE);
  device->SetRenderState(D3DRS_ZENABLE, D3DZB_FALSE);
  device->SetTexture(0, d.picture);
  device->SetTexture(D3DVERTEXTEXTURESAMPLER0, d.heights);
  device->SetSamplerState(0, D3DSAMP_MINFILTER, D3DTEXF_LINEAR);
  device->SetSamplerState(0, D3DSAMP_MAGFILTER, D3DTEXF_LINEAR);
  device->SetSamplerState(0, D3DSAMP_MIPFILTER, D3DTEXF_LINEAR);
  device->SetSamplerState(D3DVERTEXTEXTURESAMPLER0, D3DSAMP_MINFILTER, D3DTEXF_POINT);
  device->SetSamplerState(D3DVERTEXTEXTURESAMPLER0, D3DSAMP_MAGFILTER, D3DTEXF_POINT);
}

const char *chosen(const char *text, bool inlined) {
  if (inlined && text == kCallVs)
    return kCallVsInline;
  return inlined && text == kCall3 ? kCall3Inline : text;
}

void useShaders(const Device &d, const Tile &tile, bool inlined) {
  IDirect3DVertexShader9 *vertex = nullptr;
  IDirect3DPixelShader9 *pixel = nullptr;
  const auto words = [](ID3DXBuffer *code) {
    return static_cast<const DWORD *>(code->GetBufferPointer());
  };
  check(tile.vertex,
        d.device->CreateVertexShader(words(assembled(chosen(tile.vertex, inlined))), &vertex));
  check(tile.pixel,
        d.device->CreatePixelShader(words(assembled(chosen(tile.pixel, inlined))), &pixel));
  check("SetVertexShader", d.device->SetVertexShader(vertex));
  check("SetPixelShader", d.device->SetPixelShader(pixel));
}

Vertex corner(int x, int y, bool turned) {
  const float u = float(x) / kSteps, v = float(y) / kSteps;
  const float across = 1.8f * u - 0.9f;
  return {{turned ? -across : across, 0.9f - 1.8f * v, 0.5f},
          {u, v, 1 - u, 0.5f * v},
          {u, 1 - v, 0.5f + 0.4f * (u - v), 1}};
}

void drawTile(const Device &d, int index, bool inlined) {
  const Tile &tile = kTiles[index];
  useTile(d, index);
  // A level of detail between two is implementation-dependent, and each lookup increases the
  // difference.
  d.device->SetSamplerState(0, D3DSAMP_MIPFILTER,
                            tile.pixel == kDependent ? D3DTEXF_NONE : D3DTEXF_LINEAR);
  useShaders(d, tile, inlined);
  std::vector<Vertex> vertices;
  for (int y = 0; y < kSteps; ++y)
    for (int x = 0; x < kSteps; ++x)
      for (const int c : {0, 1, 2, 2, 1, 3})
        vertices.push_back(corner(x + (c & 1), y + (c >> 1), tile.turned));
  check("DrawPrimitiveUP", d.device->DrawPrimitiveUP(D3DPT_TRIANGLELIST, UINT(vertices.size() / 3),
                                                     vertices.data(), sizeof(Vertex)));
}

void declare(const Device &d) {
  const D3DVERTEXELEMENT9 elements[] = {{0, offsetof(Vertex, position), D3DDECLTYPE_FLOAT3,
                                         D3DDECLMETHOD_DEFAULT, D3DDECLUSAGE_POSITION, 0},
                                        {0, offsetof(Vertex, uv), D3DDECLTYPE_FLOAT4,
                                         D3DDECLMETHOD_DEFAULT, D3DDECLUSAGE_TEXCOORD, 0},
                                        {0, offsetof(Vertex, color), D3DDECLTYPE_FLOAT4,
                                         D3DDECLMETHOD_DEFAULT, D3DDECLUSAGE_COLOR, 0},
                                        D3DDECL_END()};
  IDirect3DVertexDeclaration9 *declaration = nullptr;
  check("CreateVertexDeclaration", d.device->CreateVertexDeclaration(elements, &declaration));
  check("SetVertexDeclaration", d.device->SetVertexDeclaration(declaration));
}

} // namespace

/// "inline" replaces calls of subroutines by their code.
int main(int argc, char **argv) {
  const bool inlined = argc > 1 && !std::strcmp(argv[1], "inline");
  const Device d = prepare();
  d.device->Clear(0, nullptr, D3DCLEAR_TARGET, D3DCOLOR_XRGB(30, 30, 60), 1.0f, 0);
  check("BeginScene", d.device->BeginScene());
  setConstants(d);
  declare(d);
  for (int index = 0; index < kColumns * kRows; ++index)
    drawTile(d, index, inlined);
  check("EndScene", d.device->EndScene());
  save(d);
  d.device->Release();
  return 0;
}
