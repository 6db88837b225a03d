"""The states whose pairs are drawn, by name and by the client's value: GL's number, or a choice of the client
(state_*.cpp). The first value of a factor is GL's default or the simplest."""

import zlib

ENUMS = {
    # blending
    "zero": 0, "one": 1, "src_color": 0x0300, "one_minus_src_color": 0x0301, "src_alpha": 0x0302,
    "one_minus_src_alpha": 0x0303, "dst_alpha": 0x0304, "one_minus_dst_alpha": 0x0305,
    "dst_color": 0x0306, "one_minus_dst_color": 0x0307, "src_alpha_saturate": 0x0308,
    "constant_color": 0x8001, "one_minus_constant_color": 0x8002, "constant_alpha": 0x8003,
    "one_minus_constant_alpha": 0x8004, "add": 0x8006, "min": 0x8007, "max": 0x8008,
    "subtract": 0x800A, "reverse_subtract": 0x800B,
    # comparisons and stencil
    "never": 0x0200, "less": 0x0201, "equal": 0x0202, "lequal": 0x0203, "greater": 0x0204,
    "notequal": 0x0205, "gequal": 0x0206, "always": 0x0207, "keep": 0x1E00, "replace": 0x1E01,
    "incr": 0x1E02, "decr": 0x1E03, "invert": 0x150A, "incr_wrap": 0x8507, "decr_wrap": 0x8508,
    # rasterization
    "front": 0x0404, "back": 0x0405, "cw": 0x0900, "ccw": 0x0901, "point": 0x1B00, "line": 0x1B01,
    "fill": 0x1B02, "flat": 0x1D00, "smooth": 0x1D01, "first": 0x8E4D, "last": 0x8E4E,
    # textures
    "1d": 0x0DE0, "2d": 0x0DE1, "3d": 0x806F, "cube": 0x8513, "rect": 0x84F5,
    "nearest": 0x2600, "linear": 0x2601, "nearest_mip_nearest": 0x2700,
    "linear_mip_nearest": 0x2701, "nearest_mip_linear": 0x2702, "linear_mip_linear": 0x2703,
    "repeat": 0x2901, "clamp": 0x2900, "clamp_to_edge": 0x812F, "clamp_to_border": 0x812D,
    "mirrored_repeat": 0x8370,
    "rgba8": 0x8058, "rgb8": 0x8051, "l8": 0x8040, "a8": 0x803C, "la8": 0x8045, "i8": 0x804B,
    "rgba16": 0x805B, "l16": 0x8042, "rgba32f": 0x8814, "rgba16f": 0x881A, "rgb5": 0x8050,
    "rgba4": 0x8056, "rgb5_a1": 0x8057, "dxt1": 0x83F1, "dxt5": 0x83F3, "depth24": 0x81A6,
    "luminance": 0x1909, "intensity": 0x8049, "alpha": 0x1906,
}


def enums(names):
    return {name: ENUMS[name] for name in names.split()}


def choices(names):
    return {name: i for i, name in enumerate(names.split())}


OPERATIONS = "keep zero replace incr decr invert incr_wrap decr_wrap"
COMPARISONS = "always never less equal lequal greater notequal gequal"
FACTORS_SOURCE = ("one zero src_color one_minus_src_color dst_color one_minus_dst_color src_alpha "
                  "one_minus_src_alpha dst_alpha one_minus_dst_alpha constant_color "
                  "one_minus_constant_color constant_alpha one_minus_constant_alpha "
                  "src_alpha_saturate")
FACTORS_DESTINATION = FACTORS_SOURCE.replace("one zero", "zero one").replace(
    " src_alpha_saturate", "")
EQUATIONS = "add subtract reverse_subtract min max"
WRAPS = "repeat clamp_to_edge clamp clamp_to_border mirrored_repeat"

