#!/usr/bin/python3
"""Feeds a mapping node with synthetic drives and prints, as JSON, what it kept. Needs a ROS master.
kill PROGRAMS FOLDER NUM_KILLS SEED    kills it (-9) at random moments, checks its store, starts it again
fill PROGRAMS FOLDER                   until its disk is full, and ten frames more"""

import contextlib
import json
import pathlib
import random
import shutil
import sqlite3
import subprocess
import sys
import time

import rospy
from rovio_sfm.msg import FrameEventMsg, MapStatus, PlaceMatchMsg

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "test/ros"))
from driver_fixture import wait_until  # noqa: E402 (a folder of tests)
from synthetic_drives import NUM_CAMERAS, World  # noqa: E402 (a folder of tests)

PATIENCE_S = 120
ROBOTS = ("rovio1", "rovio2")
PERIOD_S = 0.04  # between frames
LONGEST_LIFE_S = 2.5
LEFT_BYTES = 4 << 20  # on a disk that is to be full soon
OVERLAP_AT = 19  # camera whose frame is recognised


def wait_for(condition, what):
    if not wait_until(condition, PATIENCE_S):
        raise RuntimeError(f"no {what} within {PATIENCE_S} s")


class Feeder:
    """Sends the frames of one world after another, each from where the store ends."""

    def __init__(self, programs, folder):
        self.programs, self.folder, self.store = programs, folder, folder / "map.db"
        self.frames = [rospy.Publisher(f"/{robot}/frames", FrameEventMsg, queue_size=200) for robot in ROBOTS]
        self.matches = rospy.Publisher("/place_matches", PlaceMatchMsg, queue_size=10)
        self.status, self.nodes = None, []
        rospy.Subscriber("/map_status", MapStatus, self.take_status)
        self.num_worlds, self.next_camera = 0, 0
        self.begin_world()

    def take_status(self, status):
        self.status = status

    def begin_world(self):
        self.num_worlds += 1
        self.world = World(rospy.Time(1000 * self.num_worlds), seed=self.num_worlds)
        self.next_camera = 0

    def start(self):
        wait_for(lambda: all(p.get_num_connections() == 0 for p in self.frames), "end of the last node")
        self.status = None
        node = subprocess.Popen([self.programs / "mapping", f"_output_dir:={self.folder}"],
                                stdout=subprocess.DEVNULL)
        self.nodes.append(node)
        publishers = [*self.frames, self.matches]
        wait_for(lambda: node.poll() is not None or all(p.get_num_connections() == 1 for p in publishers), "mapping")
        if node.poll() is not None:
            raise RuntimeError(f"mapping ended with {node.returncode}")
        return node

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for node in self.nodes:
            node.kill()

    def send_next(self):
        if self.next_camera == NUM_CAMERAS:
            self.begin_world()
        camera = self.next_camera
        self.frames[camera % 2].publish(self.world.frame(camera))
        if camera == OVERLAP_AT:
            self.matches.publish(self.world.place_match(camera, camera - 1))
        self.next_camera += 1

    def send_for(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.send_next()
            time.sleep(PERIOD_S)

    def announced(self):
        """(robot, start, how many frames) that no crash can take any more."""
        saved = self.status.saved_up_to if self.status else []
        return [(i.drive.robot, i.drive.start.to_nsec(), i.index + 1) for i in saved]

    def stored(self):
        """Frames in the store, by drive."""
        with contextlib.closing(sqlite3.connect(f"file:{self.store}?mode=ro", uri=True)) as store:
            return {(robot, start): count for robot, start, count in store.execute(
                "SELECT robot, start_ns, count(*) FROM frame JOIN drive ON drive.id = frame.drive GROUP BY drive.id")}

    def is_whole(self):
        return subprocess.run([self.programs / "map_tool", "check", self.store], check=False,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def go_on_from_store(self):
        """As frontends do, which serve again what mapping missed: both drives from the earlier end."""
        stored = self.stored()
        start = self.world.start.to_nsec()
        self.next_camera = 2 * min(stored.get((robot, start), 0) for robot in ROBOTS)


def lost(announced, stored):
    return sum(max(0, count - stored.get((robot, start), 0)) for robot, start, count in announced)


def kill(feeder, num_kills, seed):
    moments = random.Random(seed)
    said, num_lost, num_broken = 0, 0, 0
    for _ in range(num_kills):
        node = feeder.start()
        feeder.send_for(moments.uniform(0.0, LONGEST_LIFE_S))
        announced = feeder.announced()
        node.kill()
        node.wait()
        if not feeder.store.exists():
            num_lost += sum(count for *_, count in announced)
            continue
        said += len(announced)
        num_broken += 0 if feeder.is_whole() else 1
        num_lost += lost(announced, feeder.stored())
        feeder.go_on_from_store()
    return {"kills": num_kills, "announcements": said, "frames": sum(feeder.stored().values()),
            "lost": num_lost, "broken": num_broken}


def fill(feeder):
    node = feeder.start()
    room = shutil.disk_usage(feeder.folder).free
    (feeder.folder / "filler").write_bytes(b"\0" * max(0, room - LEFT_BYTES))
    end = time.monotonic() + PATIENCE_S
    while not (feeder.status and feeder.status.store_error):
        if time.monotonic() > end or node.poll() is not None:
            raise RuntimeError("the disk never was full")
        feeder.send_next()
        time.sleep(PERIOD_S)
    error, announced, events = feeder.status.store_error, feeder.announced(), feeder.status.num_events
    for _ in range(10):
        feeder.send_next()
    wait_for(lambda: feeder.status.num_events >= events + 10, "event after the disk was full")
    node.kill()
    node.wait()
    return {"error": error, "announcements": len(announced), "lost": lost(announced, feeder.stored()),
            "whole": feeder.is_whole()}


def main():
    rospy.init_node("feed_mapping", disable_signals=True)
    rospy.set_param("/mapping/robots", list(ROBOTS))
    how, programs, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    with Feeder(programs, folder) as feeder:
        kept = kill(feeder, int(sys.argv[4]), int(sys.argv[5])) if how == "kill" else fill(feeder)
    print(json.dumps(kept))


if __name__ == "__main__":
    main()
