"""Pictures as rows of 8-bit RGB: reads PNG, XWD and PPM, writes PNG, compares two, joins several.

Uses only the standard library, so that the runner starts on a bare machine.
"""

import struct
import zlib
from dataclasses import dataclass
from pathlib import Path

_PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_PNG_CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}


class PictureError(Exception):
    """A file is not a picture of a supported kind."""


@dataclass(frozen=True)
class Picture:
    """A picture of width x height pixels, top row first, three bytes (red, green, blue) each."""

    width: int
    height: int
    rgb: bytes

    def is_blank(self) -> bool:
        """True if all pixels are equal: a program that drew nothing."""
        return self.rgb == self.rgb[:3] * (self.width * self.height)

    def crop(self, width: int, height: int) -> "Picture":
        """Returns the top left part, at most width x height."""
        width, height = min(width, self.width), min(height, self.height)
        stride = self.width * 3
        rows = (self.rgb[y * stride : y * stride + width * 3] for y in range(height))
        return Picture(width, height, b"".join(rows))


@dataclass(frozen=True)
class Difference:
    """The difference of two pictures, in 255ths of a channel."""

    same_size: bool
    maximum: int
    mean: float
    pixels: int  # that differ at all
    pixels_over: int  # that differ by more than 2 in a channel

    @property
    def identical(self) -> bool:
        return self.same_size and self.maximum == 0


NOTHING_ALIKE = Difference(False, 255, 255.0, 0, 0)


def compare(a: Picture, b: Picture) -> Difference:
    """Returns the difference of two pictures; the largest possible one if the sizes differ."""
    if (a.width, a.height) != (b.width, b.height):
        return Difference(False, 255, 255.0, a.width * a.height, a.width * a.height)
    if a.rgb == b.rgb:
        return Difference(True, 0, 0.0, 0, 0)
    apart = bytes(abs(x - y) for x, y in zip(a.rgb, b.rgb))
    per_pixel = [max(t) for t in zip(apart[0::3], apart[1::3], apart[2::3])]
    return Difference(
        True,
        max(per_pixel),
        sum(apart) / len(apart),
        sum(1 for d in per_pixel if d),
        sum(1 for d in per_pixel if d > 2),
    )


def of_rgba(pixels: bytes, width: int, height: int) -> Picture:
    """Returns the picture of GL's pixels: RGBA, bottom row first."""
    stride = width * 4
    rows = b"".join(pixels[y * stride:(y + 1) * stride] for y in reversed(range(height)))
    return Picture(width, height, b"".join(rows[i:i + 3] for i in range(0, len(rows), 4)))


def magnified(a: Picture, b: Picture, factor: int = 16) -> Picture:
    """Returns |a - b| times factor, which shows where two pictures of one size differ."""
    rgb = bytes(min(255, factor * abs(x - y)) for x, y in zip(a.rgb, b.rgb))
    return Picture(a.width, a.height, rgb)


def side_by_side(pictures: list[Picture], gap: int = 4) -> Picture:
    """Joins pictures in one row, with grey between them and below shorter ones."""
    height = max(p.height for p in pictures)
    grey = b"\x80\x80\x80"
    rows = []
    for y in range(height):
        parts = []
        for p in pictures:
            stride = p.width * 3
            parts.append(p.rgb[y * stride : (y + 1) * stride] if y < p.height else grey * p.width)
        rows.append((grey * gap).join(parts))
    width = sum(p.width for p in pictures) + gap * (len(pictures) - 1)
    return Picture(width, height, b"".join(rows))


def write_png(path: Path, picture: Picture) -> None:
    stride = picture.width * 3
    raw = b"".join(
        b"\0" + picture.rgb[y * stride : (y + 1) * stride] for y in range(picture.height)
    )

    def chunk(kind: bytes, data: bytes) -> bytes:
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, 2, 0, 0, 0)
    path.write_bytes(
        _PNG_SIGNATURE
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(raw, 6))
        + chunk(b"IEND", b"")
    )


