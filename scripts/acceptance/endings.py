"""How programs are ended from outside, and what they leave: signals, full disks, read-only folders."""

import contextlib
import os
import pathlib
import signal
import sqlite3
import subprocess
import tempfile
import time

from acceptance.common import PROGRAMS, Skipped

PATIENCE_S = 600
BETWEEN_SIGNALS_S = 0.7  # signals nearer than half a second are one wish


@contextlib.contextmanager
def disk(options):
    """A small file system of its own, as `mount -o` describes it."""
    with tempfile.TemporaryDirectory() as place:
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "none", place],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Skipped(f"file systems can be mounted by root alone: {done.stderr.strip()}")
        try:
            yield pathlib.Path(place)
        finally:
            subprocess.run(["umount", "-l", place], check=True)


def fill(folder):
    """Leaves no room on the file system of the folder."""
    with contextlib.suppress(OSError), (folder / "filler").open("wb", buffering=0) as filler:
        while True:
            filler.write(b"\0" * 65536)


def size_of(folder):
    return sum(path.stat().st_size for path in pathlib.Path(folder).rglob("*") if path.is_file())


class Running:
    """A program in the background, its words in a file."""

    def __init__(self, program, *arguments, **options):
        self.log = tempfile.NamedTemporaryFile("r+")
        self.process = subprocess.Popen([str(PROGRAMS / program), *map(str, arguments)],
                                        stdout=self.log, stderr=subprocess.STDOUT, **options)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.log.close()

    def said(self):
        self.log.seek(0)
        return self.log.read()

    def wait_until(self, condition):
        """Whether the condition came true before the program ended."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            if condition():
                return True
            if self.process.poll() is not None:
                return False
            time.sleep(0.05)
        return False

    def send(self, number):
        self.process.send_signal(number)

    def ended(self):
        """Exit status, as a shell shows it, and the seconds until then."""
        start = time.monotonic()
        status = self.process.wait(PATIENCE_S)
        return (128 - status if status < 0 else status), time.monotonic() - start


def end(running, how, folder):
    """Ends a program in the middle: kill, once, twice, full."""
    if how == "kill":
        running.send(signal.SIGKILL)
    elif how in ("once", "twice"):
        running.send(signal.SIGINT)
    if how == "twice":
        time.sleep(BETWEEN_SIGNALS_S)
        if running.process.poll() is None:
            running.send(signal.SIGINT)
    if how == "full":  # before it can write on
        running.send(signal.SIGSTOP)
        fill(folder)
        running.send(signal.SIGCONT)
    return running.ended()


def names_in(folder):
    """What a folder holds, relative, without the filler."""
    folder = pathlib.Path(folder)
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*")
                  if path.is_file() and path.name != "filler")


def frames_of(store):
    """Frames of a store that is whole; -1: it is not."""
    checked = subprocess.run([str(PROGRAMS / "map_tool"), "check", str(store)], capture_output=True, check=False)
    if checked.returncode != 0:
        return -1
    with contextlib.closing(sqlite3.connect(f"file:{store}?mode=ro", uri=True)) as rows:
        return rows.execute("SELECT count(*) FROM frame").fetchone()[0]


def frames_below(folder):
    """Frames of the store that a folder holds; 0: none holds one; -1: it is not whole."""
    stores = list(pathlib.Path(folder).rglob("map.db"))
    return frames_of(stores[0]) if stores else 0


def environment(port, home):
    return dict(os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_HOME=str(home))
