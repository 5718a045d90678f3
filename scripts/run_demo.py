#!/usr/bin/python3
"""The demo's drive: sim.launch, a tour, export, and the comparison with the truth."""

import argparse
import http.client
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROBOT = "rovio1"
TRUTH_PERIOD_S = 0.02
MAX_TRUTH_GAP_S = 0.5  # the robot rests while it looks
TOUR = ROOT / "config/tours/visionlab.yaml"
TOUR_DEADLINE_S = 310  # after the start; what follows takes some 20 s
MIN_REGISTERED, MAX_ERROR, MAX_SCALE_ERROR = 0.95, 0.015, 0.10  # shares


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def run(*command, timeout_s=60, check=True):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          timeout=timeout_s, check=False)
    if check and done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {(done.stdout + done.stderr).strip()}")
    return done.stdout


class TruthRecorder(threading.Thread):
    """Polls the simulator's true camera pose and stamps it with this machine's clock."""

    def __init__(self, port):
        super().__init__(daemon=True)
        self.port, self.rows, self.stopped = port, [], threading.Event()

    def run(self):
        while not self.stopped.wait(TRUTH_PERIOD_S):
            before = time.time()
            pose = self.read()
            if pose:
                self.rows.append((0.5 * (before + time.time()), pose))

    def read(self):
        try:
            connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=2)
            connection.request("GET", "/sim?truth")
            text = connection.getresponse().read().decode()
            connection.close()
        except (OSError, http.client.HTTPException):
            return None
        fields = dict(line.split(" = ", 1) for line in text.splitlines() if " = " in line)
        return fields.get("world_from_camera")

    def write(self, path):
        self.stopped.set()
        self.join()
        path.write_text("# timestamp tx ty tz qx qy qz qw (camera to world)\n"
                        + "".join(f"{stamp:.6f} {pose}\n" for stamp, pose in self.rows))


