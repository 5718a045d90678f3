"""What trying it as users do needs: the cases, programs whose end is looked at, a master of one's own."""

import os
import pathlib
import re
import signal
import subprocess
import time
from typing import NamedTuple

from acceptance.common import DEVEL, PROGRAMS, ROOT, Skipped, fresh_folder, free_port

CASES = pathlib.Path(os.environ.get("ROVIO_SFM_CASES", ROOT / "../shared/cases")).resolve()


class Ended(NamedTuple):
    status: int
    text: str  # standard output and error


def case(name):
    path = CASES / name
    if not path.exists():
        raise Skipped(f"no case {path} (set ROVIO_SFM_CASES)")
    return path


def ended(*command, timeout_s=600, **options):
    """Runs a command to its end, whatever that is."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          timeout=timeout_s, check=False, **options)
    return Ended(done.returncode, done.stdout + done.stderr)


def program(name, *arguments, **options):
    return ended(PROGRAMS / name, *arguments, **options)


def judge(outcomes):
    """outcomes: (what, holds, figure) each; all must hold. For a line's check."""
    falls = [f"{what}: {figure}" for what, holds, figure in outcomes if not holds]
    names = ", ".join(what for what, _, _ in outcomes)
    return not falls, f"{len(outcomes) - len(falls)} of {len(outcomes)} right ({names})" + (
        "; FALLS: " + " | ".join(falls) if falls else "")


def says(what, result, statuses, *patterns):
    """An outcome: the command ended with one of the statuses, and its text has all the patterns."""
    missing = [p for p in patterns if not re.search(p, result.text, re.IGNORECASE | re.MULTILINE)]
    holds = result.status in statuses and not missing
    tail = result.text.strip().splitlines()[-2:]
    return what, holds, f"status {result.status}, misses {missing}, ends with {tail}"


class Master:
    """A roscore of its own, and what is launched beside it, by the environment of the build."""

    def __init__(self, name):
        self.home = fresh_folder(f"ros/{name}")
        self.home.mkdir(parents=True)
        self.environment = dict(
            os.environ, ROS_MASTER_URI=f"http://127.0.0.1:{free_port()}", ROS_HOME=str(self.home))
        self.processes = []

    def __enter__(self):
        port = self.environment["ROS_MASTER_URI"].rsplit(":", 1)[1]
        self.start("roscore", "-p", port)
        if not self.wait_for(lambda: self.run("rosparam", "list").status == 0, 60):
            self.__exit__()
            raise RuntimeError("roscore does not come")
        return self

    def start(self, *command):
        words = [str(DEVEL / "env.sh"), *map(str, command)]
        log = open(self.home / f"{len(self.processes)}.log", "w")  # noqa: SIM115 (closed with us)
        self.processes.append((subprocess.Popen(words, env=self.environment, stdout=log,
                                                stderr=subprocess.STDOUT, start_new_session=True), log))
        return self.processes[-1][0]

    def text_of(self, process):
        number = [p for p, _ in self.processes].index(process)
        return (self.home / f"{number}.log").read_text()

    def run(self, *command, timeout_s=120):
        return ended(DEVEL / "env.sh", *command, env=self.environment, timeout_s=timeout_s)

    @staticmethod
    def wait_for(condition, timeout_s):
        end = time.monotonic() + timeout_s
        while time.monotonic() < end:
            if condition():
                return True
            time.sleep(0.2)
        return bool(condition())

    @staticmethod
    def interrupt(process, timeout_s=60):
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
        try:
            return process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return process.wait()

    def __exit__(self, *_):
        for process, log in reversed(self.processes):
            self.interrupt(process)
            log.close()
