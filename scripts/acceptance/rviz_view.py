"""rviz on a virtual display beside mapping and any number of robots that a synthetic world moves: one
robot's frames after the other's, none of which ever joins another."""

import argparse
import pathlib
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts"), str(ROOT / "test/ros")]

import numpy  # noqa: E402  (after the path is set)
import rosgraph  # noqa: E402
import rospy  # noqa: E402
from driver_fixture import wait_until  # noqa: E402
from rovio_sfm.msg import FrameEventMsg, MapStatus  # noqa: E402
from synthetic_drives import NUM_CAMERAS, NUM_POINTS, World  # noqa: E402

from demo_pictures import coloured_share  # noqa: E402

WAIT_S = 120.0


class RobotWorld(World):
    """A world of one robot, in colours."""

    def __init__(self, start, robot, seed):
        super().__init__(start, seed)
        self.robot, self.colours = robot, numpy.random.RandomState(seed).bytes(3 * NUM_POINTS)

    def frame(self, camera):
        frame = super().frame(camera)
        frame.id.drive.robot = self.robot
        frame.rgb = self.colours
        return frame


def drive(robots):
    """Sends all frames of every robot; returns map_status when all are mapped."""
    newest = []
    rospy.Subscriber("/map_status", MapStatus, lambda status: newest.append(status), queue_size=1)
    for seed, robot in enumerate(robots, 1):
        world = RobotWorld(rospy.Time.now(), robot, seed)
        publisher = rospy.Publisher(f"/{robot}/frames", FrameEventMsg, queue_size=100)
        if not wait_until(lambda p=publisher: p.get_num_connections() > 0, WAIT_S):
            raise RuntimeError(f"mapping does not listen to {robot}")
        for camera in range(0, NUM_CAMERAS, 2):
            publisher.publish(world.frame(camera))
        if not wait_until(lambda n=seed: newest and sum(s.num_keyframes >= NUM_CAMERAS // 2
                                                        for s in newest[-1].sessions) == n, WAIT_S):
            raise RuntimeError(f"{robot} is not mapped: {newest[-1:]}")
    return newest[-1]


def has_window():
    return subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "RViz"], capture_output=True,
                          check=False).stdout != b""


def launch(*words):
    return subprocess.Popen(["roslaunch", "rovio_sfm", *words], start_new_session=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--robots", default="north,south,east,west")
    arguments = parser.parse_args()
    robots = arguments.robots.split(",")
    nodes = [launch("mapping.launch", f"robots:=[{arguments.robots}]")]
    try:
        if not wait_until(rosgraph.is_master_online, WAIT_S):  # two at once would both start one, and one ends
            raise RuntimeError("mapping.launch has started no master")
        nodes.append(launch("view.launch", f"robot:={robots[-1]}"))
        rospy.init_node("rviz_view", disable_signals=True)
        status = drive(robots)
        if not wait_until(has_window, WAIT_S):
            raise RuntimeError("rviz shows no window")
        listened = f"/{robots[-1]}/image"
        wait_until(lambda: any(topic == listened and "/rviz" in nodes for topic, nodes in
                               rospy.get_master().getSystemState()[2][1]), WAIT_S)
        wait_until(lambda: take_picture(arguments.picture) > 0.01, 20, 2.0)
        shows_image = any(topic == listened for topic, _ in rospy.get_master().getSystemState()[2][1])
        print(f"maps {sum(entry.num_frames > 0 for entry in status.maps)} coloured "
              f"{coloured_share(arguments.picture):.4f} image {shows_image}")
    finally:
        for node in nodes:
            node.send_signal(signal.SIGINT)
        for node in nodes:
            node.wait(60)
    return 0


def take_picture(path):
    time.sleep(2.0)  # rviz shows the newest message with its next frame
    subprocess.run(["import", "-window", "root", str(path)], check=True)
    return coloured_share(path)


if __name__ == "__main__":
    sys.exit(main())
