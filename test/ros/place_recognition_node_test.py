#!/usr/bin/python3
"""Two frontends, mapping and place recognition over a real master: a place seen by two robots is
told, and a restarted node knows what it had seen."""

import os
import subprocess
import sys
import unittest

import cv2
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from rovio_sfm.msg import CameraMsg, FrameEventMsg, PlaceMatchMsg, PlaceStatus, Status
from rovio_sfm.srv import FindOverlaps, QueryImage
from sensor_msgs.msg import CompressedImage

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, diagnostic, wait_until
from robot_images import Robot, WAIT_S


class PlaceRecognitionNodeTest(unittest.TestCase):
    """Nodes start once for all tests: the tests do not depend on their order."""

    @classmethod
    def setUpClass(cls):
        cls.matches = Collector("/place_matches", PlaceMatchMsg)
        cls.statuses = Collector("/place_status", PlaceStatus)
        cls.robots = {name: Robot(name) for name in ("rovio1", "rovio2")}
        cls.frames = {name: Collector("/%s/frames" % name, FrameEventMsg) for name in cls.robots}
        for robot in cls.robots.values():
            assert robot.wait_until_heard()
        cls.send("rovio1", 0)

    @classmethod
    def send(cls, name, shift_px):
        return cls.robots[name].send_until_frame(cls.frames[name], shift_px)

    def status_after(self, reached):
        self.assertTrue(wait_until(lambda: self.statuses.messages
                                   and reached(self.statuses.messages[-1]), WAIT_S))
        return self.statuses.messages[-1]

    def expect_match_of_the_robots(self):
        before = self.matches.count()
        self.send("rovio2", 4)

        def joins_the_robots():
            return any(match.query.drive.robot == "rovio2"
                       and match.pairs[0].other.drive.robot == "rovio1"
                       for match in list(self.matches.messages)[before:])
        self.assertTrue(wait_until(joins_the_robots, WAIT_S), str(self.statuses.messages[-1:]))

    def call(self, name, kind, *arguments):
        rospy.wait_for_service(name, WAIT_S)
        return rospy.ServiceProxy(name, kind)(*arguments)

    def picture(self):
        data = cv2.imencode(".jpg", self.robots["rovio1"].scene[100:580, 8:648])[1].tobytes()
        return CompressedImage(format="jpeg", data=data)

    def camera(self):
        return CameraMsg(fx_px=500.0, fy_px=500.0, cx_px=320.0, cy_px=240.0, width=640, height=480)

    def test_place_seen_by_two_robots_is_told(self):
        self.expect_match_of_the_robots()
        status = self.status_after(lambda s: s.num_matched_queries > 0)
        self.assertGreaterEqual(status.num_places, 2)

    def test_killed_node_fetches_what_it_had_seen(self):
        self.send("rovio1", 8)
        self.status_after(lambda s: s.num_places >= 1)
        self.statuses.messages.clear()
        subprocess.run(["rosnode", "kill", "/place_recognition"], check=True, timeout=WAIT_S,
                       stdout=subprocess.DEVNULL)
        self.status_after(lambda s: s.num_events == 0 and s.num_fetched >= 1 and s.num_drives >= 1)
        self.expect_match_of_the_robots()

    def test_image_is_recognised(self):
        reply = self.call("/query_image", QueryImage, self.picture(), self.camera())
        self.assertEqual(reply.status.code, Status.OK, reply.status.message)
        self.assertEqual(reply.matches[0].pairs[0].other.drive.robot[:5], "rovio")

    def test_odd_calls_are_refused(self):
        broken = CompressedImage(format="jpeg", data=b"\xff\xd8 no picture")
        reply = self.call("/query_image", QueryImage, broken, self.camera())
        self.assertEqual(reply.status.code, Status.INVALID_ARGUMENT)
        reply = self.call("/query_image", QueryImage, self.picture(), CameraMsg())
        self.assertEqual(reply.status.code, Status.INVALID_ARGUMENT)
        reply = self.call("/find_overlaps", FindOverlaps, 1, 999, False)
        self.assertEqual(reply.status.code, Status.NOT_FOUND)

    def test_malformed_event_does_no_harm(self):
        publisher = rospy.Publisher("/rovio2/frames", FrameEventMsg, queue_size=5)
        self.assertTrue(wait_until(lambda: publisher.get_num_connections() > 0, WAIT_S))
        diagnostics = Collector("/diagnostics", DiagnosticArray)

        def is_told():  # mapping listens too, so that who is connected may not be who is meant
            publisher.publish(FrameEventMsg())
            return "frame of rovio2 refused: " in diagnostic(diagnostics, "frames to places")[1]
        self.assertTrue(wait_until(is_told, WAIT_S), str(diagnostics.messages[-1:]))
        reply = self.call("/query_image", QueryImage, self.picture(), self.camera())
        self.assertEqual(reply.status.code, Status.OK)


if __name__ == "__main__":
    rospy.init_node("place_recognition_node_test")
    rostest.rosrun("rovio_sfm", "place_recognition_node_test", PlaceRecognitionNodeTest, sys.argv)
