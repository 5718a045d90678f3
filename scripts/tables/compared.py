"""What was compared before a default was chosen: the questions of docs/choices.md."""

from typing import NamedTuple

from acceptance.common import dataset
from acceptance.drives import part_of
from tables import scope as settings
from tables.page import markdown
from tables.runs import Setting, map_with, points

HEAD = ("pictures", "setting", "registered", "points", "projections", "RMS, px", "error, mm", "rotation, °", "CPU, s")


class Question(NamedTuple):
    title: str
    asks: str
    settings: dict  # name -> Setting; the first is what was chosen
    sets: tuple


def fountain(_scope):
    return dataset("strecha_fountain_p11")


def desk(_scope):
    return part_of(dataset("tum_fr1_xyz"), "fr1_every_16", stride=16)


def video(_scope):
    return part_of(dataset("tum_fr1_xyz"), "fr1_video_every_2", last=399, stride=2)


def laboratory(scope):
    return scope.pictures("visionlab")


def frontend(**groups):
    return Setting(frontend=groups)


def mapper(**groups):
    return Setting(mapper=groups)


DEFAULT = Setting()
QUESTIONS = (
    Question("Pose of a pair", "`pair.verify.pose_method`: five points and refinement, or the thesis's algebraic way.",
             {"five_point": DEFAULT, "algebraic": settings.pose_method("algebraic")}, (laboratory, fountain)),
    Question("Features", "`extract.type`, 1000 of an image.",
             {name: settings.feature(name) for name in settings.FEATURES}, (laboratory, fountain)),
    Question("Matcher", "`pair.match.matcher`.", {name: settings.matcher(name) for name in settings.MATCHERS},
             (laboratory, fountain)),
    Question("Guided matching", "`pair.use_guided`: a second pass, where the depths of known matches say.",
             {"on": DEFAULT, "off": frontend(pair={"use_guided": False})}, (laboratory, fountain)),
    Question("Ratio of the nearest two", "`pair.max_ratio`, Lowe's.",
             {"0.9": DEFAULT, "0.8": frontend(pair={"max_ratio": 0.8})}, (laboratory, fountain)),
    Question("Earlier keyframes that are matched", "`recursion.max_frames`.",
             {"8": DEFAULT, "4": frontend(recursion={"max_frames": 4}), "12": frontend(recursion={"max_frames": 12})},
             (laboratory, desk)),
    Question("When two landmarks are one (f2)",
             "`f2.mean_relative`: χ² of a reprojection, or the thesis's relative distance.",
             {"χ²": DEFAULT, "the thesis's": mapper(f2={"mean_relative": True})}, (laboratory, fountain)),
    Question("Window of the local adjustment", "`adjust.local_frames`: n of §3.8.2.",
             {"10": DEFAULT, "5": mapper(adjust={"local_frames": 5}), "20": mapper(adjust={"local_frames": 20})},
             (laboratory, desk)),
    Question("Keyframes of a video", "`choose.min_flow_rad`, with `--mode parallax`.",
             {name: Setting({"choose": {"min_flow_rad": float(name)}} if name != "0.02" else {}, {}, ("--mode", "parallax"))
              for name in ("0.02", "0.01", "0.04")}, (video,)),
)


def table(question, scope):
    rows = []
    for make in question.sets:
        pictures = make(scope)
        for number, (name, setting) in enumerate(question.settings.items()):
            run = map_with(pictures, setting, scope.threads)
            rows.append((make.__name__ if number == 0 else "", f"**{name}**" if number == 0 else name, *figures(run)))
    return f"{question.asks}\n\n" + markdown(HEAD, rows)


def figures(run):
    s = run.summary
    error, rotation = s["ate_rmse_m"], s["rotation_rmse_deg"]
    return (f"{s['registered']} of {s['frames']}", points(s), s["projections"], s["rms_px"],
            None if error is None else f"{1000 * error:.1f}", rotation, f"{run.cost.cpu_s:.0f}")
