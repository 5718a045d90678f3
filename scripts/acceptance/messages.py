"""Section 5 of the third stage: messages from strangers, large ones, and fuzz targets."""

import shutil

from acceptance.common import PROGRAMS, ROOT, Line, run
from acceptance.node_tests import node_tests

FUZZ_S = 60


def fuzz():
    if shutil.which("clang++-14") is None:
        return False, "fuzz: no clang-14"
    lines = [line for line in run(ROOT / "scripts/fuzz", FUZZ_S, check=False, timeout_s=7200).splitlines()
             if line.startswith("fuzz ")]
    return bool(lines) and all("no finding" in line for line in lines), "; ".join(lines) or "fuzz: did not build"


def check(quick):
    senders, tests = node_tests("mapping_senders")
    border = run(PROGRAMS / "ros_test", "--gtest_filter=*Message*:*FrameEvent*:*PlaceMatch*", check=False)
    passed = "[  PASSED  ]" in border and "FAILED" not in border
    fuzzed, figures = (True, "") if quick else fuzz()
    return senders and passed and fuzzed, f"{tests}; messages {'refused' if passed else 'FAIL'}; {figures}"


LINES = [
    Line("messages", "5: a stray frame locks nobody out and is told, huge frames fill no memory, indices are "
         f"checked, fuzz targets find nothing in {FUZZ_S} s each", check, False),
]