FACTORS = {
    "target": {"window": 0, "texture8": 0x8058, "float32": 0x8814},
    "program": choices("texture modulate add color project bias position fog kill secondary depth "
                       "constant fog_linear fog_exp2"),
    "vertices": choices("fixed lit texgen matrix clipped program program_point"),
    "primitive": {name: number for number, name in enumerate(
        "points lines line_loop line_strip triangles triangle_strip triangle_fan quads quad_strip "
        "polygon".split())},
    "submit": choices("immediate arrays elements buffer buffer_elements list list_arrays range"),
    "colors": choices("float ubyte"),
    "depths": choices("level sloped perspective"),
    "coordinates": choices("whole minified magnified turned outside"),
    "shade": enums("smooth flat"),
    "provoking": enums("last first"),
    "cull": {"off": 0, **enums("back front")},
    "front_face": enums("ccw cw"),
    "mode_front": enums("fill line point"),
    "mode_back": enums("fill line point"),
    "offset": choices("off on"),
    "width": {"1": 1, "3": 3},
    "point_size": {"1": 1, "4": 4},
    "stipple": choices("off line polygon"),
    "antialias": choices("off on"),
    "scissor": choices("off on"),
    "viewport": choices("whole shifted small"),
    "depth_range": choices("usual reversed middle"),
    "alpha_test": {"off": 0, **enums("greater less gequal never notequal")},
    "stencil": choices("off on two_sided"),
    "stencil_func": enums(COMPARISONS),
    "stencil_fail": enums(OPERATIONS),
    "stencil_zfail": enums(OPERATIONS),
    "stencil_zpass": enums(OPERATIONS),
    "stencil_back_func": enums("always less equal gequal"),
    "stencil_back_zpass": enums("keep replace incr_wrap invert"),
    "stencil_mask": {"all": 255, "some": 6},
    "depth_test": {"off": 0, **enums(COMPARISONS)},
    "depth_mask": {"on": 1, "off": 0},
    "blend": choices("off on"),
    "blend_src": enums(FACTORS_SOURCE),
    "blend_dst": enums(FACTORS_DESTINATION),
    "blend_src_alpha": enums(FACTORS_SOURCE),
    "blend_dst_alpha": enums(FACTORS_DESTINATION),
    "equation": enums(EQUATIONS),
    "equation_alpha": enums(EQUATIONS),
    "logic_op": {"off": 0, **{f"op{i}": 0x1500 + i for i in range(16)}},
    "color_mask": {"all": 15, "red_blue": 5, "rgb": 7, "alpha": 8},
    "texture": enums("2d 1d 3d cube rect"),
    "format": enums("rgba8 rgb8 l8 a8 la8 i8 rgba16 l16 rgba32f rgba16f rgb5 rgba4 rgb5_a1 dxt1 "
                    "dxt5 depth24"),
    "size": choices("square oblong odd one"),
    "min_filter": enums("nearest linear nearest_mip_nearest linear_mip_nearest nearest_mip_linear "
                        "linear_mip_linear"),
    "mag_filter": enums("nearest linear"),
    "wrap_s": enums(WRAPS),
    "wrap_t": enums(WRAPS),
    "wrap_r": enums("repeat clamp_to_edge clamp_to_border"),
    "lod_bias": {"0": 0, "1": 1, "-0.6": -0.6},  # no other level is equally near
    "levels": choices("usual max_lod base min_lod"),
    "border": choices("black coloured"),
    "compare": {"off": 0, **enums("lequal gequal less greater")},
    "depth_mode": enums("luminance intensity alpha"),
}
# The client also reads these; run_formats.py sets other values.
FIXED = {"swizzle": 0, "anisotropy": 1, "attachment": 0, "srgb_decode": 0x8A49, "encode": 0}


# States that may hide everything, and the value that does not.
MASKS = {"alpha_test": "off", "stencil": "off", "depth_test": "off", "cull": "off",
         "scissor": "off", "viewport": "whole", "stipple": "off", "color_mask": "all"}
MOST_MASKS = 2


def make_valid(row, kept=()):
    """Makes a row valid. States that GL forbids are replaced by their effect, and only so many masks stay that
    something is
    visible; those of `kept` first. Values are names."""
    row = dict(row)
    active = [name for name in MASKS if row[name] != MASKS[name]]
    active.sort(key=lambda name: (name not in kept, zlib.crc32((name + row["format"] + row["primitive"]).encode())))
    for name in active[MOST_MASKS:]:
        row[name] = MASKS[name]
    if row["texture"] == "rect":
        for wrap in ("wrap_s", "wrap_t"):
            if row[wrap] in ("repeat", "mirrored_repeat"):
                row[wrap] = "clamp_to_edge"
        row["min_filter"] = "linear" if row["min_filter"].startswith("linear") else "nearest"
        # The host takes coordinates in texels for ones in images, and does not magnify rectangles.
        row["mag_filter"] = row["min_filter"]
        row["levels"] = "usual"
    if row["format"] == "depth24":
        if row["texture"] in ("3d", "cube"):
            row["texture"] = "2d"
    else:
        row["compare"] = "off"
    if row["format"] in ("dxt1", "dxt5") and row["texture"] != "2d":
        row["format"] = "rgba8"
    if row["logic_op"] != "off":
        # A logic operation amplifies a difference of a level to any size.
        row["program"] = "constant"
        row["target"] = "window" if row["target"] == "float32" else row["target"]
        row["blend"] = "off"
    if row["stencil"] == "two_sided" and (row["mode_front"], row["mode_back"]) != ("fill", "fill"):
        # Polygons stay polygons however they are drawn (OpenGL 2.0, section 4.1.5), but the host uses the front's
        # stencil state for all lines and points. swrast/strokes/strokes_test.cpp tests GL's rule.
        row["stencil"] = "on"
    if row["stencil"] == "two_sided" and row["antialias"] == "on" and row["primitive"].startswith(("point", "line")):
        # Lines and points have only a front (OpenGL 2.0, section 4.1.5), but the host draws smooth ones as triangles,
        # and uses the stencil state of their visible side.
        row["stencil"] = "on"
    if (row["antialias"] == "on" and row["mode_front"] != row["mode_back"]
            and not row["primitive"].startswith(("point", "line"))):
        # Once the host has drawn one smooth line or point, it shades the rest of the draw as smooth too, with a
        # coverage that was never written: bare frames differ by malloc()'s memory.
        row["antialias"] = "off"
    points = row["primitive"] == "points" or "point" in (row["mode_front"], row["mode_back"])
    if row["vertices"] == "program_point" and points:
        # The host clips a point with a per-vertex size at the viewport's edges.
        row["viewport"] = "whole"
    if row["stipple"] == "polygon" and (row["mode_front"] == "fill") != (row["mode_back"] == "fill"):
        # Once it has filled one polygon, the host also stipples those that are drawn as lines or points.
        row["stipple"] = "off"
    if row["vertices"] == "texgen" and row["texture"] in ("3d", "cube"):
        row["vertices"] = "fixed"
    return row


def line_of_numbers(row):
    """Returns a scene as the client reads it, if the values are GL's numbers already."""
    return " ".join(f"{name}={value}" for name, value in row.items())


def line(row):
    """Returns a scene as the client reads it."""
    return line_of_numbers({name: FACTORS[name][value] for name, value in row.items()} | FIXED)
