"""What the demo stands on: the graph of nodes, the truth of the simulators, a look at the maps."""

import http.client
import math
import os
import random
import re
import signal
import socket
import subprocess
import threading
import time

from demo_pictures import coloured_share

TRUTH_PERIOD_S = 0.04
PORTS = range(10000, 32768)  # Linux gives none of them to a client's connection
KINDS = ("merge", "loop", "seed")
VERDICTS = ("waits", "accepted", "provisional", "refused", "undone")
HANG_S = 900  # a call that takes longer hangs, however slow the machine
STALL_S = 60  # without any progress
TELL_PERIOD_S = 10
STOP = re.compile(r"stop (\d+) of (\d+)|the tour is done: (\d+) stops")
KEYFRAMES_BEFORE_PICTURE = 60  # of the first robot: it comes near the place where they meet


def run(*command, timeout_s=HANG_S, check=True):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          timeout=timeout_s, check=False)
    if check and done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {(done.stdout + done.stderr).strip()}")
    return done.stdout


def is_free(port):
    with socket.socket() as probe:
        try:
            probe.bind(("127.0.0.1", port))
        except OSError:
            return False
    return True


def free_ports(count):
    """The first of so many free ports in a row; connections do not take them before a slow server does."""
    while True:
        first = random.choice(PORTS[:-count])
        if all(is_free(first + i) for i in range(count)):
            return first


def wait_for(what, ready, graph, timeout_s=HANG_S):
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        graph.require_alive()
        if ready():
            return
        time.sleep(0.5)
    raise RuntimeError(f"{what} did not come up in {timeout_s} s; see {graph.log.name}")


class Graph:
    """The nodes of a launch file, under a roscore of their own."""

    def __init__(self, out, arguments):
        port = free_ports(1)
        os.environ["ROS_MASTER_URI"] = f"http://127.0.0.1:{port}"
        os.environ.update(ROS_IP="127.0.0.1", ROS_HOME=str(out / "ros"), PYTHONUNBUFFERED="1",
                          ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        os.environ.pop("ROS_HOSTNAME", None)
        self.log = (out / "roslaunch.log").open("w")
        self.process = subprocess.Popen(["roslaunch", "--port", str(port), "rovio_sfm"] + arguments,
                                        stdout=self.log, stderr=subprocess.STDOUT,
                                        start_new_session=True)

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


class Progress:
    """What has been reached: stops, frames, maps. Tells it every ten seconds, and knows since when
    nothing more has been."""

    def __init__(self, start, tour_logs, clock=time.monotonic):
        self.start, self.tour_logs = start, tour_logs  # tour_logs: {robot: log of its drive_tour}
        self.clock, self.reached = clock, None
        self.changed = self.told = clock()

    def look(self, status):
        """Takes in the newest map_status, None before the first. Call often."""
        now = self.clock()
        stops = {robot: last_stop(log) for robot, log in self.tour_logs.items()}
        reached = stops, status and (status.num_events, [s.num_frames for s in status.sessions])
        if reached != self.reached:
            self.reached, self.changed = reached, now
        if now - self.told >= TELL_PERIOD_S:
            self.told = now
            print(f"{now - self.start:5.0f} s  {describe_progress(stops, status)}", flush=True)

    def has_stalled(self):
        return self.clock() - self.changed > STALL_S


def last_stop(log):
    """The newest "N of M" of a tour's log; empty before the first."""
    found = list(STOP.finditer(log.read_text(errors="replace"))) if log.exists() else []
    if not found:
        return ""
    return f"{found[-1][1]} of {found[-1][2]}" if found[-1][1] else f"{found[-1][3]} of {found[-1][3]}"


def describe_progress(stops, status):
    parts = [f"{robot} at stop {stop}" for robot, stop in stops.items() if stop]
    if status:
        maps = [entry for entry in status.maps if entry.num_frames > 0]
        parts.append(f"{status.num_events} frames, {len(maps)} map{'s' * (len(maps) != 1)} with "
                     f"{sum(entry.num_landmarks for entry in maps)} landmarks")
    return "; ".join(parts) or "the robots look round"


class TruthRecorder(threading.Thread):
    """Polls a simulator's true camera pose and stamps it with this machine's clock."""

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


def describe(merge):
    """A merge report in a line; mapping's message says what every figure is."""
    after = "to be adjusted" if math.isnan(merge.error_after_px) else f"{merge.error_after_px:.2f} px"
    return (f"{KINDS[merge.kind]} {merge.id} {VERDICTS[merge.verdict]}: session "
            f"{merge.query_session} ({merge.query.drive.robot}/{merge.query.index}) on "
            f"{merge.other_session} ({merge.other.drive.robot}/{merge.other.index}), "
            f"{merge.num_matches} matches, {merge.num_inliers} inliers, {merge.num_links} links, "
            f"scale {merge.scale:.3f}, error {merge.error_before_px:.2f} px -> "
            f"{after}; {merge.reason}"
            + (f"; warning: {merge.warning}" if merge.warning else ""))


class MergeWatch:
    """Follows map_status: prints what is merged, and keeps pictures of before and after."""

    def __init__(self, start, pictures):
        import rospy  # needs the master that Graph has named
        from rovio_sfm.msg import MapStatus
        self.start, self.pictures, self.status = start, pictures, None
        self.told, self.lines, self.has_picture_before = {}, [], False
        self.shares = {}  # picture: share of its view that has a colour
        rospy.init_node("demo", anonymous=True, disable_signals=True)
        self.subscriber = rospy.Subscriber("/map_status", MapStatus, self.keep, queue_size=10)

    def keep(self, status):
        self.status = status

    def tell(self):
        status = self.status
        if status is None:
            return
        for merge in status.merges:
            self.tell_merge(merge)
        keyframes = [session.num_keyframes for session in status.sessions]
        is_before = len(status.maps) > 1 and keyframes[0] >= KEYFRAMES_BEFORE_PICTURE
        if is_before and not self.has_picture_before:
            self.has_picture_before = True
            self.take_picture("merge_before.png")

    def tell_merge(self, merge):
        if self.told.get(merge.id) == merge.verdict:
            return
        self.told[merge.id] = merge.verdict
        line = f"{time.monotonic() - self.start:5.0f} s  {describe(merge)}"
        self.lines.append(line)
        if merge.kind != merge.LOOP:  # further overlaps of one map are many
            print(line, flush=True)

    def final_status(self, num_sessions):
        """The status after all sessions are over."""
        deadline = time.monotonic() + HANG_S
        while time.monotonic() < deadline:
            status = self.status
            if status and sum(s.state >= s.FINISHED for s in status.sessions) >= num_sessions:
                self.tell()
                return status
            time.sleep(0.2)
        raise RuntimeError("map_status does not say that the sessions are finished")

    def take_last_picture(self):
        if self.pictures:
            time.sleep(2.0)  # rviz shows the newest message with its next frame
            self.take_picture("merge_after.png")

    def take_picture(self, name):
        if not self.pictures:
            return
        path = self.pictures / name
        run("import", "-window", "root", "+dither", "-colors", "96", f"PNG8:{path}")
        self.shares[name] = coloured_share(path)
        print(f"picture {path.resolve()}: {100 * self.shares[name]:.1f} % of the view has a colour",
              flush=True)
