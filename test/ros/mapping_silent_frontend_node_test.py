#!/usr/bin/python3
"""A frontend whose get_frames never answers: mapping goes on, says so, and ends when it is told."""

import os
import signal
import sys
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg, MapStatus, Status
from rovio_sfm.srv import FinishSession, GetFrames, GetFramesResponse

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from synthetic_drives import NUM_CAMERAS, World

WAIT_S = 90.0  # sanitizers and busy machines take their time
NUM_FRAMES = NUM_CAMERAS // 2
GAP = (12, 13)  # frames of the first robot that are not sent


class SilentFrontendTest(unittest.TestCase):
    """One test: it ends the node. Robot 1's frontend answers when it is released, robot 2 has none."""

    def setUp(self):
        rospy.wait_for_service("/finish_session", WAIT_S)
        self.asked, self.release = threading.Event(), threading.Event()
        self.service = rospy.Service("/rovio1/get_frames", GetFrames, self.hang)
        self.status = Collector("/map_status", MapStatus)
        self.frames = [rospy.Publisher("/rovio%d/frames" % i, FrameEventMsg, queue_size=100)
                       for i in (1, 2)]
        for publisher in self.frames:
            self.assertTrue(wait_until(lambda p=publisher: p.get_num_connections() > 0, WAIT_S))
        self.world = World(rospy.Time.now())

    def hang(self, request):
        self.asked.set()
        self.release.wait()
        return GetFramesResponse(status=Status(code=Status.NOT_FOUND))

    def send(self, robot, indices):
        for index in indices:
            self.frames[robot].publish(self.world.frame(2 * index + robot))

    def wait(self, condition):
        self.assertTrue(wait_until(lambda: self.status.count() > 0 and condition(self.status.last()),
                                   WAIT_S), self.status.messages[-1:])

    @staticmethod
    def num_keyframes(status, robot):
        return sum(session.num_keyframes for session in status.sessions
                   if session.drive.robot == "rovio%d" % (robot + 1))

    def test_hanging_frontend_stops_neither_mapping_nor_its_end(self):
        self.send(0, range(GAP[0]))
        self.wait(lambda s: self.num_keyframes(s, 0) == GAP[0])
        self.send(0, range(GAP[1] + 1, NUM_FRAMES))
        self.assertTrue(self.asked.wait(WAIT_S))
        self.send(1, range(NUM_FRAMES))
        self.wait(lambda s: self.num_keyframes(s, 1) == NUM_FRAMES)
        self.wait(lambda s: s.num_gaps_lost == 1 and s.num_missing == len(GAP)
                  and s.num_events == 2 * NUM_FRAMES - len(GAP))
        reply = rospy.ServiceProxy("/finish_session", FinishSession)("rovio1")
        self.assertEqual(reply.status.code, Status.OK, reply.status.message)
        self.expect_end()

    def expect_end(self):
        """The call is still out; the node ends all the same, and in time."""
        self.assertFalse(self.release.is_set())
        uri = rosgraph.Master("/test").lookupNode("/mapping")
        _, _, pid = xmlrpc.client.ServerProxy(uri).getPid("/test")
        os.kill(pid, signal.SIGTERM)
        start = time.monotonic()

        def is_gone():
            try:
                os.kill(pid, 0)
            except ProcessLookupError:
                return True
            with open("/proc/%d/stat" % pid) as stat:
                return stat.read().rsplit(")", 1)[1].split()[0] == "Z"
        self.assertTrue(wait_until(is_gone, WAIT_S))
        self.assertLess(time.monotonic() - start, 30.0)
        self.release.set()


if __name__ == "__main__":
    rospy.init_node("mapping_silent_frontend_node_test")
    rostest.rosrun("rovio_sfm", "mapping_silent_frontend_node_test", SilentFrontendTest, sys.argv)
