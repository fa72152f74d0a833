"""A headless Chromium that opens pages from disk, and what tests ask of any page that should need nothing but itself."""

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

CHROMIUM, DRIVER = "/usr/bin/chromium", "/usr/bin/chromedriver"  # Debian's chromium and chromium-driver


def start(width=1280, height=1000):
    options = Options()
    options.binary_location = CHROMIUM
    # No sandbox: tests may run as root. /dev/shm is small in containers.
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", f"--window-size={width},{height}"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


def open_page(driver, path):
    """Opens a file and returns what the console said of it."""
    driver.get_log("browser")  # of pages before
    driver.get(path.resolve().as_uri())
    return driver.get_log("browser")


def pictures(driver):
    """(alt, natural width, complete) of each picture."""
    return driver.execute_script("return [...document.images].map((i) => [i.alt, i.naturalWidth, i.complete])")


def fetched(driver):
    """Addresses of what the page asked for beside itself."""
    return driver.execute_script("return performance.getEntriesByType('resource').map((r) => r.name).filter((n) => !n.startsWith('data:'))")


def overflow(driver, width):
    """Pixels by which the page is wider than a window of this width."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": 800, "deviceScaleFactor": 1, "mobile": False})
    try:
        return driver.execute_script("return document.documentElement.scrollWidth - window.innerWidth")
    finally:
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
