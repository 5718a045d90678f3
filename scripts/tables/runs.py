"""Maps made for the tables of docs/: kept while program, pictures and options stay the same."""

import hashlib
import json
import shutil
from typing import NamedTuple

import yaml

from acceptance.common import PROGRAMS, ROOT
from comparison.measuring import Cost, measure

KEPT = ROOT / "out/tables"


class Run(NamedTuple):
    summary: dict  # summary.json
    cost: Cost
    folder: object  # with trajectory.txt and, below map_2 …, those of smaller maps


class Setting(NamedTuple):
    """frontend, mapper: what differs from config/frontend.yaml and mapping.yaml; words: of the command line."""
    frontend: dict = {}
    mapper: dict = {}
    words: tuple = ()


def map_with(pictures, setting=Setting(), threads=2):
    """Maps a folder of pictures with map_images; there may be no map."""
    folder = KEPT / "maps" / f"{pictures.name}_{fingerprint(pictures, setting)[:16]}"
    figures = folder / "run.json"
    if not figures.exists():
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(parents=True, exist_ok=True)
        cost, _ = measure(PROGRAMS / "map_images", pictures, "--out", folder, "--no-store", "--threads", threads,
                          *option_files(setting, folder), *setting.words, check=False)
        figures.write_text(json.dumps({"summary": json.loads((folder / "summary.json").read_text()),
                                       "cost": cost._asdict()}))
    kept = json.loads(figures.read_text())
    return Run(kept["summary"], Cost(**kept["cost"]), folder)


def option_files(setting, folder):
    words = []
    for word, options in (("frontend", setting.frontend), ("mapper", setting.mapper)):
        if options:
            path = folder.with_name(f"{folder.name}_{word}.yaml")
            path.write_text(yaml.safe_dump(options))
            words += [f"--{word}", path]
    return words


def fingerprint(pictures, setting):
    """Of program, pictures (with odometry and truth) and options."""
    digest = hashlib.sha256(json.dumps(setting).encode())
    digest.update((PROGRAMS / "map_images").read_bytes())
    for path in sorted(pictures.rglob("*")):
        if path.suffix in (".txt", ".jpg", ".png"):
            digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def error_percent(summary):
    """Of the map that holds most, as a share of its path; None without truth."""
    error, path = summary["ate_rmse_m"], summary["path_length_m"]
    return 100 * error / path if error is not None and path else None


def points(summary):
    """Landmarks of two views and more."""
    return summary["landmarks"] + summary["landmarks_two_views"]
