"""A robot in a few lines whose answers a test can spoil: reports, ticks, stills and drive commands."""

import http.server
import threading
import time
import urllib.parse

import cv2
import numpy

REPORT = ("x=3718 y=3495 theta=0.863 room=0 ss=60 beacon=51 beacon_x=9941 next_room=-1 next_room_ss=0 "
          "state=0 ui_status=0 resistance=0 sm=15 pp=0 flags=0001 brightness=6 resolution=3 "
          "video_compression=2 frame_rate=15 privilege=0 user_check=0 speaker_volume=14 mic_volume=17 "
          "wifi_ss=212 show_time=0 ddns_state=0 email_state=0 battery=123 charging=0 head_position=202 "
          "ac_freq=2").split()
MCU = "0E0100000000000000000003CB7B00"


def picture():
    """A VGA JPEG with something in it."""
    small = numpy.random.RandomState(1).randint(0, 255, (60, 80, 3), dtype=numpy.uint8)
    image = cv2.resize(small, (640, 480), interpolation=cv2.INTER_LINEAR)
    return cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, 60])[1].tobytes()


class OddRobot:
    def __init__(self):
        self.jpeg = picture()
        self.fields = list(REPORT)  # of GetReport; a test leaves some out
        self.hangs = threading.Event()  # nav accepts and never answers
        self.ends = threading.Event()
        self.drives = []  # (time, number) of drive commands that move
        robot = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                robot.answer(self)

            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.daemon_threads = True
        self.port = self.server.server_address[1]
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def answer(self, handler):
        url = urllib.parse.urlparse(handler.path)
        query = urllib.parse.parse_qs(url.query)
        if url.path.startswith("/Jpeg/"):
            time.sleep(0.05)
            return self.send(handler, "image/jpeg", self.jpeg)
        if url.path != "/rev.cgi":
            return self.send(handler, "text/plain", b"")  # settings: granted without a word
        while self.hangs.is_set() and not self.ends.is_set():
            time.sleep(0.05)
        return self.send(handler, "text/plain", ("Cmd = nav\nresponses = %s\n" % self.nav(query)).encode())

    def nav(self, query):
        action = query["action"][0]
        if action == "1":
            return "0|" + "|".join(self.fields)
        if action == "20":
            return MCU
        if action == "18" and query["drive"][0] != "0":
            self.drives.append((time.monotonic(), int(query["drive"][0])))
        return "0"

    @staticmethod
    def send(handler, kind, body):
        handler.send_response(200)
        handler.send_header("Content-Type", kind)
        handler.send_header("Content-Length", str(len(body)))
        handler.end_headers()
        handler.wfile.write(body)

    def without(self, name):
        self.fields = [field for field in REPORT if not field.startswith(name + "=")]

    def stop(self):
        self.ends.set()
        self.server.shutdown()
