"""The console's languages: what a browser gets, complete catalogues, and texts of robots that stay texts."""

from __future__ import annotations

import ast
import gettext
import re
from collections.abc import Iterator
from string import Formatter
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given, strategies as st
from tools.translate import DOMAINS, LOCALE, catalogue, sources

from jauspy.console.languages import ENGLISH, LANGUAGES, browser_texts, joined, language_of, sentence, translated
from jauspy.console.page_language import _
from jauspy.errors import ConfigError
from jauspy.printable import printable

OTHERS = sorted(LANGUAGES.keys() - {ENGLISH})
SAME = re.compile(r"\{[^{}]*\}")
"""A placeholder with its format, as `{speed:.2f}`."""


@pytest.mark.slow
@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("language", OTHERS)
def test_each_text_of_the_sources_has_a_translation_with_the_same_placeholders(language: str, domain: str) -> None:
    texts = {str(message.id): str(message.string) for message in catalogue(language, domain) if message.id}
    assert texts.keys() == sources(domain).keys()
    assert [text for text, translation in texts.items() if not translation] == [], "run tools/translate.py, fill in"
    wrong = {text: there for text, there in texts.items() if sorted(SAME.findall(text)) != sorted(SAME.findall(there))}
    assert wrong == {}
    assert all(text[0].isspace() == translation[0].isspace() for text, translation in texts.items())


@pytest.mark.slow
@pytest.mark.parametrize("domain", DOMAINS)
@pytest.mark.parametrize("language", OTHERS)
def test_the_compiled_catalogue_is_that_of_the_source(language: str, domain: str) -> None:
    with (LOCALE / language / "LC_MESSAGES" / f"{domain}.mo").open("rb") as file:
        compiled = gettext.GNUTranslations(file)
    for message in catalogue(language, domain):
        if message.id:
            assert compiled.gettext(str(message.id)) == message.string, "run tools/translate.py"


def calls() -> Iterator[tuple[str, ast.Call]]:
    """The calls of the console that mark a text."""
    for path in sorted(LOCALE.parent.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("_", "sentence"):
                yield f"{path.name}:{node.lineno}", node


@pytest.mark.slow
def test_each_marked_text_is_a_literal_whose_placeholders_are_given() -> None:
    wrong = []
    for place, call in calls():
        text = call.args[0]
        if not isinstance(text, ast.Constant) or len(call.args) != 1:
            wrong.append(f"{place}: not one literal")
        elif all(keyword.arg for keyword in call.keywords):  # others are checked where they are used
            names = {name for _text, name, _spec, _conversion in Formatter().parse(text.value) if name is not None}
            given = {keyword.arg for keyword in call.keywords}
            if names != given and (given or "{" in text.value):
                wrong.append(f"{place}: {sorted(names)} are not {sorted(map(str, given))}")
    assert wrong == []


@pytest.mark.slow
def test_placeholders_are_plain_names() -> None:
    """Neither attributes nor items of values can be reached from a catalogue."""
    for language in OTHERS:
        for domain in DOMAINS:
            for message in catalogue(language, domain):
                for _text, name, spec, _conversion in Formatter().parse(str(message.string)):
                    assert name is None or name.isidentifier(), message.string
                    assert "{" not in (spec or "")


def test_the_language_is_the_chosen_one_or_the_best_that_the_browser_accepts() -> None:
    assert language_of(None, None) == "en"
    assert language_of(None, "de-CH,de;q=0.9,en;q=0.8") == "de"
    assert language_of(None, "en;q=0.2, fr-FR;q=0.9") == "fr"
    assert language_of(None, "es,it;q=0.9,fr;q=0.1") == "fr"
    assert language_of(None, "de;q=0, en;q=0.5") == "en"
    assert language_of("fr", "de") == "fr"
    assert language_of("../../etc", "de") == "de"


@given(st.text(max_size=200) | st.none(), st.text(max_size=2000) | st.none())
def test_whatever_a_browser_sends_is_a_language(cookie: str | None, accepted: str | None) -> None:
    assert language_of(cookie, accepted) in LANGUAGES


@pytest.mark.parametrize("accepted", ["de;q=nan", "de;q=1e999", "de;q=", "de;q=-1", "de;=1", ";;;,,,", "de" * 9000])
def test_weights_that_are_not_valid_count_as_not_sent(accepted: str) -> None:
    assert language_of(None, accepted) == "en"


def test_a_sentence_is_english_everywhere_and_translated_on_a_page() -> None:
    text = sentence("robot {subsystem} has gone", subsystem=101)
    assert text == "robot 101 has gone"
    assert translated(text, "de") == "Roboter 101 ist fort"
    assert translated(text, "fr") == "le robot 101 a disparu"
    assert translated(text, "en") == text
    assert translated("some text of a robot", "de") == "some text of a robot"


def test_sentences_within_sentences_are_translated_too() -> None:
    inner = sentence("the robot has gone")
    error = ConfigError(inner)
    whole = sentence("{what} was stopped: {why}", what=sentence("the motion"), why=error)
    assert whole == "the motion was stopped: the robot has gone"
    assert translated(whole, "de") == "die Bewegung wurde gestoppt: der Roboter ist fort"
    assert translated(printable(str(error)), "fr") == "le robot a disparu"
    assert translated(joined([inner, "E 17"]), "de") == "der Roboter ist fort; E 17"


HOSTILE = ("{0}", "{name}", "{name.__class__}", "{", "}", "%s", "{" * 50, "${alert(1)}", "<b>{x}</b>", "\\{")


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", HOSTILE)
def test_a_name_is_never_a_template(language: str, name: str) -> None:
    text = sentence("robot {id} {name} has appeared", id=7, name=name)
    assert name in translated(text, language)
    assert name in translated(sentence("{what} was stopped: {why}", what=text, why=joined([name, text])), language)


def test_values_are_numbers_or_text_and_keep_no_object_alive() -> None:
    error: Any = SimpleNamespace(frame=object())
    assert all(isinstance(value, str | int) for value in sentence("{a} {b}", a=error, b=3).values.values())


def test_outside_of_pages_texts_are_english() -> None:
    assert _("take control first") == "take control first"
    assert _("limit {speed}", speed="1 m/s") == "limit 1 m/s"


@pytest.mark.parametrize("language", OTHERS)
def test_the_page_gets_the_texts_of_its_scripts(language: str) -> None:
    texts = browser_texts(language)
    assert texts.keys() == sources("browser").keys()
    assert browser_texts(ENGLISH) == {}


def test_no_text_is_marked_where_it_is_not_found() -> None:
    """Babel does not look into f-strings: a text there would never be translated."""
    found = [
        f"{path.name}: {line}"
        for path in LOCALE.parent.rglob("*.py")
        for line in path.read_text().splitlines()
        if re.search(r"""f(["']).*\{(_|sentence)\(["'].*\1""", line)
    ]
    assert found == []
