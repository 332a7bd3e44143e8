"""The token of the console in a real browser, and pages of other sites that embed or request the console."""

from __future__ import annotations

import http.server
import threading
import webbrowser
from collections.abc import Iterator
from contextlib import contextmanager
from urllib.parse import urlsplit

import pytest
from tests.helpers.browser import BROWSER_MARKS, SIZE, WAIT, chromium, console_for, new_page, sync_api
from tests.helpers.command_line import shared_robot

from jauspy.cli import operator_console

pytestmark = BROWSER_MARKS
FRAMES = 70


@contextmanager
def other_site(text: str) -> Iterator[str]:
    """A page at another port of this machine."""

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("content-type", "text/html")
            self.end_headers()
            self.wfile.write(text.encode())

        def log_message(self, *_: object) -> None:
            """Print nothing."""

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    try:
        yield f"http://localhost:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


def test_the_token_opens_the_console_and_other_sites_do_not(monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    with shared_robot(few_pictures=True) as robot, console_for(robot.local) as (url, _), chromium() as browser:
        base = url.partition("?")[0]
        stranger = new_page(browser)
        stranger.goto(base)
        stranger.get_by_text("opens only at the address with its token").wait_for()

        context = browser.new_context(viewport=SIZE)
        context.set_default_timeout(WAIT)
        page = context.new_page()
        with operator_console._browser_at(url):
            page.goto(opened[0])
            page.get_by_text("101 inc1").first.wait_for()
        assert page.url == base
        assert urlsplit(url).query not in page.evaluate("JSON.stringify(performance.getEntries())")
        page.reload()
        page.get_by_text("101 inc1").first.wait_for()

        frames = "".join(f'<iframe src="{base}?{number}"></iframe>' for number in range(FRAMES))
        for other in (f"{frames}<p>end", f'<a href="{url}">operate</a>'):
            with other_site(other) as site:
                hostile = context.new_page()
                hostile.goto(site)
                if "operate" in other:
                    hostile.get_by_text("operate").click()
                    hostile.get_by_text("101 inc1").first.wait_for()
                else:
                    with pytest.raises(sync_api.Error):
                        hostile.evaluate(f"fetch('{base}', {{credentials: 'include'}})")
                    assert not any(frame.get_by_text("jauspy").count() for frame in hostile.frames)
                hostile.close()
        page.reload()
        page.get_by_text("101 inc1").first.wait_for()
