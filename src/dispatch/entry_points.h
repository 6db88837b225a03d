#pragma once

/// The layer's entry points by name. Generated from gl.xml and entry_points.toml.
namespace arbiter::dispatch {

struct EntryPoint {
  /// Ours, or null: the command is not intercepted.
  void *function = nullptr;
  /// The layer offers it even where the host lacks it.
  bool provided = false;
};

/// `name` with its gl prefix, any name of an alias group.
[[nodiscard]] EntryPoint find(const char *name);

/// True if `function` is one of the layer's entry points: the host's can never be.
[[nodiscard]] bool isOurs(const void *function);

} // namespace arbiter::dispatch
