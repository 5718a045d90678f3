#!/usr/bin/python3
"""The driver against a simulated robot over real HTTP: what it publishes, and what it does when the
robot stalls, sends half images, resets connections, wants a login, is away, or the driver dies."""

import os
import shutil
import signal
import sys
import tempfile
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rovio_sfm.msg import RovioStatus, Status
from rovio_sfm.srv import SetCamera, SetHead
from sensor_msgs.msg import CameraInfo, CompressedImage, Image
from tf2_msgs.msg import TFMessage

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, Driver, Simulator, diagnostic, wait_until, write_images

OK, ERROR = DiagnosticStatus.OK, DiagnosticStatus.ERROR


class StreamingDriver(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        write_images(cls.folder, 10)
        cls.simulator = Simulator("--images", cls.folder, "--repeat")
        cls.images = Collector("/r1/image_raw/compressed", CompressedImage)
        cls.infos = Collector("/r1/camera_info", CameraInfo)
        cls.odometry = Collector("/r1/odom", Odometry)
        cls.status = Collector("/r1/status", RovioStatus)
        cls.transforms = Collector("/tf", TFMessage)
        cls.diagnostics = Collector("/diagnostics", DiagnosticArray)
        cls.driver = Driver("r1", cls.simulator.port)

    @classmethod
    def tearDownClass(cls):
        cls.driver.stop()
        cls.simulator.stop()
        shutil.rmtree(cls.folder)

    def setUp(self):
        self.simulator.fault("none", 0)
        self.assertTrue(self.images.grows_by(3, 15), "no images before the test")

    def tearDown(self):
        self.simulator.fault("none", 0)
        self.assertTrue(self.driver.is_alive())

    def wait_for_diagnosis(self, part, level, words, timeout_s=10):
        def is_so():
            now, message, _ = diagnostic(self.diagnostics, part)
            return now == level and words in message
        self.assertTrue(wait_until(is_so, timeout_s), diagnostic(self.diagnostics, part)[1])

    def assert_frames_resume(self, timeout_s=15):
        self.assertTrue(self.images.grows_by(5, timeout_s), "frames do not resume")
        self.wait_for_diagnosis("images", OK, "")

    def test_publishes_images_with_their_camera(self):
        self.assertTrue(wait_until(lambda: self.infos.count() >= self.images.count(), 5))
        image = self.images.messages[0]
        info = {i.header.stamp: i for i in self.infos.messages}[image.header.stamp]
        self.assertEqual(image.header.frame_id, "r1/camera_optical")
        self.assertEqual(info.header.frame_id, "r1/camera_optical")
        self.assertEqual((info.width, info.height), (640, 480))
        self.assertAlmostEqual(info.K[0], 699.282)
        self.assertAlmostEqual(info.D[1], -0.109756)
        with open(os.path.join(self.folder, "0000.jpg"), "rb") as file:
            pictures = [bytes(i.data) for i in self.images.messages]
            self.assertIn(file.read(), pictures)  # the robot's own bytes
        stamps = [i.header.stamp for i in self.images.messages]
        self.assertEqual(stamps, sorted(set(stamps)))

    def test_decodes_while_somebody_listens(self):
        raw = Collector("/r1/image_raw", Image)
        self.assertTrue(raw.grows_by(2, 10))
        self.assertEqual((raw.last().width, raw.last().encoding), (640, "bgr8"))
        raw.subscriber.unregister()

    def test_publishes_odometry_transforms_and_status(self):
        self.assertTrue(self.odometry.grows_by(10, 5))
        self.assertEqual(self.odometry.last().header.frame_id, "r1/odom")
        pairs = {(t.header.frame_id, t.child_frame_id)
                 for message in self.transforms.messages for t in message.transforms}
        self.assertIn(("r1/odom", "r1/base_link"), pairs)
        self.assertIn(("r1/base_link", "r1/camera_link"), pairs)
        self.assertTrue(wait_until(lambda: self.status.count() and self.status.last().is_online, 5))
        self.assertEqual(self.status.last().image_link, "stream")

    def test_the_head_moves_and_tf_follows(self):
        set_head = rospy.ServiceProxy("/r1/set_head", SetHead)
        set_head.wait_for_service(10)
        self.assertEqual(set_head(0).status.code, Status.OK)
        self.assertTrue(wait_until(lambda: abs(self.camera_height() - 0.12) < 0.01, 5))
        self.assertEqual(set_head(2).status.code, Status.OK)
        self.assertTrue(wait_until(lambda: abs(self.camera_height() - 0.28) < 0.01, 5))
        refused = set_head(9).status
        self.assertEqual((refused.code, refused.message.split(" (")[0]),
                         (Status.INVALID_ARGUMENT, "position = 9: expected 0"))

    def camera_height(self):
        for message in reversed(self.transforms.messages):
            for transform in message.transforms:
                if transform.child_frame_id == "r1/camera_link":
                    return transform.transform.translation.z
        return 0.0

    def test_settings_are_changed_and_read_back(self):
        set_camera = rospy.ServiceProxy("/r1/set_camera", SetCamera)
        set_camera.wait_for_service(10)
        reply = set_camera(resolution=-1, compression=1, frame_rate=10, brightness=5, headlight=1)
        self.assertEqual(reply.status.code, Status.OK, reply.status.message)
        self.assertTrue(wait_until(lambda: self.status.last().frame_rate == 10, 5))
        reply = set_camera(resolution=7, compression=-1, frame_rate=-1, brightness=-1, headlight=-1)
        self.assertEqual(reply.status.code, Status.INVALID_ARGUMENT)
        reply = set_camera(resolution=-1, compression=-1, frame_rate=-1, brightness=-1, headlight=5)
        self.assertEqual((reply.status.code, reply.status.message),
                         (Status.INVALID_ARGUMENT, "headlight = 5: expected 0, 1 or -1 (as it is)"))

    def test_a_stalled_stream_is_reported_and_resumes(self):
        self.simulator.fault("stall", 6)
        cpu = self.driver.cpu_seconds()
        self.wait_for_diagnosis("images", ERROR, "")
        self.assert_frames_resume()
        self.assertLess(self.driver.cpu_seconds() - cpu, 3.0, "busy loop")

    def test_a_silent_robot_is_reported_and_resumes(self):
        self.simulator.fault("silence", 6)
        self.wait_for_diagnosis("images", ERROR, "")
        self.assert_frames_resume()

    def test_half_images_are_dropped_and_counted(self):
        self.simulator.fault("truncate_jpeg", 3)
        begin = self.images.count()
        self.assertTrue(self.images.grows_by(10, 15))
        for image in self.images.messages[begin:]:
            self.assertEqual(bytes(image.data[-2:]), b"\xff\xd9")
        self.assertTrue(wait_until(lambda: int(diagnostic(self.diagnostics, "images")[2].get(
            "dropped, truncated", 0)) > 0, 5))

    def test_reset_connections_are_taken_up_again(self):
        self.simulator.fault("reset_every", 4)
        self.assertTrue(self.odometry.grows_by(20, 15))
        self.assertTrue(self.images.grows_by(10, 15))

    def test_a_refused_login_is_named(self):
        self.simulator.fault("require_login", 1)
        self.wait_for_diagnosis("robot", ERROR, "401")
        self.simulator.fault("require_login", 0)
        self.assert_frames_resume()
        self.wait_for_diagnosis("robot", OK, "")

    def test_a_robot_that_was_away_comes_back(self):
        self.simulator.fault("reboot", 4)
        self.wait_for_diagnosis("images", ERROR, "")
        self.wait_for_diagnosis("robot", ERROR, "")
        self.assert_frames_resume()
        self.wait_for_diagnosis("robot", OK, "")

    def test_odd_replies_do_no_harm(self):
        self.simulator.fault("cross_replies", 3)
        self.simulator.fault("short_mcu", 3)
        self.assertTrue(self.odometry.grows_by(10, 15))


class DrivingDriver(unittest.TestCase):
    """A robot that really moves, with a driver that takes pictures at rest only."""

    @classmethod
    def setUpClass(cls):
        cls.simulator = Simulator("--serve", "--tour", "visionlab", "--samples", "1")

    @classmethod
    def tearDownClass(cls):
        cls.simulator.stop()

    def setUp(self):
        self.driver = Driver("r2", self.simulator.port, {"capture_mode": "stationary"})
        self.odometry = Collector("/r2/odom", Odometry)
        self.images = Collector("/r2/image_raw/compressed", CompressedImage)
        self.command = rospy.Publisher("/r2/cmd_vel", Twist, queue_size=1)
        self.assertTrue(self.odometry.grows_by(5, 20), "no odometry")

    def tearDown(self):
        self.driver.stop()
        self.odometry.subscriber.unregister()

    def drive_for(self, seconds, speed):
        twist = Twist()
        twist.linear.x = speed
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.command.publish(twist)
            time.sleep(0.05)

    def assert_robot_stands(self):
        before = self.simulator.position()
        time.sleep(1.0)
        after = self.simulator.position()
        self.assertLess(abs(after[0] - before[0]) + abs(after[1] - before[1]), 0.002)

    def test_drives_measures_and_stops_when_commands_cease(self):
        begin, odometry_begin = self.simulator.position(), self.odometry.last().pose.pose.position.x
        self.drive_for(2.0, 0.15)
        time.sleep(1.5)  # the time-out of cmd_vel, and the robot's own
        self.assert_robot_stands()
        end = self.simulator.position()
        moved = ((end[0] - begin[0]) ** 2 + (end[1] - begin[1]) ** 2) ** 0.5
        measured = self.odometry.last().pose.pose.position.x - odometry_begin
        self.assertGreater(moved, 0.15)
        self.assertLess(abs(measured - moved), 0.15 * moved)
        self.assertGreater(self.odometry.last().pose.covariance[0], 0.0)

    def test_takes_one_picture_per_stop(self):
        self.assertTrue(wait_until(lambda: self.images.count() == 1, 20), "none before the start")
        self.drive_for(1.0, -0.1)
        self.assertEqual(self.images.count(), 1)
        self.assertTrue(wait_until(lambda: self.images.count() == 2, 20), "none at rest")
        time.sleep(2.0)
        self.assertEqual(self.images.count(), 2)

    def test_stops_on_sigterm(self):
        self.drive_for(1.0, 0.1)
        self.assertEqual(self.driver.stop(signal.SIGTERM), 0)
        self.assert_robot_stands()

    def test_the_robot_stops_when_the_driver_is_killed(self):
        self.drive_for(1.0, -0.1)
        self.driver.stop(signal.SIGKILL)
        time.sleep(0.7)
        self.assert_robot_stands()


if __name__ == "__main__":
    rospy.init_node("driver_node_test")
    suite = sys.argv[1]
    rostest.rosrun("rovio_sfm", suite, {"streaming": StreamingDriver, "driving": DrivingDriver}[suite])
