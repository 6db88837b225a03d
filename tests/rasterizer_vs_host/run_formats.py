#!/usr/bin/env python3
"""Compares every format of textures and color buffers on the bare host and by the rasterizer.

  run_formats.py --build build
  run_formats.py --build build --only rgb565
  run_formats.py --build build --sample 2/5

Each texture format is sampled from each possible target, between mipmaps and with its components in another order. Each
color buffer format is drawn to plainly, blended, with a color mask, with a logic operation and by a program that
exceeds
[0,1]; some also as slices, faces and renderbuffers. Each kind of pbuffer is drawn to. The rasterizer must make all
draws, as the layer's statistics tell. Exceptions are listed with their reasons, which the statistics must show. Ends
with "N passed, N failed, N skipped".
"""

import array
import concurrent.futures
import math
import pathlib
import sys
import tempfile

import sides
from factors import FACTORS, FIXED, line_of_numbers
from run_states import EDGE, run_batch

TEXTURES = {
    "rgba8": 0x8058, "rgb8": 0x8051, "l8": 0x8040, "a8": 0x803C, "la8": 0x8045, "i8": 0x804B,
    "r8": 0x8229, "rg8": 0x822B, "rgba16": 0x805B, "rgb16": 0x8054, "rgba12": 0x805A,
    "l16": 0x8042, "a16": 0x803E, "la16": 0x8048, "i16": 0x804D, "r16": 0x822A, "rg16": 0x822C,
    "rgba16f": 0x881A, "rgb16f": 0x881B, "l16f": 0x881E, "a16f": 0x881C, "la16f": 0x881F,
    "i16f": 0x881D, "r16f": 0x822D, "rg16f": 0x822F, "rgba32f": 0x8814, "rgb32f": 0x8815,
    "l32f": 0x8818, "a32f": 0x8816, "la32f": 0x8819, "i32f": 0x8817, "r32f": 0x822E,
    "rg32f": 0x8230, "rgb4": 0x804F, "rgb5": 0x8050, "rgb565": 0x8D62, "rgb10": 0x8052,
    "rgba2": 0x8055, "rgba4": 0x8056, "rgb5_a1": 0x8057, "rgb10_a2": 0x8059,
}
S3TC = {"rgb_dxt1": 0x83F0, "rgba_dxt1": 0x83F1, "rgba_dxt3": 0x83F2, "rgba_dxt5": 0x83F3,
        "srgb_dxt1": 0x8C4C, "srgba_dxt1": 0x8C4D, "srgba_dxt3": 0x8C4E, "srgba_dxt5": 0x8C4F}
SRGB = {"srgb8": 0x8C41, "srgb8_alpha8": 0x8C43, "sl8": 0x8C47, "sla8": 0x8C45}
DEPTHS = {"depth16": 0x81A5, "depth24": 0x81A6, "depth32": 0x81A7, "depth32f": 0x8CAC}
# The steps of components with less than 8 bits.
COARSE = {"rgb4": 15, "rgb5": 31, "rgb565": 31, "rgba2": 15, "rgba4": 15, "rgb5_a1": 31}
COARSE_ALPHA = {"rgb5_a1": 1, "rgb10_a2": 3}
# The rasterizer lacks these, with the reason in the statistics.
LEFT_TEXTURES = {"r3_g3_b2": 0x2A10, "rgba8_snorm": 0x8F97,
                 "r11f_g11f_b10f": 0x8C3A, "rgb9_e5": 0x8C3D}
LEFT_TARGETS = {name: LEFT_TEXTURES[name]
                for name in ("r3_g3_b2", "rgba8_snorm", "r11f_g11f_b10f")}
# Alpha and intensity formats: the host blends them by rules of its own, so that they are left to it.
ONE_VALUE = ("a8", "i8", "a16", "i16", "a16f", "i16f", "a32f", "i32f")
SKIP_DECODE, ENCODES, CLEARS_ENCODED = 0x8A4A, 1, 2
ATTACHED = ("rgba8", "srgb8_alpha8", "rgb565", "rgba16f", "rgba32f")  # also attached as other kinds of images
BATCH = 40  # scenes for each process
LEVEL = 1.01 / 255
PLAIN = {"program": "texture", "primitive": "quads", "submit": "arrays", "depth_mask": "off",
         "coordinates": "whole"}


