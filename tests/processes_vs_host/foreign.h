#pragma once
#include <functional>

/// Shared parts of the programs in this folder: a GL context, and a scene with a known picture.
namespace foreign {

/// Makes a window (GLX) or, if the environment has FOREIGN_EGL, a pbuffer (EGL) of 64x64 with a
/// compatibility context, current on this thread. Exits the process with 3 if it cannot.
void openContext();
/// Makes that context current on this thread, or releases it.
void makeCurrent(bool current);
/// Runs the body on this thread with another context, which shares objects with that one. Xlib must
/// know the threads of both (XInitThreads).
void onOtherContext(const std::function<void()> &body);
/// Deletes the textures that drawFrame() samples. They continue to exist while bound in another
/// context.
void deleteTextures();
/// Draws a frame with programs of several kinds, reads its picture, which is the same each time,
/// and shows it. The vertex program samples a texture if the environment has
/// FOREIGN_VERTEX_TEXTURE. If `fresh` is set, each program is new to the compiler.
void drawFrame(bool fresh = false);
/// Draws one frame, and prints each fourth pixel of each fourth row of its picture as "picture
/// HEX".
void drawAndPrint();
/// Draws many bitmaps of a new picture and reads it. An asynchronous event mostly interrupts a
/// bitmap.
void drawBitmaps();
/// Draws 512x512 slow pixels to a texture, which takes some milliseconds of every thread. The
/// texture stays the target.
void drawManyPixels();
/// True if a bitmap of drawBitmaps(), or the draw of drawManyPixels(), is in progress; for signal
/// handlers.
bool isInMidst();
/// Draws frames forever.
[[noreturn]] void drawForEver(bool fresh);
/// Runs the body on a thread with that much stack, and joins it.
void onThread(unsigned long stackBytes, const std::function<void()> &body);
/// Prints "WHAT failed" and exits with status 4, unless `good`.
void need(bool good, const char *what);

} // namespace foreign
