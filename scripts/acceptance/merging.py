"""The lines about merging: any number of drives in one map."""

import filecmp
import functools
import itertools
import json

from acceptance import drives, trajectories
from acceptance.common import (BUILD, PLACES, PROGRAMS, ROOT, WORK, Skipped, dataset, fresh_folder,
                               map_images, percent, render_tour, run)

SEEDS = (1, 2, 3)
NOISE = 10
ENGINE_ROOM = ("engineRoom0", "engineRoom1")
MAX_SCALE_GAP = 0.03


def joint_error(summary):
    """Of the map that holds most, as a share of its path in per cent."""
    error, path = summary["ate_rmse_m"], summary["path_length_m"]
    return percent(error, path) if error is not None and path else float("inf")


def joined(summary, drive):
    """True if some accepted overlap joins the drive with another one."""
    name = f"folder_{drive}-"
    return any(r["verdict"] == "accepted" and r["query"].startswith(name) != r["other"].startswith(name)
               for r in summary["merges"]["reports"])


def verdicts(summary):
    counts = summary["merges"]
    return ", ".join(f"{counts[name]} {name}" for name in ("accepted", "provisional", "refused"))


@functools.lru_cache(maxsize=None)
def engine_room(seed, one_overlap, pose_graph):
    """(folders, folder of the map, summary); each made once in a run."""
    folders = [render_tour(tour, NOISE, seed) for tour in ENGINE_ROOM]
    name = (f"merge/engine_room_seed{seed}{'_one' if one_overlap else ''}"
            f"{'' if pose_graph else '_no_pose_graph'}")
    options = (["--max-overlaps", 1] if one_overlap else []) + ([] if pose_graph else ["--no-pose-graph"])
    return folders, WORK / name, map_images(name, folders, *options)


def engine_rooms(one_overlap, quick):
    holds, parts = True, []
    for seed in SEEDS[:1] if quick else SEEDS:
        _, _, s = engine_room(seed, one_overlap, True)
        holds = holds and s["maps"] == 1 and joint_error(s) <= 1.5
        parts.append(f"seed {seed}: {s['registered']} of {s['frames']} in the largest of {s['maps']} maps, "
                     f"{joint_error(s):.3f} % of the path, overlaps {verdicts(s)}")
    return holds, "; ".join(parts)


def all_overlaps(quick):
    return engine_rooms(False, quick)


def one_overlap(quick):
    return engine_rooms(True, quick)


def scale_ratio(quick):
    """Worst over seeds, with all overlaps and with one, pose graph on and off."""
    holds, parts = True, []
    for pose_graph, one in itertools.product((True, False), (False, True)):
        ratios = []
        for seed in SEEDS[:1] if quick else SEEDS:
            folders, out, _ = engine_room(seed, one, pose_graph)
            ratios.append(trajectories.scale_ratio(out, folders))
        holds = holds and all(r is not None and abs(r - 1) <= MAX_SCALE_GAP for r in ratios)
        parts.append(f"pose graph {'on' if pose_graph else 'off'}, "
                     f"{'one overlap' if one else 'all overlaps'}: "
                     + ", ".join("none" if r is None else f"{r:.4f}" for r in ratios))
    return holds, "; ".join(parts)


def glance(quick):
    """engineRoom0 and a tour of which one picture sees its end."""
    holds, parts = True, []
    for seed in SEEDS[:1] if quick else SEEDS:
        folders = [render_tour(tour, NOISE, seed) for tour in ("engineRoom0", "engineRoomGlance")]
        sees = drives.covisible_frames(folders[1], "engineRoom0", 0.05)
        s = map_images(f"merge/glance_seed{seed}", folders)
        holds = holds and len(sees) == 1 and s["maps"] == 1 and joint_error(s) <= 1.5
        shares = ", ".join(f"picture {frame} with {100 * share:.0f} %" for frame, share in sees.items())
        parts.append(f"seed {seed}: {shares}; {s['maps']} maps, {s['registered']} of {s['frames']}, "
                     f"{joint_error(s):.3f} %, {reasons(s)}")
    return holds, "; ".join(parts)


