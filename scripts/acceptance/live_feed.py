#!/usr/bin/python3
"""Plays a folder of images to live nodes at an even rate and prints, as JSON, after how many seconds the pose of
each was told, null where it was not: live_feed FOLDER TOPIC RATE_HZ. Needs a ROS master on which a frontend listens to
TOPIC/compressed."""

import json
import pathlib
import sys
import time

import rospy
from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import CompressedImage

PATIENCE_S = 60  # until the nodes are there
QUIET_S = 5  # without a pose: no more will come


def wait_until(condition, patience_s):
    end = time.monotonic() + patience_s
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


class Listener:
    """When the pose of an image came first."""

    def __init__(self):
        self.came_s, self.last = {}, time.monotonic()
        self.subscriber = rospy.Subscriber("/pose", PoseStamped, self.take, queue_size=1000)

    def take(self, pose):
        self.came_s.setdefault(pose.header.stamp.to_nsec(), time.time())
        self.last = time.monotonic()

    def is_quiet(self):
        return time.monotonic() - self.last > QUIET_S


def play(paths, publisher, rate_hz):
    """Sends each image in its turn, stamped with the time at which it goes out; returns the stamps."""
    stamps, start = [], time.monotonic()
    for number, path in enumerate(paths):
        time.sleep(max(0.0, start + number / rate_hz - time.monotonic()))
        message = CompressedImage(format=path.suffix[1:], data=path.read_bytes())
        message.header.stamp = rospy.Time.now()
        publisher.publish(message)
        stamps.append(message.header.stamp.to_nsec())
    return stamps


def main(folder, topic, rate_hz):
    rospy.init_node("live_feed", disable_signals=True)
    lines = [line.split() for line in (folder / "times.txt").read_text().splitlines() if not line.startswith("#")]
    listener = Listener()
    publisher = rospy.Publisher(f"{topic}/compressed", CompressedImage, queue_size=1000)
    there = wait_until(lambda: publisher.get_num_connections() > 0 and listener.subscriber.get_num_connections() > 0,
                       PATIENCE_S)
    if not there:
        raise RuntimeError(f"no frontend listens to {topic}, or no mapping tells poses")
    start = time.monotonic()
    stamps = play([folder / line[1] for line in lines if line], publisher, float(rate_hz))
    seconds = time.monotonic() - start
    wait_until(listener.is_quiet, 10 * PATIENCE_S)
    late_s = [listener.came_s[stamp] - 1e-9 * stamp if stamp in listener.came_s else None for stamp in stamps]
    print(json.dumps({"rate_hz": len(stamps) / seconds, "late_s": late_s}))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), *sys.argv[2:])
