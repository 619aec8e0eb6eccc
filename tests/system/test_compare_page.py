#!/usr/bin/env python3
"""Tests compare.html in a headless browser: all drawings are drawn, and every rawlog can be chosen.
Run by ctest as test_compare_page.py REGRESS REPLAY RAWLOG FOLDER CHROMIUM CHROMEDRIVER; exit status 77 without
selenium."""

import json
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
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select, WebDriverWait
except ModuleNotFoundError:
    print("skipped: Python has no module selenium")
    sys.exit(77)

WAIT_S = 30
EVIL = "</script><!--<script><img src=x onerror=window.evil=1>"  # a text that must stay a text

# Number of pixels of each drawing that are neither white nor transparent.
DRAWN = """
return [...document.querySelectorAll('#drive figure')].map((figure) => {
    const canvas = figure.querySelector('canvas');
    const points = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let drawn = 0;
    for (let i = 0; i < points.length; i += 4)
        if (points[i + 3] > 0 && points[i] + points[i + 1] + points[i + 2] < 720) ++drawn;
    return [figure.dataset.id || canvas.dataset.map || 'ways', drawn];
});"""
# Number of pixels of a canvas with the colour of A or of B.
COLOURED = """
const canvas = document.querySelector(arguments[0]);
const points = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
const colours = [data.colours.a, data.colours.b].map((c) => [1, 3, 5].map((at) => parseInt(c.slice(at, at + 2), 16)));
let count = 0;
for (let i = 0; i < points.length; i += 4)
    if (colours.some((colour) => colour.every((value, k) => Math.abs(points[i + k] - value) < 8))) ++count;
return count;"""


