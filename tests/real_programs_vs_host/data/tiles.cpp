// A Direct3D 9 program that draws twelve tiles into an off-screen target, one technique each, and
// writes them to o.ppm: pixel shaders 1.1, 1.4 and 2.0, and fixed-function texture stages.
#include <cmath>

#include "tiled.h"

namespace {

struct Vertex {
  float x, y, z;           // in the tile's own viewport, z the depth
  DWORD diffuse, specular; // ARGB
  float uv[2][2];
};
constexpr DWORD kFormat = D3DFVF_XYZ | D3DFVF_DIFFUSE | D3DFVF_SPECULAR | D3DFVF_TEX2;

constexpr char kModulate11[] = "ps_1_1\n"
                               "def c0, 0.5, 0.25, 0.75, 1.0\n"
                               "tex t0\n"
                               "tex t1\n"
                               "mul r0, t0, v0\n"
                               "mad_sat r0.rgb, t1, c0, r0\n"
                               "+mov r0.a, t0.a\n";
// Bump lighting expands a normal and a light from [0, 1] to [-1, 1].
constexpr char kBump11[] = "ps_1_1\n"
                           "def c1, 0.1, 0.1, 0.2, 1.0\n"
                           "tex t0\n"
                           "tex t1\n"
                           "dp3_sat r1, t1_bx2, v0_bx2\n"
                           "mad r0, r1, t0, c1\n";
constexpr char kTexbem11[] = "ps_1_1\n"
                             "tex t0\n"
                             "texbem t1, t0\n"
                             "lrp r0, v0, t1, 1-t0\n";
constexpr char kCnd11[] = "ps_1_1\n"
                          "def c0, 1.0, 0.2, 0.1, 1.0\n"
                          "tex t0\n"
                          "mov r0, t0\n"
                          "mul r0.a, t0.g, v0.a\n"
                          "mad r0.a, v1.b, t0.b, r0.a\n"
                          "cnd r0, r0.a, c0, t0\n";
// This has two phases: the first one's result is a texture coordinate.
constexpr char kDependent14[] = "ps_1_4\n"
                                "def c0, 0.15, 0.15, 0.0, 0.0\n"
                                "texld r0, t0\n"
                                "texcrd r1.rgb, t1\n"
                                "mad r2.rgb, r0_bx2, c0, r1\n"
                                "phase\n"
                                "texld r1, r2\n"
                                "mul_x2 r0, r1, v0\n";
constexpr char kCmp14[] = "ps_1_4\n"
                          "def c1, 0.0, 0.6, 1.0, 1.0\n"
                          "texld r0, t0\n"
                          "texld r1, t1\n"
                          "sub r2, r0, r1\n"
                          "cmp r0, r2, c1, r1\n"
                          "add_d2 r0, r0, v0\n";
constexpr char kSpecular20[] = "ps_2_0\n"
                               "def c0, 2.0, -1.0, 16.0, 0.3\n"
                               "def c1, 0.9, 0.8, 0.5, 1.0\n"
                               "dcl t0.xy\n"
                               "dcl v0\n"
                               "dcl_2d s0\n"
                               "dcl_2d s1\n"
                               "texld r0, t0, s1\n"
                               "mad r0, r0, c0.x, c0.y\n"
                               "nrm r1, r0\n"
                               "mad r2.xyz, v0, c0.x, c0.y\n"
                               "dp3_sat r1.x, r1, r2\n"
                               "pow r1.w, r1.x, c0.z\n"
                               "texld r3, t0, s0\n"
                               "mad r3.xyz, r3, r1.x, c0.w\n"
                               "mad r3, c1, r1.w, r3\n"
                               "mov oC0, r3\n";
constexpr char kDistance20[] = "ps_2_0\n"
                               "def c0, 0.5, 12.0, 1.0, 0.0\n"
                               "def c2, 0.25, 0.6, 1.0, 1.0\n"
                               "dcl t0.xy\n"
                               "dcl_2d s0\n"
                               "sub r0.xy, t0, c0.x\n"
                               "mul r0.xy, r0, r0\n"
                               "add r0.x, r0.x, r0.y\n"
                               "rsq r0.y, r0.x\n"
                               "rcp r0.y, r0.y\n"
                               "mul r0.z, r0.y, c0.y\n"
                               "frc r0.z, r0.z\n"
                               "texld r1, t0, s0\n"
                               "lrp r2, r0.z, r1, c2\n"
                               "sub r0.w, r0.z, c0.x\n"
                               "cmp r2.xyz, r0.w, r2, r1\n"
                               "exp r3.x, -r0.y\n"
                               "mul r2, r2, r3.x\n"
                               "mov oC0, r2\n";
constexpr char kKill20[] = "ps_2_0\n"
                           "def c0, 0.4, 1.0, 3.1415927, 0.5\n"
                           "dcl t0.xyz\n"
                           "dcl t1.xy\n"
                           "dcl v0\n"
                           "dcl_2d s0\n"
                           "dcl_2d s1\n"
                           "texld r0, t0, s0\n"
                           "sub r1, r0.x, c0.x\n"
                           "texkill r1\n"
                           "mad r2.x, t1.x, c0.z, c0.w\n"
                           "log r3.x, r2.x\n"
                           "dp2add r3.y, t1, t1, c0.w\n"
                           "abs r3.xy, r3\n"
                           "mov r4, v0\n"
                           "mad r4.xy, r3, c0.w, r4\n"
                           "texld r5, t1, s1\n"
                           "mul r4, r4, r5\n"
                           "mov oC0, r4\n";

struct Device : Target {
  IDirect3DTexture9 *picture = nullptr, *normals = nullptr;
};

IDirect3DTexture9 *makeTexture(IDirect3DDevice9 *device, DWORD (*texel)(int, int)) {
  IDirect3DTexture9 *texture = nullptr;
  check("CreateTexture",
        device->CreateTexture(64, 64, 1, 0, D3DFMT_A8R8G8B8, D3DPOOL_MANAGED, &texture, nullptr));
  D3DLOCKED_RECT lock;
  check("LockRect", texture->LockRect(0, &lock, nullptr, 0));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      static_cast<DWORD *>(lock.pBits)[y * lock.Pitch / 4 + x] = texel(x, y);
  texture->UnlockRect(0);
  return texture;
}

DWORD pictureTexel(int x, int y) {
  const bool check = ((x / 8) ^ (y / 8)) & 1;
  return D3DCOLOR_ARGB(x * 4, check ? 40 + x * 3 : 200 - y * 2, y * 4, check ? 90 : 250 - x * 2);
}

DWORD normalTexel(int x, int y) {
  const float dx = std::sin(x * 0.4f), dy = std::cos(y * 0.3f), dz = 1.2f;
  const float scale = 127.0f / std::sqrt(dx * dx + dy * dy + dz * dz);
  return D3DCOLOR_ARGB(255, int(128 + dx * scale), int(128 + dy * scale), int(128 + dz * scale));
}

Device prepare() {
  const Target target = open("tiles");
  return {target, makeTexture(target.device, pictureTexel),
          makeTexture(target.device, normalTexel)};
}

void defaults(const Device &d) {
  IDirect3DDevice9 *const device = d.device;
  device->SetPixelShader(nullptr);
  device->SetRenderState(D3DRS_LIGHTING, FALSE);
  device->SetRenderState(D3DRS_CULLMODE, D3DCULL_NONE);
  device->SetRenderState(D3DRS_ZENABLE, D3DZB_FALSE);
  device->SetRenderState(D3DRS_SPECULARENABLE, FALSE);
  device->SetRenderState(D3DRS_ALPHATESTENABLE, FALSE);
  device->SetRenderState(D3DRS_ALPHABLENDENABLE, FALSE);
  device->SetRenderState(D3DRS_FOGENABLE, FALSE);
  device->SetTexture(0, d.picture);
  device->SetTexture(1, d.normals);
  for (DWORD stage = 0; stage < 2; ++stage) {
    device->SetSamplerState(stage, D3DSAMP_MINFILTER, D3DTEXF_LINEAR);
    device->SetSamplerState(stage, D3DSAMP_MAGFILTER, D3DTEXF_LINEAR);
    device->SetTextureStageState(stage, D3DTSS_COLOROP, D3DTOP_DISABLE);
    device->SetTextureStageState(stage, D3DTSS_ALPHAOP, D3DTOP_DISABLE);
    device->SetTextureStageState(stage, D3DTSS_TEXCOORDINDEX, stage);
  }
  const float bump[4] = {0.1f, 0.02f, -0.03f, 0.12f};
  const D3DTEXTURESTAGESTATETYPE slot[4] = {D3DTSS_BUMPENVMAT00, D3DTSS_BUMPENVMAT01,
                                            D3DTSS_BUMPENVMAT10, D3DTSS_BUMPENVMAT11};
  for (int i = 0; i < 4; ++i) {
    DWORD bits;
    std::memcpy(&bits, &bump[i], sizeof bits);
    device->SetTextureStageState(1, slot[i], bits);
  }
}

void stage(const Device &d, DWORD index, DWORD op, DWORD first, DWORD second) {
  d.device->SetTextureStageState(index, D3DTSS_COLOROP, op);
  d.device->SetTextureStageState(index, D3DTSS_COLORARG1, first);
  d.device->SetTextureStageState(index, D3DTSS_COLORARG2, second);
  d.device->SetTextureStageState(index, D3DTSS_ALPHAOP, D3DTOP_SELECTARG1);
  d.device->SetTextureStageState(index, D3DTSS_ALPHAARG1, first);
}

void shader(const Device &d, const char *text) {
  IDirect3DPixelShader9 *pixel = nullptr;
  check(text, d.device->CreatePixelShader(
                  static_cast<const DWORD *>(assembled(text)->GetBufferPointer()), &pixel));
  check("SetPixelShader", d.device->SetPixelShader(pixel));
}

void fog(const Device &d) {
  const float start = 0.0f, end = 1.0f;
  DWORD bits;
  d.device->SetRenderState(D3DRS_FOGENABLE, TRUE);
  d.device->SetRenderState(D3DRS_FOGCOLOR, D3DCOLOR_XRGB(40, 160, 60));
  d.device->SetRenderState(D3DRS_FOGTABLEMODE, D3DFOG_LINEAR);
  std::memcpy(&bits, &start, sizeof bits);
  d.device->SetRenderState(D3DRS_FOGSTART, bits);
  std::memcpy(&bits, &end, sizeof bits);
  d.device->SetRenderState(D3DRS_FOGEND, bits);
}

void technique(const Device &d, int index) {
  switch (index) {
  case 0:
    stage(d, 0, D3DTOP_MODULATE, D3DTA_TEXTURE, D3DTA_DIFFUSE);
    break;
  case 1:
    stage(d, 0, D3DTOP_ADDSIGNED, D3DTA_TEXTURE, D3DTA_DIFFUSE);
    stage(d, 1, D3DTOP_DOTPRODUCT3, D3DTA_TEXTURE, D3DTA_CURRENT);
    d.device->SetRenderState(D3DRS_SPECULARENABLE, TRUE);
    break;
  case 2:
    stage(d, 0, D3DTOP_BLENDTEXTUREALPHA, D3DTA_TEXTURE, D3DTA_DIFFUSE);
    stage(d, 1, D3DTOP_SUBTRACT, D3DTA_CURRENT, D3DTA_TEXTURE | D3DTA_COMPLEMENT);
    fog(d);
    break;
  case 3:
    shader(d, kModulate11);
    break;
  case 4:
    shader(d, kBump11);
    break;
  case 5:
    shader(d, kTexbem11);
    break;
  case 6:
    shader(d, kCnd11);
    break;
  case 7:
    shader(d, kDependent14);
    break;
  case 8:
    shader(d, kCmp14);
    break;
  case 9:
    shader(d, kSpecular20);
    break;
  case 10:
    shader(d, kDistance20);
    fog(d);
    break;
  default:
    shader(d, kKill20);
    break;
  }
}

void drawTile(const Device &d, int index) {
  useTile(d, index);
  // The corners have different depths and colors, so that a mistake in any input is visible.
  const float x[4] = {-0.95f, 0.95f, -0.95f, 0.95f}, y[4] = {0.95f, 0.95f, -0.95f, -0.95f};
  const float z[4] = {0.1f, 0.4f, 0.6f, 0.9f};
  const DWORD diffuse[4] = {0xffff8080, 0xc080ff80, 0x808080ff, 0xffffffff};
  const DWORD specular[4] = {0x00200000, 0x40002000, 0x80000020, 0xff202020};
  Vertex corners[4];
  for (int i = 0; i < 4; ++i)
    corners[i] = {x[i],        y[i],
                  z[i],        diffuse[i],
                  specular[i], {{float(i & 1), float(i >> 1)}, {1.5f * (i & 1), 0.75f * (i >> 1)}}};
  d.device->SetFVF(kFormat);
  check("DrawPrimitiveUP",
        d.device->DrawPrimitiveUP(D3DPT_TRIANGLESTRIP, 2, corners, sizeof corners[0]));
}

} // namespace

int main() {
  const Device d = prepare();
  d.device->Clear(0, nullptr, D3DCLEAR_TARGET, D3DCOLOR_XRGB(30, 30, 60), 1.0f, 0);
  check("BeginScene", d.device->BeginScene());
  // Wine ignores the first stage's texture until a draw has used two, so that the second tile is
  // drawn first.
  for (int draw = 0; draw <= kColumns * kRows; ++draw) {
    const int index = draw == 0 ? 1 : draw - 1;
    defaults(d);
    technique(d, index);
    drawTile(d, index);
  }
  check("EndScene", d.device->EndScene());
  save(d);
  d.device->Release();
  return 0;
}
