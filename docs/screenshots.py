"""Makes the pictures in docs/images: python docs/screenshots.py. Needs playwright and Chromium, as the tests of the report do."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

from rosarch.cli.main import main

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
GRAPH = ("patrol_robot", "graph", ".stage[aria-busy=false] svg.graph .box", (1280, 420))
MACHINE = ("docking_states", "component/auto_docking/docking", "svg.machine", (1000, 940))
SCENES = {"graph": GRAPH, "machine": MACHINE}
THEMES = ("light", "dark")


def take(browser: Browser, folder: Path, name: str, theme: str) -> None:
    """One picture: the whole window, or what is below the place that is linked to."""
    example, where, ready, (width, height) = SCENES[name]
    page = browser.new_page(viewport={"width": width, "height": height}, color_scheme=theme, device_scale_factor=1.25)  # type: ignore[arg-type]
    page.goto(f"{(folder / f'{example}.html').as_uri()}#/{where}")
    page.wait_for_selector(ready)
    if name == "machine":
        page.evaluate("document.querySelector('#machines').scrollIntoView()")
    page.wait_for_timeout(300)
    page.screenshot(path=IMAGES / f"{name}-{theme}.png")
    page.close()


def run() -> None:
    """All pictures, in both themes."""
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    with tempfile.TemporaryDirectory() as name, sync_playwright() as playwright:
        folder = Path(name)
        for example in {scene[0] for scene in SCENES.values()}:
            if main(["report", str(ROOT / "examples" / example), "-o", str(folder / f"{example}.html")]):
                raise SystemExit(f"no report on {example}")
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        for scene in SCENES:
            for theme in THEMES:
                take(browser, folder, scene, theme)
        browser.close()


if __name__ == "__main__":
    run()
