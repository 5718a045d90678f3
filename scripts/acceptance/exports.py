"""The lines about exports: what programs that are not ours make of them."""

import functools
import math
import os
import re

import numpy

from acceptance.common import WORK, Line, dataset, fresh_folder, map_images, run
from comparison.colmap_model import TextModel, root_mean_square, rotation

OFFSCREEN = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
FORMATS = "tum,ply,ply_ascii,kitti,colmap,colmap_text,bundler,nvm"
FULL_OPENCV = 6  # as COLMAP numbers its cameras
MAX_COST_GAP = 0.002
MIN_TRIANGULATED = 0.8  # of the points; COLMAP's own thresholds are stricter than ours
OPEN3D = """
import sys, open3d
for path in sys.argv[1:]:
    cloud = open3d.io.read_point_cloud(path)
    print(len(cloud.points), *cloud.get_center())
"""


@functools.lru_cache(maxsize=None)
def exported(quick):
    """(folder, summary) of tum_fr1_xyz in all formats; made once in a run."""
    summary = map_images("exports/tum_fr1_xyz", [dataset("tum_fr1_xyz")], "--format", FORMATS,
                         *(("--stride", 8) if quick else ("--mode", "parallax")))
    return WORK / "exports/tum_fr1_xyz", summary


def num_points(summary):
    return summary["landmarks"] + summary["landmarks_two_views"]


def colmap(*arguments):
    """What a program of COLMAP prints; its figures go to either stream."""
    return run("sh", "-c", 'exec colmap "$@" 2>&1', "colmap", *arguments, env=OFFSCREEN)


def figure(name, printed):
    return float(re.search(rf"{name}\s*:\s*([-\d.]+)", printed)[1])


def colmap_export(quick):
    folder, summary = exported(quick)
    workspace = folder / "colmap"
    model = workspace / "sparse/0"
    # The first camera's model comes after the count (8 bytes) and the camera's id (4).
    camera_model = int.from_bytes((model / "cameras.bin").read_bytes()[12:16], "little")
    pictures = sum(1 for path in (workspace / "images").rglob("*") if path.is_file())
    parts = [counts(model, summary), counts(folder / "colmap_text/sparse/0", summary), cost(folder, summary),
             triangulation(workspace, summary)]
    holds = (all(part[0] for part in parts) and camera_model == FULL_OPENCV
             and pictures == summary["registered_keyframes"])
    return holds, "; ".join([f"camera model {camera_model}, {pictures} pictures", *(part[1] for part in parts)])


def counts(model, summary):
    printed = colmap("model_analyzer", "--path", model)
    ours = {"Registered images": summary["registered_keyframes"], "Points": num_points(summary),
            "Observations": summary["projections"]}
    theirs = {name: figure(name, printed) for name in ours}
    return theirs == ours, ", ".join(f"{name.lower()} {theirs[name]:.0f} (ours {ours[name]})" for name in ours)


def cost(folder, summary):
    """COLMAP prints the root of half the mean squared residual per coordinate, in the image; our
    summary counts behind undistortion. The same model gives both figures."""
    model = folder / "colmap/sparse/0"
    text = TextModel(folder / "colmap_text/sparse/0")
    in_image, in_plane = root_mean_square(text.in_image), root_mean_square(text.in_plane) * text.focal_px
    adjusted = fresh_folder("exports/adjusted")
    adjusted.mkdir()
    printed = colmap("bundle_adjuster", "--input_path", model, "--output_path", adjusted,
                     "--BundleAdjustment.refine_focal_length", 0, "--BundleAdjustment.refine_extra_params", 0,
                     "--BundleAdjustment.max_num_iterations", 1)
    theirs, ours = math.sqrt(2) * figure("Initial cost", printed), summary["rms_counted_px"]
    holds = abs(theirs / in_image - 1) <= MAX_COST_GAP and abs(ours / in_plane - 1) <= MAX_COST_GAP
    return holds, (f"RMS in the image {theirs:.4f} px (ours {in_image:.4f}), behind undistortion {in_plane:.4f} px "
                   f"(summary {ours:.4f})")


