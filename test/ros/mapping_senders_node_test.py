#!/usr/bin/python3
"""Frames of another drive from another sender are refused and told; huge ones fill no memory."""

import os
import subprocess
import sys
import unittest

import rosgraph
import rosnode
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rovio_sfm.msg import FrameEventMsg, MapStatus

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, diagnostic, wait_until
from synthetic_drives import World

WAIT_S = 90.0
NUM_HUGE = 25  # frames of 60 MiB: 3 GB where all were kept
MEBI = 1 << 20


class SendersTest(unittest.TestCase):
    def setUp(self):
        self.status = Collector("/map_status", MapStatus)
        self.diagnostics = Collector("/diagnostics", DiagnosticArray)
        self.frames = rospy.Publisher("/rovio1/frames", FrameEventMsg, queue_size=100)
        self.assertTrue(wait_until(lambda: self.frames.get_num_connections() > 0, WAIT_S))

    def send(self, world, indices, jpeg=b""):
        for index in indices:
            frame = world.frame(2 * index)
            frame.jpeg = jpeg
            self.frames.publish(frame)

    def wait_for(self, condition):
        self.assertTrue(wait_until(lambda: self.status.count() > 0 and condition(self.status.last()),
                                   WAIT_S), self.status.messages[-1:])

    @staticmethod
    def keyframes(status, nonce):
        return sum(s.num_keyframes for s in status.sessions if s.drive.nonce == nonce)

    def mapping_pid(self):
        api = rosnode.get_api_uri(rosgraph.Master("/test"), "/mapping")
        return rosnode.ServerProxy(api).getPid("/test")[2]

    def test_a_stray_frame_and_huge_ones(self):
        world = World(rospy.Time.now())
        self.send(world, range(10))
        self.wait_for(lambda s: self.keyframes(s, 1) == 10)
        self.frames.publish(FrameEventMsg())
        self.assertTrue(wait_until(lambda: "frame of rovio1 refused: "
                                   in diagnostic(self.diagnostics, "frames to maps")[1], 20))
        stray = subprocess.run([sys.executable, os.path.abspath(__file__), "--stray"], timeout=60,
                               check=False)
        self.assertEqual(stray.returncode, 0)
        self.assertTrue(wait_until(lambda: diagnostic(self.diagnostics, "frames to maps")[0]
                                   == DiagnosticStatus.ERROR, 20), diagnostic(self.diagnostics, "maps"))
        self.assertIn("stray", diagnostic(self.diagnostics, "frames to maps")[1])
        self.send(world, range(10, 14))
        self.wait_for(lambda s: self.keyframes(s, 1) == 14 and self.keyframes(s, 2) == 0)
        self.send(world, [14] * NUM_HUGE, b"\xff" * (60 * MEBI))
        self.send(world, [15])
        self.wait_for(lambda s: self.keyframes(s, 1) == 16)
        with open("/proc/%d/status" % self.mapping_pid()) as file:
            peak_kb = next(int(line.split()[1]) for line in file if line.startswith("VmHWM"))
        self.assertLess(peak_kb, 1400 * 1024)


def send_stray():
    rospy.init_node("stray")
    publisher = rospy.Publisher("/rovio1/frames", FrameEventMsg, queue_size=1)
    if not wait_until(lambda: publisher.get_num_connections() > 0, 30):
        return 1
    frame = World(rospy.Time.now()).frame(0)
    frame.id.drive.nonce = 2
    publisher.publish(frame)
    rospy.sleep(1.0)  # until it is on its way
    return 0


if __name__ == "__main__":
    if "--stray" in sys.argv:
        sys.exit(send_stray())
    rospy.init_node("mapping_senders_node_test")
    rostest.rosrun("rovio_sfm", "mapping_senders", SendersTest)
