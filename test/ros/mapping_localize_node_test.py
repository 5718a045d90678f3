#!/usr/bin/python3
"""A robot that drives through a map of yesterday is told where it is, and the map stays what it was."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseStamped
from rovio_sfm.msg import FrameEventMsg, MapStatus, PlaceMatchMsg, Status
from rovio_sfm.srv import FinishSession, LoadMap, Reset, UnmergeSession
from tf2_msgs.msg import TFMessage

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, diagnostic, program, wait_until
from synthetic_drives import World

WAIT_S = 90.0  # sanitizers and busy machines take their time
NUM_FRAMES = 16  # of each drive


class MappingLocalizeTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="rovio_sfm_localize_")
        self.world = World(rospy.Time.now())
        self.frames = [rospy.Publisher("/rovio%d/frames" % robot, FrameEventMsg, queue_size=100)
                       for robot in (1, 2)]
        self.matches = rospy.Publisher("/place_matches", PlaceMatchMsg, queue_size=10)
        self.mapping = None

    def tearDown(self):
        if self.mapping and self.mapping.poll() is None:
            self.mapping.kill()
        shutil.rmtree(self.folder)

    def start(self, **parameters):
        parameters.update(robots=["rovio1", "rovio2"], output_dir=self.folder)
        rospy.set_param("/mapping", parameters)
        self.mapping = subprocess.Popen([program("mapping"), "__name:=mapping"])
        self.maps = Collector("/map_status", MapStatus)
        publishers = self.frames + [self.matches]
        self.assertTrue(wait_until(lambda: all(p.get_num_connections() == 1 for p in publishers), WAIT_S))

    def stop(self):
        self.mapping.send_signal(signal.SIGTERM)
        self.assertEqual(self.mapping.wait(WAIT_S), 0)
        self.maps.subscriber.unregister()
        publishers = self.frames + [self.matches]
        self.assertTrue(wait_until(lambda: all(p.get_num_connections() == 0 for p in publishers), WAIT_S))

    def wait_for(self, condition):
        self.assertTrue(wait_until(lambda: self.maps.messages and condition(self.maps.last()), WAIT_S),
                        self.maps.messages[-1:])
        return self.maps.last()

    def drive(self, robot, first, last):
        for index in range(first, last):
            self.frames[robot].publish(self.world.frame(2 * index + robot))

    def test_poses_without_a_change(self):
        self.start()
        self.drive(0, 0, NUM_FRAMES)
        self.wait_for(lambda s: s.sessions and s.sessions[0].num_keyframes == NUM_FRAMES)
        self.stop()
        self.start(localize=True)
        before = self.wait_for(lambda s: s.sessions)
        poses, edges = Collector("/pose", PoseStamped), Collector("/tf", TFMessage)
        self.assertTrue(wait_until(lambda: poses.subscriber.get_num_connections() == 1, WAIT_S))
        diagnostics = Collector("/diagnostics", DiagnosticArray)

        def told():
            return diagnostic(diagnostics, "frames to maps")

        self.drive(1, 0, 9)
        self.assertTrue(wait_until(lambda: told()[1] == "not found in the map: rovio2", WAIT_S), told())
        self.assertEqual(told()[0], 1)
        self.matches.publish(self.world.place_match(2 * 8 + 1, 2 * 8))
        self.wait_for(lambda s: s.num_localized == 1)
        self.drive(1, 9, NUM_FRAMES)
        after = self.wait_for(lambda s: s.num_localized == NUM_FRAMES - 8)
        self.assertTrue(wait_until(lambda: poses.count() == NUM_FRAMES - 8, WAIT_S), poses.count())
        self.assertEqual({p.header.frame_id for p in poses.messages}, {"session_1/map"})
        self.expect_true(poses.last())
        children = {edge.child_frame_id for message in edges.messages for edge in message.transforms}
        self.assertIn("rovio2/odom", children)
        self.assertEqual(after.num_not_localized, 8)
        self.assertTrue(wait_until(lambda: told()[1] == "robots are found in the map", WAIT_S), told())
        self.assertEqual((told()[0], told()[2]["frames localized"]), (0, str(NUM_FRAMES - 8)))
        self.assertEqual(after.sessions, before.sessions)
        self.expect_read_only()

    def test_a_mistyped_folder_is_not_made(self):
        missing = os.path.join(self.folder, "mistyped")
        rospy.set_param("/mapping", {"robots": ["rovio1"], "output_dir": missing, "localize": True})
        run = subprocess.run([program("mapping"), "__name:=mapping"], stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, universal_newlines=True, timeout=WAIT_S)
        self.assertEqual(run.returncode, 1, run.stdout)
        self.assertIn(missing + "/map.db: cannot be opened: no such file", run.stdout)
        self.assertFalse(os.path.exists(missing))

    def expect_true(self, pose):
        """Of the second drive's last frame; a session's frame is its first base, x forward, y left."""
        _, center = self.world.pose(2 * (NUM_FRAMES - 1) + 1)
        self.assertAlmostEqual(pose.pose.position.x, center[2], delta=0.02)
        self.assertAlmostEqual(pose.pose.position.y, -center[0], delta=0.02)

    def expect_read_only(self):
        for name, kind, request in (("/reset", Reset, (True,)), ("/unmerge_session", UnmergeSession, (1,)),
                                    ("/finish_session", FinishSession, ("rovio1",)),
                                    ("/load_map", LoadMap, ("x.db", True))):
            status = rospy.ServiceProxy(name, kind)(*request).status
            self.assertEqual(status.code, Status.FAILED_PRECONDITION, name)
            self.assertIn("localize", status.message)


if __name__ == "__main__":
    rospy.init_node("mapping_localize_node_test")
    rostest.rosrun("rovio_sfm", "mapping_localize_node_test", MappingLocalizeTest, sys.argv)