def triangulation(workspace, summary):
    """All points anew, from our poses and the matches of our database."""
    out = fresh_folder("exports/triangulated")
    out.mkdir()
    colmap("point_triangulator", "--database_path", workspace / "database.db", "--image_path",
           workspace / "images", "--input_path", workspace / "sparse/0", "--output_path", out,
           "--clear_points", 1, "--Mapper.max_extra_param", 10, "--Mapper.tri_ignore_two_view_tracks", 0)
    printed = colmap("model_analyzer", "--path", out)
    points, error_px = figure("Points", printed), figure("Mean reprojection error", printed)
    return (points >= MIN_TRIANGULATED * num_points(summary),
            f"{points:.0f} points triangulated anew, mean error {error_px:.3f} px")


def other_formats(quick):
    """Clouds by Open3D; KITTI against TUM; the projections of Bundler and NVM, each by its manual."""
    folder, summary = exported(quick)
    clouds = [[float(word) for word in line.split()] for line in run(
        "/usr/bin/python3", "-c", OPEN3D, folder / "cloud.ply", folder / "cloud_ascii.ply").splitlines()]
    kitti_gap = kitti_against_tum(folder)
    errors_px = {"bundler": bundler_rms(folder / "bundler/bundle.out"), "nvm": nvm_rms(folder / "nvm/model.nvm")}
    holds = (all(cloud[0] == num_points(summary) for cloud in clouds) and numpy.allclose(*clouds, atol=1e-6)
             and kitti_gap < 1e-6
             and all(abs(e / summary["rms_counted_px"] - 1) <= MAX_COST_GAP for e in errors_px.values()))
    return holds, (f"Open3D reads {clouds[0][0]:.0f} and {clouds[1][0]:.0f} points (ours {num_points(summary)}); "
                   f"KITTI differs from TUM by {kitti_gap:.1e}; RMS of "
                   + ", ".join(f"{name} {error:.4f} px" for name, error in errors_px.items())
                   + f" (ours {summary['rms_counted_px']:.4f})")


def kitti_against_tum(folder):
    """The largest difference of an entry; TUM: stamp, position, quaternion x y z w of map from camera."""
    poses = []
    for row in numpy.loadtxt(folder / "trajectory.txt"):
        pose = numpy.eye(4)
        pose[:3, :3], pose[:3, 3] = rotation(row[7], *row[4:7]), row[1:4]
        poses.append(pose)
    expected = [(numpy.linalg.inv(poses[0]) @ pose)[:3].ravel() for pose in poses]
    rows = numpy.loadtxt(next((folder / "kitti").glob("*_poses.txt")))
    return numpy.abs(rows - expected).max()


def bundler_rms(path):
    """P = R X + t, p = -P / P.z, x = f p; per coordinate."""
    words = iter(" ".join(path.read_text().splitlines()[1:]).split())

    def numbers(count):
        return numpy.array([float(next(words)) for _ in range(count)])
    num_cameras, num_points_there = (int(next(words)) for _ in range(2))
    cameras = [numbers(15) for _ in range(num_cameras)]
    residuals = []
    for _ in range(num_points_there):
        x = numbers(6)[:3]
        for _ in range(int(next(words))):
            camera, _, *seen = numbers(4)
            focal, rows = cameras[int(camera)][0], cameras[int(camera)][3:]
            p = rows[:9].reshape(3, 3) @ x + rows[9:]
            residuals.append(-focal * p[:2] / p[2] - seen)
    return root_mean_square(residuals)


def nvm_rms(path):
    """P = R (X - c), x = f P / P.z; per coordinate. Names hold no spaces."""
    words = iter(path.read_text().split()[1:])

    def numbers(count):
        return numpy.array([float(next(words)) for _ in range(count)])
    cameras = [(next(words), numbers(10))[1] for _ in range(int(next(words)))]
    residuals = []
    for _ in range(int(next(words))):
        x = numbers(6)[:3]
        for _ in range(int(next(words))):
            camera, _, *seen = numbers(4)
            focal, quaternion, center = (part for part in numpy.split(cameras[int(camera)][:8], [1, 5]))
            p = rotation(*quaternion) @ (x - center)
            residuals.append(focal * p[:2] / p[2] - seen)
    return root_mean_square(residuals)


LINES = [
    Line("colmap_export", "a COLMAP export of tum_fr1_xyz (FULL_OPENCV): model_analyzer counts the same, "
         "bundle_adjuster's initial cost is our RMS within 2 %, point_triangulator accepts it",
         colmap_export, True),
    Line("other_exports", "PLY by Open3D, KITTI, Bundler and NVM by their manuals: the same map",
         other_formats, True),
]