def scene(**changed):
    named = {name: next(iter(values)) for name, values in FACTORS.items()} | PLAIN
    numbers = {name: FACTORS[name][value] for name, value in named.items()} | FIXED
    for name, value in changed.items():
        numbers[name] = FACTORS[name][value] if isinstance(value, str) else value
    return numbers


def texture_scenes(name, number, **more):
    """Returns the scenes of one format; `more` applies to all."""
    targets = ["2d", "cube"] if number in S3TC.values() else ["2d", "1d", "3d", "cube", "rect"]
    if name in DEPTHS:
        targets = ["2d", "1d", "rect"]
    for target in targets:
        base = {"texture": target, "format": number} | more
        if target == "rect":
            base |= {"wrap_s": "clamp_to_edge", "wrap_t": "clamp_to_edge"}
        if target == "2d":
            yield f"{name} {target}", scene(**base)
        filters = {"mag_filter": "linear", "min_filter": "linear"}
        if target != "rect":
            filters["min_filter"] = "linear_mip_linear"
        yield f"{name} {target} filtered", scene(**base, **filters)
        if name in DEPTHS:
            yield f"{name} {target} compared", scene(**base, compare="lequal")
    yield f"{name} swizzled", scene(texture="2d", format=number, swizzle=1,
                                           wrap_s="clamp_to_border", wrap_t="clamp_to_border",
                                           border="coloured", coordinates="outside", **more)


def srgb_scenes():
    """Returns scenes of textures that are not decoded, and of buffers with encoding only in a clear, which the host
    does."""
    for name, number in SRGB.items():
        for label, numbers in texture_scenes(name, number, srgb_decode=SKIP_DECODE):
            yield label.replace(" ", " undecoded ", 1), numbers
    for name in ("srgb8", "srgb8_alpha8"):
        yield from target_scenes(name, SRGB[name])
        yield f"to {name} cleared", scene(target=SRGB[name], program="modulate",
                                          encode=CLEARS_ENCODED)


def anisotropic_scenes():
    """Returns scenes of anisotropic filters. A host's filter looks different (run_anisotropy.py), so that only who
    draws is
    checked. Mesa 22.3.6 crashes if a 1D texture has such a filter."""
    for target in ("2d", "3d", "cube"):
        for number in (TEXTURES["rgba8"], TEXTURES["rgba16f"]):
            yield f"anisotropic {target}", scene(texture=target, format=number, anisotropy=8,
                                                 min_filter="linear_mip_linear")


def target_scenes(name, number):
    base = {"target": number, "program": "modulate"}
    yield f"to {name}", scene(**base)
    if name not in ONE_VALUE:
        yield from blended_scenes(name, number)
    yield f"to {name} masked", scene(**base, color_mask="red_blue")
    yield f"to {name} beyond", scene(**(base | {"program": "secondary"}))
    for place, kind in enumerate(("", "slice", "face", "renderbuffer")):
        if kind and name in ATTACHED:
            yield f"to {name} {kind}", scene(**base, attachment=place)
    if not name.endswith("f"):
        yield f"to {name} by logic", scene(**(base | {"program": "constant"}), logic_op="op6")


def blended_scenes(name, number):
    base = {"target": number, "program": "modulate", "blend": "on"}
    yield f"to {name} blended", scene(**base, blend_src="src_alpha",
                                      blend_dst="one_minus_src_alpha", blend_src_alpha="one",
                                      blend_dst_alpha="dst_alpha")
    yield f"to {name} by its own", scene(**base, blend_src="dst_color",
                                         blend_dst="one_minus_dst_alpha",
                                         equation="reverse_subtract",
                                         blend_src_alpha="src_alpha", blend_dst_alpha="one")


def clears_half_to_none(client, display):
    """True if the bare host stores an alpha of one half as 0 in one bit, when it clears a buffer to it."""
    untouched = scene(target=TEXTURES["rgb5_a1"], program="modulate", color_mask=0)
    [bare] = run_batch(client, [untouched], {**sides.environment(), "DISPLAY": display}, line_of_numbers)
    return array.array("f", bare["float"][1])[4 * EDGE * (EDGE - 1) + 3] == 0  # where nothing is drawn


