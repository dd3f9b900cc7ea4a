"""`heft cells`: the cells at hand."""

import typer
from rich.table import Table

from core.cell.cell import Cell
from core.cell.folder import list_cell_folders, load_cell
from core.cli.terminal import answers, find_wording
from core.errors import BadInput

app = typer.Typer()


@app.command()
def cells() -> None:
    """List the cells at hand, and what keeps any of them from being used."""
    loaded, broken = [], {}
    for folder in list_cell_folders():
        try:
            loaded.append(load_cell(folder))
        except BadInput as error:
            broken[folder.name] = error
    answers.print(cells_table(loaded))
    for line in broken_lines(broken):
        answers.print(line, highlight=False, markup=False, soft_wrap=True)


def cells_table(cells: list[Cell]) -> Table:
    """The cells at hand."""
    table, words = Table(), find_wording()
    for heading in (words.say("cli-cell"), words.say("cli-title"), words.say("cli-axes")):
        table.add_column(heading)
    for heading in (words.say("cli-obstacles"), words.say("cli-zones"), words.say("cli-payloads")):
        table.add_column(heading)
    for cell in cells:
        table.add_row(
            cell.name,
            cell.title,
            str(len(cell.robot.home_rad)),
            ", ".join(item.name for item in cell.obstacles),
            ", ".join(zone.name for zone in cell.zones),
            ", ".join(cell.payloads),
        )
    return table


def broken_lines(broken: dict[str, BadInput]) -> list[str]:
    """What keeps cells at hand from being used, a sentence each, by their names."""
    words = find_wording()
    return [
        words.say("cli-cell-unusable", name=name, flaw=flaw.message) for name, error in broken.items() for flaw in (error, *error.others)
    ]