def reasons(summary, count=2):
    """What the reports across drives say: the accepted first."""
    across = [r for r in summary["merges"]["reports"]
              if r["query"].split("-")[0] != r["other"].split("-")[0]]
    across.sort(key=lambda r: ("accepted", "provisional", "refused", "undone").index(r["verdict"]))
    return " / ".join(f"{r['verdict']}: {r['reason']}" for r in across[:count]) or "no overlap found"


def four_folders():
    """Three parts of a circle that overlap, each of another drive, and a part of another world."""
    parts = [("turntable", 1, 0, 15), ("turntable", 2, 9, 24), ("turntable", 3, 18, 33),
             ("engineRoom0", 1, 0, 15)]
    return [drives.part_of(render_tour(tour, NOISE, seed), f"four_{i}", first, last)
            for i, (tour, seed, first, last) in enumerate(parts)]


def four_drives(quick):
    folders = four_folders()
    orders = list(itertools.permutations(range(4)))
    wrong, errors = [], []
    for order in orders[::4] if quick else orders:
        name = "merge/four_" + "".join(map(str, order))
        s = map_images(name, [folders[i] for i in order], "--features", 1000)
        errors.append(joint_error(s))
        if s["maps"] != 2 or not largest_map_is(WORK / name, order, alien=3):
            wrong.append(f"{order}: {s['maps']} maps, {reasons(s)}")
    return not wrong, (f"{len(errors) - len(wrong)} of {len(errors)} orders, joint error up to "
                       f"{max(errors):.3f} % of the path; " + "; ".join(wrong))


def largest_map_is(out, order, alien):
    """True if the map that holds most has every drive but one."""
    return all((out / f"trajectory_folder_{i}.txt").exists() == (drive != alien)
               for i, drive in enumerate(order))


def laps(_quick):
    """Two laps on one circle, 95 pictures and 94."""
    folder = render_tour("turntable2", NOISE, 1)
    s = map_images("merge/turntable2", [folder])
    out = WORK / "merge/turntable2"
    gaps = run(ROOT / "scripts/plot_laps.py", out / "trajectory.txt", folder / "groundtruth.txt", 95,
               out / "laps.png")
    largest_mm = float(gaps.split("largest ")[1].split()[0])
    loops = sum(r["kind"] == "loop" and r["verdict"] == "accepted" for r in s["merges"]["reports"])
    return (s["sessions"] == 1 and loops > 0 and joint_error(s) <= 0.4 and largest_mm <= 10.0), (
        f"{loops} loops closed, error {joint_error(s):.3f} % of the path, {gaps.strip()}; {out / 'laps.png'}")


