"""Visits a console without a browser: exchanges the token of its address for a cookie, as a browser does."""

from __future__ import annotations

import http.client
import urllib.request
from typing import NamedTuple
from urllib.parse import urlsplit


class Visit(NamedTuple):
    """A session at a console without a login."""

    url: str
    """The address without the token."""
    headers: dict[str, str]
    """The cookie."""

    @property
    def sockets(self) -> str:
        """The address of WebSockets."""
        return self.url.replace("http", "ws", 1)

    def get(self, path: str = "/") -> str:
        """The text at a path; raises `HTTPError`."""
        with urllib.request.urlopen(urllib.request.Request(self.url + path, headers=self.headers)) as answer:
            text: str = answer.read().decode()
            return text


def visit(url: str) -> Visit:
    """Begin a session with the URL that the console prints."""
    parts = urlsplit(url)
    connection = http.client.HTTPConnection(parts.netloc)
    connection.request("GET", f"/?{parts.query}")
    cookie = connection.getresponse().headers["set-cookie"]
    connection.close()
    return Visit(f"http://{parts.netloc}", {"cookie": cookie.partition(";")[0]})
