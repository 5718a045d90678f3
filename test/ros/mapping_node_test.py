#!/usr/bin/python3
"""Frontend and mapping over a real master: what goes in comes out, and odd input does no harm."""

import os
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from rovio_sfm.msg import FrameEventMsg, MapStatus, Status
from rovio_sfm.srv import ExportMap, FinishSession, GetFrames, ListSessions, Reset, StartSession
from sensor_msgs.msg import CompressedImage

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from robot_images import Robot, WAIT_S


class MappingNodeTest(unittest.TestCase):
    """Nodes start once for all tests: the tests do not depend on their order."""

    @classmethod
    def setUpClass(cls):
        cls.frames = Collector("/rovio1/frames", FrameEventMsg)
        cls.robot = Robot("rovio1")
        assert cls.robot.wait_until_heard()

    def call(self, name, kind, *arguments):
        rospy.wait_for_service(name, WAIT_S)
        return rospy.ServiceProxy(name, kind)(*arguments)

    def next_frame(self, shift_px):
        return self.robot.send_until_frame(self.frames, shift_px)

    def test_image_becomes_a_frame_with_odometry(self):
        frame = self.next_frame(0)
        self.assertEqual(frame.id.drive.robot, "rovio1")
        self.assertEqual(frame.header.frame_id, "rovio1/camera_optical")
        self.assertGreater(len(frame.x_px), 100)
        self.assertEqual(len(frame.descriptors), 128 * len(frame.x_px))
        self.assertTrue(frame.has_odometry)

    def test_both_nodes_serve_frames_by_id(self):
        frame = self.next_frame(10)
        reply = self.call("/rovio1/get_frames", GetFrames, frame.id, 10)
        self.assertEqual(reply.status.code, Status.OK)
        self.assertEqual(reply.frames[0].id.index, frame.id.index)
        reply = self.call("/rovio1/get_frames", GetFrames, frame.id, 0)
        self.assertEqual(reply.status.code, Status.INVALID_ARGUMENT)
        frame.id.index = 0
        reply = self.call("/get_frames", GetFrames, frame.id, 1)
        self.assertEqual(reply.status.code, Status.OK)

    def test_broken_image_does_no_harm(self):
        self.robot.image.publish(CompressedImage(format="jpeg", data=b"\xff\xd8\xff\xd9 no picture"))
        self.next_frame(20)

    def test_malformed_event_is_refused_and_the_node_lives(self):
        status = Collector("/diagnostics", DiagnosticArray)
        publisher = rospy.Publisher("/rovio2/frames", FrameEventMsg, queue_size=5)
        self.assertTrue(wait_until(lambda: publisher.get_num_connections() > 0, WAIT_S))
        publisher.publish(FrameEventMsg())

        def refusal_is_told():
            return any(value.key == "events refused" and int(value.value) > 0
                       for array in list(status.messages)
                       for entry in array.status for value in entry.values)
        self.assertTrue(wait_until(refusal_is_told, WAIT_S))
        self.assertEqual(self.call("/list_sessions", ListSessions).status.code, Status.OK)

    def test_services_answer_in_any_state(self):
        self.assertEqual(self.call("/finish_session", FinishSession, "rovio2").status.code,
                         Status.NOT_FOUND)
        self.assertEqual(self.call("/start_session", StartSession, "No robot").status.code,
                         Status.INVALID_ARGUMENT)
        self.assertEqual(self.call("/export_map", ExportMap, 99, "", "", False).status.code,
                         Status.NOT_FOUND)
        self.assertEqual(self.call("/reset", Reset, False).status.code, Status.INVALID_ARGUMENT)

    def test_reset_forgets_and_the_drive_goes_on(self):
        self.next_frame(30)
        self.assertEqual(self.call("/reset", Reset, True).status.code, Status.OK)
        self.next_frame(40)
        maps = Collector("/map_status", MapStatus)
        self.assertTrue(wait_until(lambda: any(m.num_events > 0 for m in list(maps.messages)), WAIT_S))


if __name__ == "__main__":
    rospy.init_node("mapping_node_test")
    rostest.rosrun("rovio_sfm", "mapping_node_test", MappingNodeTest, sys.argv)
