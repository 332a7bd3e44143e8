"""The console in German and French, in a real browser: no English text is left, and each page has its own language."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, chromium, console_for, new_page, page_at
from tests.helpers.command_line import shared_robot
from tools.translate import DOMAINS, catalogue

pytestmark = BROWSER_MARKS
TAKE = {"en": "take", "de": "übernehmen", "fr": "prendre"}
STOP = {"en": "STOP ALL", "de": "ALLE STOPP", "fr": "ARRÊT TOTAL"}
VIEWS = ("Video", "World", "Trajectory", "Tasks", "Plots", "Log", "Recordings")
TEXTS = """() => {
    const found = new Set();
    for (const each of document.querySelectorAll('body *')) {
        if (!each.checkVisibility() || each.closest('.lines, .traffic, code, script, style')) continue;
        for (const name of ['aria-label', 'title', 'placeholder']) found.add(each.getAttribute(name)?.trim() ?? '');
        for (const node of each.childNodes) if (node.nodeType === 3) found.add(node.textContent.trim());
    }
    return [...found];
}"""
"""The texts and names that a page shows, without the lines of events and messages, which have texts of robots."""
OF_ROBOTS = re.compile(
    r"[\d\W_]*"  # numbers and signs
    r"|[a-zA-Z]{1,2}[+\u2212\u2191\u2193 ]*"  # axes, units
    r"|(?:\u21e7)?[A-Z]|Esc|F8|rad|\W*(?:ready|standby|emergency|failure)\b.*"  # keys, states
    r"|.*\b(?:\d+\.\d+|101|inc1|jauspy|JAUS|REP-103|CM-[A-Z]+|WebGL|CSV|Hz|Lidar|arm_link\w*|\w+_\w+)\b.*"
    r"|.*\b(?:\d+ (?:m|N|ms|mm|s|mm/s|%|V|W|kB|MB|/s)|\d+/s|\d+°/s)\b.*|English|Deutsch|Français"
)
"""Texts that are the same in all languages: names, ids, states, numbers with units."""
OF_INC1 = {"arm", "chassis", "drive", "flippers", "gripper", "inspect", "m/s", "outside", "stow"}
"""Names of its parts and poses, and a unit."""


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with shared_robot(few_pictures=True) as robot, console_for(robot.local) as (address, _):
        yield address


def known(language: str) -> dict[str, str]:
    """The translations of a language, by the texts."""
    messages = (message for domain in DOMAINS for message in catalogue(language, domain) if message.id)
    return {str(message.id): str(message.string) for message in messages}


def shown(page: Any) -> set[str]:
    """What a page shows in all its views and in the views of the panel Arm."""
    page.get_by_text("101 inc1").first.wait_for()
    page.locator(".joints .joint").first.wait_for()
    found = set()
    for index in range(len(VIEWS)):
        page.get_by_role("tab").nth(index).click()
        page.locator(".tabs .chosen").first.wait_for()
        page.wait_for_timeout(700)
        found.update(page.evaluate(TEXTS))
    for index in (1, 2, 0):
        page.locator(".arm .q-btn-group").first.locator("button").nth(index).click()
        page.wait_for_timeout(500)
        found.update(page.evaluate(TEXTS))
    return found


@pytest.fixture(scope="module")
def english(url: str) -> set[str]:
    with page_at(url) as page:
        return shown(page)


@pytest.mark.parametrize("language", ["de", "fr"])
def test_no_english_text_is_left(url: str, english: set[str], language: str) -> None:
    translations = known(language)
    same = {text for text, translation in translations.items() if text == translation}
    with page_at(url, locale=f"{language}-{language.upper()}") as page:
        texts = shown(page)
        assert page.locator("html").get_attribute("lang") == language
        assert page.get_by_role("button", name=STOP[language]).is_visible()
        over = page.evaluate(
            "() => [...document.querySelectorAll('button, .heading')].filter((each) => each.checkVisibility()"
            " && each.scrollWidth > each.clientWidth + 1).map((each) => each.innerText)"
        )
    left = {text for text in texts & english if not OF_ROBOTS.fullmatch(text)} - same - OF_INC1
    assert sorted(left) == []
    english_ones = {text for text, translation in translations.items() if translation != text} - set(
        translations.values()
    )
    assert texts & english_ones <= OF_INC1
    assert over == [], "labels are longer than their buttons"


def test_each_page_has_its_language_which_the_browser_keeps(url: str) -> None:
    with chromium() as browser:
        german, french = new_page(browser, locale="de-DE"), new_page(browser, locale="fr-FR")
        for page, language in ((german, "de"), (french, "fr")):
            page.goto(url)
            page.get_by_role("button", name=TAKE[language], exact=True).wait_for()
        french.get_by_role("button", name=TAKE["fr"], exact=True).click()
        french.get_by_text("vous opérez ce robot").wait_for()
        german.locator(".lines").get_by_text("bedient Roboter 101").wait_for()
        french.locator(".lines").get_by_text("opère le robot 101").wait_for()
        german.keyboard.press("w")
        german.locator("#drive-answer").get_by_text("ein anderer Browser bedient diesen Roboter").wait_for()

        german.get_by_role("button", name="Achsen und Einheiten").click()
        german.get_by_role("button", name="English").click()
        german.get_by_role("button", name="take over", exact=True).wait_for()
        assert german.locator("html").get_attribute("lang") == "en-US"
        german.reload()
        german.get_by_role("button", name="take over", exact=True).wait_for()
        french.get_by_text("vous opérez ce robot").wait_for()


def test_what_a_browser_sends_as_language_is_data(url: str) -> None:
    hostile = 'de"><script>alert(1)</script>;q=1'
    with chromium() as browser:
        page = new_page(browser, extra_http_headers={"Accept-Language": hostile})
        page.context.add_cookies([{"name": "jauspy-language", "value": "../../fr", "url": url}])
        page.goto(url)
        page.get_by_role("button", name="take", exact=True).wait_for()
        assert page.locator("html").get_attribute("lang") == "en-US"


def test_german_fits_a_telephone_and_a_small_screen(url: str) -> None:
    with page_at(url, locale="de-DE", viewport={"width": 390, "height": 844}) as page:
        page.get_by_text("101 inc1").first.wait_for()
        for index in range(len(VIEWS)):
            page.get_by_role("tab").nth(index).click()
            page.wait_for_timeout(500)
            assert page.evaluate("document.documentElement.scrollWidth") <= 390, VIEWS[index]
        page.get_by_role("tab").nth(VIEWS.index("Log")).click()
        list_of, details = (page.locator(f".split > .{name}").bounding_box() for name in ("traffic", "details"))
        assert details["y"] >= list_of["y"] + list_of["height"], "one column"
        page.set_viewport_size({"width": 1024, "height": 768})
        page.locator(".heading", has_text="Kontrolle").click()
        page.keyboard.press("Digit4")
        page.locator(".desk.arranged").wait_for()
        right = page.locator(".pane[data-view='Video']").evaluate("(each) => each.getBoundingClientRect().right")
        for button in page.locator(".video-bar button:visible").all():
            box = button.bounding_box()
            assert box["x"] + box["width"] <= right + 1.0