class Graph:
    """The nodes of sim.launch, under a roscore of their own."""

    def __init__(self, out, sim_port, rviz):
        os.environ["ROS_MASTER_URI"] = f"http://127.0.0.1:{free_port()}"
        os.environ.update(ROS_IP="127.0.0.1", ROS_HOME=str(out / "ros"), PYTHONUNBUFFERED="1",
                          ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        os.environ.pop("ROS_HOSTNAME", None)
        self.log = (out / "roslaunch.log").open("w")
        self.process = subprocess.Popen(
            ["roslaunch", "--port", os.environ["ROS_MASTER_URI"].rsplit(":", 1)[1], "rovio_sfm",
             "sim.launch", f"robot:={ROBOT}", "tour:=visionlab", "noise:=10", "seed:=1",
             f"port:={sim_port}", f"output_dir:={out / 'map'}", f"rviz:={str(rviz).lower()}",
             "drive:=false"],
            stdout=self.log, stderr=subprocess.STDOUT, start_new_session=True)

    def require_alive(self):
        if self.process.poll() is not None:
            raise RuntimeError(f"roslaunch ended; see {self.log.name}")

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(40)
            except subprocess.TimeoutExpired:
                self.process.kill()
        self.log.close()


def wait_for(what, ready, graph, timeout_s=90):
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        graph.require_alive()
        if ready():
            return
        time.sleep(0.5)
    raise RuntimeError(f"{what} did not come up in {timeout_s} s; see {graph.log.name}")


def drive(programs, out, graph, deadline):
    """Drives the tour, the graph's other nodes beside it; whether every stop was looked at."""
    wait_for("mapping", lambda: "/export_map" in run("rosservice", "list", check=False), graph)
    with (out / "drive_tour.log").open("w") as log:
        try:
            done = subprocess.run(
                [programs / "drive_tour", f"__ns:={ROBOT}", f"_tour:={TOUR}", "_look:=frame"],
                stdout=log, stderr=subprocess.STDOUT, timeout=deadline - time.monotonic(), check=False)
            end = f"ended with {done.returncode}"
        except subprocess.TimeoutExpired:
            end = "did not end in time"
    if end != "ended with 0":
        print(f"drive_tour {end}; see {log.name}")
    return end == "ended with 0"


def count_stops():
    way_points = yaml.safe_load(TOUR.read_text())["way_points"]
    return 1 + sum(point.get("frames", 1) for point in way_points[1:])


def finish(out):
    """Ends the session, exports the map, and returns the map's status."""
    run("rosservice", "call", "/finish_session", f"robot: {ROBOT}", timeout_s=120)
    status = next(yaml.safe_load_all(run("rostopic", "echo", "-n", "1", "/map_status")))
    reply = yaml.safe_load(run("rosservice", "call", "/export_map",
                               "{map: 0, name: demo, overwrite: true}"))
    if not reply["files"]:
        raise RuntimeError(f"export_map: {reply['status']}")
    return status


def evaluate(programs, out, status):
    errors = json.loads(run(programs / "evaluate_trajectory", out / "truth.txt",
                            out / "map/demo/trajectory.txt", "--json", "--metric", "--max-gap",
                            MAX_TRUTH_GAP_S))
    registered = sum(session["num_keyframes"] for session in status["sessions"])
    expected = max(count_stops(), status["num_events"])
    largest = max(status["maps"], key=lambda entry: entry["num_frames"])
    return {
        "stops": count_stops(), "keyframes": status["num_events"], "registered": registered,
        "registered_share": registered / expected,
        "path_length_m": errors["path_length_m"], "ate_rmse_m": errors["ate_rmse_m"],
        "error_share_of_path": errors["ate_rmse_m"] / errors["path_length_m"],
        "rotation_rmse_deg": errors["rotation_rmse_deg"], "compared": errors["compared"],
        "metric": bool(largest["metric"]), "scale_source": largest["scale_source"],
        "scale_error": errors["scale_error"], "scale_sigma": largest["scale_sigma_log"],
        "landmarks": largest["num_landmarks"], "sessions": len(status["sessions"])}


def verdicts(figures):
    return {
        f"a picture at each of the {figures['stops']} stops": figures["has_seen_every_stop"],
        f"registered {100 * figures['registered_share']:.1f} % of the stops' keyframes":
            figures["registered_share"] >= MIN_REGISTERED,
        f"error {100 * figures['error_share_of_path']:.2f} % of the path":
            figures["error_share_of_path"] <= MAX_ERROR,
        f"metric scale from {figures['scale_source'] or 'nothing'}, wrong by "
        f"{100 * figures['scale_error']:.1f} %":
            figures["metric"] and figures["scale_error"] <= MAX_SCALE_ERROR}


def take_picture(path):
    run("import", "-window", "root", "+dither", "-colors", "96", f"PNG8:{path}")
    print(f"screenshot {path.resolve()}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/demo")
    parser.add_argument("--screenshot", type=pathlib.Path)
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    shutil.rmtree(out, ignore_errors=True)
    (out / "map").mkdir(parents=True)
    start, sim_port = time.monotonic(), free_port()
    graph = Graph(out, sim_port, rviz=bool(os.environ.get("DISPLAY")))
    recorder = TruthRecorder(sim_port)
    try:
        recorder.start()
        has_seen_every_stop = drive(arguments.programs, out, graph, start + TOUR_DEADLINE_S)
        status = finish(out)
        if arguments.screenshot:
            take_picture(arguments.screenshot)
    finally:
        recorder.write(out / "truth.txt")
        graph.stop()
    figures = evaluate(arguments.programs, out, status)
    figures["has_seen_every_stop"] = has_seen_every_stop
    figures["seconds"] = round(time.monotonic() - start)
    (out / "demo.json").write_text(json.dumps(figures, indent=2) + "\n")
    run("/usr/bin/python3", ROOT / "scripts/plot_map.py", out / "map/demo/cloud.ply",
        out / "map/demo/trajectory.txt", out / "map.png")
    results = verdicts(figures)
    for text, holds in results.items():
        print(f"{'holds' if holds else 'FALLS':6} {text}")
    for name in ("map/demo/cloud.ply", "map/demo/trajectory.txt", "map.png", "demo.json"):
        print(f"wrote {out / name}")
    return 0 if all(results.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
