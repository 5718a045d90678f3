"""A headless Chromium that looks at a page."""

import contextlib
import shutil
import time

import cv2
import numpy

from acceptance.common import Skipped

CHROMIUM, DRIVER = "/usr/bin/chromium", "/usr/bin/chromedriver"
FLAGS = ("--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--ignore-gpu-blocklist", "--window-size=1400,1300", "--hide-scrollbars")
PATIENCE_S = 60


@contextlib.contextmanager
def browser():
    if not (shutil.which(CHROMIUM) and shutil.which(DRIVER)):
        raise Skipped("chromium and chromium-driver are not installed")
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for flag in FLAGS:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service(DRIVER), options=options)
    try:
        yield driver
    finally:
        driver.quit()


def wait_until(condition, what):
    end = time.monotonic() + PATIENCE_S
    while not condition():
        if time.monotonic() > end:
            raise RuntimeError(f"no {what} within {PATIENCE_S} s")
        time.sleep(0.05)


def open_page(driver, address):
    """Opens a page; the seconds until it says that it is shown."""
    start = time.monotonic()
    driver.get(address)
    wait_until(lambda: driver.find_element("tag name", "body").get_attribute("data-shown") == "yes", "map shown")
    return time.monotonic() - start


def console(driver):
    return [entry["message"] for entry in driver.get_log("browser")]


def picture(element):
    """Of an element, as an array of grey levels."""
    png = numpy.frombuffer(element.screenshot_as_png, numpy.uint8)
    return cv2.imdecode(png, cv2.IMREAD_GRAYSCALE).astype(int)


def drag(driver, element, right_px, down_px):
    from selenium.webdriver.common.action_chains import ActionChains
    ActionChains(driver).click_and_hold(element).move_by_offset(right_px, down_px).release().perform()
