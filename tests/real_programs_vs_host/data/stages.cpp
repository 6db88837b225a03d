// Draws with Direct3D 8: fixed-function texture stages and pixel shaders 1.1, for Wine's ARB back
// end.
// usage: stages [FILE]     FILE becomes a PPM of the last frame
#include <cmath>
#include <cstdio>
#include <d3d8.h>
#include <windows.h>

namespace {

constexpr int kFrames = 12, kWidth = 300, kHeight = 200;
constexpr int kSide = 64;
constexpr DWORD kFormat = D3DFVF_XYZ | D3DFVF_DIFFUSE | D3DFVF_TEX2;

struct Vertex {
  float x, y, z;
  DWORD color;
  float u0, v0, u1, v1;
};

/// A quarter of a texel. Direct3D 8 has vertices at pixel centers. Without the offset whole columns
/// and rows would be sampled exactly at edges of texels, whose rounding is
/// implementation-dependent.
constexpr float kAside = 0.25F / kSide;
constexpr float kNone = kAside, kOnce = 1 + kAside, kTwice = 2 + kAside;
constexpr Vertex kQuad[] = {{-0.9F, -0.9F, 0.5F, 0xFFFF4020, kNone, kOnce, kNone, kTwice},
                            {-0.9F, 0.9F, 0.5F, 0xFF40FF20, kNone, kNone, kNone, kNone},
                            {0.9F, -0.9F, 0.5F, 0x802040FF, kOnce, kOnce, kTwice, kTwice},
                            {0.9F, 0.9F, 0.5F, 0xFFFFFFFF, kOnce, kNone, kTwice, kNone}};

// The shader is: ps.1.1; tex t0; tex t1; mul r0, t0, v0
constexpr DWORD kProduct[] = {0xFFFF0101, 0x42,       0xB00F0000, 0x42,       0xB00F0001,
                              0x05,       0x800F0000, 0xB0E40000, 0x90E40000, 0x0000FFFF};
// The shader is: ps.1.1; tex t0; tex t1; lrp r0, c0, t0, t1; mad r0, r0, v0, c1
constexpr DWORD kMixture[] = {
    0xFFFF0101, 0x42,       0xB00F0000, 0x42,       0xB00F0001, 0x12,       0x800F0000, 0xA0E40000,
    0xB0E40000, 0xB0E40001, 0x04,       0x800F0000, 0x80E40000, 0x90E40000, 0xA0E40001, 0x0000FFFF};

struct Stage {
  DWORD color, first, second;
};
constexpr Stage kStages[] = {{D3DTOP_MODULATE, D3DTA_TEXTURE, D3DTA_DIFFUSE},
                             {D3DTOP_ADDSIGNED, D3DTA_TEXTURE, D3DTA_DIFFUSE},
                             {D3DTOP_BLENDDIFFUSEALPHA, D3DTA_TEXTURE, D3DTA_TFACTOR},
                             {D3DTOP_DOTPRODUCT3, D3DTA_TEXTURE, D3DTA_DIFFUSE}};

/// Creates Direct3D by name, as the cross compiler has no import library of Direct3D 8.
IDirect3D8 *createDirect3D() {
  using Create = IDirect3D8 *(WINAPI *)(UINT);
  const HMODULE library = LoadLibraryA("d3d8.dll");
  if (!library)
    return nullptr;
  const auto create = reinterpret_cast<Create>(GetProcAddress(library, "Direct3DCreate8"));
  return create ? create(D3D_SDK_VERSION) : nullptr;
}

IDirect3DTexture8 *makeTexture(IDirect3DDevice8 *device, int turns) {
  IDirect3DTexture8 *texture = nullptr;
  if (device->CreateTexture(kSide, kSide, 1, 0, D3DFMT_A8R8G8B8, D3DPOOL_MANAGED, &texture) !=
      D3D_OK)
    return nullptr;
  D3DLOCKED_RECT lock;
  texture->LockRect(0, &lock, nullptr, 0);
  for (int y = 0; y < kSide; ++y) {
    auto *row = reinterpret_cast<DWORD *>(static_cast<char *>(lock.pBits) + y * lock.Pitch);
    for (int x = 0; x < kSide; ++x) {
      const auto wave = DWORD(127.5 + 127 * std::sin(0.1 * turns * (x + y)));
      row[x] = 0xFF000000 | wave << 16 | DWORD(4 * x) << 8 | DWORD(4 * y);
    }
  }
  texture->UnlockRect(0);
  return texture;
}

void drawTile(IDirect3DDevice8 *device, int tile) {
  const D3DVIEWPORT8 place = {DWORD(tile % 3) * 100, DWORD(tile / 3) * 100, 100, 100, 0, 1};
  device->SetViewport(&place);
  device->DrawPrimitiveUP(D3DPT_TRIANGLESTRIP, 2, kQuad, sizeof(Vertex));
}

void drawFrame(IDirect3DDevice8 *device, int frame, DWORD product, DWORD mixture) {
  device->Clear(0, nullptr, D3DCLEAR_TARGET, 0xFF203040, 1, 0);
  device->BeginScene();
  device->SetRenderState(D3DRS_TEXTUREFACTOR, 0xFF000000 | DWORD(frame * 20) << 8);
  int tile = 0;
  device->SetPixelShader(0);
  for (const Stage &stage : kStages) {
    device->SetTextureStageState(0, D3DTSS_COLOROP, stage.color);
    device->SetTextureStageState(0, D3DTSS_COLORARG1, stage.first);
    device->SetTextureStageState(0, D3DTSS_COLORARG2, stage.second);
    drawTile(device, tile++);
  }
  const float constants[8] = {float(frame) / kFrames, 0.3F, 0.8F, 1, 0.1F, 0, 0.1F, 0};
  device->SetPixelShaderConstant(0, constants, 2);
  const DWORD shaders[] = {product, mixture};
  for (const DWORD shader : shaders) {
    device->SetPixelShader(shader);
    drawTile(device, tile++);
  }
  device->EndScene();
}

/// Writes the drawn picture before it is shown.
bool write(IDirect3DDevice8 *device, const char *path) {
  IDirect3DSurface8 *drawn = nullptr, *copy = nullptr;
  D3DLOCKED_RECT lock;
  if (device->GetBackBuffer(0, D3DBACKBUFFER_TYPE_MONO, &drawn) != D3D_OK ||
      device->CreateImageSurface(kWidth, kHeight, D3DFMT_X8R8G8B8, &copy) != D3D_OK ||
      device->CopyRects(drawn, nullptr, 0, copy, nullptr) != D3D_OK ||
      copy->LockRect(&lock, nullptr, D3DLOCK_READONLY) != D3D_OK)
    return false;
  std::FILE *const file = std::fopen(path, "wb");
  if (!file)
    return false;
  std::fprintf(file, "P6\n%d %d\n255\n", kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const unsigned char *const bgr =
          static_cast<const unsigned char *>(lock.pBits) + y * lock.Pitch + 4 * x;
      for (int c = 2; c >= 0; --c)
        std::fputc(bgr[c], file);
    }
  copy->UnlockRect();
  copy->Release();
  drawn->Release();
  return std::fclose(file) == 0;
}

} // namespace