def tolerance(label, half_is_none):
    """Returns (a component's tolerance, alpha's tolerance, the fraction of them that may exceed a level of 255).

    A value at the border of two steps of a coarse buffer may be rounded to either. For 5 and 6 bits the host rounds to
    8
    bits and truncates, while the rasterizer rounds to the nearest step. `half_is_none`: Mesa from 23.1 on, and Debian's
    32-bit x86 Mesa, store an alpha of one half in one bit as 0; with 1, as in 64-bit Mesa, the term vanishes. What the
    host
    then reads from the buffer, multiplies and truncates again is two steps off: 6 of 31 for 7.55, which the rasterizer
    rounds to 8. The host blends 8-bit buffers in integers, and rounds each product. It filters texels as bytes with
    8-bit
    weights, which is most visible if one bit of alpha makes neighbors differ completely. If a depth nearly equals its
    reference, a comparison may go either way, especially with 32 bits, of which the host samples the upper 23. Its
    sampler
    and its GetTexImage decode S3TC blocks to bytes that sometimes differ by one, which sRGB decodes to two levels
    and more."""
    if label.startswith("anisotropic"):
        return 1, 1, 1
    to = label.split()[1] if label.startswith("to ") else ""
    steps = COARSE.get(to, 0)
    most = 1.01 / steps if steps else LEVEL
    alpha = 1.01 / COARSE_ALPHA[to] if to in COARSE_ALPHA else most
    if half_is_none and label == "to rgb5_a1 by its own":
        most *= 2
    if steps or to in COARSE_ALPHA:
        return most, alpha, 0.03 if steps == 15 else 1
    if label.endswith("compared"):
        return 1, 1, 0.002 if label.startswith("depth32 ") else 0.001
    name, filtered = label.split()[0], label.endswith("filtered")
    if filtered and name in ("rgba_dxt1", "srgba_dxt1", "rgb5_a1", "rgb10_a2"):
        return 8 * LEVEL, 8 * LEVEL, 0.015
    if name.startswith("srgb") and "_dxt" in name:
        return 3 * LEVEL, 2 * LEVEL, 0.02
    if filtered:
        return 2 * LEVEL, 2 * LEVEL, 0.01
    if to and ("blended" in label or "by its own" in label) and not to.endswith("f"):
        return 2 * LEVEL, 2 * LEVEL, 0.005
    return most, alpha, 0


def apart(bare, layer):
    """Returns (the difference of two float pictures in red, green and blue, that in alpha, how many components exceed
    a level of 255)."""
    worst, beyond = [0, 0], 0
    for i, (x, y) in enumerate(zip(array.array("f", bare), array.array("f", layer))):
        if x == y or (math.isnan(x) and math.isnan(y)):
            continue
        distance = abs(x - y) / max(1.0, abs(x))
        worst[i % 4 == 3] = max(worst[i % 4 == 3], distance)
        beyond += distance > LEVEL
    return *worst, beyond


def pbuffer_faults(build):
    """Returns (kinds of pbuffers, complaints): each is drawn to twice. Those of floats are left to the host."""
    with tempfile.TemporaryDirectory(prefix="arbiter-formats-") as scratch:
        stats = pathlib.Path(scratch) / "stats-%p.json"
        client = build / "tests/rasterizer_vs_host/rasterizer-pbuffers"
        bare = sides.run([client], sides.environment())
        layer = sides.run([client], sides.environment(
            sides.layer_of(build), "swrast", {"XDG_CACHE_HOME": scratch, "ARBITER_STATS": str(stats)}))
        drawn, given = sides.software_totals(scratch)
    faults = []
    if [name for name, _ in bare] != [name for name, _ in layer]:
        return len(bare), ["pbuffers: not the same kinds"]
    for (name, a), (_, b) in zip(bare, layer):
        least = min(int(bits) for bits in name[1:].split("-")[:4] if bits != "0")
        most, part = (2 * LEVEL, 0.005) if least >= 8 else (1.01 / (2 ** least - 1), 1)
        color, alpha, beyond = apart(a, b)
        worst = max(color, alpha)
        if worst > most or beyond > part * 4 * EDGE * EDGE:
            faults.append(f"pbuffer {name}: {beyond} components differ, by up to {worst:.5f}")
    floats = 2 * sum(name[0] == "f" for name, _ in bare)
    if drawn != 2 * len(bare) - floats or given != ({"target": floats} if floats else {}):
        faults.append(f"pbuffers: the rasterizer drew {drawn} of {2 * len(bare)}, the host {given}")
    return len(bare), faults


