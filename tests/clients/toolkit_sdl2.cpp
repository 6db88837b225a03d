/// Uses SDL2 for a window, and finds GL by SDL_GL_GetProcAddress.
#include <SDL.h>

#include "body.h"

int main(int, char **) {
  using namespace clients;
  if (SDL_Init(SDL_INIT_VIDEO) != 0)
    die("SDL_Init:", SDL_GetError());
  SDL_Window *const window = SDL_CreateWindow("client", 0, 0, 64, 64, SDL_WINDOW_OPENGL);
  const SDL_GLContext context = window ? SDL_GL_CreateContext(window) : nullptr;
  if (!context)
    die("SDL context:", SDL_GetError());
  const bool right = drawAndReport(load(SDL_GL_GetProcAddress), "sdl2");
  SDL_GL_SwapWindow(window);
  SDL_GL_DeleteContext(context);
  SDL_DestroyWindow(window);
  SDL_Quit();
  return right ? 0 : 1;
}
