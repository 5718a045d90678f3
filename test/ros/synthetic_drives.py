"""Two drives through one synthetic world, as perfect frontends and place recognition send them."""

import math

import numpy
import rospy
from geometry_msgs.msg import Transform
from rovio_sfm.msg import (CameraMsg, DriveIdMsg, FrameEventMsg, FrameIdMsg, OverlapPairMsg,
                           PairMatchesMsg, PlaceMatchMsg)

FOCAL_PX, WIDTH_PX, HEIGHT_PX = 500.0, 640, 480
NUM_POINTS, NUM_CAMERAS, STEP, DISTANCE = 400, 32, 0.15, 4.0  # map units = metres


def to_transform(rotation, translation):
    """Of a turn about the camera's y axis by `rotation` radians."""
    transform = Transform()
    transform.rotation.y = math.sin(rotation / 2)
    transform.rotation.w = math.cos(rotation / 2)
    transform.translation.x, transform.translation.y, transform.translation.z = translation
    return transform


class World:
    """Points, and cameras on a circle round them. Even cameras are the first robot's."""

    def __init__(self, start, seed=1):
        random = numpy.random.RandomState(seed)
        self.start = start
        self.points = random.uniform(-1.5, 1.5, (NUM_POINTS, 3)) * [1, 0.55, 1] + [0, 0, DISTANCE]
        self.descriptors = random.randint(0, 80, (NUM_POINTS, 128)).astype(numpy.uint8)
        self.orders = [random.permutation(NUM_POINTS) for _ in range(NUM_CAMERAS)]

    def pose(self, camera):
        """The turn, and the centre, of a camera in the first."""
        angle = camera * STEP / DISTANCE
        offset = numpy.array([-math.sin(angle), 0.0, 1.0 - math.cos(angle)]) * DISTANCE
        return angle, offset

    def cam_from_other(self, camera, other):
        angle, center = self.pose(camera)
        other_angle, other_center = self.pose(other)
        direction = self.turn(-angle) @ (other_center - center)
        return to_transform(other_angle - angle, direction / numpy.linalg.norm(direction))

    @staticmethod
    def turn(angle):
        c, s = math.cos(angle), math.sin(angle)
        return numpy.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])

    def matches(self, camera, other):
        """The features of the same points, by point: in the other, in the camera."""
        return (numpy.argsort(self.orders[other]).tolist(),
                numpy.argsort(self.orders[camera]).tolist())

    def frame_id(self, camera):
        robot = "rovio1" if camera % 2 == 0 else "rovio2"
        return FrameIdMsg(DriveIdMsg(robot, self.start, 1), camera // 2)

    def frame(self, camera):
        frame = FrameEventMsg(format_version=FrameEventMsg.FORMAT_VERSION, id=self.frame_id(camera))
        frame.header.stamp = self.start + rospy.Duration(camera)
        frame.image_name = "%04d.jpg" % camera
        frame.camera = CameraMsg(width=WIDTH_PX, height=HEIGHT_PX, fx_px=FOCAL_PX, fy_px=FOCAL_PX,
                                 cx_px=WIDTH_PX / 2, cy_px=HEIGHT_PX / 2)
        self.add_features(camera, frame)
        if camera >= 2:
            frame.pairs = [self.pair(camera, camera - 2)]
        self.add_odometry(camera, frame)
        return frame

    def add_features(self, camera, frame):
        angle, center = self.pose(camera)
        order = self.orders[camera]
        in_camera = (self.points[order] - center) @ self.turn(angle)
        pixels = FOCAL_PX * in_camera[:, :2] / in_camera[:, 2:] + [WIDTH_PX / 2, HEIGHT_PX / 2]
        frame.x_px, frame.y_px = pixels[:, 0].tolist(), pixels[:, 1].tolist()
        frame.size_px, frame.angle_rad = [3.0] * NUM_POINTS, [0.0] * NUM_POINTS
        frame.response, frame.rgb = [1.0] * NUM_POINTS, b"\x80" * (3 * NUM_POINTS)
        frame.tracks = (order + 1).tolist()
        frame.descriptor_type, frame.descriptor_metric = FrameEventMsg.SIFT, FrameEventMsg.L2
        frame.descriptor_length = 128
        frame.descriptors = self.descriptors[order].tobytes()

    def add_odometry(self, camera, frame):
        angle, center = self.pose(camera)
        frame.has_odometry = frame.has_base_from_camera = True
        frame.odometry.x_m, frame.odometry.y_m = center[2], -center[0]
        frame.odometry.yaw_rad = -angle
        rotation = frame.base_from_camera.rotation  # level, looking forward
        rotation.w, rotation.x, rotation.y, rotation.z = 0.5, -0.5, 0.5, -0.5

    def pair(self, camera, other):
        in_other, in_this = self.matches(camera, other)
        return PairMatchesMsg(other_index=other // 2, verdict=PairMatchesMsg.GENERAL,
                              cam_from_other=self.cam_from_other(camera, other),
                              median_parallax_rad=2 * STEP / DISTANCE,
                              inlier_other=in_other, inlier_this=in_this)

    def place_match(self, camera, other):
        in_other, in_query = self.matches(camera, other)
        pair = OverlapPairMsg(other=self.frame_id(other), verdict=OverlapPairMsg.GENERAL,
                              query_from_other=self.cam_from_other(camera, other),
                              inlier_other=in_other, inlier_query=in_query)
        return PlaceMatchMsg(query=self.frame_id(camera), probability=1.0, pairs=[pair])
