"""A headless Chromium that opens the explorer from disk, as a person would."""

import json
import os
import shutil
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "results" / "explorer" / "index.html"
PROGRAMS = "chromium", "chromedriver"
ABSENT = "Chromium is not installed; on Debian: apt-get install chromium chromium-driver"
ARGUMENTS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
    *("--hide-scrollbars", "--disable-dev-shm-usage"),
    "--host-resolver-rules=MAP * ~NOTFOUND",  # there is no network
)
WAIT = 40.0  # seconds, for a machine that is busy


@pytest.fixture(scope="session")
def page():
    """The page that the workflow has built."""
    if not PAGE.is_file():
        pytest.skip("results/explorer is absent: run `snakemake -c2` first")
    return PAGE


@pytest.fixture(scope="session")
def chromium(tmp_path_factory):
    """Chromium, started once; in continuous integration its absence is an error."""
    found = [shutil.which(program) for program in PROGRAMS]
    if None in found:
        if os.environ.get("CI"):
            pytest.fail(ABSENT)
        pytest.skip(ABSENT)
    from selenium import webdriver

    options = webdriver.ChromeOptions()
    options.binary_location = found[0]
    for argument in (*ARGUMENTS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options, webdriver.ChromeService(found[1]))
    driver.set_script_timeout(10 * WAIT)
    yield driver
    driver.quit()


class Explorer:
    """The open page, and what a person does with it."""

    def __init__(self, driver, page):
        self.driver, self.page = driver, page

    def open(self, fragment="", width=1280, height=900, scheme="light", media=""):
        """Open the page anew, in a window of this size."""
        command = self.driver.execute_cdp_cmd
        size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        command("Emulation.setDeviceMetricsOverride", size)
        feature = {"name": "prefers-color-scheme", "value": scheme}
        command("Emulation.setEmulatedMedia", {"media": media, "features": [feature]})
        self.driver.get("about:blank")
        for log in ("browser", "performance"):
            self.driver.get_log(log)
        self.driver.get(f"{self.page.as_uri()}#{fragment}")
        self.settle()
        return self

    def settle(self):
        """Wait until all that was asked for is drawn."""
        self.wait(
            """return document.body.dataset.shown === location.hash.slice(1)
                && !document.querySelector('[aria-busy=true]');"""
        )

    def wait(self, script):
        """Wait until a script returns something true."""
        from selenium.webdriver.support.wait import WebDriverWait

        WebDriverWait(self.driver, WAIT, 0.05).until(lambda driver: driver.execute_script(script))

    def run(self, script, *arguments):
        """What a script returns."""
        return self.driver.execute_script(script, *arguments)

    def one(self, selector):
        """The first element that a selector names."""
        return self.driver.find_element("css selector", selector)

    def all(self, selector):
        """All elements that a selector names."""
        return self.driver.find_elements("css selector", selector)

    def choose(self, selector, value):
        """Choose an option of a list by its value."""
        from selenium.webdriver.support.select import Select

        Select(self.one(selector)).select_by_value(value)
        self.settle()

    def enter(self, selector, text):
        """Write a number into a field and leave it."""
        from selenium.webdriver.common.keys import Keys

        field = self.one(selector)
        field.send_keys(Keys.CONTROL, "a")
        field.send_keys(text, Keys.TAB)
        self.settle()

    def press(self, *keys):
        """Press keys, one after the other, wherever the focus is."""
        from selenium.webdriver import ActionChains

        ActionChains(self.driver).send_keys(*keys).perform()

    def curve(self, label, panel=0):
        """The drawn path of a curve, by its label."""
        script = """return document.querySelectorAll('#charts figure')[arguments[0]]
            .querySelector(`.line[data-label="${arguments[1]}"]`)?.getAttribute('d')"""
        return self.run(script, panel, label)

    def console(self):
        """What the console says since the page was opened."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self):
        """Addresses that were asked for since the page was opened."""
        entries = self.driver.get_log("performance")
        events = [json.loads(entry["message"])["message"] for entry in entries]
        sent = [event for event in events if event["method"] == "Network.requestWillBeSent"]
        return [event["params"]["request"]["url"] for event in sent]


@pytest.fixture(scope="session")
def explorer(chromium, page):
    """The page in Chromium; each test opens it as it needs it."""
    return Explorer(chromium, page)
