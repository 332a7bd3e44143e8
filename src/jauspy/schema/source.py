"""One JSIDL file: bytes to an XML tree that is safe to walk and follows the grammar.

Document type declarations are refused, so nothing in a file can be expanded or fetched.
"""

from __future__ import annotations

import re
from pathlib import Path

from lxml import etree
from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.grammar import check
from jauspy.schema.reading import wrong

NAMESPACES = {"urn:jaus:jsidl:1.0": "1.0", "urn:jaus:jsidl:1.1": "1.1"}
MAX_FILE_SIZE = 4 * 1024 * 1024
"""Bytes; the largest public definition has less than a tenth of it."""

ROOTS = ("service_def", "declared_type_set", "declared_const_set")

_DOCTYPE = re.compile(rb"<!(DOCTYPE|ENTITY)")


def read(path: Path) -> tuple[Element, str]:
    """The root element of a file that follows the grammar, and its JSIDL version; tags have lost their namespace."""
    root, version = parse(path)
    check(root)
    return root, version


def parse(path: Path) -> tuple[Element, str]:
    """As `read`, but what is below the root may be against the grammar."""
    root = _parse(_bytes(path), path)
    if root.getroottree().docinfo.doctype:  # type: ignore[attr-defined]  # lxml-stubs lacks it
        raise wrong(root, "a document type declaration is not allowed")
    version = NAMESPACES.get(etree.QName(root).namespace or "")
    if version is None:
        raise wrong(root, f"expected a JSIDL document (xmlns {' or '.join(NAMESPACES)}), got <{root.tag}>")
    _strip_namespaces(root)
    if root.tag not in ROOTS:
        raise wrong(root, f"expected {' or '.join(f'<{tag}>' for tag in ROOTS)} as the root, got <{root.tag}>")
    return root, version


def is_jsidl(path: Path) -> bool:
    """False for well-formed XML of another kind, such as a package manifest; what cannot be read counts as JSIDL."""
    try:
        root = _parse(_bytes(path), path)
    except SchemaError:
        return True
    name = etree.QName(root)
    return name.namespace in NAMESPACES or name.localname in ROOTS


def _bytes(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            data = file.read(MAX_FILE_SIZE + 1)
    except OSError as error:
        raise SchemaError(f"cannot be read: {error.strerror}", file=path) from error
    if len(data) > MAX_FILE_SIZE:
        raise SchemaError(f"larger than {MAX_FILE_SIZE} bytes", file=path)
    _refuse_doctype(data, path)
    return data


def _refuse_doctype(data: bytes, path: Path) -> None:
    """Before parsing, because libxml2 expands entities in attributes while it reads; without NULs for UTF-16."""
    plain = data.replace(b"\0", b"")
    found = _DOCTYPE.search(plain)
    if found:
        line = plain.count(b"\n", 0, found.start()) + 1
        raise SchemaError("a document type declaration is not allowed", file=path, line=line)


def _parse(data: bytes, path: Path) -> Element:
    parser = etree.XMLParser(
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        dtd_validation=False,
        huge_tree=False,
        remove_comments=True,
        remove_pis=True,
    )
    try:
        return etree.fromstring(data, parser, base_url=str(path))
    except etree.XMLSyntaxError as error:
        raise SchemaError(f"not well-formed XML: {error.msg}", file=path, line=error.lineno) from error


def _strip_namespaces(root: Element) -> None:
    """`{urn:jaus:jsidl:1.1}record` becomes `record`; both versions may be mixed, as public files do."""
    for element in root.iter():
        namespace, _, name = str(element.tag).rpartition("}")
        if namespace[1:] not in NAMESPACES:
            raise wrong(element, f"unknown element <{element.tag}>; it is in no JSIDL namespace")
        element.tag = name