def read(path: Path) -> Picture:
    """Reads a picture from a PNG (8 bits a channel), an XWD window dump (32 bits a pixel) or a PPM (P6)."""
    data = path.read_bytes()
    if data.startswith(_PNG_SIGNATURE):
        return _read_png(data)
    if data.startswith(b"P6"):
        return _read_ppm(data)
    return _read_xwd(data)


def _read_ppm(data: bytes) -> Picture:
    fields = data.split(None, 4)
    if len(fields) < 4 or fields[3] != b"255":
        raise PictureError("a PPM must have 8 bits a channel")
    width, height = int(fields[1]), int(fields[2])
    size = width * height * 3
    return Picture(width, height, data[-size:])


def _read_xwd(data: bytes) -> Picture:
    """Reads an XWD of version 7, ZPixmap, with 32 bits a pixel and red, green, blue in a word's low 24."""
    if len(data) < 100:
        raise PictureError("too short for a window dump")
    head = struct.unpack(">25I", data[:100])
    size, version, form, _depth, width, height, _, order = head[:8]
    bits_per_pixel, stride, colours = head[11], head[12], head[19]
    if version != 7 or form != 2 or bits_per_pixel != 32:
        raise PictureError(f"window dump version {version}, format {form}, {bits_per_pixel} bits")
    start = size + colours * 12
    red, green, blue = (2, 1, 0) if order == 0 else (1, 2, 3)
    rows = []
    for y in range(height):
        line = data[start + y * stride : start + y * stride + width * 4]
        out = bytearray(width * 3)
        out[0::3], out[1::3], out[2::3] = line[red::4], line[green::4], line[blue::4]
        rows.append(bytes(out))
    return Picture(width, height, b"".join(rows))


def _read_png(data: bytes) -> Picture:
    position, body, palette = len(_PNG_SIGNATURE), b"", b""
    width = height = depth = kind = interlace = 0
    while position + 8 <= len(data):
        (length,) = struct.unpack(">I", data[position : position + 4])
        name, content = data[position + 4 : position + 8], data[position + 8 : position + 8 + length]
        position += 12 + length
        if name == b"IHDR":
            width, height, depth, kind, _, _, interlace = struct.unpack(">IIBBBBB", content)
        elif name == b"PLTE":
            palette = content
        elif name == b"IDAT":
            body += content
    if depth != 8 or interlace or kind not in _PNG_CHANNELS:
        raise PictureError(f"PNG with {depth} bits, colour type {kind}, interlace {interlace}")
    channels = _PNG_CHANNELS[kind]
    pixels = _unfilter(zlib.decompress(body), width * channels, height, channels)
    return Picture(width, height, _to_rgb(pixels, kind, palette))


def _unfilter(raw: bytes, stride: int, height: int, step: int) -> bytes:
    out, above = bytearray(), bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        method, line = raw[start], bytearray(raw[start + 1 : start + 1 + stride])
        if method == 2:
            line = bytearray((a + b) & 255 for a, b in zip(line, above))
        elif method:
            for i in range(stride):
                left = line[i - step] if i >= step else 0
                up, corner = above[i], above[i - step] if i >= step else 0
                if method == 1:
                    guess = left
                elif method == 3:
                    guess = (left + up) // 2
                else:
                    p = left + up - corner
                    guess = min((left, up, corner), key=lambda v: abs(p - v))
                line[i] = (line[i] + guess) & 255
        out += line
        above = line
    return bytes(out)


def _to_rgb(pixels: bytes, kind: int, palette: bytes) -> bytes:
    if kind == 2:
        return pixels
    if kind == 3:
        return b"".join(palette[3 * i : 3 * i + 3] for i in pixels)
    channels = _PNG_CHANNELS[kind]
    out = bytearray(len(pixels) // channels * 3)
    for c in range(3):
        out[c::3] = pixels[(c if kind == 6 else 0) :: channels]
    return bytes(out)
