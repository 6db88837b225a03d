#pragma once
#include <functional>

/// What the programs of this folder share: a GL context, and a scene whose picture is known.
namespace foreign {

/// A window (GLX) or, where the environment has FOREIGN_EGL, a pbuffer (EGL) of 64x64 with a
/// compatibility context, current on this thread. Ends the process with 3 if there is none.
void openContext();
/// Makes that context current on this thread, or releases it.
void makeCurrent(bool current);
/// Runs the body on this thread with another context, which shares objects with that one; the
/// threads of both must be Xlib's to know (XInitThreads).
void onOtherContext(const std::function<void()> &body);
/// Deletes what drawFrame() samples. Where it is bound in another context it goes on to exist.
void deleteTextures();
/// Draws a frame with programs of several kinds (the vertex program samples a texture, where the
/// environment has FOREIGN_VERTEX_TEXTURE), each a new one for the compiler where `fresh` is
/// set, reads its picture, which is the same each time, and shows it.
void drawFrame(bool fresh = false);
/// One frame, and of its picture each fourth pixel of each fourth row as "picture HEX".
void drawAndPrint();
/// Bitmaps of a new picture, and reads it; many, so that what comes at any time mostly finds one
/// under way.
void drawBitmaps();
/// A draw of 512x512 pixels that take long, into a texture of its own from now on, which takes some
/// milliseconds of every thread.
void drawManyPixels();
/// A bitmap of drawBitmaps(), or the draw of drawManyPixels(), is under way; to be asked in
/// handlers.
bool isInMidst();
/// Draws frames for ever.
[[noreturn]] void drawForEver(bool fresh);
/// Runs the body on a thread of its own with that much stack, and joins it.
void onThread(unsigned long stackBytes, const std::function<void()> &body);
/// "WHAT failed", and the end with status 4, unless `good`.
void need(bool good, const char *what);

} // namespace foreign
