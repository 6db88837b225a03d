"""Tests the comparison of recordings: each kind of fault must be noticed, in any frame."""

import io
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parent))

import cases
import session
from cases import Case
from picture import Picture, PictureError
from recordings import judge, replay, traces
from recordings.frames import Frame, distance, read_frames
from recordings.replay import Run, Way
from recordings.traces import Recording

SIDE = 20


def _shot(changed: int = 0, by: int = 0) -> Picture:
    """Returns a gradient whose first `changed` pixels are brighter by `by` in green."""
    rgb = bytearray((i * 5) % 200 for i in range(SIDE * SIDE * 3))
    for pixel in range(changed):
        rgb[pixel * 3 + 1] += by
    return Picture(SIDE, SIDE, bytes(rgb))


def _pnm(*shots: tuple[int, Picture]) -> bytes:
    return b"".join(b"P6\n#%d\n%d %d\n255\n" % (call, p.width, p.height) + p.rgb
                    for call, p in shots)


class Frames(unittest.TestCase):
    def test_snapshots_are_read_with_their_calls(self):
        found = list(read_frames(io.BytesIO(_pnm((7, _shot()), (2551, _shot(3, 9))))))
        self.assertEqual([f.call for f in found], [7, 2551])
        self.assertEqual([f.picture for f in found], [_shot(), _shot(3, 9)])

    def test_what_mesa_says_of_extensions_is_no_snapshot(self):
        said = b"Warning: extension 'GL_ARB_shader_objects' cannot be disabled\n"
        self.assertEqual([f.call for f in read_frames(io.BytesIO(said + _pnm((7, _shot()))))], [7])

    def test_a_stream_that_ends_early_or_is_noise_is_an_error(self):
        for data in (_pnm((7, _shot()))[:-1], b"hello\n" + _pnm((7, _shot()))):
            with self.assertRaises(PictureError):
                list(read_frames(io.BytesIO(data)))

    def test_wrong_is_more_than_60_pixels_by_more_than_3_percent(self):
        def wrong(pixels: int, by: int) -> bool:
            return distance(1, _shot(), _shot(pixels, by)).wrong()

        self.assertTrue(wrong(61, 8))
        self.assertFalse(wrong(60, 50))
        self.assertFalse(wrong(400, 7))
        self.assertEqual(distance(1, _shot(), _shot(400, 7)).maximum, 7)

    def test_another_size_is_wrong(self):
        self.assertTrue(distance(1, _shot(), _shot().crop(SIDE - 1, SIDE)).wrong())


