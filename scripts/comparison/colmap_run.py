"""COLMAP on a folder of images by the rules of data.md: sequential matching, intrinsics fixed, CPU."""

import shutil

import numpy

from comparison.colmap_model import TextModel, root_mean_square, rotation
from comparison.measuring import NOTHING, Result, add, error_of, measure

OFFSCREEN = {"QT_QPA_PLATFORM": "offscreen"}


def map_with_colmap(images, work, options, truth, evaluate_program):
    """images: a comparison.images.ImageSet; work: a folder that is made anew."""
    shutil.rmtree(work, ignore_errors=True)
    (work / "sparse").mkdir(parents=True)
    cost = NOTHING
    for command in commands(images, work, options):
        step, _ = measure("colmap", *command, env=OFFSCREEN, check=command[0] != "mapper")
        cost = add(cost, step)
    models = sorted((work / "sparse").iterdir())
    for model in models:
        measure("colmap", "model_converter", "--input_path", model, "--output_path", model,
                "--output_type", "TXT", env=OFFSCREEN)
    read = sorted((TextModel(model) for model in models), key=lambda model: -len(model.poses))
    if not read:
        return Result(0.0, 0, 0, 0, None, None, None, 0, cost)
    return summarize(read[0], len(read), images, work, truth, evaluate_program, cost)


def commands(images, work, options):
    database = ("--database_path", work / "database.db")
    folder = ("--image_path", images.folder)
    extraction, matching = [], []
    if options.get("max_features"):
        extraction += ["--SiftExtraction.max_num_features", options["max_features"]]
    if options.get("hurried"):
        extraction += ["--SiftExtraction.first_octave", 0]
    threads = options["threads"]
    return [
        ("feature_extractor", *database, *folder, "--ImageReader.single_camera", 1,
         "--ImageReader.camera_model", "FULL_OPENCV",
         "--ImageReader.camera_params", ",".join([*images.calibration[:9], "0", "0", "0"]),
         "--SiftExtraction.use_gpu", 0, "--SiftExtraction.num_threads", threads, *extraction),
        ("sequential_matcher", *database, "--SequentialMatching.overlap", 10, "--SiftMatching.use_gpu", 0,
         "--SiftMatching.num_threads", threads, *matching),
        ("mapper", *database, *folder, "--output_path", work / "sparse", "--Mapper.ba_refine_focal_length", 0,
         "--Mapper.ba_refine_extra_params", 0, "--Mapper.max_extra_param", 10, "--Mapper.num_threads", threads),
    ]


def tum_pose(pose):
    """Position and quaternion x y z w of map from camera, of COLMAP's w x y z, t of camera from map."""
    w, x, y, z = pose[:4]
    center = -rotation(w, x, y, z).T @ pose[4:]
    return [*center, -x, -y, -z, w]


def summarize(model, num_models, images, work, truth, evaluate_program, cost):
    trajectory = work / "trajectory.txt"
    trajectory.write_text("".join(
        f"{images.stamps[name]} " + " ".join(f"{number:.9f}" for number in tum_pose(pose)) + "\n"
        for name, pose in sorted(model.poses.items(), key=lambda item: float(images.stamps[item[0]]))))
    many = numpy.array([model.views[point] > 3 for point in model.point_of], bool)
    rms, rms_many = root_mean_square(model.in_plane), root_mean_square(model.in_plane[many])
    return Result(model.num_features / len(model.poses), len(model.poses), len(model.points), len(model.point_of),
                  rms and rms * model.focal_px,
                  rms_many and rms_many * 1000, error_of(evaluate_program, truth, trajectory), num_models, cost)
