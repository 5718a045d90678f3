"""Runs node tests of the built tree, as acceptance."""

import re
import subprocess

from acceptance.common import BUILD, DEVEL


def node_tests(pattern):
    """Whether all tests whose name matches pass, at least one; and what ctest says."""
    done = subprocess.run([str(DEVEL / "env.sh"), "ctest", "-R", pattern, "--output-on-failure"],
                          cwd=BUILD, capture_output=True, text=True, check=False)
    found = "No tests were found" not in done.stdout + done.stderr
    summary = re.search(r"\d+% tests passed.*", done.stdout)
    return done.returncode == 0 and found, f"{pattern}: {summary[0] if summary else 'no test ran'}"