class Compared(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.out = Path(self._folder.name)

    def tearDown(self):
        self._folder.cleanup()

    def _compare(self, bare: list[Picture], again: list[Picture], layer: list[Picture],
                 statuses=(0, 0, 0), stats=None, cut_off=False, **recording) -> judge.Row:
        """Returns the row of the one way, with replays that have these pictures and statuses."""
        runs = iter(zip((bare, again, layer), statuses, (False, False, cut_off)))

        def replay(_recording, _calls, _way, folder, _timeout, take):
            folder.mkdir(parents=True)
            shots, status, late = next(runs)
            for call, shot in enumerate(shots):
                take(Frame(call, shot))
            return Run(status, 1.0, "last words", stats or [], "cut off" if late else "", late)

        with mock.patch.object(judge, "replay", replay), \
                mock.patch.object(traces, "snapshot_calls", lambda _: "frame"):
            rows = judge.compare(Recording("r", Path("r.trace"), **recording),
                                 [Way(session.Mode("layer"))], self.out / "r", 1.0, lambda _: None)
        self.assertEqual(len(rows), 1)
        return rows[0]

    def test_the_same_frames_pass(self):
        row = self._compare([_shot()] * 3, [_shot()] * 3, [_shot()] * 3)
        self.assertEqual((row.passed, row.frames, row.steady), (True, 3, 3))

    def test_a_wrong_frame_in_the_middle_is_found_and_drawn(self):
        row = self._compare([_shot()] * 3, [_shot()] * 3, [_shot(), _shot(100, 40), _shot()])
        self.assertEqual([(w["call"], w["pixels"]) for w in row.wrong], [(1, 100)])
        self.assertFalse(row.passed)
        self.assertTrue((self.out / "r" / "layer" / "worst-1.png").exists())

    def test_a_case_may_state_that_more_pixels_are_off(self):
        for allowed, passed in ((99, False), (100, True)):
            row = self._compare([_shot()], [_shot()], [_shot(100, 40)], wrong_pixels=allowed)
            self.assertEqual(row.passed, passed)

    def test_a_case_may_state_that_pixels_are_further_off(self):
        for step, passed in ((40, False), (41, True)):
            row = self._compare([_shot()], [_shot()], [_shot(100, 40)], step=step)
            self.assertEqual(row.passed, passed)

    def test_a_frame_that_two_bare_runs_do_not_agree_on_does_not_count(self):
        row = self._compare([_shot()] * 3, [_shot(100, 40), _shot(), _shot()],
                            [_shot(100, 50), _shot(), _shot()])
        self.assertEqual((row.passed, row.steady), (True, 2))

    def test_nothing_steady_or_blank_is_no_comparison(self):
        blank = Picture(SIDE, SIDE, bytes(SIDE * SIDE * 3))
        for bare, again in ((_shot(), _shot(100, 40)), (blank, blank)):
            self.assertFalse(self._compare([bare], [again], [bare]).passed)

    def test_another_status_or_number_of_frames_is_a_failure(self):
        row = self._compare([_shot()], [_shot()], [_shot()], statuses=(0, 0, -11))
        self.assertIn("status -11, bare 0", row.reason)
        self.assertIn("1 frames, bare 2", self._compare([_shot()] * 2, [_shot()] * 2,
                                                        [_shot()]).reason)
        # A program that fails on the bare host may fail with the layer.
        self.assertTrue(self._compare([_shot()], [_shot()], [_shot()], statuses=(1, 1, 1)).passed)

    def test_of_a_run_that_was_cut_off_no_frame_is_compared(self):
        row = self._compare([_shot()] * 2, [_shot()] * 2, [_shot(100, 40)], cut_off=True)
        self.assertEqual((row.passed, row.wrong, row.problems), (False, [], ["cut off"]))

    def test_a_layer_that_did_not_draw_proves_nothing(self):
        row = self._compare([_shot()], [_shot()], [_shot()], least_programs=2, refused=0)
        self.assertIn("0 fragment programs compiled, 2 expected", row.reason)
        stats = [{"programs": [{"target": "fragment"}] * 2, "draws": {"rasterizer": 4}}]
        self.assertTrue(self._compare([_shot()], [_shot()], [_shot()], stats=stats,
                                      least_programs=2, refused=0).passed)


class Replayed(unittest.TestCase):
    def test_a_process_that_does_not_end_is_cut_off(self):
        picture = _pnm((7, _shot())).hex()
        script = ("import sys, time; sys.stdout.buffer.write(bytes.fromhex(sys.argv[1])); "
                  "sys.stdout.flush(); time.sleep(float(sys.argv[2]))")
        for lasts, expected in (("60", True), ("0", False)):
            process = subprocess.Popen([sys.executable, "-c", script, picture, lasts],
                                       stdout=subprocess.PIPE, start_new_session=True)
            taken = []
            problem, cut_off = replay._take_all(process, 3.0 if expected else 60.0, taken.append)
            self.assertEqual((cut_off, "cut off" in problem), (expected, expected))


class Ways(unittest.TestCase):
    def test_cases_leave_out_ways_that_there_are(self):
        self.assertEqual({way.name for way in replay.ways(Path("layer.so"))}, set(cases.WAYS))
        Case("c", ["c"], ways_left_out=cases.DRAWN)
        with self.assertRaises(ValueError):
            Case("c", ["c"], ways_left_out=("fixed",))


class Traces(unittest.TestCase):
    def test_a_recording_without_a_draw_is_made_again_with_more_time(self):
        case, times = Case("c", ["c"], stop_after=1.0), []

        def record(case, _folder, trace):
            times.append(case.stop_after)
            trace.write_text("draws" if case.stop_after > 2 else "")

        def shell(command):
            return "12 glEnd()\n" if Path(command[-1]).read_text() else ""

        with tempfile.TemporaryDirectory() as folder, \
                mock.patch.object(session, "record", record), \
                mock.patch.object(traces, "shell", shell), \
                mock.patch.object(traces, "frame_count", lambda _: 1):
            self.assertEqual(traces.of_case("p", case, Path(folder), 9).trace.read_text(), "draws")
        self.assertEqual(times, [1.0, 2.0, 4.0])

    def test_the_last_draw_is_looked_at_if_no_swap_follows(self):
        swap, draw = "9 glXSwapBuffers(dpy = 0x1)\n", "12 glEnd()\n"
        for dump, expected in ((draw + swap, "frame"), (swap + draw, "frame,12"),
                               ("9 eglSwapBuffers(dpy = 0x1)\n", "frame")):
            with mock.patch.object(traces, "shell", lambda *_, d=dump: d):
                self.assertEqual(traces.snapshot_calls(Path("t")), expected)

    def test_a_trace_without_draws_is_an_error(self):
        with mock.patch.object(traces, "shell", lambda *_: ""):
            with self.assertRaises(traces.PrepareError):
                traces.snapshot_calls(Path("t"))


if __name__ == "__main__":
    unittest.main()
