#!/usr/bin/env python3
"""Tests report.html in a headless browser: all charts are drawn and follow the cursor.
Run by ctest as test_report_page.py REPLAY RAWLOG FOLDER CHROMIUM CHROMEDRIVER; exit status 77 without selenium."""

import shutil
import subprocess
import sys
import unittest
from pathlib import Path
from urllib.parse import quote

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
except ModuleNotFoundError:
    print("skipped: Python has no module selenium")
    sys.exit(77)

WAIT_S = 30
NAME = "<img src=x onerror=window.evil=1>.rawlog"  # a name that must stay a name

# Number of pixels of each chart's drawing that are neither white nor transparent.
DRAWN = """
return [...document.querySelectorAll('.chart, .plan')].map((figure) => {
    const canvas = figure.querySelector('canvas');
    const points = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let drawn = 0;
    for (let i = 0; i < points.length; i += 4)
        if (points[i + 3] > 0 && points[i] + points[i + 1] + points[i + 2] < 720) ++drawn;
    return [figure.id || canvas.id, drawn];
});"""
# Position of the cursor line in each chart; null when it is not shown.
CURSORS = """
return [...document.querySelectorAll('.cursor')].map((line) => line.hidden ? null : line.getBoundingClientRect().left);"""
# Labels of the time axis of each chart.
AXES = """
return [...document.querySelectorAll('.chart')].map((chart) =>
    [...chart.querySelectorAll('.dygraph-axis-label-x')].map((label) => label.textContent).join(' '));"""


