from __future__ import annotations

from rich.table import Table

from jauspy.cli import console


def test_piped_table_is_not_folded(capsys):
    table = Table(box=None)
    table.add_column("what", overflow="fold")
    table.add_row("x" * 250)
    console.stdout(pipe_width=1000).print(table)
    assert "x" * 250 in capsys.readouterr().out
    console.stdout().print(table, soft_wrap=False)
    assert "x" * 250 not in capsys.readouterr().out
