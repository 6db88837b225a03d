"""Reads the frames of a replay from glretrace's output, stores them, and compares them one by one."""

import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Iterator

from picture import Picture, PictureError

# A frame is wrong if more pixels than this differ by more than 3 % in a channel, unless its case says otherwise. Seams
# of a pixel and the last bit of a filter stay below; a lost draw or a moved edge does not.
WRONG_PIXELS = 60
STEP = 8  # in 255ths: the smallest difference over 3 %, unless its case says otherwise

# Mesa prints this on standard output about MESA_EXTENSION_OVERRIDE.
_HOSTS_WORDS = b"Warning: extension "


@dataclass(frozen=True)
class Frame:
    """The picture of one snapshot; `call` is the number of the call in the trace."""

    call: int
    picture: Picture


@dataclass(frozen=True)
class Distance:
    """The difference of a frame from the same frame of the first bare run."""

    call: int
    pixels: int  # that differ by the step or more; all if the sizes differ
    maximum: int  # in 255ths
    same_size: bool = True

    def wrong(self, allowed: int = WRONG_PIXELS) -> bool:
        return not self.same_size or self.pixels > allowed


def read_frames(stream: BinaryIO) -> Iterator[Frame]:
    """Yields the snapshots that `glretrace --snapshot-prefix=-` writes: binary PNM with the call's number
    as comment. Raises PictureError if the stream is anything else, or ends within a picture."""
    while head := stream.readline():
        kind = head.strip()
        if head.startswith(_HOSTS_WORDS):
            continue
        if kind not in (b"P5", b"P6"):
            raise PictureError(f"no snapshot but {head[:40]!r}")
        call = int(stream.readline().strip().lstrip(b"#") or b"0")
        width, height = map(int, stream.readline().split())
        if stream.readline().strip() != b"255":
            raise PictureError(f"snapshot of call {call}: not 8 bits a channel")
        channels = 3 if kind == b"P6" else 1
        data = stream.read(width * height * channels)
        if len(data) != width * height * channels:
            raise PictureError(f"snapshot of call {call} is cut off")
        if channels == 1:
            data = bytes(value for value in data for _ in range(3))
        yield Frame(call, Picture(width, height, data))


def distance(call: int, a: Picture, b: Picture, step: int = STEP) -> Distance:
    """Counts differing pixels, in the rows whose bytes differ; most frames have none."""
    if (a.width, a.height) != (b.width, b.height):
        return Distance(call, max(a.width * a.height, b.width * b.height), 255, False)
    if a.rgb == b.rgb:
        return Distance(call, 0, 0)
    stride, pixels, maximum = a.width * 3, 0, 0
    for start in range(0, len(a.rgb), stride):
        left, right = a.rgb[start : start + stride], b.rgb[start : start + stride]
        if left == right:
            continue
        apart = [abs(x - y) for x, y in zip(left, right)]
        largest = max(apart)
        maximum = max(maximum, largest)
        if largest >= step:
            pixels += sum(1 for t in zip(apart[0::3], apart[1::3], apart[2::3]) if max(t) >= step)
    return Distance(call, pixels, maximum)


class FrameStore:
    """Stores the frames of the first bare run, compressed in one file."""

    def __init__(self, path: Path):
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file = open(path, "w+b")
        self._places: list[tuple[int, int, int, int, int]] = []  # call, width, height, offset, size
        self.any_shown = False  # a frame with more than one color

    def __len__(self) -> int:
        return len(self._places)

    def add(self, frame: Frame) -> None:
        shot = frame.picture
        data = zlib.compress(shot.rgb, 1)
        self._places.append((frame.call, shot.width, shot.height, self._file.tell(), len(data)))
        self._file.write(data)
        self.any_shown = self.any_shown or not shot.is_blank()

    def get(self, index: int) -> Frame:
        call, width, height, offset, size = self._places[index]
        self._file.seek(offset)
        return Frame(call, Picture(width, height, zlib.decompress(self._file.read(size))))

    def close(self) -> None:
        self._file.close()


class Comparison:
    """Takes the frames of a later run in order and compares each with the stored one.

    Only the frames whose index is in `steady` count; None: all do. The frame with the largest difference
    is kept for display. `allowed` is the number of pixels that may differ by `step` or more.
    """

    def __init__(self, store: FrameStore, allowed: int, steady: set[int] | None = None,
                 step: int = STEP):
        self._step = step
        self._store, self._steady, self._allowed, self._next = store, steady, allowed, 0
        self.distances: dict[int, Distance] = {}  # by the frame's index
        self.worst: tuple[Frame, Frame] | None = None  # before, after
        self._worst_pixels = 0

    @property
    def seen(self) -> int:
        """Returns how many frames the run had, counted or not."""
        return self._next

    def compare(self, frame: Frame) -> None:
        index = self._next
        self._next += 1
        if index >= len(self._store) or (self._steady is not None and index not in self._steady):
            return
        before = self._store.get(index)
        apart = distance(before.call, before.picture, frame.picture, self._step)
        if before.call != frame.call:
            apart = Distance(before.call, apart.pixels, apart.maximum, False)
        self.distances[index] = apart
        if apart.wrong(self._allowed) and apart.pixels > self._worst_pixels:
            self.worst, self._worst_pixels = (before, frame), apart.pixels

    def agreeing(self) -> set[int]:
        """Returns the indices of the frames that are not wrong."""
        return {index for index, apart in self.distances.items() if not apart.wrong(self._allowed)}

    def wrong(self) -> list[Distance]:
        return [apart for apart in self.distances.values() if apart.wrong(self._allowed)]
