"""What curl gets from the simulated robot, byte for byte, against docs of the robot's HTTP face."""

import re
import subprocess

from acceptance.common import Simulator

REPORT = re.compile(
    r"Cmd = nav\n"
    r"responses = 0\|x=-?\d+\|y=-?\d+\|theta=-?\d\.\d{3}\|room=\d\|ss=\d+\n"
    r"\|beacon=\d+\|beacon_x=-?\d+\|next_room=-?\d+\|next_room_ss=\d+\n"
    r"\|state=\d\|ui_status=\d+\|resistance=\d+\|sm=\d+\|pp=\d+\|flags=[0-9a-f]{4}\n"
    r"\|brightness=\d\|resolution=[0-3]\|video_compression=[0-2]\|frame_rate=\d+\n"
    r"\|privilege=[01]\|user_check=[01]\|speaker_volume=\d+\|mic_volume=\d+\n"
    r"\|wifi_ss=\d+\|show_time=\d+\|ddns_state=\d+\|email_state=\d+\n"
    r"\|battery=\d+\|charging=\d+\|head_position=\d+\|ac_freq=\d\n")
MCU_REPORT = re.compile(r"Cmd = nav\nresponses = 0E[0-9A-F]{28}\n")
END = b"\xff\xd9"


def curl(url, *options, seconds=10):
    """Status line and headers as text, body as bytes."""
    done = subprocess.run(["curl", "-s", "-i", "--max-time", str(seconds), *options, url],
                          capture_output=True, check=False)
    head, _, body = done.stdout.partition(b"\r\n\r\n")
    return head.decode("latin-1"), body


def report(base):
    head, body = curl(base + "/rev.cgi?Cmd=nav&action=1")
    return head.startswith("HTTP/1.0 200") and REPORT.fullmatch(body.decode("latin-1")) is not None


def mcu_report(base):
    head, body = curl(base + "/rev.cgi?Cmd=nav&action=20")
    return head.startswith("HTTP/1.0 200") and MCU_REPORT.fullmatch(body.decode("latin-1")) is not None


def still(base):
    head, body = curl(base + "/Jpeg/CamImg1234.jpg")
    length = re.search(r"Content-Length: (\d+)", head)
    return (head.startswith("HTTP/1.0 200") and "Content-Type: image/jpeg" in head
            and length is not None and int(length[1]) == len(body)
            and body.startswith(b"\xff\xd8") and body.rstrip(b"\r\n").endswith(END))


def stream(base):
    """Ten seconds of MJPEG: the robot's boundary, no length in the parts, whole JPEGs in them."""
    head, body = curl(base + "/GetData.cgi", seconds=10)
    parts = body.split(b"--WINBONDBOUDARY\r\nContent-Type: image/jpeg\r\n\r\n")
    whole = [part for part in parts[1:-1]
             if part.startswith(b"\xff\xd8") and part.rstrip(b"\r\n").endswith(END)]
    return (head.startswith("HTTP/1.0 200")
            and "Content-Type: multipart/x-mixed-replace;boundary=WINBONDBOUDARY" in head
            and len(whole) >= 2 and len(whole) == len(parts) - 2)


def refused_login(base):
    """With checking on, no or wrong credentials get 401 and the robot's realm."""
    curl(base + "/SetUserCheck.cgi?Check=true", "-u", "admin:admin")
    answers = [curl(base + "/GetStatus.cgi"), curl(base + "/GetStatus.cgi", "-u", "admin:wrong")]
    allowed, _ = curl(base + "/GetStatus.cgi", "-u", "admin:admin")
    return allowed.startswith("HTTP/1.0 200") and all(
        head.startswith("HTTP/1.0 401") and 'WWW-Authenticate: Basic realm="Rovio"' in head
        for head, _ in answers)


def check(_quick):
    with Simulator("--serve", "--tour", "visionlab") as simulator:
        base = f"http://127.0.0.1:{simulator.port}"
        results = {face.__name__: face(base) for face in (report, mcu_report, still, stream, refused_login)}
    return all(results.values()), ", ".join(f"{k} {'as written' if v else 'WRONG'}"
                                            for k, v in results.items())
