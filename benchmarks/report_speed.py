"""Measure how soon a reader of reports sees something: bytes of the page, first paint, contents, the graph laid out.

    benchmarks/report_speed.py PAGE... [--runs N] [--where ADDRESS]

PAGE is what `rosarch report` wrote, opened from disk in headless Chromium, in a new browser for each run. *first paint* is the browser's
own measure, *contents* when the report is there instead of a word to wait, *laid out* when the graph of the largest system (or that which
ADDRESS, such as `graph?by=none`, names) is drawn; all from the moment when the page is asked for, in seconds, of several runs the median.
Needs playwright and Chromium, as the tests of the report do. Prints a Markdown table.
"""

from __future__ import annotations

import argparse
import shutil
import statistics
import time
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

HEAD = "| report | size | first paint | contents | laid out | shown |\n|---|---|---|---|---|---|"
FIRST_PAINT = "performance.getEntriesByType('paint').find((entry) => entry.name === 'first-contentful-paint').startTime / 1000"
LAID_OUT = ".stage[aria-busy=false] svg.graph .box"


def opened(browser: Browser, address: str, ready: str) -> tuple[float, float, str]:
    """Seconds until the first paint and until something is there, and what the graph has, where it is one."""
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    start = time.perf_counter()
    page.goto(address, wait_until="commit")
    page.wait_for_selector(ready, timeout=120_000)
    seconds = time.perf_counter() - start
    page.wait_for_function("performance.getEntriesByType('paint').length > 1")
    shown = page.locator(".status").inner_text() if "/graph" in address else ""
    return page.evaluate(FIRST_PAINT), seconds, shown.split(";")[0]


def row(report: Path, where: str, runs: int) -> str:
    """The line of one report."""
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    address = report.resolve().as_uri()
    paints, contents, graphs, shown = [], [], [], ""
    with sync_playwright() as playwright:
        for _ in range(runs):
            for place, ready, found in (("", "main h1", contents), (where, LAID_OUT, graphs)):
                browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
                paint, seconds, shown = opened(browser, f"{address}#/{place}", ready)
                paints.append(paint)
                found.append(seconds)
                browser.close()
    figures = " | ".join(f"{statistics.median(values):.2f} s" for values in (paints, contents, graphs))
    return f"| {report.stem} | {report.stat().st_size / 2**20:.1f} MiB | {figures} | {shown} |"


def main() -> None:
    """The table."""
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("pages", nargs="+", type=Path, metavar="PAGE")
    arguments.add_argument("--runs", type=int, default=5)
    arguments.add_argument("--where", default="graph", metavar="ADDRESS")
    given = arguments.parse_args()
    print(HEAD)
    for page in given.pages:
        print(row(page, given.where, given.runs), flush=True)


if __name__ == "__main__":
    main()
