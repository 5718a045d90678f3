"""A model of COLMAP in its text format, of one FULL_OPENCV camera."""

import cv2
import numpy

UNDISTORTION = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 100, 1e-9)


def rotation(w, x, y, z):
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class TextModel:
    """poses: name -> w x y z, t of camera from map; views: point's id -> how many see it; points_of: name -> ids of
    what it sees; num_features: of all images, seen points or not. Residuals by projection: in the image (px), and behind
    undistortion on the plane z = 1; point_of: whose they are."""

    def __init__(self, folder):
        cameras, images, points = (self.rows(folder / f"{name}.txt") for name in ("cameras", "images", "points3D"))
        parameters = numpy.array(cameras[0].split()[4:], float)
        self.focal_px = parameters[:2].mean()
        self.matrix = numpy.array([[parameters[0], 0, parameters[2]], [0, parameters[1], parameters[3]], [0, 0, 1]])
        self.distortion = parameters[4:]
        words = [line.split() for line in points]
        self.points = {int(w[0]): numpy.array(w[1:4], float) for w in words}
        self.views = {int(w[0]): (len(w) - 8) // 2 for w in words}
        self.poses, self.points_of, parts = {}, {}, []
        self.num_features = sum(len(features.split()) // 3 for features in images[1::2])
        for pose, features in zip(images[::2], images[1::2]):
            numbers = [float(word) for word in pose.split()[1:8]]
            name = pose.split()[9]
            self.poses[name] = numbers
            parts.append(self.residuals(numbers, numpy.array(features.split(), float).reshape(-1, 3)))
            self.points_of[name] = parts[-1][2]
        self.in_image, self.in_plane, self.point_of = (numpy.concatenate(part) for part in zip(*parts))

    @staticmethod
    def rows(path):
        """Without comments; an image without features has an empty line."""
        return [line for line in path.read_text().splitlines() if not line.startswith("#")]

    def residuals(self, pose, features):
        seen = features[features[:, 2] >= 0]
        if not len(seen):
            return numpy.zeros((0, 2)), numpy.zeros((0, 2)), numpy.zeros(0, int)
        ids, pixels = seen[:, 2].astype(int), seen[:, :2]
        x = numpy.array([self.points[i] for i in ids]) @ rotation(*pose[:4]).T + pose[4:]
        expected = cv2.projectPoints(x, numpy.zeros(3), numpy.zeros(3), self.matrix, self.distortion)[0]
        plane = cv2.undistortPointsIter(pixels[:, None], self.matrix, self.distortion, None, None, UNDISTORTION)
        return expected[:, 0] - pixels, x[:, :2] / x[:, 2:] - plane[:, 0], ids


def root_mean_square(residuals):
    """Per coordinate, so with 2l in the denominator."""
    return float(numpy.sqrt(numpy.mean(numpy.square(residuals)))) if len(residuals) else None
