#pragma once
namespace arbiter::state {

struct RasterContext;

/// Ends shadows in all contexts for the rest of the process: the host draws everything. Called
/// before an EGLImage is made from a GL object or from memory of another interface, and before such
/// memory is imported. From then on commands of any context, API or process may change pixels
/// unseen (GL_OES_EGL_image, GL_EXT_memory_object).
void imagesEscape();

} // namespace arbiter::state

/// Tracks the neighbours of each context: other contexts that may change what it knows. Contexts of
/// its share group may change its textures, renderbuffers and buffers; so may contexts that are
/// current with the same window or pbuffer.
///
/// A context keeps its own knowledge of such objects (residency's images, the mirror's answers,
/// copies of buffers), so no context touches what another thread draws with. That knowledge is
/// valid as long as no neighbour was current: a draw compares one number, NeighbourEpoch. While a
/// neighbour is current, nothing is kept from one command to the next and the host draws.
///
/// A context that is not current keeps what it knows of its window until another context becomes
/// current with that window.
///
/// A context that stays current needs no notice. The application must order its contexts' commands
/// anyway (OpenGL 4.6, 5.3), and the epoch moves before a neighbour's first command and after its
/// last.
namespace arbiter::state {

struct Drawable;

/// Add a context when it is made, and remove it when it is freed.
void addNeighbour(RasterContext &context);
void removeNeighbour(RasterContext &context);
/// Notes that the host has made the context current with `drawable`, which becomes
/// RasterContext::drawable. Called before the application goes on.
void becomesCurrent(RasterContext &context, const Drawable &drawable);
/// Notes that the host takes the context from its thread, or gives it another drawable.
void ceasesToBeCurrent(RasterContext &context);

} // namespace arbiter::state
