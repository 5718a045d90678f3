#!/usr/bin/python3
"""What error the observations of a map allow, whatever solves for it:
  expected_error.py MODEL [--sigma-px S] [--json]
MODEL: colmap_text of an export, or sparse/0 in it; lengths are in its units. The adjustment is linearised at the map, poses and
points free, each coordinate of a feature off by S px (by default what the residuals tell), the points eliminated, the
seven freedoms of a similarity left out; the focal length is the mean of both, distortion is left out. Prints the
expected RMSE of the camera centres after one similarity, how much of it the greatest mode has, and for each two drives
the sigma of the scale of one to the other. Where the errors of two programs differ by less, chance may be all."""

import argparse
import itertools
import json
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
sys.dont_write_bytecode = True

from comparison.colmap_model import TextModel, rotation  # noqa: E402  (after the path is set)
from read_plainly import Unreadable, end_plainly, reads  # noqa: E402  (after the path is set)

FREEDOMS = 7  # of a similarity


def cross(v):
    return numpy.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def drive_of(name):
    return name.rpartition("/")[0]


def observations_of(model):
    """By point: (camera's number, Jacobian by its rotation and centre, 2x6, and by the point, 2x3), in pixels."""
    names, found = sorted(model.poses), {}
    for number, name in enumerate(names):
        pose = model.poses[name]
        turn = rotation(*pose[:4])
        for point in model.points_of[name]:
            x = turn @ model.points[point] + pose[4:]
            project = model.focal_px / x[2] * numpy.array([[1, 0, -x[0] / x[2]], [0, 1, -x[1] / x[2]]])
            by_point = project @ turn
            found.setdefault(point, []).append((number, numpy.hstack([-project @ cross(x), -by_point]), by_point))
    return names, found


def camera_information(num_cameras, observations):
    """6n x 6n, the points eliminated (Schur's complement), for a noise of one pixel."""
    information = numpy.zeros((6 * num_cameras, 6 * num_cameras))
    for views in observations.values():
        rows = numpy.concatenate([numpy.arange(6 * number, 6 * number + 6) for number, _, _ in views])
        for number, by_camera, _ in views:
            part = slice(6 * number, 6 * number + 6)
            information[part, part] += by_camera.T @ by_camera
        of_point = sum(by_point.T @ by_point for _, _, by_point in views)
        mixed = numpy.vstack([by_camera.T @ by_point for _, by_camera, by_point in views])
        numpy.subtract.at(information, (rows[:, None], rows), mixed @ numpy.linalg.solve(of_point, mixed.T))
    return information


def similarity_motions(centres):
    """3n x 7: how the centres move with scale, rotation and shift, orthonormal."""
    from_middle = centres - centres.mean(0)
    moves = [numpy.hstack([c[:, None], -cross(c), numpy.eye(3)]) for c in from_middle]
    return numpy.linalg.qr(numpy.vstack(moves))[0]


def scale_gradient(centres, chosen):
    """3n: how the log of the chosen cameras' scale changes with the centres."""
    from_middle = numpy.where(chosen[:, None], centres - centres[chosen].mean(0), 0.0)
    return (from_middle / (from_middle ** 2).sum()).ravel()


def noise_px(model, num_unknowns):
    residuals = model.in_image
    return float(numpy.sqrt((residuals ** 2).sum() / max(1, residuals.size - num_unknowns)))


def expected_error(model, sigma_px=None):
    names, observations = observations_of(model)
    sigma_px = sigma_px or noise_px(model, 6 * len(names) + 3 * len(observations) - FREEDOMS)
    values, vectors = numpy.linalg.eigh(camera_information(len(names), observations))
    covariance = sigma_px ** 2 * (vectors[:, FREEDOMS:] / values[FREEDOMS:]) @ vectors[:, FREEDOMS:].T
    of_centres = (numpy.arange(6 * len(names)).reshape(-1, 6)[:, 3:]).ravel()
    covariance = covariance[numpy.ix_(of_centres, of_centres)]
    centres = numpy.array([-rotation(*pose[:4]).T @ pose[4:] for pose in (model.poses[name] for name in names)])
    motions = similarity_motions(centres)
    kept = numpy.eye(len(motions)) - motions @ motions.T
    modes = numpy.linalg.eigvalsh(kept @ covariance @ kept)
    drives = numpy.array([drive_of(name) for name in names])
    scales = {}
    for a, b in itertools.combinations(sorted(set(drives)), 2):
        gradient = scale_gradient(centres, drives == b) - scale_gradient(centres, drives == a)
        scales[f"{b} / {a}"] = float(numpy.sqrt(gradient @ covariance @ gradient))
    return {"cameras": len(names), "points": len(observations), "sigma_px": sigma_px,
            "expected_rmse": float(numpy.sqrt(modes.sum() / len(names))),
            "greatest_mode": float(numpy.sqrt(modes[-1] / len(names))), "sigma_relative_scale": scales}


@reads("a model of COLMAP in its text format")
def read_model(folder):
    """Of a folder of cameras.txt, images.txt and points3D.txt, or of an export that has it below sparse/0."""
    if not folder.is_dir():
        raise Unreadable(f"{folder}: no such folder: expected colmap_text of an export")
    below = folder / "sparse/0"
    return TextModel(below if below.is_dir() else folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("model", metavar="MODEL", type=pathlib.Path)
    parser.add_argument("--sigma-px", type=float)
    parser.add_argument("--json", action="store_true")
    arguments = parser.parse_args()
    found = expected_error(read_model(arguments.model), arguments.sigma_px)
    if arguments.json:
        print(json.dumps(found))
        return 0
    print(f"{found['cameras']} cameras, {found['points']} points, {found['sigma_px']:.2f} px: expected RMSE "
          f"{found['expected_rmse']:.5f}, of its greatest mode {found['greatest_mode']:.5f}")
    for pair, sigma in found["sigma_relative_scale"].items():
        print(f"scale of {pair}: sigma {100 * sigma:.3f} %")
    return 0


if __name__ == "__main__":
    sys.exit(end_plainly(main))
