"""On which pictures tables are made, and the settings that several of them share."""

from typing import NamedTuple

from acceptance.renders import Render, render
from tables.runs import Setting, map_with

FEATURES = ("sift", "surf", "orb", "akaze")
MATCHERS = ("exact", "kdtree", "kmeans_tree")


class Scope(NamedTuple):
    frames: int = 0  # of each tour; 0: all
    threads: int = 2

    def pictures(self, tour, clean=False):
        """As the robot's camera sees them; clean: without noise."""
        return render(Render(tour, frames=self.frames), clean)

    def map(self, tour, setting=Setting()):
        return map_with(self.pictures(tour), setting, self.threads)


def feature(name, **extract):
    return Setting(frontend={"extract": {"type": name, **extract}} if name != "sift" or extract else {})


def without_denoising(name):
    return Setting(frontend={"denoise": {"enabled": False}, **feature(name).frontend})


def matcher(name):
    return Setting(frontend={"pair": {"match": {"matcher": name}}} if name != "exact" else {})


def pose_method(name):
    return Setting(frontend={"pair": {"verify": {"pose_method": name}}} if name != "five_point" else {})


def percentile(factor):
    return Setting(frontend={"pair": {"max_mean_factor": factor}} if factor != 2 else {})


def odometry_gate(enabled):
    return Setting(frontend={"recursion": {"odometry_gate": {"enabled": True}}} if enabled else {})


DENSIFIED = Setting(words=("--format", "tum,ply,densified"))
