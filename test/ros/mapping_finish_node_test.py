#!/usr/bin/python3
"""A drive over a real master, of which the actions make a dense cloud, a surface and a grid while
mapping goes on."""

import os
import pathlib
import shutil
import sys
import unittest

import actionlib
import cv2
import numpy
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from nav_msgs.msg import OccupancyGrid
from rovio_sfm.msg import (DensifyAction, DensifyGoal, FrameEventMsg, MapStatus,
                           ReconstructSurfaceAction, ReconstructSurfaceGoal, Status)
from rovio_sfm.srv import Reset, SaveMap
from sensor_msgs.msg import PointCloud2
from visualization_msgs.msg import Marker

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from synthetic_drives import DISTANCE, FOCAL_PX, HEIGHT_PX, WIDTH_PX, World

WAIT_S = 150.0  # sanitizers and busy machines take their time
CAMERAS = range(0, 12, 2)  # of the first robot, whose frames bring pictures
LATER_CAMERA = 12
BLIND_CAMERAS = range(1, 9, 2)  # of the second, whose frames bring none
TEXELS, TEXEL = 900, 0.01  # of a textured wall through the middle of the points; map units


def wall_picture(world, camera, texture):
    """What a camera sees of the wall z = DISTANCE, as a JPEG."""
    angle, center = world.pose(camera)
    cam_from_world = world.turn(angle).T
    corner = numpy.array([-0.5 * TEXELS * TEXEL, -0.5 * TEXELS * TEXEL, DISTANCE]) - center
    cam_from_texel = numpy.column_stack([TEXEL * cam_from_world[:, 0], TEXEL * cam_from_world[:, 1],
                                         cam_from_world @ corner])
    intrinsics = numpy.array([[FOCAL_PX, 0, WIDTH_PX / 2], [0, FOCAL_PX, HEIGHT_PX / 2], [0, 0, 1]])
    picture = cv2.warpPerspective(texture, intrinsics @ cam_from_texel, (WIDTH_PX, HEIGHT_PX))
    return cv2.imencode(".jpg", picture)[1].tobytes()


class Goal:
    """A goal that was sent, with what came back of it."""

    def __init__(self, client, goal):
        self.client, self.feedback = client, []
        client.send_goal(goal, feedback_cb=self.feedback.append)

    def wait(self, test):
        test.assertTrue(self.client.wait_for_result(rospy.Duration(WAIT_S)))
        return self.client.get_result()

    def wait_for_work(self, test):
        test.assertTrue(wait_until(lambda: self.feedback, WAIT_S))


