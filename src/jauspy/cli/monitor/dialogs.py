"""Screens above the main one: a text to read, a line to type, a field to choose."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import ClassVar

from rich.text import Text
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical, VerticalScroll
from textual.screen import ModalScreen
from textual.suggester import SuggestFromList
from textual.widgets import Input, OptionList, Static
from textual.widgets.option_list import Option


class TextDialog(ModalScreen[None]):
    """A text that is scrolled, until a key closes it."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,enter,q", "dismiss", "Close")]

    def __init__(self, title: str, text: Text) -> None:
        super().__init__()
        self._title, self._text = title, text

    def compose(self) -> ComposeResult:
        """The text in a frame."""
        with VerticalScroll(classes="dialog large") as frame:
            frame.border_title = Text(self._title)
            frame.border_subtitle = Text("Esc closes")
            yield Static(self._text, markup=False)


class LineDialog(ModalScreen[None]):
    """A line of text. `done` returns what is wrong with it, or what to show; the dialog closes if it returns None."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "dismiss", "Cancel")]

    def __init__(
        self,
        title: str,
        value: str,
        hint: str,
        done: Callable[[str], Awaitable[Text | None]],
        suggestions: list[str] | None = None,
    ) -> None:
        super().__init__()
        self._title, self._value, self._hint, self._done = title, value, hint, done
        self._suggestions = suggestions or []

    def compose(self) -> ComposeResult:
        """The line, and below it a hint or an answer."""
        with Vertical(classes="dialog") as frame:
            frame.border_title = Text(self._title)
            frame.border_subtitle = Text(
                "Enter sends, Esc closes" if self._suggestions else "Enter applies, Esc closes"
            )
            suggester = SuggestFromList(self._suggestions, case_sensitive=False) if self._suggestions else None
            yield Input(self._value, suggester=suggester, select_on_focus=False)
            with VerticalScroll(classes="answer"):
                yield Static(Text(self._hint, style="dim"), id="answer", markup=False)

    async def on_input_submitted(self, event: Input.Submitted) -> None:
        """Try the line, while keys and the screen go on."""
        self.run_worker(self._try(event.value), exclusive=True)

    async def _try(self, value: str) -> None:
        shown = await self._done(value)
        if shown is None:
            self.dismiss()
        else:
            self.query_one("#answer", Static).update(shown)


class ChoiceDialog(ModalScreen[int | None]):
    """A list of which one is chosen; its number, or None."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape", "cancel", "Cancel")]

    def __init__(self, title: str, choices: list[str]) -> None:
        super().__init__()
        self._title, self._choices = title, choices

    def compose(self) -> ComposeResult:
        """The list in a frame."""
        with Vertical(classes="dialog") as frame:
            frame.border_title = Text(self._title)
            frame.border_subtitle = Text("Enter chooses, Esc closes")
            yield OptionList(*[Option(Text(choice)) for choice in self._choices], markup=False)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Close with what was chosen."""
        self.dismiss(event.option_index)

    def action_cancel(self) -> None:
        """Close without a choice."""
        self.dismiss(None)
