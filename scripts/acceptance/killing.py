"""The lines about a mapping node that is killed, or whose disk is full or cannot be written."""

import json
import re
import tempfile

from acceptance.common import PROGRAMS, ROOT, Line, fresh_folder
from acceptance.endings import Running, disk
from acceptance.live_mapping import master, ros

FEEDER = ROOT / "scripts/acceptance/feed_mapping.py"
MIN_ANNOUNCEMENTS = 0.5  # of the drives at a kill: most lives are longer than a commit takes


def fed(env, how, *arguments):
    said = ros(env, "/usr/bin/python3", FEEDER, how, PROGRAMS, *arguments, check=True)
    return json.loads(said.splitlines()[-1])


def killed(quick):
    folder = fresh_folder("kept/killed")
    folder.mkdir()
    with tempfile.TemporaryDirectory() as home, master(home) as env:
        kept = fed(env, "kill", folder, 5 if quick else 50, 1)
    holds = kept["lost"] == kept["broken"] == 0 and kept["announcements"] >= MIN_ANNOUNCEMENTS * kept["kills"]
    return holds, ", ".join(f"{name} {count}" for name, count in kept.items())


def full_disk(_quick):
    with disk("size=200m") as folder, tempfile.TemporaryDirectory() as home, master(home) as env:
        kept = fed(env, "fill", folder)
    holds = kept["lost"] == 0 and kept["whole"] and kept["announcements"] > 0
    return holds, ", ".join(f"{name} {value}" for name, value in kept.items())


def read_only(_quick):
    with disk("size=1m,ro") as folder, tempfile.TemporaryDirectory() as home, master(home) as env, \
            Running("mapping", f"_output_dir:={folder}", env=env) as node:
        status, _ = node.ended()
        said = re.findall(rf"{re.escape(str(folder))}[^\x1b\n]*", node.said())
    return status == 1 and bool(said), f"exit status {status}: {said[-1] if said else node.said()[-300:]}"


LINES = [
    Line("killed", "kill -9 of mapping at random moments (50; 5 in the quick run): the store is whole, and every frame "
         "announced as saved is there", killed, True),
    Line("full_disk", "a full disk: map_status says why, mapping goes on, nothing saved is lost", full_disk, True),
    Line("read_only", "a folder that cannot be written: refused at start, named", read_only, True),
]
