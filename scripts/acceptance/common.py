"""What every acceptance needs: running programs, mapping folders, and lines that hold or fall."""

import hashlib
import json
import os
import pathlib
import shutil
import socket
import subprocess
import time
from typing import Callable, NamedTuple

import yaml

from demo_graph import free_ports

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BUILD = pathlib.Path(os.environ.get("ROVIO_SFM_BUILD", ROOT / "build"))
DEVEL = (ROOT if BUILD == ROOT / "build" else BUILD) / "devel"
PROGRAMS = DEVEL / "lib/rovio_sfm"
DATA = pathlib.Path(os.environ.get("ROVIO_SFM_DATA", ROOT / "../shared/data")).resolve()
WORK = ROOT / "out/accept"  # everything written here may be deleted
MODEL = os.environ.get("ROVIO_SFM_PLACES", "")  # a place model instead of the shipped one
PLACES = ("--places", MODEL) if MODEL else ()
THREADS = 2  # of the machine that the acceptance speaks of; they change no result


class Skipped(Exception):
    """The line cannot be measured here; says why."""


class Line(NamedTuple):
    """One line of an issue's acceptance. check(quick) returns (holds, figures)."""
    name: str
    text: str
    check: Callable[[bool], tuple[bool, str]]
    quick: bool  # what the continuous integration can bear


def run(*command, timeout_s=3600, check=True, **options):
    """Runs a command and returns its standard output; the error says what failed, and how."""
    words = [str(word) for word in command]
    done = subprocess.run(words, capture_output=True, text=True, timeout=timeout_s, check=False, **options)
    if check and done.returncode != 0:
        tail = (done.stdout + done.stderr).strip().splitlines()[-5:]
        raise RuntimeError(f"{words[0]} ended with {done.returncode}: {' | '.join(tail)}")
    return done.stdout


def dataset(name):
    folder = DATA / name
    if not folder.exists():
        raise Skipped(f"no data set {folder} (set ROVIO_SFM_DATA)")
    return folder


def fresh_folder(name):
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    return folder


def map_images(name, folders, *options, threads=THREADS):
    """Maps folders into out/accept/NAME and returns summary.json."""
    out = fresh_folder(name)
    run(ROOT / "scripts/map_images", *folders, "--out", out, "--threads", threads, *PLACES, *options)
    return json.loads((out / "summary.json").read_text())


NOISE = 10  # grey levels; tours are rendered with it and, in the same pass, without


def render_tour(tour, noise, seed, max_frames=0):
    """The folder of a rendered tour; rendered, with and without noise in one pass, unless a render
    of the same program, world, tour and options is there."""
    if noise not in (0, NOISE):
        raise ValueError(f"tours are rendered with noise 0 and {NOISE}")
    folders = {n: WORK / f"tours/{tour}_noise{n}_seed{seed}_frames{max_frames or 'all'}" for n in (NOISE, 0)}
    wanted = render_fingerprint(tour, seed, max_frames)
    if any(fingerprint_of(folder) != wanted for folder in folders.values()):
        render_into(folders, wanted, tour, seed, max_frames)
    return folders[noise]


def render_fingerprint(tour, seed, max_frames):
    """Of everything that a render depends on."""
    spec_file = ROOT / f"config/tours/{tour}.yaml"
    spec = yaml.safe_load(spec_file.read_text())
    sharing = [ROOT / f"config/tours/{name}.yaml" for name in spec.get("shares_with", [])]
    digest = hashlib.sha256(f"{tour} {NOISE} {seed} {max_frames}".encode())
    for path in (PROGRAMS / "rovio_sim", spec_file, ROOT / f"config/worlds/{spec['world']}.yaml", *sharing):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def fingerprint_of(folder):
    path = folder / "fingerprint"
    return path.read_text() if path.exists() else None


def render_into(folders, fingerprint, tour, seed, max_frames):
    """Renders beside the folders, then puts the new ones into their place: others may be reading."""
    fresh = {noise: folder.with_name(f".{folder.name}.{os.getpid()}") for noise, folder in folders.items()}
    for folder in fresh.values():
        shutil.rmtree(folder, ignore_errors=True)
        folder.parent.mkdir(parents=True, exist_ok=True)
    run(PROGRAMS / "rovio_sim", "--render", tour, "--out", fresh[NOISE], "--clean-out", fresh[0],
        "--camera", "plain", "--noise", NOISE, "--seed", seed, "--frames", max_frames, "--threads", THREADS)
    for noise, folder in folders.items():
        (fresh[noise] / "fingerprint").write_text(fingerprint)
        stale = folder.with_name(f".{folder.name}.{os.getpid()}.stale")
        if folder.exists():
            folder.rename(stale)
        fresh[noise].rename(folder)
        shutil.rmtree(stale, ignore_errors=True)


def free_port():
    return free_ports(1)


class Simulator:
    """A rovio_sim in the background, stopped on leaving."""

    def __init__(self, *arguments):
        self.port = free_port()
        self.process = subprocess.Popen(
            [str(PROGRAMS / "rovio_sim"), *map(str, arguments), "--port", str(self.port)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def __enter__(self):
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and self.process.poll() is None:
            with socket.socket() as probe:
                probe.settimeout(1.0)
                if probe.connect_ex(("127.0.0.1", self.port)) == 0:
                    return self
            time.sleep(0.1)
        self.__exit__()
        raise RuntimeError("rovio_sim does not listen")

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


def percent(part, whole):
    return 100.0 * part / whole if whole else 0.0