class ReportPage(unittest.TestCase):
    REPLAY = RAWLOG = CHROMIUM = CHROMEDRIVER = None
    FOLDER = Path()

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(cls.FOLDER, ignore_errors=True)
        cls.FOLDER.mkdir(parents=True)
        shutil.copy(cls.RAWLOG, cls.FOLDER / NAME)
        cls.out = cls.FOLDER / "out"
        subprocess.run([cls.REPLAY, cls.FOLDER / NAME, "--output", cls.out, "--quiet"], check=True)
        options = Options()
        options.binary_location = cls.CHROMIUM
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1280,1000"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        cls.browser = webdriver.Chrome(service=Service(cls.CHROMEDRIVER), options=options)
        cls.addClassCleanup(cls.browser.quit)

    def setUp(self):
        self.open()

    def tearDown(self):
        self.assertEqual(self.browser.get_log("browser"), [], "messages on the console")

    def open(self, fragment=""):
        self.browser.get("about:blank")
        self.browser.get("file://" + quote(str(self.out / "report.html")) + fragment)
        self.until(lambda: self.run_script("return document.getElementById('large').naturalWidth > 0"))

    def run_script(self, script):
        return self.browser.execute_script(script)

    def until(self, condition):
        return WebDriverWait(self.browser, WAIT_S).until(lambda _: condition())

    def time(self):
        return float(self.run_script("return document.body.dataset.t"))

    def robots(self):
        return self.run_script("return ['way', 'map'].map((id) => document.getElementById(id).dataset.robot)")

    def picture(self):
        """Returns the time of the selected picture in the strip, which must be the one shown large."""
        script = """
            const current = document.querySelectorAll('#strip .current');
            return [current.length, current[0].querySelector('img').src === document.getElementById('large').src,
                    current[0].textContent]"""
        count, is_large, text = self.run_script(script)
        self.assertEqual((count, is_large), (1, True))
        return float(text.strip().removesuffix(" s"))

    def plot(self, chart):
        element = self.browser.find_element(By.CSS_SELECTOR, f"#chart-{chart} .plot")
        self.run_script(f"document.getElementById('chart-{chart}').scrollIntoView({{block: 'center'}})")
        return element

    def point_at(self, chart, share):
        """Moves the mouse to a share of the chart's width."""
        plot = self.plot(chart)
        x = int((share - 0.5) * plot.size["width"])
        before = self.time()
        ActionChains(self.browser, duration=50).move_to_element_with_offset(plot, x, 0).perform()
        self.until(lambda: self.time() != before)

    # ---- what is shown

    def test_every_chart_is_drawn_and_nothing_is_fetched(self):
        drawn = dict(self.until(lambda: self.run_script(DRAWN)))
        expected = {"chart-" + name for name in "status turn speed heading distance labels counts contacts floor".split()}
        self.assertEqual(set(drawn), expected | {"way", "map"})
        for name, points in drawn.items():
            self.assertGreater(points, 1000, name)
        fetched = self.run_script("return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([name for name in fetched if not name.startswith("data:")], [])

    def test_a_strange_name_is_only_a_name(self):
        self.assertIsNone(self.run_script("return window.evil === undefined ? null : window.evil"))
        self.assertEqual(self.browser.find_element(By.TAG_NAME, "h1").text, "Replay of " + NAME)

    def test_fits_into_wide_and_narrow_windows(self):
        try:
            for width in (1280, 800):
                self.browser.set_window_size(width, 900)
                self.until(lambda: self.run_script("return innerWidth") == width)
                self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), width)
        finally:
            self.browser.set_window_size(1280, 1000)

    # ---- following the cursor

    def test_all_follow_the_mouse_over_a_chart(self):
        self.point_at("turn", 0.3)
        first, robots = self.time(), self.robots()
        self.point_at("turn", 0.8)
        second = self.time()
        self.assertGreater(second, first + 1)
        cursors = self.run_script(CURSORS)
        self.assertEqual(len(cursors), 9)
        for x in cursors:
            self.assertAlmostEqual(x, cursors[0], delta=1.5)
        for before, after in zip(robots, self.robots()):
            self.assertNotEqual(before, after)
        self.assertAlmostEqual(self.picture(), second, delta=0.5)
        self.assertIn(f"t = {second:.2f} s", self.browser.find_element(By.ID, "readout").text)
        for chart in ("turn", "speed"):
            flow = self.browser.find_elements(By.CSS_SELECTOR, f"#chart-{chart} .legend b")[-1].text
            self.assertIn(f"{chart} {flow} ", self.browser.find_element(By.ID, "readout").text)

    def test_the_map_leads_as_well(self):
        canvas = self.browser.find_element(By.ID, "map")
        self.run_script("document.getElementById('map').scrollIntoView({block: 'center'})")
        for side, expected in ((-0.45, 0.0), (0.45, None)):
            before = self.time()
            mouse = ActionChains(self.browser, duration=50)
            mouse.move_to_element_with_offset(canvas, int(side * canvas.size["width"]), 0).perform()
            self.until(lambda: self.time() != before)
            if expected is not None:
                self.assertAlmostEqual(self.time(), expected, delta=0.2)
        self.assertGreater(self.time(), 1)

    def test_a_click_pins_and_escape_frees(self):
        self.point_at("speed", 0.5)
        ActionChains(self.browser).click().perform()
        self.until(lambda: "#t=" in self.browser.current_url)
        pinned = self.time()
        ActionChains(self.browser, duration=50).move_by_offset(150, 0).perform()
        self.until(lambda: "pinned" in self.browser.find_element(By.ID, "readout").text)
        self.assertEqual(self.time(), pinned)
        self.browser.find_element(By.TAG_NAME, "body").send_keys(Keys.ESCAPE)
        self.assertNotIn("#t=", self.browser.current_url)
        self.point_at("speed", 0.2)
        self.assertLess(self.time(), pinned)

    def test_arrow_keys_step_through_pictures_and_fields(self):
        self.open("#t=2")
        body = self.browser.find_element(By.TAG_NAME, "body")
        start = self.picture()
        body.send_keys(Keys.ARROW_RIGHT)
        self.assertGreater(self.picture(), start)
        self.assertEqual(self.time(), self.picture())
        body.send_keys(Keys.ARROW_LEFT)
        self.assertEqual(self.picture(), start)
        body.send_keys(Keys.SHIFT + Keys.ARROW_RIGHT)
        self.assertTrue(start < self.time() < start + 0.2, "one field further")

    def test_the_fragment_opens_a_moment(self):
        self.open("#t=1.5")
        self.assertAlmostEqual(self.time(), 1.5)
        self.assertAlmostEqual(self.picture(), 1.5, delta=0.5)
        self.run_script("location.hash = '#t=2.5'")
        self.until(lambda: self.time() == 2.5)

    def test_zoom_is_linked_and_a_double_click_shows_all_again(self):
        everything = self.run_script(AXES)
        self.assertEqual(len(set(everything)), 1)
        plot = self.plot("heading")
        mouse = ActionChains(self.browser, duration=50).move_to_element_with_offset(plot, -100, 0)
        mouse.click_and_hold().move_by_offset(150, 5).release().perform()
        self.until(lambda: self.run_script(AXES) != everything)
        self.until(lambda: len(set(self.run_script(AXES))) == 1)
        ActionChains(self.browser).double_click(plot).perform()
        self.until(lambda: self.run_script(AXES) == everything)

    # ---- times

    def test_times_come_from_the_summary(self):
        picker = self.browser.find_element(By.ID, "summary")
        other = self.FOLDER / "other.json"
        other.write_text('{"input": {"file": "other.rawlog"}}')
        picker.send_keys(str(other))
        self.until(lambda: "is not the summary.json" in self.browser.find_element(By.ID, "times").text)
        picker.send_keys(str(self.out / "summary.json"))
        self.until(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#chart-timing .plot canvas"))
        self.assertGreater(dict(self.run_script(DRAWN))["chart-timing"], 1000)
        text = self.browser.find_element(By.ID, "times").text
        self.assertIn("fields a second", text)
        self.assertNotIn("NaN", text)
        self.assertNotIn("is not the summary.json", text)


if __name__ == "__main__":
    arguments = [sys.argv.pop(1) for _ in range(5)]
    ReportPage.REPLAY, ReportPage.RAWLOG = arguments[0:2]
    ReportPage.FOLDER = Path(arguments[2])
    ReportPage.CHROMIUM, ReportPage.CHROMEDRIVER = arguments[3:5]
    unittest.main()