int main(int count, char **arguments) {
  WNDCLASSA kind = {};
  kind.lpfnWndProc = DefWindowProcA;
  kind.lpszClassName = "stages";
  RegisterClassA(&kind);
  HWND window = CreateWindowA("stages", "stages", WS_POPUP | WS_VISIBLE, 0, 0, kWidth, kHeight,
                              nullptr, nullptr, nullptr, nullptr);
  IDirect3D8 *direct3d = createDirect3D();
  if (!direct3d)
    return 1;
  D3DPRESENT_PARAMETERS shown = {};
  shown.Windowed = TRUE;
  shown.SwapEffect = D3DSWAPEFFECT_DISCARD;
  shown.BackBufferFormat = D3DFMT_X8R8G8B8;
  shown.BackBufferWidth = kWidth;
  shown.BackBufferHeight = kHeight;
  shown.BackBufferCount = 1;
  shown.hDeviceWindow = window;
  IDirect3DDevice8 *device = nullptr;
  if (direct3d->CreateDevice(0, D3DDEVTYPE_HAL, window, D3DCREATE_HARDWARE_VERTEXPROCESSING, &shown,
                             &device) != D3D_OK)
    return 2;
  device->SetVertexShader(kFormat);
  device->SetRenderState(D3DRS_LIGHTING, FALSE);
  device->SetRenderState(D3DRS_CULLMODE, D3DCULL_NONE);
  device->SetTexture(0, makeTexture(device, 3));
  device->SetTexture(1, makeTexture(device, 7));
  DWORD product = 0, mixture = 0;
  if (device->CreatePixelShader(kProduct, &product) != D3D_OK ||
      device->CreatePixelShader(kMixture, &mixture) != D3D_OK)
    return 3;
  for (int frame = 0; frame < kFrames; ++frame) {
    drawFrame(device, frame, product, mixture);
    if (frame == kFrames - 1 && count > 1 && !write(device, arguments[1]))
      return 4;
    device->Present(nullptr, nullptr, nullptr, nullptr);
  }
  device->Release();
  direct3d->Release();
  DestroyWindow(window);
  return 0;
}
