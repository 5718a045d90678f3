#!/usr/bin/python3
"""The demo's drive: two simulated robots and their graph, one map of both, and its comparison with
the truth."""

import argparse
import contextlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import yaml

import demo_services
from demo_graph import (STALL_S, Graph, MergeWatch, Progress, TruthRecorder, free_ports, run,
                        wait_for)
from demo_pictures import MIN_COLOURED_SHARE
from read_plainly import Unreadable, end_plainly

HERE = pathlib.Path(__file__).resolve().parent  # scripts/, or lib/rovio_sfm of an install space
IS_INSTALLED = HERE.name == "rovio_sfm"
SHARE = HERE.parent.parent / "share/rovio_sfm" if IS_INSTALLED else HERE.parent
OUT = pathlib.Path("rovio_sfm_demo") if IS_INSTALLED else SHARE / "out/demo"
TOURS = {"rovio1": "engineRoom0", "rovio2": "engineRoom1"}  # by robot: where they begin
WAYS = {"rovio1": SHARE / "config/tours/engineRoom0.yaml",
        "rovio2": SHARE / "config/demo/engineRoom1.yaml"}  # and where they drive
FORMATS = "tum,ply,dense,mesh,grid,report"
MAX_TRUTH_GAP_S = 0.5  # the robots rest while they look
PATIENCE = ("_stop_timeout_s:=50", "_look_timeout_s:=50", "_ready_timeout_s:=300")  # slow machines
MIN_REGISTERED, MAX_ERROR, MAX_SCALE_ERROR = 0.95, 0.015, 0.10  # shares


def count_stops(way):
    way_points = yaml.safe_load(way.read_text())["way_points"]
    return 1 + sum(point.get("frames", 1) for point in way_points[1:])


def tour_log(out, robot):
    return out / f"drive_tour_{robot}.log"


def start_tour(programs, out, robot):
    with tour_log(out, robot).open("w") as log:
        return subprocess.Popen(
            [programs / "drive_tour", f"__ns:={robot}", "_look:=frame",
             f"_tour:={WAYS[robot]}", *PATIENCE],
            stdout=log, stderr=subprocess.STDOUT)


def drive(programs, out, graph, start, watch):
    """Both robots drive their tours, however long it takes; whether every stop was looked at. Ends
    early where nothing goes on any more."""
    drivers = {robot: start_tour(programs, out, robot) for robot in TOURS}
    progress = Progress(start, {robot: tour_log(out, robot) for robot in TOURS})
    while any(driver.poll() is None for driver in drivers.values()):
        graph.require_alive()
        watch.tell()
        progress.look(watch.status)
        if progress.has_stalled():
            print(f"no new stop, frame or pose for {STALL_S} s: the tours end here")
            break
        time.sleep(0.5)
    for robot, driver in drivers.items():
        if driver.poll() != 0:
            print(f"drive_tour of {robot} did not end well; see {tour_log(out, robot)}")
        driver.terminate()
    return all(driver.wait() == 0 for driver in drivers.values())


def finish(watch):
    """Ends the sessions and returns the status of the maps."""
    for robot in TOURS:
        run("rosservice", "call", "/finish_session", f"robot: {robot}")
    return watch.final_status(len(TOURS))


def export():
    print("dense cloud, surface, grid and page are made: a minute or three", flush=True)
    reply = yaml.safe_load(run("rosservice", "call", "/export_map",
                               f"{{map: 0, name: demo, overwrite: true, formats: '{FORMATS}'}}"))
    if not reply["files"]:
        raise RuntimeError(f"export_map: {reply['status']}")


def evaluate(programs, out, status):
    pairs = [(out / f"truth_{robot}.txt", out / f"map/demo/trajectory_{robot}.txt")
             for robot in TOURS if (out / f"map/demo/trajectory_{robot}.txt").exists()]
    if not pairs:  # the robots did not meet
        largest = max(status.sessions, key=lambda session: session.num_frames)
        pairs = [(out / f"truth_{largest.drive.robot}.txt", out / "map/demo/trajectory.txt")]
    errors = json.loads(run(programs / "evaluate_trajectory", *[f for pair in pairs for f in pair],
                            "--json", "--metric", "--max-gap", MAX_TRUTH_GAP_S))
    largest = max(status.maps, key=lambda entry: entry.num_frames)
    registered = sum(session.num_keyframes for session in status.sessions
                     if session.map == largest.map)
    num_stops = sum(count_stops(way) for way in WAYS.values())
    return {
        "stops": num_stops, "keyframes": status.num_events, "registered": registered,
        "registered_share": registered / max(num_stops, status.num_events),
        "maps": sum(entry.num_frames > 0 for entry in status.maps),
        "sessions": len(status.sessions), "merges_accepted": status.num_merges_accepted,
        "path_length_m": errors["path_length_m"], "ate_rmse_m": errors["ate_rmse_m"],
        "error_share_of_path": errors["ate_rmse_m"] / errors["path_length_m"],
        "rotation_rmse_deg": errors["rotation_rmse_deg"], "compared": errors["compared"],
        "metric": bool(largest.metric), "scale_source": largest.scale_source,
        "scale_error": errors["scale_error"], "scale_sigma": largest.scale_sigma_log,
        "landmarks": largest.num_landmarks}


