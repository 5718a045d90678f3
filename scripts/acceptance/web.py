"""The lines about the page that map_web serves while robots drive, as a browser shows it."""

import re

from acceptance import browser
from acceptance.common import NOISE, WORK, Line, fresh_folder, free_port, render_tour
from acceptance.page import MIN_DRAWN, MIN_TURNED, share_drawn
from acceptance.users import Master, judge, program

ROBOTS = ("rovio1", "rovio2")
PATIENCE_S = 240
COUNT = "return window.livePage ? window.livePage.cloud.total : 0"
SESSIONS = "return window.livePage.status.sessions.map(s => [s.robot, s.state, s.keyframes])"
MERGED = "return window.livePage.status.merges.some(m => m.verdict === 'accepted' && m.kind !== 'loop')"
PICTURES = "return [...document.querySelectorAll('#cameras img')].map(image => image.naturalWidth)"


def make_bags(quick):
    folder = fresh_folder("web/bags")
    folder.mkdir(parents=True)
    bags = []
    for number, robot in enumerate(ROBOTS):
        tour = render_tour(f"engineRoom{number}", NOISE, 1, 20 if quick else 0)
        bags.append(folder / f"{robot}.bag")
        program("images_to_bag", tour, bags[-1], "--robot", robot)
    return bags


def press(driver, service, **fields):
    """Fills a form of the page and presses its button; what the page then says."""
    form = driver.find_element("css selector", f"form[data-service={service}]")
    for name, value in fields.items():
        field = form.find_element("name", name)
        if field.tag_name == "input":
            field.clear()
        field.send_keys(value)
    form.find_element("tag name", "button").click()
    said = driver.find_element("id", "said")
    browser.wait_until(lambda: said.text not in ("", "…"), f"answer of {service}")
    return said.text


def turned(driver, canvas):
    before = browser.picture(canvas)
    browser.drag(driver, canvas, 160, 40)
    return (abs(browser.picture(canvas) - before) > 8).mean()


def watch(driver, master, port, quick):
    """Outcomes of looking at a page while two robots drive."""
    text = lambda: master.text_of(master.processes[-1][0])  # noqa: E731
    master.wait_for(lambda: "#token=" in text(), PATIENCE_S)
    token = re.search(r"#token=([0-9a-f]{32})", text())[1]
    browser.open_page(driver, f"http://127.0.0.1:{port}/#token={token}")
    counts = []

    def grows():
        count = driver.execute_script(COUNT)
        if count > (counts[-1] if counts else 0):
            counts.append(count)
        return len(counts) >= 4

    def is_whole():
        robots = {robot for robot, _, keyframes in driver.execute_script(SESSIONS) if keyframes > 5}
        return robots == set(ROBOTS) and (quick or driver.execute_script(MERGED))

    outcomes = [("counts grow", master.wait_for(grows, PATIENCE_S), counts),
                ("both robots", master.wait_for(is_whole, PATIENCE_S), driver.execute_script(SESSIONS)),
                ("pictures", min(driver.execute_script(PICTURES)) > 100, driver.execute_script(PICTURES))]
    canvas = driver.find_element("id", "canvas")
    drawn = share_drawn(browser.picture(canvas))
    outcomes.append((f"{100 * drawn:.0f} % of the view drawn", drawn >= MIN_DRAWN, drawn))
    driver.save_screenshot(str(WORK / "web/map_web.png"))
    share = turned(driver, canvas)
    outcomes.append((f"a drag changes {100 * share:.0f} %", share >= MIN_TURNED, share))
    said = press(driver, "save_map", name="friday.db")
    outcomes.append(("save", "friday.db" in said, said))
    said = press(driver, "finish_session")
    outcomes.append(("finish", "session" in said, said))
    said = browser.console(driver)
    outcomes.append((f"{counts[0]} to {driver.execute_script(COUNT)} landmarks, console empty", not said, said))
    return outcomes


def live(quick):
    bags, maps, port = make_bags(quick), fresh_folder("web/map"), free_port()  # a kept map would be gone on with
    with Master("web") as master, browser.browser() as driver:
        launched = master.start(
            "roslaunch", "rovio_sfm", "replay.launch", f"robot:={','.join(ROBOTS)}", "mode:=every",
            f"bag:={' '.join(map(str, bags))}", "web:=true", f"web_port:={port}", "web_control:=true",
            f"output_dir:={maps}")
        outcomes = watch(driver, master, port, quick)
        status = master.interrupt(launched)
        outcomes.append(("ends", status == 0, status))
    return judge(outcomes)


LINES = [Line("web", "the live page in headless Chromium while two robots drive: grows, turns, its buttons work",
              live, True)]
