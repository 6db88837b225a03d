#pragma once

/// The layer's entry points by name. Generated from gl.xml and entry_points.toml.
namespace arbiter::dispatch {

struct EntryPoint {
  /// The layer's function, or null: the command is not intercepted.
  void *function = nullptr;
  /// The layer offers it even where the host lacks it.
  bool provided = false;
  /// There for the rasterizer alone: with the host as backend the host's own function serves.
  bool forSoftware = false;
  /// That serves all the same where generic vertex attributes may be the conventional ones.
  bool forAliases = false;
};

/// `name` with its gl prefix, any name of an alias group.
[[nodiscard]] EntryPoint find(const char *name);

/// The entry points that exist for the rasterizer alone, or for attributes that alias, and are in
/// no row of entry_points.toml; none of all others.
[[nodiscard]] EntryPoint findForSoftware(const char *name);
[[nodiscard]] bool isForSoftware(const void *function);

/// True if `function` is one of the layer's entry points: the host's can never be.
[[nodiscard]] bool isOurs(const void *function);

} // namespace arbiter::dispatch
