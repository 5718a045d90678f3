#!/usr/bin/python3
"""Two drives and a place match over a real master: one map, and two again."""

import os
import sys
import unittest

import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg, MapStatus, MergeReportMsg, PlaceMatchMsg, Status
from rovio_sfm.srv import (ListSessions, MergeSessions, MergeSessionsRequest, Reset,
                           UnmergeSession)
from tf2_msgs.msg import TFMessage

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from synthetic_drives import NUM_CAMERAS, World

WAIT_S = 90.0  # sanitizers and busy machines take their time


class MappingMergeNodeTest(unittest.TestCase):
    """The node starts once for all tests; each maps its own two drives."""

    def setUp(self):
        for name in ("reset", "list_sessions", "merge_sessions", "unmerge_session"):
            rospy.wait_for_service("/" + name, WAIT_S)
        self.reset = rospy.ServiceProxy("/reset", Reset)
        self.list_sessions = rospy.ServiceProxy("/list_sessions", ListSessions)
        self.merge = rospy.ServiceProxy("/merge_sessions", MergeSessions)
        self.unmerge = rospy.ServiceProxy("/unmerge_session", UnmergeSession)
        self.assertEqual(self.reset(True).status.code, Status.OK)
        self.status = Collector("/map_status", MapStatus)
        self.frames = [rospy.Publisher("/rovio%d/frames" % i, FrameEventMsg, queue_size=100)
                       for i in (1, 2)]
        self.matches = rospy.Publisher("/place_matches", PlaceMatchMsg, queue_size=100)
        for publisher in self.frames + [self.matches]:
            self.assertTrue(wait_until(lambda p=publisher: p.get_num_connections() > 0, WAIT_S))
        self.world = World(rospy.Time.now())

    def map_both(self):
        """First the one, then the other: their sessions have the numbers 1 and 2."""
        for robot in (0, 1):
            for camera in range(robot, NUM_CAMERAS, 2):
                self.frames[robot].publish(self.world.frame(camera))
            self.wait_for_status(lambda s, n=robot + 1: self.counts(s) == [NUM_CAMERAS // 2] * n)

    @staticmethod
    def counts(status):
        return [session.num_keyframes for session in status.sessions]

    def wait_for_status(self, condition):
        def holds():
            return self.status.count() > 0 and condition(self.status.last())
        self.assertTrue(wait_until(holds, WAIT_S), self.status.messages[-1:])
        return self.status.last()

    def merge_request(self, a, b, **more):
        return self.merge(MergeSessionsRequest(session_a=a, session_b=b, **more))

    def test_place_match_makes_one_map_and_unmerge_restores_two(self):
        edges = Collector("/tf", TFMessage)
        self.matches.publish(self.world.place_match(17, 16))  # before its frames: it waits
        self.map_both()
        status = self.wait_for_status(lambda s: len(s.maps) == 1)
        self.assertEqual(list(status.maps[0].sessions), [1, 2])
        self.assertTrue(status.maps[0].metric)
        self.assertEqual(status.num_merges_accepted, 1)
        self.assertEqual(status.merges[-1].verdict, MergeReportMsg.ACCEPTED)
        self.assertEqual(status.merges[-1].query.drive.robot, "rovio2")
        self.assertTrue(edges.grows_by(3, WAIT_S))
        parents = self.edges_of(edges.last())
        self.assertEqual({child: edge.header.frame_id for child, edge in parents.items()},
                         {"session_1/map": "map", "session_2/map": "map",
                          "rovio1/odom": "session_1/map", "rovio2/odom": "session_2/map"})
        place = parents["session_2/map"].transform.translation
        _, center = self.world.pose(1)  # where session 2 begins
        self.assertAlmostEqual(place.x, center[2], delta=0.02)
        self.assertAlmostEqual(place.y, -center[0], delta=0.02)
        self.assertEqual(self.merge_request(1, 2).status.code, Status.FAILED_PRECONDITION)

        reply = self.unmerge(2)
        self.assertEqual(reply.status.code, Status.OK, reply.status.message)
        self.assertEqual(len(reply.undone), 1)
        self.assertEqual(len(self.list_sessions().maps), 2)
        self.assertEqual(self.unmerge(2).status.code, Status.FAILED_PRECONDITION)
        self.wait_for_status(lambda s: len(s.maps) == 2 and s.num_merges_undone == 1)
        self.assertTrue(edges.grows_by(3, WAIT_S))
        self.assertNotIn("session_2/map", self.edges_of(edges.last()))

        reply = self.merge_request(1, 2)
        self.assertEqual(reply.status.code, Status.OK, reply.status.message)
        self.assertEqual(len(self.list_sessions().maps), 1)

    @staticmethod
    def edges_of(message):
        return {edge.child_frame_id: edge for edge in message.transforms}

    def test_odd_matches_and_requests_are_refused_and_the_node_lives(self):
        self.matches.publish(PlaceMatchMsg())
        odd = self.world.place_match(17, 16)
        odd.pairs[0].inlier_query = odd.pairs[0].inlier_query[:-1]
        self.matches.publish(odd)
        out_of_reach = self.world.place_match(17, 16)  # features that its frames do not have
        out_of_reach.pairs[0].inlier_query = [i + 60000 for i in range(20)]
        out_of_reach.pairs[0].inlier_other = [i + 60000 for i in range(20)]
        self.matches.publish(out_of_reach)
        self.map_both()
        status = self.wait_for_status(lambda s: s.num_place_matches_refused >= 2)
        self.assertEqual(len(status.maps), 2)
        self.assertEqual(self.merge_request(1, 1).status.code, Status.INVALID_ARGUMENT)
        self.assertEqual(self.merge_request(1, 9).status.code, Status.NOT_FOUND)
        reply = self.merge_request(1, 2, by_hand=True)  # a rotation of zeros
        self.assertEqual(reply.status.code, Status.INVALID_ARGUMENT)
        reply = self.merge_request(1, 2)
        self.assertEqual(reply.status.code, Status.FAILED_PRECONDITION)
        self.assertIn("no overlap", reply.status.message)
        self.assertEqual(self.unmerge(9).status.code, Status.NOT_FOUND)

    def test_merge_by_hand_places_a_session(self):
        self.map_both()
        request = MergeSessionsRequest(session_a=1, session_b=2, by_hand=True, scale=1.0)
        request.b_from_a.rotation.w = 1.0
        request.b_from_a.translation.x = -3.0
        reply = self.merge(request)
        self.assertEqual(reply.status.code, Status.OK, reply.status.message)
        self.wait_for_status(lambda s: len(s.maps) == 1)


if __name__ == "__main__":
    rospy.init_node("mapping_merge_node_test")
    rostest.rosrun("rovio_sfm", "mapping_merge_node_test", MappingMergeNodeTest, sys.argv)
