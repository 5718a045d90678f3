#!/usr/bin/python3
"""Tests of scripts/expected_error.py against adjustments of many noisy drives."""

import pathlib
import sys
import tempfile
import unittest

import cv2
import numpy
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

import expected_error  # noqa: E402  (after the path is set)
from comparison.colmap_model import TextModel  # noqa: E402  (after the path is set)

FOCAL_PX, CENTRE_PX = 500.0, (320.0, 240.0)
MATRIX = numpy.array([[FOCAL_PX, 0, CENTRE_PX[0]], [0, FOCAL_PX, CENTRE_PX[1]], [0, 0, 1]])
CAMERAS_OF_A_DRIVE, POINTS, DRAWS, SIGMA_PX = 3, 24, 30, 0.5


def scene():
    """Two drives sideways before one wall: rotation vectors n x 3, centres n x 3, points m x 3."""
    random = numpy.random.default_rng(7)
    centres = [(0.3 * i, 0.1 * drive, 0.0) for drive in range(2) for i in range(CAMERAS_OF_A_DRIVE)]
    turns = random.uniform(-0.2, 0.2, (len(centres), 3))
    return turns, numpy.array(centres), random.uniform((-1.5, -1.5, 3), (2.0, 1.5, 6), (POINTS, 3))


def project(turns, centres, points):
    """Pixels, cameras x points x 2, by OpenCV; turns: rotation vectors."""
    return numpy.array([cv2.projectPoints(points, turn, -cv2.Rodrigues(turn)[0] @ centre, MATRIX, None)[0][:, 0]
                        for turn, centre in zip(turns, centres)])


def adjust(pixels, turns, centres, points):
    """The centres that explain the pixels best, from the true ones on."""
    n = len(centres)

    def residuals(x):
        return (project(x[:3 * n].reshape(n, 3), x[3 * n:6 * n].reshape(n, 3), x[6 * n:].reshape(-1, 3)) - pixels).ravel()
    start = numpy.concatenate([turns.ravel(), centres.ravel(), points.ravel()])
    return least_squares(residuals, start, method="trf", xtol=1e-10).x[3 * n:6 * n].reshape(n, 3)


def aligned(centres, truth):
    """Of small differences: what no similarity explains."""
    motions = expected_error.similarity_motions(truth)
    gap = (centres - truth).ravel()
    return gap - motions @ (motions.T @ gap)


def write_model(folder, turns, centres, points, pixels):
    (folder / "cameras.txt").write_text(f"1 FULL_OPENCV 640 480 {FOCAL_PX} {FOCAL_PX} 320 240 0 0 0 0 0 0 0 0\n")
    lines = []
    for number, (turn, centre, seen) in enumerate(zip(turns, centres, pixels)):
        from_map = Rotation.from_rotvec(turn)
        x, y, z, w = from_map.as_quat()
        numbers = " ".join(map(str, (w, x, y, z, *-from_map.apply(centre))))
        lines.append(f"{number + 1} {numbers} 1 drive_{number // CAMERAS_OF_A_DRIVE}/{number:06d}.jpg")
        lines.append(" ".join(f"{x} {y} {i + 1}" for i, (x, y) in enumerate(seen)))
    (folder / "images.txt").write_text("\n".join(lines) + "\n")
    (folder / "points3D.txt").write_text("".join(
        f"{i + 1} {' '.join(map(str, point))} 0 0 0 0" + "".join(f" {c + 1} {i}" for c in range(len(centres))) + "\n"
        for i, point in enumerate(points)))


class ExpectedError(unittest.TestCase):
    def test_is_what_adjustments_of_noisy_pixels_are_off_by(self):
        turns, centres, points = scene()
        true_pixels = project(turns, centres, points)
        random, gaps, scales = numpy.random.default_rng(1), [], []
        second = numpy.arange(len(centres)) >= CAMERAS_OF_A_DRIVE
        gradient = expected_error.scale_gradient(centres, second) - expected_error.scale_gradient(centres, ~second)
        for _ in range(DRAWS):
            found = adjust(true_pixels + random.normal(0, SIGMA_PX, true_pixels.shape), turns, centres, points)
            gap = aligned(found, centres)
            gaps.append((gap ** 2).sum() / len(centres))
            scales.append(gradient @ gap)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_model(folder, turns, centres, points, true_pixels)
            expected = expected_error.expected_error(TextModel(folder), SIGMA_PX)
            write_model(folder, turns, centres, points, true_pixels + random.normal(0, SIGMA_PX, true_pixels.shape))
            noise_px = expected_error.noise_px(TextModel(folder), 0)
        self.assertAlmostEqual(numpy.sqrt(numpy.mean(gaps)) / expected["expected_rmse"], 1.0, delta=0.2)
        sigma = expected["sigma_relative_scale"]["drive_1 / drive_0"]
        self.assertAlmostEqual(numpy.std(scales) / sigma, 1.0, delta=0.3)
        self.assertAlmostEqual(noise_px, SIGMA_PX, delta=0.08)


if __name__ == "__main__":
    unittest.main()
