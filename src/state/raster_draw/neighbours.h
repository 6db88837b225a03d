#pragma once
namespace arbiter::state {

class Context;

/// Before an EGLImage is made of an object of GL's, or of memory of other interfaces, and before
/// such memory is imported: from then on pixels may change by commands of any context, API or
/// process, none of which the layer sees (GL_OES_EGL_image, GL_EXT_memory_object). Draws of all
/// contexts are the host's for the rest of the process.
void imagesEscape();

} // namespace arbiter::state

/// Which other contexts may change what a context knows: those of its share group, which change its
/// textures, renderbuffers and buffers, and those that are current with the same window or pbuffer.
///
/// What a context keeps of such objects (residency's images, the mirror's answers, copies of
/// buffers) is its own, so that no context ever touches what another thread draws with. It is good
/// for as long as no neighbour was current: a draw looks at one number, NeighbourEpoch. While a
/// neighbour is current nothing is kept from one command to the next, and draws are the host's.
///
/// What a context keeps of a window while it is current nowhere is good until another context
/// becomes current with that window, which takes it away.
///
/// A context that stays current need not be told of anything: the application must order its
/// contexts' commands anyway (OpenGL 4.6, 5.3), by whatever it uses to do so, and a neighbour's
/// epoch moves before that neighbour's first command and after its last one.
namespace arbiter::state::software {

struct Drawable;

/// A context is made, or freed.
void addNeighbour(Context &context);
void removeNeighbour(Context &context);
/// The host made the context current, with what becomes Context::drawable; before the application
/// goes on.
void becomesCurrent(Context &context, const Drawable &drawable);
/// The host took it away from its thread, or gives it another drawable.
void ceasesToBeCurrent(Context &context);

} // namespace arbiter::state::software
