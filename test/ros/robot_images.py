"""A robot for node tests: pictures, calibration and odometry, without a driver."""

import cv2
import numpy
import rospy
from nav_msgs.msg import Odometry
from sensor_msgs.msg import CameraInfo, CompressedImage

from driver_fixture import wait_until

WAIT_S = 60.0  # sanitizers and busy machines take their time


class Robot:
    """Publishes what a driver would: pictures, calibration and odometry."""

    def __init__(self, name):
        self.name = name
        self.image = rospy.Publisher("/%s/image_raw/compressed" % name, CompressedImage, queue_size=5)
        self.info = rospy.Publisher("/%s/camera_info" % name, CameraInfo, queue_size=5)
        self.odom = rospy.Publisher("/%s/odom" % name, Odometry, queue_size=5)
        random = numpy.random.RandomState(1)
        small = random.randint(0, 255, (90, 120, 3), dtype=numpy.uint8)
        self.scene = cv2.resize(small, (960, 720), interpolation=cv2.INTER_CUBIC)

    def wait_until_heard(self):
        publishers = (self.image, self.info, self.odom)
        return wait_until(lambda: all(p.get_num_connections() > 0 for p in publishers), WAIT_S)

    def send(self, shift_px):
        stamp = rospy.Time.now()
        info = CameraInfo(width=640, height=480, distortion_model="plumb_bob", D=[0.0] * 5)
        info.K = [500.0, 0, 320.0, 0, 500.0, 240.0, 0, 0, 1.0]
        info.header.stamp = stamp
        info.header.frame_id = self.name + "/camera_optical"
        odom = Odometry()
        odom.header.stamp = stamp
        odom.pose.pose.orientation.w = 1.0
        image = CompressedImage(header=info.header, format="jpeg")
        picture = self.scene[100:580, shift_px:shift_px + 640]
        image.data = cv2.imencode(".jpg", picture)[1].tobytes()
        self.info.publish(info)
        self.odom.publish(odom)
        self.image.publish(image)
        return stamp

    def send_until_frame(self, frames, shift_px):
        """The frame event of a picture, sent again until one comes; not one of a picture sent before."""
        first_stamp = None
        for _ in range(int(WAIT_S / 2)):
            stamp = self.send(shift_px)
            first_stamp = first_stamp or stamp
            new = lambda: [m for m in frames.messages if m.header.stamp >= first_stamp]
            if wait_until(new, 2.0):
                return new()[0]
        raise AssertionError("no frame event came")
