"""Bring the console's catalogues up to date: the texts of the sources into the .po files, and these into .mo files.

A text that is new has an empty translation, which `tests/console/test_languages.py` reports; fill it in, then run this
again. Translations of texts that are gone are dropped.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from datetime import UTC, datetime
from io import BytesIO
from pathlib import Path
from typing import Final

from babel.messages.catalog import Catalog
from babel.messages.extract import extract_from_dir
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

from jauspy.console.languages import ENGLISH, LANGUAGES

ROOT: Final = Path(__file__).resolve().parents[1]
CONSOLE: Final = ROOT / "src" / "jauspy" / "console"
LOCALE: Final = CONSOLE / "locale"
DOMAINS: Final = {"console": ("**.py", "python"), "browser": ("**.js", "javascript")}
"""The catalogues: which files their texts are in, and what reads these."""
KEYWORDS: Final[dict[str, None]] = {"_": None, "sentence": None}
"""Functions whose first argument is a text."""
WIDTH: Final = 120
DATE: Final = datetime(2026, 11, 27, tzinfo=UTC)
"""The date in the headers, so that files change with their texts only."""


def sources(domain: str) -> dict[str, set[str]]:
    """The texts of a catalogue, with the files that they are in."""
    pattern, reader = DOMAINS[domain]
    found: dict[str, set[str]] = {}
    rows = extract_from_dir(
        CONSOLE, method_map=[(pattern, reader)], options_map={pattern: {"encoding": "utf-8"}}, keywords=dict(KEYWORDS)
    )
    for name, _, text, *_ in rows:
        assert isinstance(text, str)
        found.setdefault(text, set()).add(name)
    return found


def catalogue(language: str, domain: str) -> Catalog:
    """The present texts with the translations that the .po file has."""
    path = LOCALE / language / "LC_MESSAGES" / f"{domain}.po"
    known = read_po(BytesIO(path.read_bytes()), locale=language) if path.exists() else Catalog(locale=language)
    new = Catalog(
        locale=language,
        header_comment=f"# The console of jauspy in {LANGUAGES[language]}; see tools/translate.py.",
        project="jauspy console",
        version="1",
        last_translator="the authors of jauspy",
        language_team="the authors of jauspy",
        msgid_bugs_address="see CONTRIBUTING.md",
        creation_date=DATE,
        revision_date=DATE,
        fuzzy=False,
    )
    for text, names in sorted(sources(domain).items()):
        before = known.get(text)
        new.add(text, before.string if before is not None else "", [(name, 0) for name in sorted(names)])
    return new


def files(language: str, domain: str) -> Iterator[tuple[Path, bytes]]:
    """The .po and the .mo file of a catalogue, with their contents."""
    folder, texts = LOCALE / language / "LC_MESSAGES", catalogue(language, domain)
    source, compiled = BytesIO(), BytesIO()
    write_po(source, texts, width=WIDTH, omit_header=False, include_lineno=False)
    yield folder / f"{domain}.po", source.getvalue()
    write_mo(compiled, texts)
    yield folder / f"{domain}.mo", compiled.getvalue()


def main() -> None:
    """Write all catalogues."""
    missing = 0
    for language in LANGUAGES.keys() - {ENGLISH}:
        for domain in DOMAINS:
            for path, content in files(language, domain):
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
            missing += sum(1 for message in catalogue(language, domain) if message.id and not message.string)
    if missing:
        sys.exit(f"translate: {missing} texts have no translation yet; they are empty in {LOCALE.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
