#!/usr/bin/python3
"""What mapping sends when one of two robots has finished, over a real master: nothing of it again."""

import os
import sys
import unittest

import rospy
import rostest
from nav_msgs.msg import Path
from rovio_sfm.msg import FrameEventMsg, MapStatus, SessionSummary, Status
from rovio_sfm.srv import FinishSession, Reset
from sensor_msgs.msg import PointCloud2
from visualization_msgs.msg import Marker, MarkerArray

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from synthetic_drives import NUM_CAMERAS, World

WAIT_S = 90.0  # sanitizers and busy machines take their time
NUM_FRAMES = NUM_CAMERAS // 2
FINISHED = range(NUM_FRAMES - 1)  # frames of the first robot
FIRST, REST = range(11), range(11, NUM_FRAMES)  # of the second


class MappingPublishNodeTest(unittest.TestCase):
    """The node starts once; each test maps its own two drives: sessions 1 and 2, not merged."""

    def setUp(self):
        for name in ("reset", "finish_session"):
            rospy.wait_for_service("/" + name, WAIT_S)
        self.assertEqual(rospy.ServiceProxy("/reset", Reset)(True).status.code, Status.OK)
        self.status = self.collect("/map_status", MapStatus)
        self.frames = [rospy.Publisher("/rovio%d/frames" % i, FrameEventMsg, queue_size=100)
                       for i in (1, 2)]
        for publisher in self.frames:
            self.assertTrue(wait_until(lambda p=publisher: p.get_num_connections() > 0, WAIT_S))
        self.world = World(rospy.Time.now())
        self.send(0, FINISHED)
        reply = rospy.ServiceProxy("/finish_session", FinishSession)("rovio1")
        self.assertEqual((reply.status.code, reply.session), (Status.OK, 1))
        self.send(1, FIRST)

    def send(self, robot, indices):
        for index in indices:
            self.frames[robot].publish(self.world.frame(2 * index + robot))
        self.wait(lambda: self.status.count() > 0
                  and self.counts(self.status.last())[robot:] == [indices[-1] + 1])

    def collect(self, topic, kind):
        """A listener of this test alone: of one process, all share one connection."""
        collector = Collector(topic, kind)
        self.addCleanup(collector.subscriber.unregister)
        return collector

    @staticmethod
    def counts(status):
        return [session.num_keyframes for session in status.sessions]

    def wait(self, condition):
        self.assertTrue(wait_until(condition, WAIT_S), self.status.messages[-1:])

    @staticmethod
    def drawn(markers):
        return {marker.ns for marker in markers.markers if marker.action == Marker.ADD}

    def test_event_of_one_robot_sends_nothing_of_one_that_has_finished(self):
        paths = [self.collect("/path/session_%d" % n, Path) for n in (1, 2)]
        clouds = [self.collect(topic, PointCloud2) for topic in ("/cloud", "/cloud/map_2")]
        cameras = self.collect("/cameras", MarkerArray)
        self.wait(lambda: all(c.count() > 0 for c in paths + clouds + [cameras]))
        num_clouds = clouds[1].count()
        self.send(1, REST[:1])
        self.wait(lambda: len(paths[1].last().poses) == len(FIRST) + 1)
        self.wait(lambda: clouds[1].count() > num_clouds)
        self.assertEqual(self.status.last().sessions[0].state, SessionSummary.FINISHED)
        before = [c.count() for c in (paths[0], clouds[0], cameras, paths[1], clouds[1])]
        for index in REST[1:]:
            self.send(1, range(index, index + 1))
        self.wait(lambda: len(paths[1].last().poses) == NUM_FRAMES)
        self.wait(lambda: clouds[1].count() > before[4] and cameras.count() > before[2])
        self.assertEqual(paths[0].count(), before[0])
        self.assertEqual(clouds[0].count(), before[1])
        self.assertGreater(paths[1].count(), before[3])
        for markers in cameras.messages[before[2]:]:
            self.assertEqual(self.drawn(markers), {"session_2"})
            self.assertEqual(len(markers.markers), 1)

    def test_late_listener_is_sent_everything_at_once(self):
        self.send(1, REST)
        late = [self.collect("/path/session_1", Path), self.collect("/cloud", PointCloud2)]
        cameras = self.collect("/cameras", MarkerArray)
        self.wait(lambda: all(c.count() > 0 for c in late + [cameras]))
        self.wait(lambda: len(late[0].last().poses) == len(FINISHED) and late[1].last().width > 100)
        self.assertEqual(cameras.messages[0].markers[0].action, Marker.DELETEALL)
        self.assertEqual(self.drawn(cameras.messages[0]), {"session_1", "session_2"})

    def test_one_topic_has_the_paths_of_all_sessions_and_one_the_maps_apart(self):
        paths, apart = self.collect("/paths", MarkerArray), self.collect("/maps_apart", MarkerArray)
        self.wait(lambda: paths.count() > 0 and apart.count() > 0)
        self.assertEqual(paths.messages[0].markers[0].action, Marker.DELETEALL)
        self.assertEqual(self.drawn(paths.messages[0]), {"path_1", "path_2"})
        self.wait(lambda: {"map_2/points", "map_2/path", "map_2/name"} == self.drawn(apart.last()))
        before = paths.count()
        self.send(1, REST[:1])
        self.wait(lambda: paths.count() > before)
        self.assertEqual(self.drawn(paths.last()), {"path_2"})

    def test_finishing_a_session_without_frames_does_not_name_the_one_before(self):
        self.frames[0].publish(self.world.frame(2 * len(FINISHED)))
        self.wait(lambda: len(self.status.last().sessions) == 3)
        finish = rospy.ServiceProxy("/finish_session", FinishSession)
        reply = finish("rovio1")
        self.assertEqual((reply.status.code, reply.session), (Status.FAILED_PRECONDITION, 0))
        self.assertIn("no frames yet", reply.status.message)
        self.assertEqual(finish("rovio1").status.code, Status.NOT_FOUND)

    def test_reset_clears_what_is_shown(self):
        path, cloud = self.collect("/path/session_1", Path), self.collect("/cloud", PointCloud2)
        cameras = self.collect("/cameras", MarkerArray)
        self.wait(lambda: all(c.count() > 0 for c in (path, cloud, cameras)))
        self.assertEqual(rospy.ServiceProxy("/reset", Reset)(True).status.code, Status.OK)
        self.wait(lambda: len(path.last().poses) == 0 and cloud.last().width == 0)
        self.wait(lambda: {m.ns for m in cameras.last().markers if m.action == Marker.DELETE}
                  >= {"session_1", "session_2"})


if __name__ == "__main__":
    rospy.init_node("mapping_publish_node_test")
    rostest.rosrun("rovio_sfm", "mapping_publish_node_test", MappingPublishNodeTest, sys.argv)