def verdicts(figures):
    return {
        f"a picture at each of the {figures['stops']} stops": figures["has_seen_every_stop"],
        f"one map of both robots (maps: {figures['maps']})":
            figures["maps"] == 1 and figures["merges_accepted"] > 0,
        f"registered {100 * figures['registered_share']:.1f} % of the stops' keyframes in it":
            figures["registered_share"] >= MIN_REGISTERED,
        f"joint error {100 * figures['error_share_of_path']:.2f} % of the path":
            figures["error_share_of_path"] <= MAX_ERROR,
        f"metric scale from {figures['scale_source'] or 'nothing'}, wrong by "
        f"{100 * figures['scale_error']:.1f} %":
            figures["metric"] and figures["scale_error"] <= MAX_SCALE_ERROR}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=pathlib.Path, default=HERE)
    parser.add_argument("--out", type=pathlib.Path, default=OUT)
    parser.add_argument("--screenshots", type=pathlib.Path, metavar="DIR",
                        help="keep pictures of the display before and after the merge")
    parser.add_argument("--vocabulary", default="", help="another place model than the package's")
    parser.add_argument("--services", action="store_true",
                        help="afterwards unmerge the robots by rosservice, and merge them again")
    return parser.parse_args()


def picture_verdicts(shares):
    return {f"{name}: {100 * share:.1f} % of the view has a colour": share >= MIN_COLOURED_SHARE
            for name, share in shares.items()}


def report(out, figures, merges, answers):
    (out / "demo.json").write_text(json.dumps(figures, indent=2) + "\n")
    (out / "merges.txt").write_text("".join(merge + "\n" for merge in merges))
    run("/usr/bin/python3", HERE / "plot_map.py", out / "map/demo/cloud.ply",
        out / "map/demo/trajectory.txt", out / "map.png")
    results = {**verdicts(figures), **answers}
    for text, holds in results.items():
        print(f"{'holds' if holds else 'FALLS':6} {text}")
    for name in ("map/map.db", *(f"map/demo/{name}" for name in (
            "cloud.ply", "trajectory.txt", "dense.ply", "mesh.ply", "map.yaml", "report.html")),
            "map.png", "merges.txt", "demo.json"):
        print(f"wrote {out / name}")
    return all(results.values())


def begin_folder(out):
    """Empties the folder of an earlier demo, and no other."""
    figures = out / "demo.json"
    if out.exists() and not figures.exists() and (not out.is_dir() or any(out.iterdir())):
        raise Unreadable(f"{out}: holds something else; expected a new folder, or that of an earlier demo")
    shutil.rmtree(out, ignore_errors=True)
    (out / "map").mkdir(parents=True)
    figures.write_text("{}\n")


def main():
    arguments = parse_arguments()
    out = arguments.out.resolve()
    begin_folder(out)
    start, port = time.monotonic(), free_ports(len(TOURS))
    graph = Graph(out, [
        "multi.launch", "sim:=true", "robots:=" + ",".join(TOURS),
        "tours:=" + ",".join(TOURS.values()), f"port:={port}", "seed:=1", "noise:=10", "camera:=plain",
        "drive:=false", f"output_dir:={out / 'map'}", f"vocabulary:={arguments.vocabulary}",
        f"rviz:={str(bool(os.environ.get('DISPLAY'))).lower()}"])
    recorders = {robot: TruthRecorder(port + i) for i, robot in enumerate(TOURS)}
    with contextlib.ExitStack() as stack:
        stack.callback(graph.stop)
        for robot, recorder in recorders.items():
            recorder.start()
            stack.callback(recorder.write, out / f"truth_{robot}.txt")
        wait_for("mapping", lambda: "/export_map" in run("rosservice", "list", check=False), graph)
        wait_for("a simulated robot", lambda: all(r.rows for r in recorders.values()), graph)
        watch = MergeWatch(start, arguments.screenshots)
        has_seen_every_stop = drive(arguments.programs, out, graph, start, watch)
        status = finish(watch)
        watch.take_last_picture()
        answers = demo_services.take_apart_and_merge() if arguments.services else {}
        export()
    figures = evaluate(arguments.programs, out, status)
    figures["has_seen_every_stop"] = has_seen_every_stop
    figures["seconds"] = round(time.monotonic() - start)
    answers.update(picture_verdicts(watch.shares))
    return 0 if report(out, figures, watch.lines, answers) else 1


if __name__ == "__main__":
    try:
        sys.exit(end_plainly(main))
    except KeyboardInterrupt:
        sys.exit("run_demo.py: stopped")
