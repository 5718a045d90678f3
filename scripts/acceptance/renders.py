"""Tours as the robot's own camera sees them, or in another light, or of another folder of tours."""

import hashlib
import shutil
from typing import NamedTuple

import yaml

from acceptance.common import NOISE, PROGRAMS, ROOT, THREADS, WORK, fingerprint_of, run


class Render(NamedTuple):
    """What rovio_sim --render is asked for; config: the text of a tour that is not among the shipped ones."""
    tour: str
    camera: str = "robot"
    noise: int = NOISE
    seed: int = 1
    light: int = 0
    frames: int = 0  # all
    steps: int = 1   # times the tour's own
    movers: bool = False
    config: str = ""


def render(wanted, clean=False):
    """The folder of the rendered pictures, or of the same ones without noise; rendered in one pass
    unless what the same program made of the same files is there."""
    folders = {noise: WORK / f"renders/{folder_name(wanted, noise)}" for noise in (wanted.noise, 0)}
    fingerprint = fingerprint_to_be(wanted)
    if any(fingerprint_of(folder) != fingerprint for folder in folders.values()):
        for folder in folders.values():
            shutil.rmtree(folder, ignore_errors=True)
            folder.parent.mkdir(parents=True, exist_ok=True)
        run(PROGRAMS / "rovio_sim", "--render", wanted.tour, "--out", folders[wanted.noise], "--clean-out", folders[0],
            "--camera", wanted.camera, "--noise", wanted.noise, "--seed", wanted.seed, "--light", wanted.light,
            "--frames", wanted.frames, "--steps", wanted.steps, *["--movers"] * wanted.movers, "--threads", THREADS,
            *own_config(wanted))
        for folder in folders.values():
            (folder / "fingerprint").write_text(fingerprint)
    return folders[0 if clean else wanted.noise]


def folder_name(wanted, noise):
    """Short for what is usual."""
    return (f"{wanted.tour}_{wanted.camera}_noise{noise}_seed{wanted.seed}" + f"_light{wanted.light}" * bool(wanted.light)
            + f"_frames{wanted.frames}" * bool(wanted.frames) + f"_steps{wanted.steps}" * (wanted.steps != 1)
            + "_movers" * wanted.movers)


def fingerprint_to_be(wanted):
    """Of everything that a render depends on."""
    text = wanted.config or (ROOT / f"config/tours/{wanted.tour}.yaml").read_text()
    spec = yaml.safe_load(text)
    sharing = [ROOT / f"config/tours/{name}.yaml" for name in spec.get("shares_with", [])]
    digest = hashlib.sha256(f"{wanted} {text}".encode())
    for path in (PROGRAMS / "rovio_sim", ROOT / f"config/worlds/{spec['world']}.yaml", *sharing):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def own_config(wanted):
    """Options for a folder of the shipped worlds and that tour alone; none for a shipped tour."""
    if not wanted.config:
        return ()
    folder = WORK / f"configs/{wanted.tour}"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "tours").mkdir(parents=True)
    (folder / "worlds").symlink_to(ROOT / "config/worlds")
    (folder / "tours" / f"{wanted.tour}.yaml").write_text(wanted.config)
    return ("--config", folder)
