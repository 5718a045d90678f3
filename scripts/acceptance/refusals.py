"""What cannot be done is said by its name and by the exit status: formats, stores in use, files of other kinds."""

import json
import os
import shutil

from acceptance.common import Line, dataset, fresh_folder
from acceptance.endings import Running, frames_of
from acceptance.users import case, judge, program, says

EVERY = ("--places", "none")
NO_GRID = "grid: not written, as the map is not metric"


def formats(_quick):
    """A grid of a map that is not metric, alone and beside another format, by both programs."""
    outcomes = []
    for what, words, statuses, files in (("grid alone", "grid", {1}, set()),
                                         ("grid and tum", "grid,tum", {0}, {"trajectory.txt"})):
        out = fresh_folder("refusals/formats")
        result = program("map_images", case("good7"), "--out", out, *EVERY, "--format", words)
        outcomes.append(says(f"map_images, {what}", result, statuses, f"^{NO_GRID}$"))
        told = json.loads((out / "summary.json").read_text())["formats_left_out"]
        outcomes.append((f"summary.json, {what}", len(told) == 1 and told[0].endswith(NO_GRID), told))
        exported = out / "exported"
        result = program("map_tool", "export", out / "map.db", "--out", exported, "--format", words)
        outcomes.append(says(f"map_tool, {what}", result, statuses, f"^{NO_GRID}$"))
        left = {path.name for path in exported.iterdir()}
        outcomes.append((f"files, {what}", left == files, left))
    return judge(outcomes)


def stores(_quick):
    """A store that a program maps into is only read; what is no store says so."""
    out = fresh_folder("refusals/stores")
    with Running("map_images", dataset("leuven_castle"), "--out", out, *EVERY) as mapping:
        mapping.wait_until(lambda: (out / "map.db").exists() and frames_of(out / "map.db") > 0)  # a store afterwards too
        in_use = "another process maps into this folder"
        outcomes = [says("prune", program("map_tool", "prune", out / "map.db", "--descriptors"), {1}, in_use)]
    outcomes += [
        says("prune afterwards", program("map_tool", "prune", out / "map.db", "--descriptors"), {0}, "forgot"),
        says("a folder", program("map_tool", "info", out), {1}, "is a folder; expected a map store"),
        says("nothing", program("map_tool", "prune", "/nope.db", "--images"), {1}, "/nope.db: .*no such file")]
    return judge(outcomes)


def files(_quick):
    """Files of options and calibrations, links and bags that are something else."""
    work = fresh_folder("refusals/files")
    work.mkdir(parents=True)
    (work / "octal.yaml").write_text("extract: {max_features: 0777}\n")
    (work / "two.yaml").write_text("extract: {max_features: 500}\n---\nextract: {max_features: 600}\n")
    (work / "text.bag").write_text("no bag\n")
    for name in ("centre", "circle"):
        shutil.copytree(case("good7"), work / name)
    calibration = work / "centre/calibration.txt"
    numbers = [line for line in calibration.read_text().splitlines() if line and line[0] != "#"][0].split()
    calibration.chmod(0o644)
    calibration.write_text(" ".join([*numbers[:2], "9999", *numbers[3:]]) + "\n")
    picture = sorted((work / "circle/images").iterdir())[2]
    picture.unlink()
    os.symlink(picture.name, picture)

    def mapped(*words):
        return program("map_images", *words, "--out", work / "map", *EVERY)

    good = case("good7")
    return judge([
        says("an octal number", mapped(good, "--frontend", work / "octal.yaml"), {1},
             "octal.yaml: extract.max_features: expected a whole number, not '0777'"),
        says("two documents", mapped(good, "--frontend", work / "two.yaml"), {1}, "two.yaml: .*a second document"),
        says("a folder of options", mapped(good, "--mapper", work), {1}, "is a folder; expected a YAML file"),
        says("no file of options", mapped(good, "--frontend", "/nope"), {1}, "/nope: cannot be read: No such file"),
        says("a centre outside", mapped(work / "centre"), {1}, r"calibration.txt:\d+: camera cx = 9999: expected 0 to"),
        says("a link in a circle", mapped(work / "circle"), {1}, r"times.txt:\d+: .*Too many levels"),
        says("no bag", program("replay", work / "text.bag", "--out", work / "map"), {1},
             "text.bag: no bag, or not a whole one"),
    ])


LINES = [
    Line("shell_formats", "a format that a map cannot be written in is told; none written ends with 1", formats, True),
    Line("shell_stores", "a store that is mapped into is not changed by map_tool", stores, True),
    Line("shell_files", "options, calibrations, links and bags that are something else are named", files, True),
]