def halves(quick):
    whole = dataset("tum_fr1_xyz")
    stride = 4 if quick else 1
    count = len(drives.image_list(whole))
    folders = [drives.part_of(whole, "fr1_first", 0, count // 2 - 1, stride),
               drives.part_of(whole, "fr1_second", count // 2, count - 1, stride)]
    s = map_images("merge/fr1_halves", folders, "--mode", "parallax")
    bound_m = 0.05 if quick else 0.02
    return s["maps"] == 1 and small(s, bound_m), (
        f"{s['maps']} maps, {s['registered']} of {s['frames']}, {centimetres(s)}, {reasons(s)}"
        + (f" (every {stride}th, <= {100 * bound_m:.0f} cm)" if quick else ""))


def xyz_and_rpy(_quick):
    folders = [dataset("tum_fr1_xyz"), dataset("tum_fr1_rpy")]
    s = map_images("merge/fr1_both", folders, "--mode", "parallax")
    file = WORK / "merge/fr1_both/trajectory_folder_1.txt"
    posed = len(trajectories.read_centers(file)) if file.exists() else 0
    share = percent(posed, len(drives.image_list(folders[1])))
    return share >= 80 and small(s, 0.04), (
        f"{share:.1f} % of the second's pictures, {s['maps']} maps of {s['sessions']} sessions, "
        f"{centimetres(s)}, overlaps {verdicts(s)}, {reasons(s)}")


def small(summary, bound_m):
    return summary["ate_rmse_m"] is not None and summary["ate_rmse_m"] <= bound_m


def centimetres(summary):
    error = summary["ate_rmse_m"]
    return "no error known" if error is None else f"{100 * error:.2f} cm"


def castle(quick):
    """The castle stays alone beside drives of every other world."""
    others = [render_tour(tour, NOISE, 1) for tour in ("visionlab", "engineRoom0")]
    if not quick:
        others += [dataset("strecha_fountain_p11"),
                   drives.part_of(dataset("tum_fr1_xyz"), "fr1_thin", stride=16)]
    s = map_images("merge/castle", [dataset("leuven_castle"), *others])
    alone = not any(joined(s, drive) for drive in range(len(others) + 1))
    return alone and s["maps"] >= 1 + len(others), (
        f"{s['maps']} maps of {len(others) + 1} drives, overlaps {verdicts(s)}, {reasons(s)}")


def lost(_quick):
    """Ten black pictures within the first of two laps."""
    whole = render_tour("turntable2", NOISE, 1)
    folder = drives.part_of(whole, "lost", 0, 149, black=range(40, 50))
    s = map_images("merge/lost", [folder])
    return s["maps"] == 1 and s["registered"] >= 0.95 * 140 and joint_error(s) <= 1.5, (
        f"{s['maps']} maps of {s['sessions']} sessions, {s['registered']} of 140 pictures that show "
        f"something, {joint_error(s):.3f} % of the path, overlaps {verdicts(s)}")


def deterministic(_quick):
    """map_images and, where it is built, replay: one thread, two threads, two threads."""
    folders = four_folders()[:2]
    summaries = [map_images(f"merge/same_{i}", folders, threads=threads)
                 for i, threads in enumerate((1, 2, 2))]
    same = len({json.dumps(s["merges"]) for s in summaries}) == 1 and equal_maps("merge/same")
    figures = (f"three runs {'equal' if same else 'DIFFER'}, {summaries[0]['maps']} map, overlaps "
               f"{verdicts(summaries[0])}")
    if not (PROGRAMS / "replay").exists():
        return same and joined(summaries[0], 0), figures + "; replay is not built"
    replayed = replay_thrice(folders)
    return same and joined(summaries[0], 0) and replayed, (
        figures + f"; three replays {'equal' if replayed else 'DIFFER'}")


def equal_maps(name):
    """True if three runs gave the same bytes."""
    return all(filecmp.cmp(WORK / f"{name}_0" / file, WORK / f"{name}_{i}" / file, shallow=False)
               for i in (1, 2) for file in ("trajectory.txt", "cloud.ply"))


def replay_thrice(folders):
    bags = []
    for i, folder in enumerate(folders):
        bags.append(WORK / f"merge/drive_{i}.bag")
        run(PROGRAMS / "images_to_bag", folder, bags[-1], "--robot", f"rovio_{i}", "--overwrite")
    for i, threads in enumerate((1, 2, 2)):
        run(PROGRAMS / "replay", *bags, "--out", fresh_folder(f"merge/replayed_{i}"), "--threads", threads,
            "--mode", "every", *PLACES)
    return equal_maps("merge/replayed")


def twin_worlds(quick):
    """Two rooms that share three textured objects, standing otherwise."""
    holds, parts = True, []
    for seed in SEEDS[:1] if quick else SEEDS:
        folders = [render_tour(tour, NOISE, seed) for tour in ("repeatsA", "repeatsB")]
        s = map_images(f"merge/twins_seed{seed}", folders)
        holds = holds and s["maps"] == 2 and not joined(s, 0)
        parts.append(f"seed {seed}: {s['maps']} maps, {s['registered']} pictures in the larger, overlaps "
                     f"{verdicts(s)}, {reasons(s)}")
    return holds, "; ".join(parts)


def unit_tests(suite):
    """A line that holds if the tests of a suite of app_test do, and there are some."""
    def check(_quick):
        places = PROGRAMS / "app_test", BUILD / "app_test"
        program = next((place for place in places if place.exists()), None)
        if program is None:
            raise Skipped("app_test is not built")
        said = run(program, f"--gtest_filter={suite}.*", check=False)
        failed = [line.split("]")[1].strip() for line in said.splitlines() if "[  FAILED  ]" in line]
        count = said.count("[       OK ]")
        return count > 0 and not failed, f"{count} tests passed" + "".join(f"; {f}" for f in failed)
    return check