class ComparePage(unittest.TestCase):
    REGRESS = REPLAY = RAWLOG = CHROMIUM = CHROMEDRIVER = None
    FOLDER = Path()

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(cls.FOLDER, ignore_errors=True)
        cls.FOLDER.mkdir(parents=True)
        cls.make_runs()
        options = Options()
        options.binary_location = cls.CHROMIUM
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1280,1000"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        cls.browser = webdriver.Chrome(service=Service(cls.CHROMEDRIVER), options=options)
        cls.addClassCleanup(cls.browser.quit)

    @classmethod
    def regress(cls, *arguments):
        subprocess.run([cls.REGRESS, *arguments, "--quiet"], check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def make_runs(cls):
        """Creates runs a and b of one recording under three names, with another tau in b; `other` is the same in
        both."""
        rawlogs = cls.FOLDER / "rawlogs"
        rawlogs.mkdir()
        for name in ("drive", "other", "strange"):
            shutil.copy(cls.RAWLOG, rawlogs / (name + ".rawlog"))
        manifest = cls.FOLDER / "manifest"
        cls.regress("manifest", rawlogs, "--output", manifest)
        common = ("--manifest", manifest, "--program", cls.REPLAY)
        cls.regress("run", *common, "--output", cls.FOLDER / "a")
        cls.regress("run", *common, "--output", cls.FOLDER / "b", "--set", "obstacles.tau_px=2")
        shutil.rmtree(cls.FOLDER / "b/done/other")
        shutil.copytree(cls.FOLDER / "a/done/other", cls.FOLDER / "b/done/other")
        cls.spoil(cls.FOLDER / "b/done/strange/result.json")
        cls.compare("a", "b", "compare.html")
        shutil.copytree(cls.FOLDER / "b", cls.FOLDER / "figures")
        for file in (cls.FOLDER / "figures/done").glob("*/*"):
            if file.name != "result.json":
                file.unlink()
        cls.compare("a", "figures", "figures.html")
        cls.compare("a", "a", "same.html")

    @staticmethod
    def spoil(file):
        """Writes texts with HTML syntax to a result; the page must show them as text."""
        result = json.loads(file.read_text())
        result["settings"] = f"[camera]\ncamera_label = {EVIL}\n"
        result["program"] = EVIL
        result["figures"][EVIL] = 1.0
        file.write_text(json.dumps(result))

    @classmethod
    def compare(cls, before, after, page):
        cls.regress("compare", cls.FOLDER / before, cls.FOLDER / after, "--output", cls.FOLDER / page)

    def setUp(self):
        self.open()

    def tearDown(self):
        self.assertEqual(self.browser.get_log("browser"), [], "messages on the console")

    def open(self, fragment="", page="compare.html"):
        self.browser.get("about:blank")
        self.browser.get("file://" + quote(str(self.FOLDER / page)) + fragment)
        self.until(lambda: self.run_script("return document.readyState") == "complete")
        self.until(lambda: self.run_script("return !document.querySelector('canvas[data-map]:not([data-complete])')"))

    def run_script(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def until(self, condition):
        return WebDriverWait(self.browser, WAIT_S).until(lambda _: condition())

    def chosen(self):
        chosen = self.run_script("return document.body.dataset.id")
        box = Select(self.browser.find_element(By.ID, "rawlog"))
        self.assertEqual(box.first_selected_option.get_attribute("value"), chosen)
        return chosen

    def text(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector).text

    def rows(self, selector):
        return len(self.browser.find_elements(By.CSS_SELECTOR, selector + " tbody tr"))

    # ---- what is shown

    def test_everything_is_drawn_and_nothing_is_fetched(self):
        expected = {"ways", "difference", "a", "b", "omega_radps", "v_mps", "obstacles", "confident", "inliers",
                    "strips_free", "strips_obstacle"}
        for fragment in ("#id=drive", "#id=other"):
            self.open(fragment)
            drawn = dict(self.run_script(DRAWN))
            self.assertEqual(set(drawn), expected)
            for name, points in drawn.items():
                self.assertGreater(points, 1000, name)
        fetched = self.run_script("return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([name for name in fetched if not name.startswith("data:")], [])

    def test_another_parameter_is_seen_at_a_glance(self):
        self.assertIn("2 changed", self.text("body > p"))
        self.assertIn("1.25 (default)", self.text(".runs"))
        glance = self.browser.find_element(By.CSS_SELECTOR, ".glance [data-id=drive]")
        self.assertIn("%", glance.text)
        self.assertNotIn("other", self.text(".glance"))
        self.assertIn("Without any change: other.", self.text("#glance"))
        thumb = self.browser.find_element(By.CSS_SELECTOR, ".thumbs [data-id=drive] img")
        self.assertTrue(thumb.get_attribute("src").startswith("data:image/png;"))

    def test_differences_are_drawn_where_there_are_any(self):
        self.open("#id=drive")
        self.assertGreater(self.run_script(COLOURED, "canvas[data-map=difference]"), 0)
        curves = self.browser.find_elements(By.CSS_SELECTOR, ".chart")
        self.assertEqual(curves[0].get_attribute("data-id"), "obstacles", "what differs comes first")
        self.assertEqual(len(curves[0].find_elements(By.CSS_SELECTOR, ".plot")), 2)
        self.assertIn("The same in both.", curves[1].text)
        self.open("#id=other")
        self.assertIn("Every figure is the same.", self.text("#choice"))
        self.assertIn("Both maps have the same occupied cells.", self.text("#drive"))
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, ".plot.low")), 0)

    def test_equal_runs_say_so(self):
        self.open(page="same.html")
        self.assertIn("every figure is the same", self.text("body > p"))
        self.assertEqual(self.text("#overview"), "")
        self.assertEqual(len(self.run_script(DRAWN)), 11)

    def test_runs_with_figures_only_say_so(self):
        self.open("#id=drive", "figures.html")
        self.assertIn("--keep figures", self.text("#drive"))
        self.assertEqual(self.rows(".glance"), 2)

    def test_strange_texts_are_only_texts(self):
        self.assertIsNone(self.run_script("return window.evil === undefined ? null : window.evil"))
        self.assertIn(EVIL, self.text(".runs"))
        self.assertIn(EVIL, self.text("#changes"))

    def test_fits_into_wide_and_narrow_windows(self):
        try:
            for width in (1280, 800):
                self.browser.set_window_size(width, 900)
                self.until(lambda: self.run_script("return innerWidth") == width)
                self.assertLessEqual(self.run_script("return document.documentElement.scrollWidth"), width)
        finally:
            self.browser.set_window_size(1280, 1000)

    # ---- choosing

    def test_the_worst_is_shown_first_and_the_list_chooses(self):
        self.assertEqual(self.chosen(), "strange")
        Select(self.browser.find_element(By.ID, "rawlog")).select_by_value("other")
        self.assertEqual(self.chosen(), "other")
        self.assertTrue(self.browser.current_url.endswith("#id=other"))

    def test_a_click_into_the_table_of_the_glance_chooses(self):
        row = self.browser.find_element(By.CSS_SELECTOR, ".glance [data-id=drive]")
        row.find_element(By.TAG_NAME, "td").click()
        self.assertEqual(self.chosen(), "drive")
        self.assertEqual(row.get_attribute("class"), "chosen")
        self.browser.find_element(By.CSS_SELECTOR, ".thumbs [data-id=strange]").click()
        self.assertEqual(self.chosen(), "strange")

    def test_arrow_keys_go_through_the_rawlogs(self):
        body = self.browser.find_element(By.TAG_NAME, "body")
        for key, expected in ((Keys.ARROW_LEFT, "strange"), (Keys.ARROW_RIGHT, "drive"), (Keys.ARROW_RIGHT, "other"),
                              (Keys.ARROW_RIGHT, "other"), (Keys.ARROW_LEFT, "drive")):
            body.send_keys(key)
            self.assertEqual(self.chosen(), expected)

    def test_the_address_chooses(self):
        self.open("#id=other")
        self.assertEqual(self.chosen(), "other")
        self.run_script("location.hash = '#id=drive'")
        self.until(lambda: self.chosen() == "drive")
        self.open("#id=none")
        self.assertEqual(self.chosen(), "strange")

    def test_the_changes_can_be_those_of_one_rawlog(self):
        everything = self.rows(".changes")
        links = self.browser.find_elements(By.CSS_SELECTOR, ".changes a")
        next(link for link in links if link.text == "drive").click()
        self.assertLess(self.rows(".changes"), everything)
        self.assertIn("Every change of drive", self.text("#changes"))
        self.assertEqual(self.chosen(), "drive")
        self.browser.find_element(By.XPATH, "//button[text()='All rawlogs']").click()
        self.assertEqual(self.rows(".changes"), everything)


if __name__ == "__main__":
    arguments = [sys.argv.pop(1) for _ in range(6)]
    ComparePage.REGRESS, ComparePage.REPLAY, ComparePage.RAWLOG = arguments[0:3]
    ComparePage.FOLDER = Path(arguments[3])
    ComparePage.CHROMIUM, ComparePage.CHROMEDRIVER = arguments[4:6]
    unittest.main()
