#pragma once

/// Finds the layer's entry points by name. Generated from gl.xml and entry_points.toml.
namespace arbiter::dispatch {

struct EntryPoint {
  /// The layer's function, or null if the command is not intercepted.
  void *function = nullptr;
  /// True if the layer offers the command even if the host lacks it.
  bool provided = false;
  /// True if the entry point serves the rasterizer only. With the host as backend, the host's own
  /// function is used.
  bool forSoftware = false;
  /// True if the entry point is also needed with the host as backend when generic vertex attributes
  /// may alias the conventional ones.
  bool forAliases = false;
};

/// Finds an entry point. \param name includes the gl prefix; any name of an alias group
[[nodiscard]] EntryPoint find(const char *name);

/// Finds the entry points that serve only the rasterizer or aliasing attributes and have no row in
/// entry_points.toml. Returns an empty one for all others.
[[nodiscard]] EntryPoint findForSoftware(const char *name);
[[nodiscard]] bool isForSoftware(const void *function);

/// True if `function` is one of the layer's entry points. A function of the host never is.
[[nodiscard]] bool isOurs(const void *function);

} // namespace arbiter::dispatch
