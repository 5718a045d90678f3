"""What COLMAP makes of a rendered tour: a reference that is not ours."""

import os
import re
import subprocess
from typing import NamedTuple

from acceptance.common import fresh_folder, render_tour, run

OFFSCREEN = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
TOURS = ("visionlab", "turntable")
MIN_REGISTERED = 0.95
MAX_TRACK_LENGTH, MIN_ERROR_PX = 10.0, 0.2  # real sets: 7.7–8.7 and 0.33–0.76


class Model(NamedTuple):
    registered: int
    track_length: float
    error_px: float


def check(_quick):
    holds, parts = True, []
    for name in TOURS:
        folder = render_tour(name, 0, 1)
        frames = len(list((folder / "images").iterdir()))
        model = largest_model(folder)
        holds = (holds and model.registered >= MIN_REGISTERED * frames
                 and model.track_length < MAX_TRACK_LENGTH and model.error_px > MIN_ERROR_PX)
        parts.append(f"{name} {model.registered} of {frames}, mean track length "
                     f"{model.track_length:.2f}, mean error {model.error_px:.2f} px")
    return holds, "; ".join(parts)


def largest_model(folder):
    work = fresh_folder(f"colmap_{folder.name}")
    (work / "sparse").mkdir(parents=True)
    database = ("--database_path", work / "database.db")
    images = ("--image_path", folder / "images")
    camera = calibration(folder)[:9] + ["0", "0", "0"]
    run("colmap", "feature_extractor", *database, *images, "--ImageReader.single_camera", 1,
        "--ImageReader.camera_model", "FULL_OPENCV", "--ImageReader.camera_params", ",".join(camera),
        "--SiftExtraction.use_gpu", 0, env=OFFSCREEN)
    run("colmap", "sequential_matcher", *database, "--SequentialMatching.overlap", 10,
        "--SiftMatching.use_gpu", 0, env=OFFSCREEN)
    run("colmap", "mapper", *database, *images, "--output_path", work / "sparse",
        "--Mapper.ba_refine_focal_length", 0, "--Mapper.ba_refine_extra_params", 0,
        "--Mapper.max_extra_param", 10, env=OFFSCREEN, check=False)
    models = [analyze(model) for model in sorted((work / "sparse").iterdir())]
    return max(models, default=Model(0, 0.0, 0.0))


def analyze(model):
    done = subprocess.run(["colmap", "model_analyzer", "--path", str(model)], capture_output=True,
                          text=True, check=True)

    def figure(name):
        return float(re.search(name + r": ([\d.]+)", done.stdout + done.stderr)[1])
    return Model(int(figure("Registered images")), figure("Mean track length"),
                 figure("Mean reprojection error"))


def calibration(folder):
    lines = (folder / "calibration.txt").read_text().splitlines()
    return next(line for line in lines if line and not line.startswith("#")).split()
