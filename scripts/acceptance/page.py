"""The lines about the page of a map, as a browser shows it."""

import numpy

from acceptance import browser
from acceptance.common import NOISE, WORK, Line, map_images, render_tour

MAX_BYTES, MAX_FIRST_PICTURE_S = 15 << 20, 3.0
MIN_DRAWN, MIN_TURNED = 0.02, 0.01  # shares of the view's pixels


def page(quick):
    """The page of one tour, dense cloud and surface on it."""
    frames = 20 if quick else 0
    folders = [render_tour(f"engineRoom{i}", NOISE, 1, frames) for i in (0, 1)]
    map_images("page/rooms", folders, "--format", "tum,ply,dense,mesh,grid,report")
    return WORK / "page/rooms/report.html"


def share_drawn(picture):
    """Of a view's pixels, those that are not its ground."""
    ground = numpy.bincount(picture.ravel()).argmax()
    return (abs(picture - ground) > 8).mean()


def report(quick):
    path = page(quick)
    with browser.browser() as driver:
        seconds = browser.open_page(driver, path.resolve().as_uri())
        canvas = driver.find_element("id", "canvas")
        before = browser.picture(canvas)
        drawn = share_drawn(before)
        browser.drag(driver, canvas, 160, 40)
        turned = (abs(browser.picture(canvas) - before) > 8).mean()
        said = browser.console(driver)
        driver.save_screenshot(str(WORK / "page/report.png"))
    size = path.stat().st_size
    holds = (not said and drawn >= MIN_DRAWN and turned >= MIN_TURNED and size <= MAX_BYTES
             and seconds <= MAX_FIRST_PICTURE_S)
    return holds, (f"{size / 2**20:.1f} MB, shown after {seconds:.1f} s, {100 * drawn:.0f} % of the view drawn, a drag "
                   f"changes {100 * turned:.0f} %, console: {said or 'nothing'}")


LINES = [Line("report", "the page of a map in headless Chromium: shown, turned by a drag, nothing in the console",
              report, True)]
