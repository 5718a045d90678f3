"""The lines about maps that go on: folders whose times are all counted from 0, as people write them."""

import shutil
import signal

from acceptance.common import PLACES, PROGRAMS, ROOT, Line, fresh_folder, render_tour, run
from acceptance.endings import Running, frames_of
from acceptance.users import ended, judge, program, says

NUM_FRAMES = 20  # of each folder
ENOUGH_FRAMES = 8  # of a drive that is ended in the middle


def counted_from_zero(name, tour):
    """A rendered tour's pictures, a second apart, and calibration alone."""
    tour_folder = render_tour(tour, 10, 1, NUM_FRAMES)
    folder = fresh_folder(f"going_on/{name}")
    folder.mkdir(parents=True)
    shutil.copytree(tour_folder / "images", folder / "images")
    shutil.copy(tour_folder / "calibration.txt", folder)
    lines = (tour_folder / "times.txt").read_text().splitlines()
    names = [line.split()[1] for line in lines if not line.startswith("#")]
    (folder / "times.txt").write_text("".join(f"{i} {name}\n" for i, name in enumerate(names)))
    return folder


def maps(*words):
    return ended(ROOT / "scripts/map_images", *words, *PLACES)


def holds_drives(store, count):
    text = run(PROGRAMS / "map_tool", "info", store)
    expected = f"{NUM_FRAMES} frames"
    return f"{count} drives", f"drives    {count}\n" in text and text.count(expected) == count, text[:300]


def another_folder(first, second):
    """The second day's pictures are a drive of their own, which is known wherever it stands."""
    out = fresh_folder("going_on/days")
    maps(first, "--out", out)
    outcomes = [says("a second folder", maps(second, "--out", out, "--resume"), {0}, "wrote .*summary.json"),
                holds_drives(out / "map.db", 2)]
    maps(second, first, "--out", out, "--resume")
    outcomes.append(holds_drives(out / "map.db", 2))
    strided = maps(first, "--stride", 2, "--out", out, "--resume")
    outcomes.append(says("other pictures of a known folder are told", strided, {0, 2},
                         "stride, mode and the options of the frontend must be those of the run before"))
    outcomes.append(holds_drives(out / "map.db", 2))
    return outcomes


def localised(folder):
    out = fresh_folder("going_on/localised")
    maps(folder, "--out", out)
    return says("the map's own pictures are localised", maps(folder, "--out", out, "--localize"), {0},
                f"{NUM_FRAMES} of {NUM_FRAMES} images posed in the map")


def merged(first, second):
    stores = []
    for folder in (first, second):
        out = fresh_folder(f"going_on/store_of_{folder.name}")
        maps(folder, "--out", out)
        stores.append(out / "map.db")
    both = fresh_folder("going_on/both.db")
    both.unlink(missing_ok=True)
    return says("their stores merge", program("map_tool", "merge", *stores, both), {0},
                f"copied {2 * NUM_FRAMES} frames")


def interrupted(folder):
    """A drive that ends in the middle, orderly, goes on in one map."""
    out = fresh_folder("going_on/interrupted")
    out.mkdir()
    with Running("map_images", folder, "--out", out, *PLACES) as running:
        running.wait_until(lambda: (out / "map.db").exists() and frames_of(out / "map.db") >= ENOUGH_FRAMES)
        running.send(signal.SIGINT)
        status, _ = running.ended()
    maps(folder, "--out", out, "--resume")
    text = run(PROGRAMS / "map_tool", "info", out / "map.db")
    holds = status in (0, 130) and "maps      1\n" in text
    return "Ctrl-C and --resume leave one map", holds, f"status {status}, {text[:600]}"


def going_on(_quick):
    first, second = counted_from_zero("first", "engineRoom0"), counted_from_zero("second", "engineRoom1")
    return judge([*another_folder(first, second), localised(first), merged(first, second), interrupted(first)])


LINES = [
    Line("going_on", "folders whose times are counted from 0: a second one is a drive of its own, is localised and "
         "merged; a drive ended by Ctrl-C goes on in one map", going_on, True),
]
