#!/usr/bin/python3
"""drive_tour against a robot that obeys cmd_vel and takes one picture per rest, some of them lost."""

import math
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import rospy
import rostest
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import program

PERIOD_S = 0.05
REST_S = 0.3
TOUR = """
way_points:
  - {x_m: 1.0, y_m: 1.0, yaw_deg: 0}
  - {x_m: 1.3, y_m: 1.1, yaw_deg: 10, frames: 3}
"""
NUM_STOPS = 4


class RestingRobot:
    """Integrates cmd_vel; pictures by number, from 0, are lost if they are in `lost`."""

    def __init__(self, name, lost):
        self.lock, self.lost = threading.Lock(), lost
        self.twist, self.pose, self.rest_s, self.num_pictures = Twist(), [0.0, 0.0, 0.0], 0.0, 0
        self.odom = rospy.Publisher("/%s/odom" % name, Odometry, queue_size=5)
        self.info = rospy.Publisher("/%s/camera_info" % name, CameraInfo, queue_size=5)
        self.subscriber = rospy.Subscriber("/%s/cmd_vel" % name, Twist, self.obey)
        self.timer = rospy.Timer(rospy.Duration(PERIOD_S), self.step)

    def obey(self, twist):
        with self.lock:
            self.twist = twist

    def step(self, _):
        with self.lock:
            velocity = (self.twist.linear.x, self.twist.linear.y, self.twist.angular.z)
            yaw = self.pose[2]
            self.pose[0] += PERIOD_S * (velocity[0] * math.cos(yaw) - velocity[1] * math.sin(yaw))
            self.pose[1] += PERIOD_S * (velocity[0] * math.sin(yaw) + velocity[1] * math.cos(yaw))
            self.pose[2] += PERIOD_S * velocity[2]
            rested_s, self.rest_s = self.rest_s, 0.0 if any(velocity) else self.rest_s + PERIOD_S
            self.publish_odometry()
            if rested_s < REST_S <= self.rest_s:
                self.take_picture()

    def publish_odometry(self):
        odom = Odometry()
        odom.header.stamp = rospy.Time.now()
        odom.pose.pose.position.x, odom.pose.pose.position.y = self.pose[:2]
        odom.pose.pose.orientation.z = math.sin(0.5 * self.pose[2])
        odom.pose.pose.orientation.w = math.cos(0.5 * self.pose[2])
        self.odom.publish(odom)

    def take_picture(self):
        if self.info.get_num_connections() == 0:
            self.rest_s = 0.0  # it waits for somebody to see it
            return
        if self.num_pictures not in self.lost:
            info = CameraInfo()
            info.header.stamp = rospy.Time.now()
            self.info.publish(info)
        self.num_pictures += 1

    def stop(self):
        self.timer.shutdown()
        self.subscriber.unregister()


class DriveTourNodeTest(unittest.TestCase):
    def drive(self, name, lost):
        """Exit status of drive_tour, and the robot afterwards."""
        robot = RestingRobot(name, lost)
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as tour:
            tour.write(TOUR)
            tour.flush()
            status = subprocess.call([program("drive_tour"), "__ns:=" + name, "_tour:=" + tour.name,
                                      "_look_timeout_s:=3.0", "_max_looks:=3"], timeout=100)
        robot.stop()
        return status, robot

    def test_looks_at_every_stop(self):
        status, robot = self.drive("whole", ())
        self.assertEqual(status, 0)
        self.assertEqual(robot.num_pictures, NUM_STOPS)
        self.assertAlmostEqual(robot.pose[0], 0.3, delta=0.05)
        self.assertAlmostEqual(robot.pose[1], 0.1, delta=0.05)
        self.assertAlmostEqual(robot.pose[2], math.radians(10), delta=0.06)

    def test_looks_again_where_a_picture_was_lost(self):
        status, robot = self.drive("lossy", (2,))
        self.assertEqual(status, 0)
        self.assertGreater(robot.num_pictures, NUM_STOPS)

    def test_says_if_a_stop_stays_without_a_picture(self):
        status, _ = self.drive("blind", range(1, 100))
        self.assertEqual(status, 1)


if __name__ == "__main__":
    rospy.init_node("drive_tour_node_test")
    rostest.rosrun("rovio_sfm", "drive_tour_node_test", DriveTourNodeTest)
