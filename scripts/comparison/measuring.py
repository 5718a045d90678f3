"""What a command costs, and figures of one run of either system."""

import json
import os
import subprocess
import tempfile
import time
from typing import NamedTuple, Optional

from read_plainly import Unreadable


class Cost(NamedTuple):
    wall_s: float
    cpu_s: float  # user and system, of all child processes
    peak_mb: float  # of the largest process


NOTHING = Cost(0.0, 0.0, 0.0)


def add(a, b):
    """One after the other."""
    return Cost(a.wall_s + b.wall_s, a.cpu_s + b.cpu_s, max(a.peak_mb, b.peak_mb))


class Result(NamedTuple):
    """Of the map that holds most. Landmarks and projections: of two views and more."""
    features: float  # of a picture, in the mean
    registered: int
    landmarks: int
    projections: int
    rms_px: Optional[float]
    rms_n: Optional[float]  # thesis, Eq. 5.2-5.4: over more than three views
    error_m: Optional[float]  # ATE after one similarity; None: no truth
    maps: int
    cost: Cost


def measure(*command, env=None, check=True):
    """Runs a command; returns its cost and what it printed."""
    with tempfile.TemporaryFile("w+") as said:
        start = time.monotonic()
        process = subprocess.Popen([str(word) for word in command], stdout=said, stderr=subprocess.STDOUT,
                                   env={**os.environ, **(env or {})})
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        cost = Cost(time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)
        said.seek(0)
        text = said.read()
    if check and process.returncode != 0:
        raise Unreadable(f"{command[0]} ended with {process.returncode}: " + " | ".join(text.splitlines()[-5:]))
    return cost, text


def error_of(program, truth, trajectory):
    """ATE in metres by our evaluate_trajectory; None without truth or with less than three poses."""
    if not truth.exists():
        return None
    done = subprocess.run([str(program), "--json", str(truth), str(trajectory)], capture_output=True,
                          text=True, check=False)
    return json.loads(done.stdout)["ate_rmse_m"] if done.returncode == 0 else None
