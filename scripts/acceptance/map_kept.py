"""The lines about the map store: what a crash leaves, what comes back, what is refused."""

import contextlib
import os
import shutil
import sqlite3
import subprocess

from acceptance.common import PROGRAMS, WORK, Line, fresh_folder, map_images, render_tour, run

SAVED_TABLES = ("info", "drive", "frame", "descriptors", "image", "pair", "track_link", "session", "keyframe",
                "keyframe_tracks", "light_pose", "landmark_block", "track_alias", "merge_edit", "waiting_match",
                "gauge", "separated")  # the journal may be written in other parts


def crash_states(quick):
    """Unit tests on a simulated disk; their last lines say how many states were tried."""
    wanted = {"ROVIO_SFM_CRASH_STATES": "" if quick else "whole"}
    printed = run(PROGRAMS / "app_test", "--gtest_filter=CrashStates.*", env={**os.environ, **wanted})
    figures = [line for line in printed.splitlines() if " states, " in line]
    held = "[  PASSED  ] 5 tests." in printed
    return held, "; ".join(figures)


def tool(*arguments):
    done = subprocess.run([str(PROGRAMS / "map_tool"), *map(str, arguments)], capture_output=True, text=True,
                          check=False, timeout=600)
    return done.returncode, done.stdout, done.stderr


def rows_of(path):
    """Everything that a store holds, by table."""
    with contextlib.closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as store:
        return {table: sorted(map(repr, store.execute(f"SELECT * FROM {table}"))) for table in SAVED_TABLES}


def kept_map(quick):
    """A map of two drives and its store; mapped once."""
    folder = WORK / "kept/rooms"
    if not (folder / "map.db").exists():
        folders = [render_tour(f"engineRoom{i}", 10, 1, 20 if quick else 40) for i in (0, 1)]
        map_images("kept/rooms", folders)
    return folder / "map.db"


def save_load_save(quick):
    store = kept_map(quick)
    copies = fresh_folder("kept/copies")
    copies.mkdir()
    once, twice = copies / "once.db", copies / "twice.db"
    statuses = [tool("repair", store, once)[0], tool("repair", once, twice)[0],
                tool("check", store)[0], tool("check", twice)[0]]
    first, last = rows_of(store), rows_of(twice)
    other = [table for table in SAVED_TABLES if first[table] != last[table]]
    held = statuses == [0, 0, 0, 0] and not other
    count = sum(map(len, first.values()))
    return held, f"{count} rows, tables that differ: {', '.join(other) or 'none'}, statuses {statuses}"


def set_version(path, version):
    with contextlib.closing(sqlite3.connect(path)) as store:
        store.execute(f"PRAGMA user_version = {version}")


def other_versions(quick):
    """Refused by a real program, with both versions named, and left as they were."""
    folder = fresh_folder("kept/versions")
    folder.mkdir()
    store = folder / "map.db"
    shutil.copy(kept_map(quick), store)
    answers = []
    for version in (0, 3):
        set_version(store, version)
        before = store.read_bytes()
        status, _, error = tool("info", store)
        named = f"map.db: version = {version}: expected 2, which this program writes, or 1" in error
        answers.append(status == 1 and named and store.read_bytes() == before)
    set_version(store, 2)
    answers.append(tool("check", store)[0] == 0)
    return all(answers), f"refused older, refused newer, accepted its own: {answers}"


LINES = [
    Line("crash_states", "a drive on a disk that loses its power at every sync and fails at any call: nothing saved "
         "is lost (unit tests)", crash_states, True),
    Line("save_load_save", "save -> load -> save: equal content", save_load_save, True),
    Line("other_versions", "a store of an older or newer schema version is refused with the version named",
         other_versions, True),
]
