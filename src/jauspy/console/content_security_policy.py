"""The Content-Security-Policy of the console: what a page may load, run and reach, should text become markup after all.

NiceGUI writes scripts into its page, so each answer has a nonce of its own, which its template gives to every script.
Code in attributes and from other origins never runs. NiceGUI and Vue compile code at run time ('unsafe-eval'); which
code that may be is decided by `static/trusted.js`, in browsers that know Trusted Types.
"""

from __future__ import annotations

import secrets
from typing import Any, Final

from jinja2.ext import Extension
from nicegui import client
from starlette.types import ASGIApp, Receive, Scope, Send

NONCE: Final = "jauspy.nonce"
"""Where the ASGI scope of a request has the nonce of its answer."""
_POLICY: Final = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self' 'nonce-{nonce}' 'unsafe-eval'",
        "script-src-attr 'none'",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "font-src 'self'",
        "media-src 'self'",
        "connect-src 'self' data: blob:",
        "base-uri 'none'",
        "form-action 'self'",
        "frame-ancestors 'none'",
        "object-src 'none'",
        "require-trusted-types-for 'script'",
        "trusted-types default vue dompurify",
    )
)
"""`data:` and `blob:` are pictures and buffers inside mesh files and the page's own downloads, never other hosts."""


class ContentSecurityPolicy:
    """ASGI middleware that sends the policy with each answer of `app`."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        client.templates.env.add_extension(_Nonces)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection, as ASGI defines."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        nonce = secrets.token_urlsafe(16)
        header = (b"content-security-policy", _POLICY.format(nonce=nonce).encode())

        async def with_policy(message: Any) -> None:
            if message["type"] == "http.response.start":
                message = {**message, "headers": [*message.get("headers", ()), header]}
            await send(message)

        await self._app({**scope, NONCE: nonce}, receive, with_policy)


class _Nonces(Extension):
    """Gives the scripts of NiceGUI's template the nonce. It changes the template and never what is put into it."""

    def preprocess(self, source: str, name: str | None, filename: str | None = None) -> str:  # noqa: ARG002
        """Add the attribute to each script element of the template."""
        return source.replace("<script", f'<script nonce="{{{{ request.scope["{NONCE}"] }}}}"')
