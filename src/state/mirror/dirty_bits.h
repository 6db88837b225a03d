#pragma once
#include <cstdint>

/// Groups of the host's state that may have changed since the mirror queried them. An entry point
/// that changes state sets bits in ContextHot::dirty and calls the host. A draw queries the groups
/// whose bits are set, and no others. The rows of software.toml name these bits.
namespace arbiter::state::dirty {
inline constexpr std::uint32_t kTextureBindings = 1u << 0; ///< bound textures, active unit, sampler
                                                           ///< objects
inline constexpr std::uint32_t kTextureParameters =
    1u << 1; ///< filters, wraps, levels, LOD bias of units
inline constexpr std::uint32_t kFramebuffer =
    1u << 2; ///< bindings, attachments, draw and read buffers
inline constexpr std::uint32_t kViewport = 1u << 3; ///< viewport, depth range, scissor
inline constexpr std::uint32_t kRaster =
    1u << 4; ///< cull, front face, modes, offset, shade model, points, lines, stipples, provoking
inline constexpr std::uint32_t kPixelOps =
    1u << 5; ///< alpha, blend, depth, stencil, logic, masks, clamp, dither, multisample
inline constexpr std::uint32_t kTransform =
    1u << 6; ///< all matrices, with the modelview matrix; normalise, rescale, clip planes
inline constexpr std::uint32_t kLighting =
    1u << 7; ///< lights, light model, colour material, and materials
inline constexpr std::uint32_t kTexGen = 1u << 8;   ///< texgen, point sprite
inline constexpr std::uint32_t kArrays = 1u << 9;   ///< pointers, enables, buffer bindings, VAO
inline constexpr std::uint32_t kCurrent = 1u << 10; ///< current vertex attributes
inline constexpr std::uint32_t kFog = 1u << 11;     ///< fog parameters
inline constexpr std::uint32_t kQueries =
    1u << 12; ///< occlusion queries, feedback, conditional rendering
inline constexpr std::uint32_t kPixelStore = 1u << 13; ///< pack, unpack, transfer, pixel buffers
inline constexpr std::uint32_t kProgramState =
    1u << 14;                                       ///< any state that a program's parameters name
inline constexpr std::uint32_t kBuffers = 1u << 15; ///< contents of buffer objects
inline constexpr std::uint32_t kRasterPosition = 1u << 16; ///< with the values that belong to it
inline constexpr std::uint32_t kModelview = 1u << 17;      ///< the modelview matrix alone
inline constexpr std::uint32_t kMaterial = 1u << 18;       ///< values of materials
inline constexpr int kGroups = 19;
// These are no groups: GenerationCounter::take() says which group they count as.
inline constexpr std::uint32_t kMatrix = 1u << 19;     ///< the matrix that MATRIX_MODE names
inline constexpr std::uint32_t kMatrixMode = 1u << 20; ///< which matrix MATRIX_MODE names
inline constexpr std::uint32_t kAll = ~0u;
} // namespace arbiter::state::dirty