def judge(label, bare, layer, half_is_none):
    for side, name in ((bare, "the bare host"), (layer, "the layer")):
        if isinstance(side, str):
            return f"died on {name}: {side}"
    if bare["errors"][0] != layer["errors"][0]:
        return f"errors: '{bare['errors'][0]}', layer '{layer['errors'][0]}'"
    most, most_alpha, part = tolerance(label, half_is_none)
    worst, alpha, beyond = apart(bare["float"][1], layer["float"][1])
    if worst > most or alpha > most_alpha or beyond > part * 4 * EDGE * EDGE:
        return (f"{beyond} components differ, by up to {worst:.5f}, alpha by {alpha:.5f}; allowed "
                f"{most:.5f} and {most_alpha:.5f}")
    return ""


def main():
    parser = sides.options(__doc__)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", help="scenes whose name holds this")
    parser.add_argument("--sample", default="1/1", metavar="N/M", help="one of M scenes, the Nth")
    args = parser.parse_args()
    client = args.build.resolve() / "tests/rasterizer_vs_host/rasterizer-states"
    supported = [s for name, number in (TEXTURES | SRGB | S3TC | DEPTHS).items()
                 for s in texture_scenes(name, number)]
    supported += [s for name, number in TEXTURES.items() for s in target_scenes(name, number)]
    supported += srgb_scenes()
    supported += anisotropic_scenes()
    left = [("texture", f"{name} 2d", scene(texture="2d", format=number))
            for name, number in LEFT_TEXTURES.items()]
    left += [("target", f"to {name}", scene(target=number, program="color"))
             for name, number in LEFT_TARGETS.items()]
    left += [("target", *each) for name in ONE_VALUE
             for each in blended_scenes(name, TEXTURES[name])]
    left += [("state", "to srgb8_alpha8 encoded",
              scene(target=SRGB["srgb8_alpha8"], program="color", encode=ENCODES))]
    if args.only:
        supported = [s for s in supported if args.only in s[0]]
        left = [s for s in left if args.only in s[1]]
    part, parts = map(int, args.sample.split("/"))
    supported = supported[part - 1::parts]
    left = left[part - 1::parts]
    failed = passed = 0
    with sides.Displays() as displays, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:

        def run(scenes):
            """Returns the records of both sides, draws of the rasterizer, reasons of the others."""
            with tempfile.TemporaryDirectory(prefix="arbiter-formats-") as scratch:
                stats = pathlib.Path(scratch) / "stats-%p.json"
                layer = sides.environment(sides.layer_of(args.build.resolve()), "swrast",
                                          {"XDG_CACHE_HOME": scratch, "ARBITER_STATS": str(stats),
                                           "ARBITER_FIXED_FUNCTION": "programs"})  # programs are counted
                both = [run_batch(client, scenes, {**env, "DISPLAY": displays.name()},
                                  line_of_numbers)
                        for env in (sides.environment(), layer)]
                return (*both, *sides.software_totals(scratch))

        half_is_none = clears_half_to_none(client, displays.name())
        batches = [supported[i:i + BATCH] for i in range(0, len(supported), BATCH)]
        results = pool.map(lambda batch: run([numbers for _, numbers in batch]), batches)
        for batch, (bares, layers, drawn, given) in zip(batches, results):
            for (label, _), bare, layer in zip(batch, bares, layers):
                fault = judge(label, bare, layer, half_is_none)
                failed += bool(fault)
                passed += not fault
                if fault:
                    print(f"FAIL {label}: {fault}", flush=True)
            if drawn >= len(batch) and not given:
                continue
            for label, numbers in batch:
                _, _, one, other = run([numbers])
                if not one or other:
                    failed += 1
                    print(f"FAIL {label}: the rasterizer drew {one}, the host {other}", flush=True)
        alone = pool.map(lambda each: run([each[2]]), left)
        for (reason, label, _), (_, _, one, other) in zip(left, alone):
            fault = one or set(other) != {reason}
            failed += bool(fault)
            passed += not fault
            if fault:
                print(f"FAIL {label}: the rasterizer drew {one}, the host {other}, not for '{reason}'")
    if not args.only:
        kinds, faults = pbuffer_faults(args.build.resolve())
        passed += kinds
        failed += len(faults) or not kinds
        print("\n".join(faults), end="\n" if faults else "")
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
