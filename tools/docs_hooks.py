"""MkDocs hooks: generated pages, the list of decision records, and links to files of the repository."""

from __future__ import annotations

import posixpath
import re
from pathlib import Path
from typing import Any, Final

from mkdocs.structure.files import File, Files

from jauspy.cli.main import GROUPS, load_verb

ROOT: Final = Path(__file__).parents[1]
PAGES: Final = {
    "architecture.md": "ARCHITECTURE.md",
    "changelog.md": "CHANGELOG.md",
    "contributing.md": "CONTRIBUTING.md",
}
"""Pages of the site and the files of the repository that they show."""

_LINK: Final = re.compile(r"\]\((?!https?:|#)([^)\s]+)\)")


def on_config(config: Any) -> Any:
    """List the decision records in the navigation, in the order of their numbers."""
    for tab in config.nav:
        for entries in tab.values():
            for entry in entries if isinstance(entries, list) else ():
                if entry.get("Decisions") == "adr/":
                    entry["Decisions"] = ["adr/README.md", *sorted(f"adr/{path.name}" for path in _records())]
    return config


def on_files(files: Files, config: Any) -> Files:
    """Add the pages that show files of the repository, and the reference of the command line."""
    for page, source in PAGES.items():
        files.append(File.generated(config, page, content=(ROOT / source).read_text(encoding="utf-8")))
    files.append(File.generated(config, "reference/cli.md", content=_command_line()))
    return files


def on_page_markdown(markdown: str, page: Any, config: Any, files: Files) -> str:
    """Point links at pages of the site where there is one, else at the repository."""
    source = PAGES.get(page.file.src_uri, f"docs/{page.file.src_uri}")
    by_source = {shown: page_uri for page_uri, shown in PAGES.items()}

    def target(match: re.Match[str]) -> str:
        path, anchor, fragment = match[1].partition("#")
        repository_path = posixpath.normpath(posixpath.join(posixpath.dirname(source), path))
        uri = by_source.get(repository_path, repository_path.removeprefix("docs/"))
        if files.get_file_from_path(uri) and (repository_path.startswith("docs/") or uri in PAGES):
            shown = posixpath.relpath(uri, posixpath.dirname(page.file.src_uri) or ".")
        else:
            if not (ROOT / repository_path).exists():
                return match[0]  # MkDocs reports it
            shown = f"{config.repo_url}/blob/main/{repository_path}"
        return f"]({shown}{anchor}{fragment})"

    return _LINK.sub(target, markdown)


def _records() -> list[Path]:
    return list((ROOT / "docs" / "adr").glob("[0-9]*.md"))


def _command_line() -> str:
    """The help of every verb as Markdown."""
    parts = ["# Command line"]
    for group, verbs in GROUPS.items():
        for name, (target, _) in verbs.items():
            verb = load_verb(name, target)
            prefix = "jauspy" if group == "jauspy" else f"jauspy {group}"
            text = re.sub(r"(?m)^  (?=\S)", "    ", _escaped(verb.help))
            text = re.sub(r"(?m)^(Examples?:)\n", r"\1\n\n", text)
            rows = [
                f"| `{_shown(each)}` | {_escaped(each.help or '')}{_default(each)} |"
                for each in verb.params
                if not getattr(each, "hidden", False) and each.name != "help"
            ]
            parts += [f"## {prefix} {name}", text, "\n".join(["| parameter | meaning |", "|---|---|", *rows])]
    return "\n\n".join(parts) + "\n"


def _escaped(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;")


def _shown(parameter: Any) -> str:
    """`--port, -p` of an option, `FILE` of an argument."""
    if parameter.param_type_name == "argument":
        return str(parameter.metavar or parameter.name.upper()).replace("|", "\\|")
    names = "/".join([", ".join(parameter.opts), *parameter.secondary_opts])
    return f"{names} {parameter.metavar or ''}".strip().replace("|", "\\|")


def _default(parameter: Any) -> str:
    default = parameter.default
    if default in (None, False, ()) or callable(default) or parameter.required or isinstance(default, bool):
        return ""
    return f" [default: {getattr(default, 'value', default)}]"