class MappingFinishNodeTest(unittest.TestCase):
    """The tests share one map of the first robot, but for the last, which forgets it."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(rospy.get_param("/mapping/output_dir"))
        cls.densify = actionlib.SimpleActionClient("/densify", DensifyAction)
        cls.surface = actionlib.SimpleActionClient("/reconstruct_surface", ReconstructSurfaceAction)
        for client in (cls.densify, cls.surface):
            assert client.wait_for_server(rospy.Duration(WAIT_S))
        cls.status = Collector("/map_status", MapStatus)
        cls.cloud = Collector("/dense_cloud", PointCloud2)
        cls.mesh = Collector("/mesh", Marker)
        cls.grid = Collector("/grid", OccupancyGrid)
        cls.frames = [rospy.Publisher("/%s/frames" % robot, FrameEventMsg, queue_size=100)
                      for robot in ("rovio1", "rovio2")]
        assert wait_until(lambda: all(f.get_num_connections() > 0 for f in cls.frames), WAIT_S)
        cls.world = World(rospy.Time.now())
        random = numpy.random.RandomState(3)
        noise = random.randint(0, 256, (TEXELS, TEXELS, 3)).astype(numpy.uint8)
        cls.texture = cv2.GaussianBlur(noise, (0, 0), 1.5)
        for camera in CAMERAS:
            cls.publish(camera)
        for camera in BLIND_CAMERAS:
            cls.frames[1].publish(cls.world.frame(camera))
        assert wait_until(lambda: cls.keyframes() == [len(CAMERAS), len(BLIND_CAMERAS)], WAIT_S)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)

    @classmethod
    def publish(cls, camera):
        frame = cls.world.frame(camera)
        frame.jpeg = wall_picture(cls.world, camera, cls.texture)
        cls.frames[0].publish(frame)

    @classmethod
    def keyframes(cls):
        sessions = cls.status.last().sessions if cls.status.count() else []
        return [session.num_keyframes for session in sessions]

    def densify_goal(self, **fields):
        return Goal(self.densify, DensifyGoal(**{"map": 1, "method": "depth", **fields}))

    def surface_goal(self, **fields):
        return Goal(self.surface, ReconstructSurfaceGoal(**{"map": 1, **fields}))

    def expect_refused(self, goal, code, words):
        result = goal.wait(self)
        self.assertEqual(goal.client.get_state(), GoalStatus.ABORTED)
        self.assertEqual(result.status.code, code)
        self.assertIn(words, result.status.message)
        self.assertEqual(goal.client.get_goal_status_text(), result.status.message)

    def test_a_depth_goal_gives_cloud_file_and_grid(self):
        goal = self.densify_goal(name="finished")
        result = goal.wait(self)
        self.assertEqual(goal.client.get_state(), GoalStatus.SUCCEEDED, result.status.message)
        self.assertEqual(result.map, 1)
        self.assertGreater(result.num_points, 2000)
        self.assertEqual(result.file, str(self.folder / "finished/dense.ply"))
        self.assertTrue(os.path.getsize(result.file) > 20 * result.num_points)
        last = goal.feedback[-1]
        self.assertEqual((last.stage, last.num_done), ("depth", last.num_total))
        self.assertTrue(wait_until(lambda: self.cloud.count() and
                                   self.cloud.last().width == result.num_points, WAIT_S))
        self.assertEqual(self.cloud.last().header.frame_id, "map")
        self.assertTrue(wait_until(lambda: self.grid.count() and self.grid.last().info.width > 0,
                                   WAIT_S))
        self.expect_refused(self.densify_goal(name="finished"), Status.ALREADY_EXISTS, "dense.ply")

    def test_a_surface_goes_through_the_dense_cloud(self):
        goal = self.surface_goal(source="dense")
        result = goal.wait(self)
        self.assertEqual(goal.client.get_state(), GoalStatus.SUCCEEDED, result.status.message)
        self.assertGreater(result.num_triangles, 1000)
        self.assertEqual(result.file, "")
        self.assertTrue(wait_until(lambda: self.mesh.count() and len(
            self.mesh.last().points) == 3 * result.num_triangles, WAIT_S))
        self.assertEqual(goal.feedback[-1].stage, "surface")

    def test_a_matches_goal_gives_more_points_than_landmarks(self):
        goal = self.densify_goal(method="matches", name="finished")
        result = goal.wait(self)
        self.assertEqual(goal.client.get_state(), GoalStatus.SUCCEEDED, result.status.message)
        self.assertGreater(result.num_points, self.status.last().maps[0].num_landmarks)
        self.assertEqual(result.file, str(self.folder / "finished/densified.ply"))
        self.assertEqual(goal.feedback[-1].stage, "matches")
        self.assertTrue(wait_until(lambda: self.cloud.count() and
                                   self.cloud.last().width == result.num_points, WAIT_S))

    def test_a_goal_ends_when_it_is_cancelled(self):
        goal = self.densify_goal(name="cancelled")
        goal.wait_for_work(self)
        goal.client.cancel_goal()
        self.assertEqual(goal.wait(self).status.code, Status.CANCELLED)
        self.assertEqual(goal.client.get_state(), GoalStatus.PREEMPTED)
        self.assertFalse((self.folder / "cancelled").exists())

    def test_a_second_goal_cancels_the_first(self):
        first = self.densify_goal()
        first.wait_for_work(self)
        other = actionlib.SimpleActionClient("/densify", DensifyAction)
        self.assertTrue(other.wait_for_server(rospy.Duration(WAIT_S)))
        second = Goal(other, DensifyGoal(map=1, method="depth"))
        self.assertEqual(first.wait(self).status.code, Status.CANCELLED)
        self.assertEqual(second.wait(self).status.code, Status.OK)

    def test_mapping_goes_on_meanwhile(self):
        goal = self.densify_goal()
        goal.wait_for_work(self)
        self.publish(LATER_CAMERA)
        self.assertTrue(wait_until(lambda: self.keyframes()[0] == len(CAMERAS) + 1, WAIT_S))
        self.assertEqual(goal.client.get_state(), GoalStatus.ACTIVE)
        self.assertEqual(goal.wait(self).status.code, Status.OK)

    def test_what_cannot_be_done_is_refused_with_a_sentence(self):
        self.expect_refused(self.densify_goal(method="magic"), Status.INVALID_ARGUMENT, "method = magic")
        self.expect_refused(self.densify_goal(map=9), Status.NOT_FOUND, "session 9")
        self.expect_refused(self.densify_goal(name="../x"), Status.INVALID_ARGUMENT, "name")
        self.expect_refused(self.densify_goal(map=2), Status.FAILED_PRECONDITION,
                            "no picture of the map's %d keyframes" % len(BLIND_CAMERAS))
        self.expect_refused(self.surface_goal(source="thin air"), Status.INVALID_ARGUMENT,
                            "source = thin air")

    def test_saving_shows_the_grid(self):
        saved = rospy.ServiceProxy("/save_map", SaveMap)("saved.db", False)
        self.assertEqual(saved.status.code, Status.OK, saved.status.message)
        self.assertTrue(wait_until(lambda: self.grid.count() and self.grid.last().info.width > 0,
                                   WAIT_S))

    def test_zz_of_a_map_that_is_forgotten_meanwhile_nothing_is_taken(self):
        goal = self.densify_goal(name="forgotten")
        goal.wait_for_work(self)
        self.assertEqual(rospy.ServiceProxy("/reset", Reset)(True).status.code, Status.OK)
        self.expect_refused(goal, Status.FAILED_PRECONDITION, "map 1 was merged, taken apart or")
        self.assertFalse((self.folder / "forgotten").exists())
        self.assertTrue(wait_until(lambda: self.cloud.last().width == 0, WAIT_S))
        self.assertTrue(wait_until(lambda: self.mesh.last().action == Marker.DELETE, WAIT_S))
        self.assertTrue(wait_until(lambda: self.grid.last().info.width == 0, WAIT_S))


if __name__ == "__main__":
    rospy.init_node("mapping_finish_node_test")
    rostest.rosrun("rovio_sfm", "mapping_finish_node_test", MappingFinishNodeTest, sys.argv)
