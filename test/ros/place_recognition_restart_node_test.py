#!/usr/bin/python3
"""Place recognition killed in the middle of two drives: mapping makes one map of them all the same."""

import os
import signal
import sys
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg, MapStatus, PlaceMatchMsg, PlaceStatus, Status
from rovio_sfm.srv import Reset

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from synthetic_drives import NUM_CAMERAS, World

WAIT_S = 90.0  # sanitizers and busy machines take their time
NODE = "/place_recognition"
NUM_FRAMES = NUM_CAMERAS // 2  # of each drive
TOPICS = {"/rovio1/frames", "/rovio2/frames"}


def ask_node(method):
    """What the running place_recognition answers to a call of ROS's slave API; None if it is not there."""
    try:
        uri = rosgraph.Master(rospy.get_name()).lookupNode(NODE)
        return getattr(xmlrpc.client.ServerProxy(uri), method)(rospy.get_name())[2]
    except (OSError, rosgraph.MasterException, xmlrpc.client.Error):
        return None


class PlaceRecognitionRestartTest(unittest.TestCase):
    """The nodes start once for all tests; each drives through a world of its own."""

    num_worlds = 0

    def setUp(self):
        rospy.wait_for_service("/reset", WAIT_S)
        self.assertEqual(rospy.ServiceProxy("/reset", Reset)(True).status.code, Status.OK)
        self.maps = Collector("/map_status", MapStatus)
        self.places = Collector("/place_status", PlaceStatus)
        self.wait_for(self.maps, lambda s: not s.sessions)  # not what was before the reset
        self.frames = [rospy.Publisher(topic, FrameEventMsg, queue_size=100) for topic in sorted(TOPICS)]
        self.wait_until_heard()
        type(self).num_worlds += 1
        self.world = World(rospy.Time.now(), seed=self.num_worlds)

    def wait_for(self, collector, condition):
        self.assertTrue(wait_until(lambda: collector.messages and condition(collector.last()), WAIT_S),
                        collector.messages[-1:])
        return collector.last()

    def wait_until_heard(self):
        def listens():
            links = ask_node("getBusInfo") or []
            return TOPICS <= {link[4] for link in links if link[2] == "i"}
        self.assertTrue(wait_until(listens, WAIT_S))
        self.assertTrue(wait_until(lambda: all(p.get_num_connections() >= 2 for p in self.frames), WAIT_S))

    def drive(self, robot, first=0, last=NUM_FRAMES):
        for index in range(first, last):
            self.frames[robot].publish(self.world.frame(2 * index + robot))
        self.wait_for(self.maps, lambda s: self.num_keyframes(s, robot) == last)

    @staticmethod
    def num_keyframes(status, robot):
        return sum(session.num_keyframes for session in status.sessions
                   if session.drive.robot == "rovio%d" % (robot + 1))

    def kill_node(self):
        """Without a chance to say goodbye; returns once another one runs, which roslaunch started."""
        killed = ask_node("getPid")
        os.kill(killed, signal.SIGKILL)
        self.assertTrue(wait_until(lambda: ask_node("getPid") not in (None, killed), WAIT_S))

    def expect_one_map(self):
        status = self.wait_for(self.maps, lambda s: len(s.maps) == 1
                               and [self.num_keyframes(s, robot) for robot in (0, 1)] == [NUM_FRAMES] * 2)
        self.assertEqual(list(status.maps[0].sessions), [1, 2])
        return status

    def test_what_the_killed_node_had_seen_joins_what_came_after(self):
        self.drive(0, 0, 12)
        self.kill_node()
        self.drive(0, 12)  # to its end, while nobody, or nobody yet, listens
        self.drive(1, 0, 8)
        self.wait_until_heard()
        self.drive(1, 8)
        self.expect_one_map()
        status = self.wait_for(self.places, lambda s: s.num_places == 2 * NUM_FRAMES)
        self.assertGreaterEqual(status.num_fetched, 12)
        self.assertEqual(status.num_missing, 0)

    def test_what_the_restarted_node_says_again_changes_nothing(self):
        self.drive(0)
        self.drive(1)
        before = self.expect_one_map()
        self.kill_node()
        told = self.wait_for(self.places, lambda s: s.num_events == 0 and s.num_places == 2 * NUM_FRAMES)
        after = self.wait_for(self.maps, lambda s: s.num_place_matches
                              >= before.num_place_matches + told.num_matches)
        self.assertGreater(after.num_place_matches_repeated, before.num_place_matches_repeated)
        self.assertEqual(after.maps[0].revision, before.maps[0].revision)
        self.expect_one_map()

    def test_late_listener_hears_what_was_told(self):
        self.drive(0)
        self.drive(1)
        status = self.wait_for(self.places, lambda s: s.num_matches > 0)
        late = Collector("/place_matches", PlaceMatchMsg)
        self.assertTrue(wait_until(lambda: late.count() >= status.num_matches, WAIT_S))


if __name__ == "__main__":
    rospy.init_node("place_recognition_restart_node_test")
    rostest.rosrun("rovio_sfm", "place_recognition_restart_node_test", PlaceRecognitionRestartTest, sys.argv)
