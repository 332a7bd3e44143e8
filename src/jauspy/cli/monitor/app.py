"""The full screen of `jauspy monitor`: a tree of components, their messages, and the fields of one."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from itertools import pairwise
from time import monotonic
from typing import ClassVar, Final

from rich.text import Text
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical, VerticalScroll
from textual.widgets import DataTable, Footer, Static, Tree
from textual.widgets.tree import TreeNode

from jauspy.capture.filters import Filter
from jauspy.cli.monitor import texts
from jauspy.cli.monitor.dialogs import ChoiceDialog, LineDialog, TextDialog
from jauspy.cli.monitor.sources import CaptureSource, LiveSource
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.observed import Observed, ObservedComponent, Stream
from jauspy.inspection.rates import Route
from jauspy.inspection.series import Series, numeric_fields
from jauspy.printable import printable

PERIOD: Final = 0.25
"""Seconds between two updates of the screen."""
MAX_ROWS: Final = 300
PLOT_SECONDS: Final = 60.0
"""Seconds that a plot of live values shows."""
STEP, LEAP = 1.0, 10.0
"""Seconds by which keys move in a capture."""
COLUMNS: Final = {"message": 0, "peer": 0, "count": 5, "/s": 5, "age": 6, "bytes": 5, "last 20 s": 20}
"""Names and widths of columns; the first two share what is left."""
CELL_STYLES: Final = {"peer": texts.PURPLE, "last 20 s": texts.BAR, "age": texts.FAINT, "message": "bold"}
WIDE_COLUMNS: Final = frozenset({"bytes", "last 20 s"})
RIGHT_ALIGNED: Final = frozenset({"count", "/s", "age", "bytes"})
TREE_WIDTHS: Final = 26, 40
"""Widths of a narrow and a wide terminal, as in monitor.tcss; borders included."""
NARROW: Final = 100
"""Columns of the terminal below which the last two columns of the table are left out."""
PANELS: Final = "#head, #tree, #about, #messages, #fields, #fields-frame, #plot"
SORTINGS: Final = ("name", "rate", "count", "age")

KEYS: Final = (
    ("Tab, arrows", "tree, messages, fields; move within them"),
    ("Enter, o", "open the message: header, fields, bytes"),
    ("i", "all that is known about the component"),
    ("/", "filter: list only messages that fit; empty lists all"),
    ("p", "plot a field of the message; again to end it"),
    ("a", "ask: send a query to the component, as its client (live only)"),
    ("s", "sort by name, rate, count or age"),
    ("Space", "live: stand still or go on; capture: play or pause"),
    ("← →, Shift", "capture: a second back or on; with Shift ten"),
    ("Home, End", "capture: its beginning, its end"),
    ("+ -", "capture: play faster, more slowly"),
    ("q", "quit"),
)
"""What keys do."""

Ask = Callable[[JausID, str], Awaitable[Text]]
"""Sends the query that a line describes, and returns its answer or what is wrong."""


class MonitorApp(App[None]):
    """Shows what a source tells; it sends nothing but queries that the user types."""

    CSS_PATH = "monitor.tcss"
    TITLE = "jauspy monitor"
    ENABLE_COMMAND_PALETTE = False
    HORIZONTAL_BREAKPOINTS = [  # noqa: RUF012 - declared by App
        (0, "-narrow"),
        (NARROW, "-wide"),
    ]
    VERTICAL_BREAKPOINTS = [  # noqa: RUF012
        (0, "-short"),
        (32, "-tall"),
    ]
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("q", "quit", "Quit"),
        Binding("question_mark", "help", "Help", key_display="?"),
        Binding("slash", "filter", "Filter", key_display="/"),
        Binding("o", "open", "Open"),
        Binding("i", "about", "Info"),
        Binding("p", "plot", "Plot"),
        Binding("a", "ask", "Ask"),
        Binding("s", "sort", "Sort"),
        Binding("space", "pause", "Pause", priority=True, key_display="space"),
        Binding("left", "move(-1)", "Back", priority=True, show=False),
        Binding("right", "move(1)", "On", priority=True, show=False),
        Binding("shift+left", "leap(-1)", "Back 10 s", priority=True, show=False),
        Binding("shift+right", "leap(1)", "On 10 s", priority=True, show=False),
        Binding("home", "end(0)", "Begin", priority=True, show=False),
        Binding("end", "end(1)", "End", priority=True, show=False),
        Binding("plus", "speed(1)", "Faster", show=False),
        Binding("minus", "speed(-1)", "Slower", show=False),
    ]

    def __init__(
        self,
        source: LiveSource | CaptureSource,
        registry: Registry,
        title: str,
        ask: Ask | None,
        only: str | None = None,
    ) -> None:
        super().__init__()
        self.source = source
        self._known = registry
        self._what = title
        self._ask = ask
        self._filter = ""
        self._scope = ""
        self._route: Route | None = None
        self._sorting = SORTINGS[0]
        self._widths: list[int] = []
        self._rows: dict[str, tuple[Route, tuple[str, ...]]] = {}
        self._branches: dict[str, TreeNode[str]] = {}
        self._labels: dict[str, str] = {}
        self._before = monotonic()
        self._working = False
        if only is not None:
            self._set_filter(only)

    def compose(self) -> ComposeResult:
        """Head, tree and panels, slider of a capture, keys."""
        yield Static(id="head", markup=False)
        with Horizontal(id="main"):
            tree: Tree[str] = Tree("", id="tree")
            tree.show_root = False
            tree.guide_depth = 2
            tree.border_title = "components"
            yield tree
            with Vertical(id="right"):
                yield Static(id="about", markup=False)
                table: DataTable[Text] = DataTable(id="messages", cursor_type="row", zebra_stripes=True, cell_padding=0)
                table.border_title = "messages"
                yield table
                with Horizontal(id="detail"):
                    with VerticalScroll(id="fields-frame") as frame:
                        frame.border_title = "fields"
                        yield Static(id="fields", markup=False)
                    plot = Static(id="plot", markup=False)
                    plot.border_title = "plot"
                    yield plot
        if isinstance(self.source, CaptureSource):
            yield Static(id="slider", markup=False)
        yield Footer(show_command_palette=False)

    def on_mount(self) -> None:
        """Begin to update the screen."""
        self.theme = "tokyo-night"
        self.query_one("#plot").display = False
        self._make_columns()
        self.query_one(Tree).focus()
        self.set_interval(PERIOD, self.update_screen)
        self.call_after_refresh(self.update_screen)

    def on_resize(self) -> None:
        """Fit the table to the new width."""
        if self.query("#messages"):
            self._make_columns()
        self.call_after_refresh(self.update_screen)

    # --- updates ------------------------------------------------------------------------------------------------------

    @property
    def observed(self) -> Observed:
        """What is shown."""
        return self.source.observed

    def update_screen(self) -> None:
        """Take what is new, and show it."""
        now = monotonic()
        if isinstance(self.source, LiveSource):
            self.source.poll()
        else:
            self.source.advance(now - self._before)
            self._work(self.source)
        self._before = now
        if len(self.screen_stack) > 1:  # the dialog above is read
            return
        if len(self.query(PANELS)) < PANELS.count("#"):  # the screen is not made yet, or is being closed
            return
        self._show_head()
        self._show_tree()
        self._show_about()
        self._show_messages()
        self._show_detail()

    def _work(self, source: CaptureSource) -> None:
        """Decode in another thread, one piece of work at a time."""
        if not self._working and source.busy:
            self._working = True

            def work() -> None:
                try:
                    source.work()
                finally:
                    self._working = False

            self.run_worker(work, thread=True)

    def _show_head(self) -> None:
        source, observed = self.source, self.observed
        text = Text.assemble((" jauspy ", f"bold reverse {texts.BLUE}"), " ", (printable(self._what), "bold"))
        if isinstance(source, LiveSource) and source.frozen:
            text.append("  PAUSED", f"bold {texts.YELLOW}")
        text.append(f"  {texts.rate(observed.history.rate(source.now))}/s ")
        text.append(texts.bars(observed.history.counts(source.now)[-16:]), texts.BLUE)
        text.append(f"  {texts.amount(observed.count)} messages", texts.FAINT)
        for what, count in (
            ("lost", source.lost),
            ("malformed", observed.undecodable),
            ("beyond the limit", observed.beyond),
        ):
            if count:
                text.append(f"  {texts.amount(count)} {what}", texts.YELLOW)
        if self._filter:
            text.append(f"  / {printable(self._filter)}", texts.PURPLE)
        if source.problem:
            text.append(f"  {printable(source.problem)}", texts.RED)
        text.truncate(self.size.width, overflow="ellipsis")
        self.query_one("#head", Static).update(text)
        if isinstance(source, CaptureSource):
            timeline = source.timeline
            bar = texts.slider(
                timeline.start, timeline.end, source.position,
                playing=source.playing, speed=source.speed, width=self.size.width - 2,
            )  # fmt: skip
            self.query_one("#slider", Static).update(bar)

    def _show_tree(self) -> None:
        observed, tree = self.observed, self.query_one("#tree", Tree)
        for id in self.source.ids:
            if str(id) not in self._branches:
                self._insert(tree, id)
        for scope, node in self._branches.items():
            match scope.split("."):
                case [subsystem]:
                    self._label(node, texts.subsystem_label(int(subsystem), observed))
                case [subsystem, number]:
                    self._label(node, texts.node_label(int(subsystem), int(number), observed))
                case _:
                    id = JausID.parse(scope)
                    component = observed.components.get(id) or ObservedComponent(id)
                    self._label(node, texts.component_label(component, self.source.now))

    def _insert(self, tree: Tree[str], id: JausID) -> None:
        """Add a component to the tree, in the order of ids; what is chosen and folded stays so."""
        parent = tree.root
        parent.expand()
        for scope in (str(id.subsystem), f"{id.subsystem}.{id.node}", str(id)):
            if scope not in self._branches:
                number = int(scope.rpartition(".")[2])
                before = sum(int((node.data or "").rpartition(".")[2]) < number for node in parent.children)
                place = before if before < len(parent.children) else None
                is_leaf = scope == str(id)
                self._branches[scope] = parent.add(
                    Text(scope), data=scope, before=place, expand=not is_leaf, allow_expand=not is_leaf
                )
            parent = self._branches[scope]
        if not self._scope:
            self._scope = str(id)
            self.call_after_refresh(tree.move_cursor, parent)

    def _label(self, node: TreeNode[str], text: Text) -> None:
        """Set a label if it differs; setting it draws the tree."""
        key = f"{text.plain}\0{text.spans}"
        if self._labels.get(node.data or "") != key:
            self._labels[node.data or ""] = key
            node.set_label(text)

    def _show_about(self) -> None:
        about = self.query_one("#about", Static)
        width = about.content_size.width or 40
        id = texts.id_of(self._scope)
        if not self._scope:
            about.update(Text("no messages yet", style=texts.FAINT))
        elif id is None:
            about.update(texts.about_group(self._scope, self.observed, self.source.peers, self.source.now, width))
        else:
            component = self.observed.components.get(id) or ObservedComponent(id)
            about.update(texts.about_component(component, self.observed, self.source.peers, self.source.now, width))

    def _show_messages(self) -> None:
        table = self.query_one("#messages", DataTable)
        streams = self.observed.streams_of(self._scope) if self._scope else []
        streams = self._sorted(streams)[:MAX_ROWS]
        shown = len(table.ordered_columns)
        rows = {
            "\0".join(route): (route, texts.cells(route, stream, self._scope, self.source.now)[:shown])
            for route, stream in streams
        }
        if list(rows) != list(self._rows) or (rows and self._route is None):
            self._rows = rows
            self._fill(table)
        else:
            for key, (_, cells) in rows.items():
                old = self._rows[key][1]
                if cells == old:
                    continue
                for column, cell, new, before in zip(
                    table.ordered_columns, self._row(table, cells), cells, old, strict=True
                ):
                    if new != before:
                        table.update_cell(key, column.key, cell)
            self._rows = rows
        table.border_title = f"messages by {self._sorting}"

    def _fill(self, table: DataTable[Text]) -> None:
        """Make the rows anew, and return to the one that was chosen."""
        chosen = self._route
        table.clear()
        for key, (_, cells) in self._rows.items():
            table.add_row(*self._row(table, cells), key=key)
        keys = list(self._rows)
        row = keys.index("\0".join(chosen)) if chosen is not None and "\0".join(chosen) in keys else 0
        self._route = self._rows[keys[row]][0] if keys else None
        if keys:
            table.move_cursor(row=row)

    def _row(self, table: DataTable[Text], cells: tuple[str, ...]) -> list[Text]:
        columns = zip(table.ordered_columns, cells, self._widths, strict=True)
        return [_cell(column.key.value or "", text, width) for column, text, width in columns]

    def _sorted(self, streams: list[tuple[Route, Stream]]) -> list[tuple[Route, Stream]]:
        now = self.source.now
        keys: dict[str, Callable[[tuple[Route, Stream]], float]] = {
            "rate": lambda item: -item[1].history.rate(now),
            "count": lambda item: -item[1].count,
            "age": lambda item: -item[1].latest.time,
        }
        return sorted(streams, key=keys[self._sorting]) if self._sorting in keys else streams

    def _show_detail(self) -> None:
        stream = None if self._route is None else self.observed.streams.get(self._route)
        fields, frame = self.query_one("#fields", Static), self.query_one("#fields-frame")
        frame.border_title = Text("fields" if self._route is None else printable(self._route.message))
        fields.update(Text("") if stream is None else texts.message_text(stream.latest))
        series, plot = self.source.series, self.query_one("#plot", Static)
        plot.display = series is not None
        if series is None:
            return
        if isinstance(self.source, CaptureSource):
            start, end, cursor = self.source.timeline.start, self.source.timeline.end, self.source.now
        else:
            start, end, cursor = self.source.now - PLOT_SECONDS, self.source.now, None
        width, height = plot.content_size
        plot.update(texts.plot(series, start, end, (width or 30, height or 8), cursor=cursor))

    def _make_columns(self) -> None:
        """As many columns as there is room for, the first ones as wide as it allows."""
        table = self.query_one("#messages", DataTable)
        table.clear(columns=True)
        self._rows = {}
        narrow = self.size.width < NARROW
        names = [name for name in COLUMNS if not (narrow and name in WIDE_COLUMNS)]
        frame = 1 if narrow else 3  # a scrollbar, and borders
        fixed = sum(COLUMNS[name] + 1 for name in names)
        rest = max(20, self.size.width - TREE_WIDTHS[not narrow] - frame - fixed)
        shares = {"message": rest * 3 // 5, "peer": rest - rest * 3 // 5}
        self._widths = [shares.get(name, COLUMNS[name]) for name in names]
        for name, width in zip(names, self._widths, strict=True):
            heading = f"{name:>{width}} " if name in RIGHT_ALIGNED else name
            table.add_column(heading, width=width + 1, key=name)

    # --- what is chosen -----------------------------------------------------------------------------------------------

    def on_tree_node_highlighted(self, event: Tree.NodeHighlighted[str]) -> None:
        """Show what was chosen in the tree."""
        if event.node.data and event.node.data != self._scope:
            self._scope = event.node.data
            self._route = None
            self.update_screen()

    def on_data_table_row_highlighted(self, event: DataTable.RowHighlighted) -> None:
        """Show the message that was chosen."""
        found = self._rows.get(event.row_key.value or "")
        if found is not None and self.query_one("#messages").has_focus:
            self._route = found[0]
            self._show_detail()

    def on_data_table_row_selected(self) -> None:
        """Open the message."""
        self.action_open()

    # --- keys ---------------------------------------------------------------------------------------------------------

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Keys of a capture are for captures, queries for what is live; dialogs have keys of their own."""
        del parameters
        if action == "ask":
            return self._ask is not None and len(self.screen_stack) < 2
        if action in {"move", "leap", "end", "speed"}:
            return isinstance(self.source, CaptureSource) and len(self.screen_stack) < 2
        if action in {"pause", "open", "about", "filter", "plot", "sort", "help"}:
            return len(self.screen_stack) < 2
        return True

    def action_help(self) -> None:
        """Explain the keys."""
        width = max(len(keys) for keys, _ in KEYS)
        lines = [Text.assemble((f"{keys:<{width}}  ", "bold"), what, "\n") for keys, what in KEYS]
        notes = Text(
            "\nEverything is inferred from messages that were routed here; what none has told is unknown.\n"
            "State: reported by the component, or commanded and not confirmed yet. ◂ is the controlling client.\n"
            "Missing: sequence numbers that were not seen; lost, or sent where nobody listens.",
            style=texts.FAINT,
        )
        self.push_screen(TextDialog("keys", Text.assemble(*lines, notes)))

    def action_open(self) -> None:
        """Show a message with header, fields and bytes."""
        stream = None if self._route is None else self.observed.streams.get(self._route)
        if stream is not None:
            title = f"{printable(stream.latest.name)} from {stream.latest.part.packet.source}"
            self.push_screen(TextDialog(title, texts.message_text(stream.latest, head=True)))

    def action_about(self) -> None:
        """Show everything about a component."""
        id = texts.id_of(self._scope)
        component = None if id is None else self.observed.components.get(id)
        if component is not None:
            text = texts.component_page(component, self.observed, self.source.peers, self.source.now)
            self.push_screen(TextDialog(str(id), text))

    def action_filter(self) -> None:
        """Type a filter."""

        async def done(text: str) -> Text | None:
            try:
                self._set_filter(text)
            except ConfigError as error:
                return Text(str(error), style=texts.RED)
            return None

        hint = "as in: src == 101.* and msg == Report* and x > 5\nempty: all messages; counting begins anew"
        self.push_screen(LineDialog("filter", self._filter, hint, done))

    def _set_filter(self, text: str) -> None:
        fits = Filter(text, self._known) if text.strip() else None
        self._filter = text.strip()
        self.source.set_filter(fits)

    def action_plot(self) -> None:
        """Choose the field to plot, or end the plot."""
        stream = None if self._route is None else self.observed.streams.get(self._route)
        if self.source.series is not None:
            self.source.plot(None)
            return
        route = self._route
        message = None if stream is None else stream.latest.part.content.message
        paths = [] if message is None else numeric_fields(message)
        if route is None or not paths:
            self.notify("choose a message with numbers first", markup=False)
            return

        def chosen(number: int | None) -> None:
            if number is not None:
                self.source.plot(Series(route, paths[number]))

        self.push_screen(ChoiceDialog(f"plot a field of {route.message}", paths), chosen)

    def action_ask(self) -> None:
        """Type a query to the chosen component and send it."""
        id, ask = texts.id_of(self._scope), self._ask
        if id is None or ask is None:
            self.notify("choose a component first", markup=False)
            return
        names = sorted({entry.name for entry in self._known.entries if entry.name.startswith("Query")})
        hint = "a query and its fields, as in: QueryLocalPose presence_vector=0x43\n→ completes the name"

        async def done(text: str) -> Text | None:
            return await ask(id, text)

        self.push_screen(LineDialog(f"ask {id}", "QueryStatus", hint, done, names))

    def action_sort(self) -> None:
        """Sort by the next property."""
        following = dict(pairwise((*SORTINGS, SORTINGS[0])))
        self._sorting = following[self._sorting]
        self.update_screen()

    def action_pause(self) -> None:
        """Stand still or go on; play or pause."""
        if isinstance(self.source, LiveSource):
            self.source.freeze()
        else:
            self.source.play()
            self._before = monotonic()
        self.update_screen()

    def action_move(self, direction: int) -> None:
        """Go a second back or on."""
        self._move(direction * STEP)

    def action_leap(self, direction: int) -> None:
        """Go ten seconds back or on."""
        self._move(direction * LEAP)

    def action_end(self, which: int) -> None:
        """Go to the beginning or the end."""
        if isinstance(self.source, CaptureSource):
            self.source.move(self.source.timeline.end if which else self.source.timeline.start)
            self.update_screen()

    def action_speed(self, steps: int) -> None:
        """Play faster or more slowly."""
        if isinstance(self.source, CaptureSource):
            self.source.change_speed(steps)
            self.update_screen()

    def _move(self, seconds: float) -> None:
        if isinstance(self.source, CaptureSource):
            self.source.move(self.source.position + seconds)
            self.update_screen()


def _cell(column: str, text: str, width: int) -> Text:
    """A cell with a space to its right."""
    shown = Text(text, style=CELL_STYLES.get(column, ""))
    shown.truncate(width, overflow="ellipsis")
    shown.align("right" if column in RIGHT_ALIGNED else "left", width)
    return shown.append(" ")
