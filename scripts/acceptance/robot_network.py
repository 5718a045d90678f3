"""Section 4 of the third stage: a robot that answers oddly, and what the simulated one shows."""

import re

from acceptance.common import Line, Simulator
from acceptance.node_tests import node_tests
from acceptance.robot_face import curl

LEAST_BYTES, MOST_BYTES = 3500, 50000  # outside public clients drop a picture


def picture_bytes(base):
    """The size of a VGA still by compression ratio."""
    curl(base + "/ChangeResolution.cgi?ResType=3")
    sizes = []
    for ratio in (0, 1, 2):
        curl(base + f"/ChangeCompressRatio.cgi?Ratio={ratio}")
        for _ in range(4):  # the answer precedes the effect
            _, body = curl(base + "/Jpeg/CamImg1.jpg")
        sizes.append(len(body))
    return sizes


def simulator_face():
    with Simulator("--serve", "--tour", "visionlab") as simulator:
        base = f"http://127.0.0.1:{simulator.port}"
        page, _ = curl(base + "/")
        _, register = curl(base + "/debug.cgi?action=read_i2c&address=0x13")
        sizes = picture_bytes(base)
    holds = (page.startswith("HTTP/1.0 200") and "text/html" in page
             and re.fullmatch(rb"read_i2c = 00000013=[0-9a-f]{8}\n", register) is not None
             and all(LEAST_BYTES < size <= MOST_BYTES for size in sizes) and sizes == sorted(sizes))
    return holds, f"GET / {page.split(chr(13))[0]}, debug.cgi {register!r}, VGA stills by ratio {sizes} bytes"


def check(_quick):
    faults, tests = node_tests("driver_(odd_robot|streaming|driving)")
    face, figures = simulator_face()
    return faults and face, f"{tests}; {figures}"


LINES = [
    Line("robot_network", "4: each field of a report has its own fate, a silent nav is told, damaged JPEGs, second "
         "drivers and stale commands do no harm; the simulator serves /, debug.cgi and 3.5 to 50 kB a VGA frame",
         check, False),
]
