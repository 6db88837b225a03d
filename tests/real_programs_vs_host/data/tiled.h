// Parts of the Direct3D 9 programs that draw twelve tiles into an off-screen target.
#pragma once
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <d3d9.h>
#include <d3dx9shader.h>

inline constexpr int kTile = 128, kColumns = 4, kRows = 3;
inline constexpr int kWidth = kTile * kColumns, kHeight = kTile * kRows;

struct Target {
  IDirect3DDevice9 *device = nullptr;
  IDirect3DSurface9 *target = nullptr;
};

[[noreturn]] inline void fail(const char *what, HRESULT code) {
  std::fprintf(stderr, "%s: 0x%08lx\n", what, static_cast<unsigned long>(code));
  std::exit(1);
}

inline void check(const char *what, HRESULT code) {
  if (FAILED(code))
    fail(what, code);
}

/// Opens a device that draws into a target of all tiles.
inline Target open(const char *name) {
  Target d;
  HWND window = CreateWindowA("static", name, WS_OVERLAPPEDWINDOW, 0, 0, kWidth, kHeight, nullptr,
                              nullptr, nullptr, nullptr);
  IDirect3D9 *d3d = Direct3DCreate9(D3D_SDK_VERSION);
  D3DPRESENT_PARAMETERS p = {};
  p.Windowed = TRUE;
  p.SwapEffect = D3DSWAPEFFECT_DISCARD;
  p.BackBufferFormat = D3DFMT_X8R8G8B8;
  p.BackBufferWidth = kWidth;
  p.BackBufferHeight = kHeight;
  p.hDeviceWindow = window;
  check("CreateDevice", d3d->CreateDevice(D3DADAPTER_DEFAULT, D3DDEVTYPE_HAL, window,
                                          D3DCREATE_HARDWARE_VERTEXPROCESSING, &p, &d.device));
  check("CreateRenderTarget",
        d.device->CreateRenderTarget(kWidth, kHeight, D3DFMT_X8R8G8B8, D3DMULTISAMPLE_NONE, 0,
                                     FALSE, &d.target, nullptr));
  check("SetRenderTarget", d.device->SetRenderTarget(0, d.target));
  return d;
}

/// Returns the code of a shader; ends the process if its text is wrong.
inline ID3DXBuffer *assembled(const char *text) {
  ID3DXBuffer *code = nullptr, *errors = nullptr;
  const HRESULT result =
      D3DXAssembleShader(text, UINT(std::strlen(text)), nullptr, nullptr, 0, &code, &errors);
  if (FAILED(result)) {
    std::fprintf(stderr, "%s", text);
    fail(errors ? static_cast<const char *>(errors->GetBufferPointer()) : text, result);
  }
  return code;
}

/// Draws into a tile from now on.
inline void useTile(const Target &d, int index) {
  const D3DVIEWPORT9 view = {DWORD(index % kColumns * kTile),
                             DWORD(index / kColumns * kTile),
                             DWORD(kTile),
                             DWORD(kTile),
                             0.0f,
                             1.0f};
  d.device->SetViewport(&view);
}

/// Writes the target to o.ppm.
inline void save(const Target &d) {
  IDirect3DSurface9 *copy = nullptr;
  check("CreateOffscreenPlainSurface",
        d.device->CreateOffscreenPlainSurface(kWidth, kHeight, D3DFMT_X8R8G8B8, D3DPOOL_SYSTEMMEM,
                                              &copy, nullptr));
  check("GetRenderTargetData", d.device->GetRenderTargetData(d.target, copy));
  D3DLOCKED_RECT lock;
  check("LockRect", copy->LockRect(&lock, nullptr, D3DLOCK_READONLY));
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const DWORD p = static_cast<const DWORD *>(lock.pBits)[y * lock.Pitch / 4 + x];
      rgb.insert(rgb.end(), {std::uint8_t(p >> 16), std::uint8_t(p >> 8), std::uint8_t(p)});
    }
  std::FILE *file = std::fopen("o.ppm", "wb");
  if (!file)
    fail("o.ppm", 0);
  std::fprintf(file, "P6\n%d %d\n255\n", kWidth, kHeight);
  std::fwrite(rgb.data(), 1, rgb.size(), file);
  std::fclose(file);
}
