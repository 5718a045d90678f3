#!/usr/bin/python3
"""A drive over a real master, exported with its pictures and read by COLMAP."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import cv2
import numpy
import rospy
import rostest
from rovio_sfm.msg import FrameEventMsg, MapStatus, Status
from rovio_sfm.srv import ExportMap

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from driver_fixture import Collector, wait_until
from synthetic_drives import HEIGHT_PX, NUM_CAMERAS, WIDTH_PX, World

WAIT_S = 90.0  # sanitizers and busy machines take their time
CAMERAS = range(0, NUM_CAMERAS, 2)
WITHOUT_PICTURE = 4


def jpeg_of(camera):
    picture = numpy.full((HEIGHT_PX, WIDTH_PX, 3), 5 * camera, numpy.uint8)
    return cv2.imencode(".jpg", picture)[1].tobytes()


class MappingExportNodeTest(unittest.TestCase):
    """One drive of which all frames but one bring their pictures."""

    @classmethod
    def setUpClass(cls):
        rospy.wait_for_service("/export_map", WAIT_S)
        cls.export = rospy.ServiceProxy("/export_map", ExportMap)
        cls.folder = pathlib.Path(rospy.get_param("/mapping/output_dir"))
        status = Collector("/map_status", MapStatus)
        frames = rospy.Publisher("/rovio1/frames", FrameEventMsg, queue_size=100)
        assert wait_until(lambda: frames.get_num_connections() > 0, WAIT_S)
        world = World(rospy.Time.now())
        for camera in CAMERAS:
            frame = world.frame(camera)
            if camera != WITHOUT_PICTURE:
                frame.jpeg = jpeg_of(camera)
            frames.publish(frame)
        assert wait_until(lambda: status.count() > 0 and [
            session.num_keyframes for session in status.last().sessions] == [len(CAMERAS)], WAIT_S)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)

    def test_colmap_reads_the_map_and_its_pictures_are_there(self):
        reply = self.export(0, "colmap", "colmap,ply", False)
        self.assertEqual(reply.status.code, Status.OK, reply.status.message)
        self.assertIn("1 picture was not at hand", reply.status.message)
        for path in reply.files:
            self.assertTrue(os.path.isabs(path) and os.path.exists(path), path)
        folder = self.folder / "colmap/colmap"
        printed = subprocess.run(["colmap", "model_analyzer", "--path", str(folder / "sparse/0")],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=True,
                                 text=True).stdout
        self.assertEqual(int(re.search(r"Registered images: (\d+)", printed)[1]), len(CAMERAS))
        self.assertGreater(int(re.search(r"Points: (\d+)", printed)[1]), 100)
        pictures = {path.name: path.read_bytes() for path in (folder / "images/rovio1").iterdir()}
        self.assertEqual(pictures, {"%04d.jpg" % camera: jpeg_of(camera)
                                    for camera in CAMERAS if camera != WITHOUT_PICTURE})

    def test_nothing_is_replaced_unasked(self):
        self.assertEqual(self.export(0, "twice", "nvm", False).status.code, Status.OK)
        refused = self.export(0, "twice", "ply,nvm", False)
        self.assertEqual(refused.status.code, Status.ALREADY_EXISTS)
        self.assertIn(str(self.folder / "twice/nvm"), refused.status.message)
        self.assertFalse((self.folder / "twice/cloud.ply").exists())
        self.assertEqual(self.export(0, "twice", "ply,nvm", True).status.code, Status.OK)

    def test_an_unknown_format_is_refused_by_name(self):
        refused = self.export(0, "unknown", "ply,obj", False)
        self.assertEqual(refused.status.code, Status.INVALID_ARGUMENT)
        self.assertIn('"obj"', refused.status.message)
        self.assertFalse((self.folder / "unknown").exists())


if __name__ == "__main__":
    rospy.init_node("mapping_export_node_test")
    rostest.rosrun("rovio_sfm", "mapping_export_node_test", MappingExportNodeTest, sys.argv)
